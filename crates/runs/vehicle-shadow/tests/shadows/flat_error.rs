//! Section 19.7 measured: where flat ground has the edge of a shadow, and where true ground has it.

use std::sync::Arc;

use exact::Ceilings;
use glam::DVec3;
use landscape::relief::{Relief, Undulation};
use landscape::{Attitude, Bank, Landscape, Level};
use quantities::{radians, unit_interval};
use scenario::{FieldOfView, Scenery};
use solids::Solid;
use vehicle_shadow::{Mast, MastEdge, Shape, Shot, TrueGround, flat_error, small_flat_error};

use crate::scenes::{stage, sun, to_sun};

const MAST: Mast = Mast::REPORT;

fn relief(seed: u64) -> Arc<Landscape> {
    let undulation = Undulation { rms_height: 3.0, hurst: 0.8, longest: 300.0, shortest: 12.0, waves: 200 };
    let relief = Relief {
        seed,
        extent: [800.0, 800.0],
        region_size: 4.0,
        tilt: [0.0; 2],
        undulation: Some(undulation),
        craters: None,
        massifs: Vec::new(),
        rilles: Vec::new(),
    };
    Arc::new(Landscape::new(Bank::new("relief", vec![relief.build().unwrap()], None).unwrap(), 1.0))
}

/// The error that is measured is the formula's, to rounding, and the small-angle form is near it.
#[test]
fn the_formula_holds_on_a_seeded_relief() {
    let ground = |seed| {
        let landscape = relief(seed);
        let ceilings = Ceilings::new(&landscape);
        (seed, landscape, ceilings)
    };
    let grounds: Vec<_> = (1..4).map(ground).collect();
    println!(
        "sun deg | shadow m | mean |rise| m | mean error mrad | largest | mean by the small-angle form | places"
    );
    for elevation in [30.0, 16.7, 8.0] {
        let (mut errors, mut small, mut rises) = (Vec::new(), 0.0, 0.0);
        for (seed, landscape, ceilings) in &grounds {
            for index in 0..300 {
                let part = |k: u64| unit_interval(*seed, &[index, k]);
                let [x, y] = [100.0 + 600.0 * part(0), 100.0 + 600.0 * part(1)];
                let sun = sun(360.0 * part(2), elevation);
                let edge = MAST.edge(landscape, ceilings, [x, y], sun);
                let MastEdge::Seen { distance, rise, angle } = edge else { continue };
                let expected = flat_error(MAST.top, MAST.eye, rise, distance);
                assert!((angle - expected).abs() < 1e-9, "{elevation} deg: {angle}, not {expected}");
                small += small_flat_error(MAST.top, MAST.eye, rise, distance);
                rises += rise.abs();
                errors.push(angle);
            }
        }
        let count = errors.len() as f64;
        let (mean, largest) =
            (errors.iter().sum::<f64>() / count, errors.iter().copied().fold(0.0, f64::max));
        println!(
            "{elevation} | {:.2} | {:.3} | {:.2} | {:.1} | {:.2} | {}",
            MAST.top / libm::tan(radians(elevation)),
            rises / count,
            1e3 * mean,
            1e3 * largest,
            1e3 * small / count,
            errors.len()
        );
        assert!(errors.len() > 600 && mean > 1e-3, "{mean} of {}", errors.len());
        assert!((small / count / mean - 1.0).abs() < 0.35, "small angles: {} for {mean}", small / count);
    }
}

/// The edge that pictures of true ground show lies where the formula has it.
#[test]
fn pictures_of_true_ground_show_that_error() {
    let landscape = relief(9);
    let ceilings = Ceilings::new(&landscape);
    let (size, elevation) = ([4, 6000], 20.0);
    let mut checked = 0;
    for index in 0..12 {
        let [x, y] = [150.0 + 40.0 * f64::from(index), 420.0];
        let foot = DVec3::new(x, y, landscape.height(x, y).unwrap());
        let edge = MAST.edge(&landscape, &ceilings, [x, y], sun(180.0, elevation));
        let MastEdge::Seen { distance, angle: expected, .. } = edge else { continue };
        // A wide plate whose upper edge is square to the sun, the eye over its face.
        let plate = Solid::boxed(DVec3::new(-0.001, -1.0, 0.0), DVec3::new(0.0, 1.0, MAST.top), 1.0).unwrap();
        let field = FieldOfView { tan_half_width: 0.001, tan_half_height: 0.6 };
        let attitude = Attitude::default();
        let shot = Shot {
            time: 0.0,
            eye: [x, y, foot.z + MAST.eye],
            height: MAST.eye,
            vehicle: attitude,
            camera: attitude,
            field,
        };
        let truth =
            TrueGround::new(stage(&landscape, Scenery::still(sun(180.0, elevation)), [4, 6000])).unwrap();
        let gates = truth
            .gates(&Shape::new(vec![plate], MAST.eye), &shot, &[to_sun(180.0, elevation)], &[], size)
            .suns
            .remove(0);
        let Some(first) = gates.lines.iter().position(|gate| gate.holds(0.0003)) else { continue };
        let seen = 0.6 * (2.0 * first as f64 - 6000.0) / 6000.0;
        let flat = MAST.eye / distance;
        let measured = (libm::atan(seen) - libm::atan(flat)).abs();
        assert!((measured - expected).abs() < 3e-4, "{index}: {measured}, not {expected}");
        checked += 1;
    }
    assert!(checked >= 6, "{checked}");
}

/// Ground 120 m long whose height is `height` (m) at the corners of its regions of 2 m, by their number northwards.
fn across(height: impl Fn(u64) -> f64) -> Landscape {
    let words = |index: u64| std::array::from_fn(|word| if word == 0 { height(index / 3) } else { 0.0 });
    let level = Level::new(2.0, [0.0; 2], [61, 3], (0..61 * 3).map(words).collect()).unwrap();
    Landscape::new(Bank::new("across", vec![level], None).unwrap(), 1.0)
}

/// The edge that a mast at `north` casts northwards.
fn northwards(landscape: &Landscape, north: f64, elevation: f64) -> MastEdge {
    MAST.edge(landscape, &Ceilings::new(landscape), [north, 2.0], sun(180.0, elevation))
}

/// Level ground, and a step 2 m before the mast: the rise is the step's, the error the formula's.
#[test]
fn steps_of_known_height() {
    for (height, elevation) in [(0.0, 16.7), (0.4, 16.7), (-0.4, 16.7), (1.0, 10.0), (-0.1, 30.0)] {
        let landscape = across(|corner| if corner < 21 { 0.0 } else { height });
        let edge = northwards(&landscape, 38.0, elevation);
        let MastEdge::Seen { distance, rise, angle } = edge else { panic!("{height}: {edge:?}") };
        assert!((distance - MAST.top / libm::tan(radians(elevation))).abs() < 1e-12, "{distance}");
        assert!((rise - height).abs() < 1e-12, "{height}: {rise}");
        assert!(
            (angle - flat_error(MAST.top, MAST.eye, height, distance)).abs() < 1e-12,
            "{height}: {angle}"
        );
        assert_eq!(height == 0.0, angle < 1e-12, "{height}: {angle}");
    }
}

/// A ridge before the sun, a ridge before the edge, the end of the ground, and a sun that is down.
#[test]
fn edges_that_are_not_seen() {
    let ridge = |height: f64| across(move |corner| if corner == 20 { height } else { 0.0 });
    let (high, low) = (ridge(4.0), ridge(1.5));
    // Its crest is 4 m behind the mast and 0.95 m above its top: 13.4 degrees.
    assert_eq!(northwards(&high, 44.0, 12.0), MastEdge::Dark);
    assert!(matches!(northwards(&high, 44.0, 15.0), MastEdge::Seen { .. }));
    // 6 m before the mast the line from the view port to the edge at 20 m is 1.07 m high, the ray through the top 2.13 m.
    assert_eq!(northwards(&low, 34.0, 8.67), MastEdge::Hidden);
    assert!(matches!(northwards(&low, 44.0, 8.67), MastEdge::Seen { .. }));
    for (north, elevation, expected) in
        [(-1.0, 10.0, MastEdge::OffGround), (110.0, 10.0, MastEdge::OffGround), (50.0, 0.0, MastEdge::Dark)]
    {
        assert_eq!(northwards(&low, north, elevation), expected, "{north}");
    }
}
