//! Craters along lines of sight: a closed form, and marching over fields of them.

use std::sync::Arc;

use crate::scenes::{bumps, crater_field, landscape, plane};
use exact::{Ceilings, Outlook, Ray, Sight};
use features::{Crater, Features, Shape};
use landscape::{Landscape, parabolic_drop};
use proptest::prelude::*;
use scenario::Curvature;

fn with(features: Features, ground: Arc<Landscape>) -> Landscape {
    Landscape::clone(&ground).with_features(features)
}

/// Check value of 23.4: the near rim hides the bowl up to 68.37 m.
#[test]
fn the_near_rim_hides_the_bowl() {
    let [x, y, height] = [10.0, 60.0, 1.63];
    let crater = Crater::new([x + 60.0, y], Shape::Bowl { r1: 10.0 }, 2.0, 0.0).unwrap();
    let ground = with(Features::new(vec![crater]), landscape(plane(20.0, [6, 6], 0.0, [0.0; 2]), 1.0));
    let ceilings = Ceilings::new(&ground);
    let outlook = Outlook::new(&ground, &ceilings, [x, y, height], Curvature::None, [1.5, 105.0], None);
    let look = |rise: f64| match outlook.look(&Ray { direction: [1.0, 0.0], rise }) {
        Sight::Ground(spot) => spot.range,
        Sight::Sky | Sight::TooNear | Sight::Cut(_) => f64::INFINITY,
    };
    let rim = -height / 50.0;
    assert!((look(rim - 1e-9) - 50.0).abs() < 1e-5, "the rim itself");
    assert!((look(rim + 1e-9) - 68.37).abs() < 1e-5, "behind it: {}", look(rim + 1e-9));
    // Within the bowl, a (rho^2 / r1^2 - 1) = H + t s.
    for rise in [-0.031, -0.029, -0.0272] {
        let range = look(rise);
        let rho = range - 60.0;
        assert!((2.0 * (rho * rho / 100.0 - 1.0) - height - rise * range).abs() < 1e-12, "{rise}: {range}");
    }
}

/// A rim crest from the side, hardly above the line: found, not stepped over.
#[test]
fn a_crest_that_hardly_reaches_the_line() {
    let crater = Crater::new([60.0, 60.0], Shape::RimmedBowl { r1: 10.0, r2: 12.0 }, 2.0, 0.5).unwrap();
    let ground = with(Features::new(vec![crater]), landscape(plane(20.0, [6, 6], 0.0, [0.0; 2]), 1.0));
    let ceilings = Ceilings::new(&ground);
    for miss in [0.0, 5.0, 10.9, 10.999, 11.0] {
        for (over, meets) in [(1e-9, false), (-1e-9, true), (-1e-6, true)] {
            let eye = [10.0, 60.0 + miss, 0.5 + over];
            let outlook = Outlook::new(&ground, &ceilings, eye, Curvature::None, [1.5, 105.0], None);
            let sight = outlook.look(&Ray { direction: [1.0, 0.0], rise: 0.0 });
            assert_eq!(matches!(sight, Sight::Ground(_)), meets, "{miss} {over}: {sight:?}");
            if let Sight::Ground(spot) = sight {
                let rho = libm::hypot(spot.place[0] - 60.0, spot.place[1] - 60.0);
                assert!((rho - 11.0).abs() < 2e-3, "{rho}");
            }
        }
    }
}

/// Ground less line at a range; `None` beyond the area.
fn above(ground: &Landscape, eye: [f64; 3], curved: bool, ray: &Ray, range: f64) -> Option<f64> {
    let height = ground.height(eye[0] + range * ray.direction[0], eye[1] + range * ray.direction[1])?;
    Some(height - if curved { parabolic_drop(range) } else { 0.0 } - eye[2] - ray.rise * range)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn every_ray_meets_the_first_ground(
        (seed, count) in (any::<u64>(), 0..400u64),
        (size, relief) in (0.5..20.0f64, 0.0..1.0f64),
        eye in (5.0..43.0f64, 5.0..43.0f64, 0.05..3.0f64),
        curved in any::<bool>(),
    ) {
        let ground = with(crater_field(seed, count, size), landscape(bumps(seed, relief), 1.0));
        let eye = [eye.0, eye.1, ground.height(eye.0, eye.1).unwrap() + eye.2];
        let ceilings = Ceilings::new(&ground);
        let curvature = if curved { Curvature::Parabolic } else { Curvature::None };
        let outlook = Outlook::new(&ground, &ceilings, eye, curvature, [0.2, 45.0], None);
        for step in 0..40 {
            let azimuth = 0.157 * f64::from(step);
            let ray = Ray { direction: [libm::cos(azimuth), libm::sin(azimuth)], rise: -0.3 + 0.01 * f64::from(step) };
            let above = |range| above(&ground, eye, curved, &ray, range);
            let met = match outlook.look(&ray) {
                Sight::Ground(spot) => spot.range,
                Sight::Sky => 45.0,
                Sight::Cut(_) => continue,
                Sight::TooNear => { prop_assert!(above(0.2).unwrap() >= 0.0); continue }
            };
            let mut range = 0.2;
            while range < met - 1e-9 {
                let Some(above) = above(range) else { break };
                prop_assert!(above < 1e-11, "{above} at {range}, before {met}");
                range += 0.01;
            }
            if met < 45.0 {
                prop_assert!(above(met).is_none_or(|above| above.abs() < 1e-10), "{:?} at {met}", above(met));
            }
        }
    }
}
