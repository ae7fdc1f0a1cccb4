//! The boundary of two levels (specification of the terrain builder, sections 7 and 11, test 11): what a switch, a blend, and a blend
//! without its slope term change there, in `two-levels-blended`.
//!
//! Pixels are taken together by their ground range, in rings of 25 m. A ring lies at the boundary if the blend reaches into it, or the
//! switch falls into it; the others are its surroundings.

use generator::PlaneKind;
use lunoid_tests::Shipped;
use lunoid_tests::shipped::Shown;
use scenario::LevelSwitch;

/// Frames from which on pairs are compared; frames are 2 m of way apart.
const PAIRS: [u64; 4] = [0, 18, 36, 54];
/// Ground range of a ring (m), and of all that is looked at.
const RING: f64 = 25.0;
const LOOKED_AT: [f64; 2] = [300.0, 1300.0];
/// Sweeps a frame.
const SWEEPS: u32 = 300;

/// Largest root mean square of a ring, in levels of 255.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Largest {
    at_boundary: f64,
    around: f64,
}

/// Squares of differences by ring.
#[derive(Default)]
struct Rings(Vec<(f64, u32)>);

impl Rings {
    /// Adds the differences of two pictures at the ranges (m) of `judged`.
    fn add(&mut self, [one, other]: [&Shown; 2], judged: &Shown) {
        let ranges = judged.planes.get(PlaneKind::Range).expect("a plane of exact");
        let codes = one.picture.codes().iter().zip(other.picture.codes());
        for ((one, other), range) in codes.zip(ranges) {
            let ring = ((f64::from(*range) - LOOKED_AT[0]) / RING).floor();
            if ring < 0.0 || f64::from(*range) >= LOOKED_AT[1] {
                continue;
            }
            let ring = ring as usize;
            self.0.resize(self.0.len().max(ring + 1), (0.0, 0));
            let apart = f64::from(*one) - f64::from(*other);
            self.0[ring] = (self.0[ring].0 + apart * apart, self.0[ring].1 + 1);
        }
    }

    fn largest(&self, switch: LevelSwitch) -> Largest {
        let mut found = Largest { at_boundary: 0.0, around: 0.0 };
        for (ring, (sum, count)) in self.0.iter().enumerate().filter(|(_, ring)| ring.1 > 100) {
            let begin = LOOKED_AT[0] + ring as f64 * RING;
            let is_at = begin + RING > switch.range - switch.blend && begin <= switch.range;
            let side = if is_at { &mut found.at_boundary } else { &mut found.around };
            *side = side.max((sum / f64::from(*count)).sqrt());
        }
        found
    }
}

/// The scenario with the hardware of a designer who has, or has not, the slope term.
fn scene(blends: bool, slope_term: bool) -> Shipped {
    let mut shipped = Shipped::changed("two-levels-blended", Some(SWEEPS), |scenario| {
        let levels = scenario.levels.as_mut().expect("two levels");
        levels.blend = if blends { levels.blend } else { 0.0 };
    });
    shipped.settings.analog.level_blend.slope_term = slope_term;
    shipped
}

/// The boundary of the scenario as it ships.
fn boundary() -> LevelSwitch {
    scene(true, true).settings.levels.expect("two levels")
}

/// Largest change from a frame to the next, and largest distance from the frames of `exact`.
fn measured(shipped: &Shipped) -> [Largest; 2] {
    let [mut changes, mut errors] = [Rings::default(), Rings::default()];
    for frame in PAIRS {
        let [before, after] = [frame, frame + 1].map(|frame| shipped.machine(frame));
        let judged = shipped.exact(frame + 1);
        changes.add([&before, &after], &judged);
        errors.add([&after, &judged], &judged);
    }
    [changes, errors].map(|rings| rings.largest(boundary()))
}

#[test]
fn a_blend_changes_no_more_at_the_boundary_than_around_it() {
    let [switching, judged_switch] = measured(&scene(false, true));
    let [blending, judged] = measured(&scene(true, true));
    let [lacking, stripe] = measured(&scene(true, false));
    println!("change of a frame: switch {switching:?}, blend {blending:?}, without slope term {lacking:?}");
    println!("distance from exact: switch {judged_switch:?}, blend {judged:?}, without slope term {stripe:?}");
    assert!(switching.at_boundary > 2.0 * switching.around, "{switching:?}");
    assert!(blending.at_boundary <= blending.around, "{blending:?}");
    assert!(stripe.at_boundary > 3.0 * judged.at_boundary, "{stripe:?}, with its term {judged:?}");
    assert_eq!(stripe.around, judged.around, "beyond the blend nothing is lacking");
}
