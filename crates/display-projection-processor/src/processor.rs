//! Elevation, occlusion and deflection of a group of sweeps.

use landscape::parabolic_drop;
use scenario::{Curvature, Occlusion};
use signal::{LANES, Lanes, Real, Signal, Unit};

use crate::Deflection;

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground("dpp.elevation", Unit::Tangent, "tangent of the elevation of the profile (fig. 30)"),
    Signal::ground("dpp.blank", Unit::Gate, "1 while the profile is hidden by nearer ground (fig. 30)"),
    Signal::ground("dpp.hold", Unit::Tangent, "highest elevation so far: what the sample-and-hold keeps"),
    Signal::ground("dpp.y", Unit::Line, "line position of the write beam, from the top (fig. 30)"),
];

/// What the block is set to for a run: tables over the sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Processor<S> {
    occlusion: Occlusion,
    inverse_range: Vec<S>,
    drop: Vec<S>,
}

/// Outputs of a group: one [`Lanes`] a sample.
#[derive(Debug, Clone, Default)]
pub struct Projected<S> {
    /// Tangent of the elevation.
    pub elevation: Vec<Lanes<S>>,
    /// Highest tangent so far, tops between samples included.
    pub hold: Vec<Lanes<S>>,
    /// Part of the step from the sample before, 0..=1, at which the profile comes back into sight; 0 if it was.
    pub entry: Vec<Lanes<S>>,
    /// Line position of the elevation itself, in sight or not, from the top of the picture.
    pub position: Vec<Lanes<S>>,
    /// Line position of the held elevation: never grows.
    pub line: Vec<Lanes<S>>,
}

impl<S: Real> Processor<S> {
    /// A processor for samples at `ranges` (m, ascending, above 0).
    pub fn new(occlusion: Occlusion, curvature: Curvature, ranges: &[f64]) -> Self {
        let drop = |range: f64| match curvature {
            Curvature::None => 0.0,
            Curvature::Parabolic => parabolic_drop(range),
        };
        Self {
            occlusion,
            inverse_range: ranges.iter().map(|&range| S::from_f64(1.0 / range)).collect(),
            drop: ranges.iter().map(|&range| S::from_f64(drop(range))).collect(),
        }
    }

    /// Projects the profiles of a group; `height` is above the eye (m), `deflection` in lines.
    pub fn run(&self, height: &[Lanes<S>], deflection: &[Deflection; LANES], out: &mut Projected<S>) {
        let Projected { elevation, hold, entry, position, line } = out;
        for signal in [elevation, hold, entry, position, line] {
            signal.resize(height.len(), Lanes::default());
        }
        self.elevate(height, &mut out.elevation);
        match self.occlusion {
            Occlusion::PeakHold => occlude(out, peak_hold),
            Occlusion::Derivative => occlude(out, derivative),
        }
        deflect(deflection, &out.elevation, &mut out.position);
        deflect(deflection, &out.hold, &mut out.line);
    }

    fn elevate(&self, height: &[Lanes<S>], elevation: &mut [Lanes<S>]) {
        let tables = self.drop.iter().zip(&self.inverse_range);
        for ((elevation, &height), (&drop, &inverse)) in elevation.iter_mut().zip(height).zip(tables) {
            *elevation = (height - Lanes::splat(drop)) * Lanes::splat(inverse);
        }
    }
}

/// One step of an occlusion circuit: elevation before and now, held value before; held value now.
fn peak_hold<S: Real>(_before: S, hold: S, now: S) -> S {
    now.at_least(hold)
}

/// As reported: while unblanked the hold follows the elevation; a fall of it blanks and holds.
fn derivative<S: Real>(before: S, hold: S, now: S) -> S {
    let blanked = before < hold;
    let stays_blanked = if blanked { now < hold } else { now < before };
    if stays_blanked { hold } else { now }
}

fn occlude<S: Real>(out: &mut Projected<S>, step: impl Fn(S, S, S) -> S) {
    let Some(&first) = out.elevation.first() else { return };
    let (mut below, mut before, mut hold) = (first, first, first);
    // Beyond the last sample the profile is taken to rise: no top there.
    let beyond = Lanes::splat(S::from_f64(f64::INFINITY));
    let after = out.elevation.iter().skip(1).chain(std::iter::once(&beyond));
    let outputs = out.hold.iter_mut().zip(&mut out.entry);
    for ((&now, &after), (held, entry)) in out.elevation.iter().zip(after).zip(outputs) {
        let top = Lanes::from_fn(|lane| top_of(below[lane], now[lane], after[lane]));
        *entry = Lanes::from_fn(|lane| entry_of(below[lane], hold[lane], now[lane], top[lane]));
        hold = Lanes::from_fn(|lane| step(before[lane], hold[lane], top[lane]));
        *held = hold;
        (below, before) = (now, top);
    }
}

/// A fall to the next sample by more than this (tangent) is taken for the end of the profile, not its shape.
const CLIFF: f64 = 0.25;

/// What the circuit sees around a sample: its elevation, or the top of the parabola through it and its neighbours
/// where it is the highest of the three. The derivative changes sign there, between two samples.
#[inline(always)]
fn top_of<S: Real>(below: S, now: S, after: S) -> S {
    let (rise, fall) = (now - below, now - after);
    let skew = rise - fall;
    let top = now + skew * skew / (S::from_f64(8.0) * (rise + fall));
    if rise > S::ZERO && fall >= S::ZERO && fall < S::from_f64(CLIFF) { top } else { now }
}

/// Where in the step to a sample the elevation rises through the held one; 1 if only the top beyond it does.
#[inline(always)]
fn entry_of<S: Real>(before: S, hold: S, now: S, top: S) -> S {
    let share = (hold - before) / (now - before);
    match (before < hold, now > hold) {
        (true, true) => share,
        (true, false) if top > hold => S::ONE,
        _ => S::ZERO,
    }
}

fn deflect<S: Real>(deflection: &[Deflection; LANES], tangents: &[Lanes<S>], lines: &mut [Lanes<S>]) {
    let lanes = |part: fn(&Deflection) -> f64| Lanes::from_fn(|lane| S::from_f64(part(&deflection[lane])));
    let (a, b, c, e) = (lanes(|d| d.a), lanes(|d| d.b), lanes(|d| d.c), lanes(|d| d.e));
    for (line, &tangent) in lines.iter_mut().zip(tangents) {
        *line = (a - b * tangent) / (c + e * tangent);
    }
}

#[cfg(test)]
mod tests {
    use super::{Processor, Projected};
    use crate::Deflection;
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};
    use scenario::{Curvature, Occlusion, Projection};
    use signal::{LANES, Lanes};

    fn project(occlusion: Occlusion, heights: &[f64], ranges: &[f64]) -> Projected<f64> {
        let processor = Processor::new(occlusion, Curvature::None, ranges);
        let height: Vec<_> = heights.iter().map(|&height| Lanes::splat(height)).collect();
        let level = Deflection::new(Projection::Exact, 0.0, 0.0).in_lines(575.0, 0.268);
        let mut out = Projected::default();
        processor.run(&height, &[level; LANES], &mut out);
        out
    }

    fn bowl(range: f64) -> f64 {
        // Type 1 crater, r1 = 10, a = 2, near rim at 50, seen from H = 1.63.
        let rho = range - 60.0;
        let depth = if rho.abs() < 10.0 { 2.0 * (rho * rho / 100.0 - 1.0) } else { 0.0 };
        depth - 1.63
    }

    #[test]
    fn a_crater_is_hidden_by_its_near_rim_until_the_closed_form_says() {
        // Section 15.2: hidden from z1 to z1 + r1 + r1 (1 - r1 H / (a z1)) = 68.37.
        let ranges: Vec<f64> = (0..40_001).map(|k| 40.0 + 0.001 * f64::from(k)).collect();
        let heights: Vec<f64> = ranges.iter().map(|&range| bowl(range)).collect();
        for occlusion in [Occlusion::PeakHold, Occlusion::Derivative] {
            let out = project(occlusion, &heights, &ranges);
            let hidden = |k: usize| out.elevation[k][0] < out.hold[k][0];
            let first = (0..ranges.len()).find(|&k| hidden(k)).unwrap();
            let last = (0..ranges.len()).rfind(|&k| hidden(k)).unwrap();
            assert!((ranges[first] - 50.0).abs() < 0.0015, "{}", ranges[first]);
            // The rim is a kink: its top is known to a part of a sample.
            assert!((ranges[last] + 0.001 * out.entry[last + 1][0] - 68.37).abs() < 5e-4);
        }
    }

    #[test]
    fn the_top_of_a_hill_lies_between_samples() {
        // tan eta = 0.1 - (z - z0)^2 / 1000, sampled every metre: the top is held wherever it falls.
        for shift in [0.0, 0.2, 0.5, 0.9] {
            let ranges: Vec<f64> = (0..20).map(|k| 100.0 + f64::from(k)).collect();
            let hill = |range: f64| {
                let off = range - 110.0 - shift;
                (0.1 - off * off / 1000.0) * range
            };
            let heights: Vec<f64> = ranges.iter().map(|&range| hill(range)).collect();
            for occlusion in [Occlusion::PeakHold, Occlusion::Derivative] {
                let out = project(occlusion, &heights, &ranges);
                assert!((out.hold[19][0] - 0.1).abs() < 1e-12, "{shift}: {}", out.hold[19][0]);
            }
        }
    }

    #[test]
    fn check_table_23_5_elevations() {
        let out = project(Occlusion::PeakHold, &[-1.63, 0.87], &[6.0, 100.0]);
        assert!((out.elevation[0][0] + 0.27166666666666667).abs() < 1e-15);
        assert!((out.elevation[1][0] - 0.0087).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn both_circuits_hide_the_same_ground(heights in proptest::collection::vec(-30.0..30.0f64, 2..200)) {
            let ranges: Vec<f64> = (0..heights.len()).map(|k| 5.0 + 3.0 * k as f64).collect();
            let peak = project(Occlusion::PeakHold, &heights, &ranges);
            let reported = project(Occlusion::Derivative, &heights, &ranges);
            prop_assert_eq!(&peak.hold, &reported.hold);
            prop_assert_eq!(&peak.entry, &reported.entry);
            prop_assert!(peak.line.windows(2).all(|pair| pair[1][0] <= pair[0][0]));
            prop_assert!(peak.entry.iter().all(|entry| (0.0..=1.0).contains(&entry[0])));
        }
    }
}
