//! Straight down and up, and from on high, where no sweep is drawn.

use std::sync::Arc;

use crate::scenes::{
    bumps, crater_field, draw, landscape, laws, plane, planes, pose, settings, standing_box, sun, value,
};
use exact::{Ceilings, Exact, Outlook, Ray, Sight};
use generator::{Generator, Label, PlaneKind, Planes, Stage};
use hardware_model::Settings;
use landscape::{Landscape, Photometry};
use quantities::radians;
use scenario::{BodyVisibility, Curvature, Laws, PixelRule, Pose, Projection, Scenery, ShadowFineness};
use signal::Probe;

/// The level camera of these tests over a flat Moon.
pub fn usual(lines: u32, rule: PixelRule) -> Settings {
    settings(21, lines, laws(Projection::Exact, Curvature::None, rule), [12.0, 5000.0])
}

/// Codes of the labels of all pixels.
pub fn labels(planes: &Planes) -> Vec<u8> {
    planes.get(PlaneKind::Label).unwrap().iter().map(|&label| label as u8).collect()
}

/// The nadir in the very middle of a pixel: the ray has no azimuth, and the ground there is seen as all around it.
#[test]
fn the_nadir_and_the_zenith() {
    for photometry in [Photometry::Lambert, Photometry::LommelSeeliger, Photometry::LunarLambert] {
        let ground = Landscape::clone(&landscape(plane(40.0, [20, 20], 7.0, [0.02, 0.01]), 0.5));
        let ground = Arc::new(ground.with_photometry(photometry));
        for (up, heading) in [(2.0, 0.0), (300.0, 33.0), (1e6, 270.0)] {
            let eye = [410.0, 390.0, 7.0 + 0.02 * 410.0 + 0.01 * 390.0 + up];
            let field = [0.3 * 100.0 / (100.0 + up); 2];
            let mut settings = usual(21, PixelRule::LineMean);
            [settings.raster.field.tan_half_width, settings.raster.field.tan_half_height] = field;
            let scenery = || Scenery::still(sun(70.0, 24.0));
            let down = planes(&ground, scenery(), &settings, &pose(eye, -90.0, heading));
            let middle = 10 * 21 + 10;
            let at = |kind, index| value(&down, kind, index);
            assert!(at(PlaneKind::Range, middle) <= 1e-12 * (1.0 + up), "{}", at(PlaneKind::Range, middle));
            let height = 7.0 + 0.02 * 410.0 + 0.01 * 390.0;
            assert!((at(PlaneKind::Height, middle) - height).abs() < 1e-5);
            for (kind, tolerance) in [(PlaneKind::Reflectivity, 2e-3), (PlaneKind::Intensity, 2e-3)] {
                assert!((at(kind, middle) / at(kind, middle - 21) - 1.0).abs() < tolerance, "{photometry:?}");
            }
            assert!(labels(&down).iter().all(|&label| label == Label::Terrain.code()));
            let above = planes(&ground, scenery(), &settings, &pose(eye, 90.0, heading));
            assert!(labels(&above).iter().all(|&label| label == Label::Sky.code()));
        }
    }
}

/// Straight down a level plane lies in the picture as on a map: range is height times distance from the middle.
#[test]
fn straight_down_is_a_map() {
    let ground = landscape(plane(40.0, [20, 20], 0.0, [0.0; 2]), 1.0);
    let settings = usual(31, PixelRule::Centre);
    let (_, range) = draw(&ground, sun(70.0, 24.0), &settings, &pose([400.0, 400.0, 60.0], -90.0, 20.0));
    let field = settings.raster.field;
    for (index, &range) in range.iter().enumerate() {
        let x = field.tan_half_width * (f64::from(2 * (index as u32 % 21) + 1) / 21.0 - 1.0);
        let y = field.tan_half_height * (f64::from(2 * (index as u32 / 21) + 1) / 31.0 - 1.0);
        let expected = 60.0 * libm::hypot(x, y);
        assert!(
            (f64::from(range) - expected).abs() < 1e-6 * (1.0 + expected),
            "{index}: {range}, {expected}"
        );
    }
}

/// Pitched over the zenith by half a turn the camera looks back, on its head.
#[test]
fn half_a_turn_of_pitch() {
    let ground = landscape(bumps(2, 0.6), 1.0);
    let height = ground.height(20.0, 20.0).unwrap() + 1.5;
    for rule in [PixelRule::Centre, PixelRule::LineMean] {
        let settings = settings(20, 16, laws(Projection::Exact, Curvature::None, rule), [1e-3, 45.0]);
        let over = pose([20.0, 20.0, height], 180.0, 50.0);
        let back = Pose { yoke: std::f64::consts::PI, ..pose([20.0, 20.0, height], 0.0, 230.0) };
        let [over, back] =
            [over, back].map(|pose| planes(&ground, Scenery::still(sun(9.0, 20.0)), &settings, &pose));
        for kind in [PlaneKind::Label, PlaneKind::Range, PlaneKind::Intensity] {
            for index in 0..320 {
                let [a, b] = [value(&over, kind, index), value(&back, kind, index)];
                assert!(a == b || (a - b).abs() < 1e-4 * (1.0 + a.abs()), "{kind:?} {index}: {a} {b}");
            }
        }
        assert!(labels(&over).contains(&Label::Terrain.code()) && labels(&over).contains(&Label::Sky.code()));
    }
}

/// Ground nearer than the first sample is black where sweeps could be drawn; where none could it is seen.
#[test]
fn the_ground_under_the_eye() {
    let ground = landscape(plane(40.0, [20, 20], 0.0, [0.0; 2]), 1.0);
    let settings = usual(200, PixelRule::Centre);
    let nearest = |pose: &Pose| {
        let (_, range) = draw(&ground, sun(0.0, 30.0), &settings, pose);
        range.into_iter().fold(f32::INFINITY, f32::min)
    };
    let eye = [400.0, 400.0, 2.0];
    assert!(nearest(&pose(eye, -30.0, 0.0)) >= 12.0, "half the field is 15 deg: 45 deg");
    assert!(nearest(&pose(eye, -64.9, 0.0)).is_infinite(), "79.9 deg: all that is seen is nearer");
    assert!(nearest(&pose(eye, -65.1, 0.0)) < 0.4, "80.1 deg");
    assert!(nearest(&pose([-1.0, 400.0, 2.0], 0.0, 0.0)) < 8.0, "an eye beside the area");
    assert!(nearest(&Pose { yoke: radians(90.0), ..pose(eye, -60.0, 0.0) }) < 1.0, "a screen on its side");
}

/// A box straight below, from 1000 km: its roof, its size, its shadow beside it; by depth and as reported.
#[test]
fn a_box_straight_below() {
    let ground = landscape(plane(40.0, [20, 20], 0.0, [0.0; 2]), 1.0);
    for (height, visibility) in
        [(50.0, BodyVisibility::Depth), (1e6, BodyVisibility::Depth), (1e6, BodyVisibility::AsReported)]
    {
        let mut settings = usual(21, PixelRule::Centre);
        settings.laws = Laws { body_visibility: visibility, ..settings.laws };
        settings.shadows = Some(ShadowFineness::default());
        let half = 10.5 / height;
        [settings.raster.field.tan_half_width, settings.raster.field.tan_half_height] = [half; 2];
        let scenery =
            Scenery::still(sun(90.0, 45.0)).with_bodies(vec![standing_box(0, [400.2, 400.2, 0.0], 2.0, 3.0)]);
        let found = planes(&ground, scenery, &settings, &pose([400.0, 400.0, height], -90.0, 0.0));
        let labels = labels(&found);
        let roof = labels.iter().filter(|&&label| label == Label::Culture.code()).count();
        // Roof 3 m above the ground: nearer, so larger by the share of the height.
        let side = 4.0 * height / (height - 3.0);
        assert!((roof as f64).sqrt() - side < 1.0 && roof >= 16, "{height}: {roof} pixels, side {side}");
        let middle = 10 * 21 + 10;
        assert_eq!(labels[middle], Label::Culture.code());
        assert_eq!(value(&found, PlaneKind::Height, middle), 3.0);
        let shade = found.get(PlaneKind::Shadow).unwrap();
        let dark = shade.iter().filter(|&&code| code == 2.0).count();
        assert!(
            (9..=13).contains(&dark),
            "{height}: {dark} pixels of 4 m x 3 m of shadow, some behind the box"
        );
    }
}

/// Straight down range is all but 0, and still tells heights apart: in one part of 10^9.
#[test]
fn ranges_of_steep_rays() {
    for size in [8.0, 1e5] {
        let ground = landscape(plane(size, [6, 6], 3.0, [0.02, 0.01]), 1.0);
        let ground = Arc::new(Landscape::clone(&ground).with_features(crater_field(5, 50, 9.0)));
        let ceilings = Ceilings::new(&ground);
        for (up, rise) in [(1.0, -9.0), (1e3, -1e3), (1e6, -1e6), (1e6, -1e12), (1e6, -1e18), (1.0, -1e18)] {
            for place in [[20.0, 20.0], [31.0, 7.0], [24.0, 24.0], [11.5, 40.0]] {
                let eye = [place[0], place[1], ground.height(place[0], place[1]).unwrap() + up];
                let outlook = Outlook::new(&ground, &ceilings, eye, Curvature::None, [0.0, 5000.0], None);
                let Sight::Ground(spot) = outlook.look(&Ray { direction: [0.6, 0.8], rise }) else {
                    panic!()
                };
                let expected = (outlook.height(&spot) - eye[2]) / rise;
                assert!(
                    (spot.range / expected - 1.0).abs() < 1e-9,
                    "{size} {rise}: {}, not {expected}",
                    spot.range
                );
            }
        }
    }
}

/// As reported a body is seen whole unless ground before its foot stands higher; from on high that is an angle.
#[test]
fn bodies_as_reported_from_on_high() {
    let ground = landscape(plane(40.0, [20, 20], 7.0, [0.11, -0.07]), 1.0);
    let mut settings = usual(21, PixelRule::Centre);
    settings.laws = Laws { body_visibility: BodyVisibility::AsReported, ..settings.laws };
    for height in [300.0, 3e4, 1e6] {
        let body = |k: u32| {
            let [x, y] = [400.0 + 7.3 * f64::from(k % 5) - 11.0, 400.0 + 5.9 * f64::from(k / 5) - 9.1];
            standing_box(k, [x, y, ground.height(x, y).unwrap()], 0.5, 1.0)
        };
        let scenery = Arc::new(Scenery::still(sun(90.0, 45.0)).with_bodies((0..20).map(body).collect()));
        let stage = Stage { landscape: Arc::clone(&ground), scenery, view: settings.view() };
        let mut planes = Planes::new(21, 21, &[PlaneKind::Intensity]);
        let session = Exact.prepare(stage).unwrap();
        let counts =
            session.frame(0, &pose([400.0, 400.0, height], -90.0, 0.0), &mut planes, &mut Probe::off());
        assert_eq!(counts.unwrap().get("bodies"), Some(20), "{height}");
    }
}
