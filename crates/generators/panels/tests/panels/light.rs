//! Light of panels, of unseen ground, and of another sun.

use std::sync::Arc;

use generator::Stage;
use landscape::{Landscape, Sun};
use panels::{Parameters, Shading};
use scenario::Scenery;

use crate::shots::{SUN, draw, landscape, light, photograph, pose, run, session, stage};

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
