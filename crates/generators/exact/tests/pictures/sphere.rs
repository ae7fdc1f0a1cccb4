//! `curvature = "exact"`: the sphere.

use crate::scenes::{landscape, laws, plane, pose, settings, standing_box, sun};
use exact::{Ceilings, Exact, Outlook, Ray, Sight};
use generator::{Generator, PlaneKind, Planes, Stage};
use landscape::{LUNOID_RADIUS, Landscape};
use scenario::{Curvature, PixelRule, Projection, Scenery};
use signal::Probe;
use std::sync::Arc;

fn look(ground: &Arc<Landscape>, eye: [f64; 3], curvature: Curvature, rise: f64) -> Option<f64> {
    let ceilings = Ceilings::new(ground);
    let outlook = Outlook::new(ground, &ceilings, eye, curvature, [0.0, f64::INFINITY], None);
    match outlook.look(&Ray { direction: [1.0, 0.0], rise }) {
        Sight::Ground(spot) => Some(spot.range),
        _ => None,
    }
}

/// Level ground for 4000 km ahead of an eye over x = 0.
fn far_ground() -> Arc<Landscape> {
    landscape(plane(1e5, [40, 2], 0.0, [0.0; 2]), 1.0)
}

/// The nearer root of `s^2 (1 + t^2) + 2 t (R + H) s + H (2R + H) = 0`.
fn on_sphere(height: f64, rise: f64) -> f64 {
    let (half, constant) = (-rise * (LUNOID_RADIUS + height), height * (2.0 * LUNOID_RADIUS + height));
    constant / (half + (half * half - (1.0 + rise * rise) * constant).sqrt())
}

#[test]
fn ranges_and_the_horizon_of_the_sphere() {
    let ground = far_ground();
    for height in [1.63, 2e3, 1e5, 1e6, 1e8] {
        let horizon = -(height * (2.0 * LUNOID_RADIUS + height)).sqrt() / LUNOID_RADIUS;
        let eye = [0.0, 5e4, height];
        assert_eq!(look(&ground, eye, Curvature::Exact, horizon * (1.0 - 1e-9)), None, "{height}");
        for factor in [1.0 + 1e-6, 1.0001, 1.01, 1.5, 10.0, 200.0] {
            let expected = on_sphere(height, horizon * factor);
            let found = look(&ground, eye, Curvature::Exact, horizon * factor).unwrap();
            assert!((found / expected - 1.0).abs() < 1e-9, "{height} {factor}: {found}, not {expected}");
            assert!(found < LUNOID_RADIUS);
        }
    }
}

/// Sphere and parabola part by `s^4 / 8R^3`, and that divided by the slope at which the ray meets the ground.
#[test]
fn sphere_and_parabola_part_with_the_fourth_power() {
    let ground = far_ground();
    for (height, range) in [(500.0, 2e4), (2e3, 5e4), (9e3, 1e5), (9e3, 1.5e5)] {
        let drop = range * range / (2.0 * LUNOID_RADIUS);
        let rise = -(height + drop) / range;
        let [parabola, sphere] = [Curvature::Parabolic, Curvature::Exact]
            .map(|curvature| look(&ground, [0.0, 5e4, height], curvature, rise).unwrap());
        assert!((parabola / range - 1.0).abs() < 1e-12);
        let cube = LUNOID_RADIUS * LUNOID_RADIUS * LUNOID_RADIUS;
        let parted = range * range * range * range / (8.0 * cube);
        let steepness = -rise - range / LUNOID_RADIUS;
        let expected = parted / steepness;
        let found = sphere - parabola;
        assert!((found / expected - 1.0).abs() < 0.1, "{range}: {found}, not {expected}");
    }
}

/// Ground of the map beyond R is not there, and neither is a body.
#[test]
fn the_sphere_ends() {
    let ground = landscape(plane(1e5, [40, 2], 3e6, [0.0; 2]), 1.0);
    let eye = [0.0, 5e4, 3.1e6];
    // Ground 3000 km high: a level ray would meet the parabola nowhere, a falling one beyond R.
    let rise = -2.0;
    let met = look(&ground, eye, Curvature::Exact, rise).unwrap();
    assert!((met / on_sphere(1e5, rise) - 1.0).abs() < 1e-9);
    assert_eq!(look(&ground, eye, Curvature::Exact, -0.01), None);
    let bodies = |range: f64, curvature| {
        let settings = settings(9, 9, laws(Projection::Exact, curvature, PixelRule::Centre), [1.0, 1e6]);
        let body = standing_box(0, [range, 5e4, 3e6], 5.0, 9.0);
        let scenery = Arc::new(Scenery::still(sun(180.0, 30.0)).with_bodies(vec![body]));
        let stage = Stage { landscape: Arc::clone(&ground), scenery, view: settings.view() };
        let mut planes = Planes::new(9, 9, &[PlaneKind::Intensity]);
        let session = Exact.prepare(stage).unwrap();
        session.frame(0, &pose(eye, 0.0, 0.0), &mut planes, &mut Probe::off()).unwrap().get("bodies")
    };
    assert_eq!([1.7e6, 1.8e6].map(|range| bodies(range, Curvature::Exact)), [1, 0].map(Some));
    assert_eq!([1.7e6, 1.8e6].map(|range| bodies(range, Curvature::Parabolic)), [1, 1].map(Some));
}
