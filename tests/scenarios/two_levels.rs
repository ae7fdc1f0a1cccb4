//! The boundary of two levels (test 11 of the terrain builder's specification): what a switch, a blend, and a blend
//! without its slope term change there, in `two-levels-blended`.
//!
//! Pixels are taken together by their ground range, in rings of 25 m; a figure is the root mean square of a ring, in levels of 255.
//!
//! ```text
//! 300 m        450 m                875   900   925 m                  1300 m
//!   │   fine     │       blend        │  at the  │        beyond          │
//!   │            │                    │  switch  │        coarse          │
//! ```

use std::ops::Range;

use generator::PlaneKind;
use lunoid_tests::Shipped;
use lunoid_tests::shipped::Shown;
use scenario::LevelSwitch;

/// Frames from which on pairs are compared.
const PAIRS: [u64; 4] = [0, 18, 36, 54];
/// Way of the camera from frame to frame (m).
const WAY: f64 = 2.0;
/// Ground range of a ring (m).
const RING: f64 = 25.0;
/// Rings with fewer pixels say nothing.
const FEW: u32 = 100;
/// Number of sweeps a frame.
const SWEEPS: u32 = 300;
/// Where the scenario goes over; the documented rings are around it.
const BOUNDARY: LevelSwitch = LevelSwitch { range: 900.0, blend: 450.0 };

const AT_THE_SWITCH: Range<f64> = 875.0..925.0;
const BEYOND: Range<f64> = 925.0..1300.0;
const BLEND: Range<f64> = 450.0..900.0;

/// Squares of differences by ring, from 0 m on.
#[derive(Default)]
struct Rings(Vec<(f64, u32)>);

impl Rings {
    /// Adds the differences of two pictures at the ranges (m) of `judged`.
    fn add(&mut self, [one, other]: [&Shown; 2], judged: &Shown) {
        let ranges = judged.planes.get(PlaneKind::Range).expect("a plane of exact");
        let codes = one.picture.codes().iter().zip(other.picture.codes());
        for ((one, other), range) in codes.zip(ranges).filter(|(_, range)| f64::from(**range) < BEYOND.end) {
            let ring = (f64::from(*range) / RING) as usize;
            self.0.resize(self.0.len().max(ring + 1), (0.0, 0));
            let apart = f64::from(*one) - f64::from(*other);
            self.0[ring] = (self.0[ring].0 + apart * apart, self.0[ring].1 + 1);
        }
    }

    /// The largest figure of the rings that begin in `span` (m).
    fn largest(&self, span: Range<f64>) -> f64 {
        let rings = self
            .0
            .iter()
            .enumerate()
            .filter(|(ring, (_, count))| *count >= FEW && span.contains(&(*ring as f64 * RING)));
        rings.map(|(_, (sum, count))| (sum / f64::from(*count)).sqrt()).fold(0.0, f64::max)
    }
}

/// The scenario with the hardware of a designer who has, or has not, the slope term. The small craters are left out, which no level
/// holds.
fn scene(blend: f64, slope_term: bool) -> Shipped {
    let mut shipped = Shipped::changed("two-levels-blended", Some(SWEEPS), |scenario| {
        scenario.features.populations.clear();
        assert_eq!(scenario.levels, Some(BOUNDARY));
    });
    shipped.settings.levels = Some(LevelSwitch { blend, ..BOUNDARY });
    shipped.settings.analog.level_blend.slope_term = slope_term;
    shipped
}

/// What is seen of a boundary.
#[derive(Debug)]
struct Seen {
    /// Change from a frame of the drive to the next, at the switch and beyond.
    drive: [f64; 2],
    /// Change for a camera that stands while the boundary goes on by the way of a frame.
    pop: f64,
    /// Distance from `exact` in the blend, and beyond.
    off: [f64; 2],
}

impl Seen {
    fn of(shipped: &Shipped) -> Self {
        let mut nearer = shipped.clone();
        let levels = nearer.settings.levels.as_mut().expect("two levels");
        levels.range -= WAY;
        let [mut drive, mut pop, mut off] = [(); 3].map(|()| Rings::default());
        for frame in PAIRS {
            let [before, after] = [frame, frame + 1].map(|frame| shipped.machine(frame));
            let judged = shipped.exact(frame + 1);
            drive.add([&before, &after], &judged);
            pop.add([&nearer.machine(frame + 1), &after], &judged);
            off.add([&after, &judged], &judged);
        }
        Self {
            drive: [AT_THE_SWITCH, BEYOND].map(|span| drive.largest(span)),
            pop: pop.largest(0.0..BEYOND.end),
            off: [BLEND, BEYOND].map(|span| off.largest(span)),
        }
    }
}

#[test]
fn a_blend_changes_no_more_at_the_boundary_than_around_it() {
    let switching = Seen::of(&scene(0.0, true));
    let blending = Seen::of(&scene(BOUNDARY.blend, true));
    let lacking = Seen::of(&scene(BOUNDARY.blend, false));
    println!("switch {switching:.2?}\nblend {blending:.2?}\nwithout slope term {lacking:.2?}");
    assert!(switching.drive[0] > 5.0 * switching.drive[1], "{switching:?}");
    assert!(blending.drive[0] <= blending.drive[1], "{blending:?}");
    assert!(blending.pop < 0.1 * switching.pop, "{blending:?}, {switching:?}");
    assert!(lacking.off[0] > 5.0 * blending.off[0], "{lacking:?}, with its term {blending:?}");
    assert_eq!(lacking.off[1], blending.off[1], "beyond the blend nothing is lacking");
}
