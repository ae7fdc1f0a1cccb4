//! Light of panels, of unseen ground, and of another sun.

use std::sync::Arc;

use generator::{PlaneKind, Stage};
use glam::DVec3;
use landscape::{Landscape, Sun};
use panels::{Parameters, Shading};
use scenario::{Scenery, ShadowFineness};

use crate::shots::{SIDE, SUN, draw, landscape, light, photograph, pose, run, session, stage};

/// The picture straight down from 300 m over the middle, 40 x 40 pixels on 150 m x 150 m.
fn from_above(stage: Stage, run: Parameters) -> Vec<f32> {
    let session = session(stage, run);
    light(&draw(&*session, 40, &pose([200.0, 200.0, 300.0], 0.0, -90.0))).to_vec()
}

fn flat() -> Landscape {
    landscape(0.0)
}

#[test]
fn ground_beside_the_photograph_has_the_light_outside() {
    // 80 pixels of half a metre cover the middle 40 m alone.
    let photos = || vec![photograph(80, 500.0, |_, _| 0.75)];
    let run = |shading, outside| Parameters { shading, outside, ..run() };
    for shading in [Shading::Texture, Shading::Gouraud, Shading::Panel] {
        let found = from_above(stage(flat(), photos(), 40, 0.25), run(shading, 0.125));
        assert!((found[20 * 40 + 20] - 0.75).abs() < 1e-3, "{shading:?}: {}", found[20 * 40 + 20]);
        assert!((found[0] - 0.125).abs() < 1e-3, "{shading:?}: {}", found[0]);
    }
}

#[test]
fn another_sun_lights_the_albedo() {
    let elevation_of = |sun: [f64; 2]| quantities::sin_cos(sun[1]).0;
    let photos = || vec![photograph(800, 500.0, |_, _| 0.4 * elevation_of(SUN))];
    for sun in [SUN, [4.0, 0.3]] {
        let under = |relights| {
            let scenery = Scenery::still(Sun { azimuth: sun[0], elevation: sun[1] });
            let stage = Stage { scenery: Arc::new(scenery), ..stage(flat(), photos(), 40, 0.25) };
            let run = Parameters { relights, ..run() };
            let omissions = session(stage.clone(), run.clone()).omissions();
            (from_above(stage, run)[20 * 40 + 20], omissions)
        };
        let (relit, omissions) = under(true);
        assert!((f64::from(relit) - 0.4 * elevation_of(sun)).abs() < 1e-3, "{sun:?}: {relit}");
        assert!(omissions.is_empty(), "{omissions:?}");
        let (own, omissions) = under(false);
        assert!((f64::from(own) - 0.4 * elevation_of(SUN)).abs() < 1e-3, "{sun:?}: {own}");
        // The photograph's own light is listed where its sun is another one.
        assert_eq!(omissions.len(), usize::from(sun != SUN), "{omissions:?}");
        assert!(omissions.iter().all(|omission| omission.why.contains("panels.relight = true")));
    }
}

#[test]
fn relit_panels_and_vertices_have_the_light_of_relit_pixels() {
    let photos = || vec![photograph(800, 500.0, |_, _| 0.3)];
    let of = |shading| {
        let run = Parameters { shading, relights: true, ..run() };
        from_above(stage(flat(), photos(), 40, 0.25), run)
    };
    let pixels = of(Shading::Texture);
    for shading in [Shading::Gouraud, Shading::Panel] {
        let apart = of(shading).iter().zip(&pixels).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(apart < 1e-5, "{shading:?}: {apart}");
    }
}

/// Height by which ground stands above the way from a place to the sun, at most (m); below 0 where the way is clear.
fn above_the_way(landscape: &Landscape, place: DVec3, sun: DVec3) -> f64 {
    let along = (6..800).map(|step| place + sun * (0.5 * f64::from(step)));
    let inside = along.take_while(|at| (0.0..=SIDE).contains(&at.x) && (0.0..=SIDE).contains(&at.y));
    inside.map(|at| landscape.height(at.x, at.y).unwrap() - at.z).fold(f64::NEG_INFINITY, f64::max)
}

/// Relit ground is black where hills stand two metres above the way to the sun, and nearly all ground is unchanged where the way is two metres clear.
#[test]
fn relit_ground_has_the_shadows_of_the_scenario() {
    let sun = Sun { azimuth: 4.0, elevation: 0.15 };
    let under = |shadows: Option<ShadowFineness>| {
        let mut stage = stage(landscape(12.0), vec![photograph(800, 500.0, |_, _| 0.3)], 40, 0.25);
        stage.scenery = Arc::new(Scenery::still(sun));
        stage.view.shadows = shadows;
        let session = session(stage, Parameters { relights: true, spacing: Some(2.0), ..run() });
        assert!(session.omissions().is_empty(), "{:?}", session.omissions());
        draw(&*session, 40, &pose([200.0, 200.0, 300.0], 0.0, -90.0))
    };
    let [plain, shadowed] = [under(None), under(Some(ShadowFineness::default()))];
    let distance = plain.get(PlaneKind::Distance).unwrap();
    let [mut dark, mut clear, mut changed] = [0, 0, 0];
    for pixel in 0..1600 {
        let tangent = |at: usize| ((at as f64 + 0.5) / 20.0 - 1.0) * 0.25;
        let way = DVec3::new(-tangent(pixel / 40), tangent(pixel % 40), -1.0).normalize();
        let place = DVec3::new(200.0, 200.0, 300.0) + way * f64::from(distance[pixel]);
        let above = above_the_way(&landscape(12.0), place, DVec3::from_array(sun.direction()));
        let [before, after] = [&plain, &shadowed].map(|planes| light(planes)[pixel]);
        if above > 2.0 {
            dark += 1;
            assert!(after < 1e-6, "{pixel}: {after}, {above} m");
        } else if above < -2.0 {
            clear += 1;
            changed += usize::from(after != before);
        }
    }
    // Beside a crest a cell may reach into its shadow.
    assert!(dark > 100 && clear > 200 && 33 * changed < clear, "{dark} dark, {changed} of {clear} changed");
}
