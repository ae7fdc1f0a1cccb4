//! Two levels: the switch, the fade, the end of the fine level, and shadow over both.

use std::sync::Arc;

use crate::scenes::{bumps, crater_field, laws, planes, pose, settings, sun, value};
use exact::{Ceilings, Outlook, Ray, Sight};
use generator::PlaneKind;
use hardware_model::{LevelSwitch, Settings};
use landscape::{Bank, CornerWords, Landscape, Level, basis};
use proptest::prelude::*;
use quantities::unit_interval;
use scenario::{Curvature, PixelRule, Projection, Scenery, ShadowFineness};

fn part(d: f64, origin: [f64; 2], regions: [usize; 2], corner: impl Fn(f64, f64) -> CornerWords) -> Level {
    let words = |index: usize| corner((index / (regions[1] + 1)) as f64, (index % (regions[1] + 1)) as f64);
    let corners = regions.map(|count| count + 1);
    Level::new(d, origin, corners, (0..corners[0] * corners[1]).map(words).collect()).unwrap()
}

fn height(value: f64) -> CornerWords {
    [value, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
}

/// Fine level ground at 0 m, 200 m x 60 m; coarse level ground at 1 m, 2000 m x 400 m, with a hill to the north.
fn two_levels() -> Arc<Landscape> {
    let fine = part(20.0, [0.0, 0.0], [10, 3], |_, _| height(0.0));
    let coarse = part(100.0, [-200.0, -200.0], [20, 4], |m, n| {
        height(if (m, n) == (15.0, 2.0) { 300.0 } else { 1.0 })
    });
    Arc::new(Landscape::new(Bank::new("two", vec![fine, coarse], None).unwrap(), 1.0))
}

const EYE: [f64; 3] = [10.0, 30.0, 3.0];

fn look(switch: Option<LevelSwitch>, direction: [f64; 2], rise: f64) -> Sight {
    let ground = two_levels();
    let ceilings = Ceilings::new(&ground);
    Outlook::new(&ground, &ceilings, EYE, Curvature::None, [1.0, 1500.0], switch)
        .look(&Ray { direction, rise })
}

fn range(sight: Sight) -> f64 {
    match sight {
        Sight::Ground(spot) => spot.range,
        Sight::Sky | Sight::TooNear | Sight::Cut(_) => f64::INFINITY,
    }
}

#[test]
fn fine_before_the_switch_coarse_behind_it_and_their_mean_between() {
    let switch = Some(LevelSwitch { range: 100.0, blend: 40.0 });
    for (rise, expected) in
        [(-0.06, 50.0), (-0.0505, 3.0 / 0.0505), (-0.019, 2.0 / 0.019), (-0.0101, 2.0 / 0.0101)]
    {
        assert!((range(look(switch, [1.0, 0.0], rise)) - expected).abs() < 1e-9, "{rise}");
    }
    for step in 0..40 {
        let rise = -0.0499 + 0.0007 * f64::from(step);
        let found = range(look(switch, [1.0, 0.0], rise));
        if found < 100.0 {
            let ground = 1.0 - basis::values((found - 60.0) / 40.0)[0];
            assert!(found > 60.0 && (ground - 3.0 - rise * found).abs() < 1e-11, "{rise}: {found}");
        } else {
            assert!((found + 2.0 / rise).abs() < 1e-9 && rise > -0.0201, "{rise}: {found}");
        }
    }
}

#[test]
fn a_hard_switch_shows_the_step() {
    let switch = Some(LevelSwitch { range: 100.0, blend: 0.0 });
    // Fine ground would be met at 3 / t > 100 m, coarse ground at 2 / t < 100 m: the face of the step.
    assert_eq!(range(look(switch, [1.0, 0.0], -0.025)), 100.0);
    assert!((range(look(switch, [1.0, 0.0], -0.031)) - 3.0 / 0.031).abs() < 1e-9);
    assert!((range(look(switch, [1.0, 0.0], -0.019)) - 2.0 / 0.019).abs() < 1e-9);
}

#[test]
fn where_the_fine_level_ends_the_coarse_one_begins() {
    let switch = Some(LevelSwitch { range: 100.0, blend: 40.0 });
    // To the east the fine level ends after 30 m, and south of the eye after 10 m.
    assert!((range(look(switch, [0.0, 1.0], -0.11)) - 3.0 / 0.11).abs() < 1e-9);
    assert_eq!(range(look(switch, [0.0, 1.0], -0.08)), 30.0);
    assert!((range(look(switch, [0.0, 1.0], -0.05)) - 40.0).abs() < 1e-9);
    assert!((range(look(switch, [-1.0, 0.0], -0.05)) - 40.0).abs() < 1e-9);
    assert_eq!(look(None, [-1.0, 0.0], -0.05), Sight::Sky, "without a switch there is only the fine level");
    // The hill, 1300 m to the north on the coarse level.
    assert!((range(look(switch, [1.0, 0.0], 0.1)) - 1290.0).abs() < 100.0);
    assert_eq!(look(switch, [1.0, 0.0], 0.25), Sight::Sky);
}

#[test]
fn a_hill_of_the_coarse_level_shadows_the_fine_one() {
    let laws = laws(Projection::Exact, Curvature::None, PixelRule::Centre);
    let switch = Some(LevelSwitch { range: 100.0, blend: 40.0 });
    let settings = Settings {
        shadows: Some(ShadowFineness::default()),
        levels: switch,
        ..settings(1, 9, laws, [1.0, 1500.0])
    };
    let dark = |azimuth: f64, elevation: f64| {
        let scenery = Scenery::still(sun(azimuth, elevation));
        let found = planes(&two_levels(), scenery, &settings, &pose([10.0, 0.0, 3.0], 0.0, 0.0));
        // Bottom pixel: the foreground.
        value(&found, PlaneKind::Shadow, 8) == 2.0
    };
    // The hill stands over (1300, 0), 300 m high: 13 degrees from the foreground at (21, 0).
    assert!(dark(0.0, 12.0) && !dark(0.0, 14.0) && !dark(180.0, 5.0) && !dark(60.0, 12.0));
}

/// A sunbeam from outside the fine level goes through it, and over its ground.
#[test]
fn a_hill_of_the_fine_level_shadows_the_coarse_one() {
    let hill = |m: f64, n: f64| height(if (m, n) == (5.0, 1.0) { 40.0 } else { 0.0 });
    let fine = part(20.0, [0.0, 0.0], [10, 3], hill);
    let coarse = part(100.0, [-200.0, -200.0], [20, 4], |_, _| height(1.0));
    let ground = Arc::new(Landscape::new(Bank::new("two", vec![fine, coarse], None).unwrap(), 1.0));
    let laws = laws(Projection::Exact, Curvature::None, PixelRule::Centre);
    let switch = Some(LevelSwitch { range: 100.0, blend: 40.0 });
    let settings = Settings {
        shadows: Some(ShadowFineness::default()),
        levels: switch,
        ..settings(1, 9, laws, [1.0, 150.0])
    };
    let dark = |azimuth: f64, elevation: f64| {
        let scenery = Scenery::still(sun(azimuth, elevation));
        let found = planes(&ground, scenery, &settings, &pose([10.0, 20.0, 3.0], 0.0, 180.0));
        // Coarse ground at about (-7, 20), the hill 107 m to the north.
        assert!((value(&found, PlaneKind::Range, 6) - 16.8).abs() < 0.1);
        value(&found, PlaneKind::Shadow, 6) == 2.0
    };
    assert_eq!([dark(0.0, 15.0), dark(0.0, 25.0), dark(180.0, 15.0)], [true, false, false]);
}

/// Height (m) and slopes of a level at a place, by its own direct sum.
fn level_at(level: &Level, [x, y]: [f64; 2]) -> Option<[f64; 3]> {
    let (region, local) = level.locate(x, y)?;
    let [height, hu, hv] = level.height_and_slopes(region, local);
    Some([height, hu / level.region_size(), hv / level.region_size()])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn the_first_ground_of_fading_bumps_with_craters(
        seed in any::<u64>(), (range, blend) in (5.0..30.0f64, 0.0..30.0f64), up in 0.1..2.0f64,
    ) {
        let blend = blend.min(range);
        let word = |m: f64, n: f64, k: usize| unit_interval(seed, &[m as u64, n as u64, k as u64, 1]) - 0.5;
        let coarse = part(21.0, [-19.0, -23.0], [4, 4], |m, n| std::array::from_fn(|k| word(m, n, k)));
        let bank = Bank::new("two", vec![bumps(seed, 0.4), coarse], None).unwrap();
        let ground = Landscape::new(bank, 1.0).with_features(crater_field(seed, 60, 6.0));
        let eye = [24.0, 24.0, ground.height(24.0, 24.0).unwrap() + up];
        let ceilings = Ceilings::new(&ground);
        let switch = LevelSwitch { range, blend };
        let outlook = Outlook::new(&ground, &ceilings, eye, Curvature::None, [0.2, 40.0], Some(switch));
        let levels = ground.bank().levels();
        for step in 0..40 {
            let azimuth = 0.157 * f64::from(step) + 0.01;
            let direction = [libm::cos(azimuth), libm::sin(azimuth)];
            let ray = Ray { direction, rise: -0.25 + 0.009 * f64::from(step) };
            let place = |s: f64| [eye[0] + s * direction[0], eye[1] + s * direction[1]];
            let terrain = |s: f64| {
                let fine = level_at(&levels[0], place(s)).filter(|_| s < range);
                Some(match (fine, level_at(&levels[1], place(s))) {
                    (Some(fine), _) if s <= range - blend => fine,
                    (Some(fine), Some(coarse)) => {
                        let share = (s - range + blend) / blend;
                        let weight = basis::values(share)[0];
                        // The weight changes along the ray: so does what it weighs.
                        let along = basis::derivatives(share)[0] / blend * (fine[0] - coarse[0]);
                        let turn = [0.0, along * direction[0], along * direction[1]];
                        std::array::from_fn(|k| weight * fine[k] + (1.0 - weight) * coarse[k] + turn[k])
                    }
                    (_, coarse) => coarse?,
                })
            };
            let above = |s: f64| {
                let [x, y] = place(s);
                Some(terrain(s)?[0] + ground.features().at(x, y).height - eye[2] - ray.rise * s)
            };
            let (met, found) = match outlook.look(&ray) {
                Sight::Ground(spot) => (spot.range, [spot.height, spot.slopes[0], spot.slopes[1]]),
                Sight::Sky => (40.0, [0.0; 3]),
                Sight::TooNear | Sight::Cut(_) => continue,
            };
            let mut s = 0.2;
            while s < met - 1e-9 {
                let Some(above) = above(s) else { break };
                prop_assert!(above < 1e-11, "{above} at {s}, before {met}");
                s += 0.01;
            }
            // It lies on the ground, or on the face of a step where a level ends.
            if met < 40.0 {
                let [here, behind] = [met, met + 1e-6].map(above);
                let expected = terrain(met).unwrap_or(found);
                let on = here.is_none_or(|above| above.abs() < 1e-10);
                prop_assert!(!on || (0..3).all(|k| (found[k] - expected[k]).abs() < 1e-9), "{found:?}, {expected:?}");
                prop_assert!(on || behind.is_none_or(|above| above > 0.0), "{here:?} at {met}");
            }
        }
    }
}
