//! What multiplying D/As take, and when; and when the polarity turns.

use std::collections::BTreeSet;

use super::array::Sweep;
use super::figures::{Figures, PEAKS, StopFigures, TERMS};
use super::ramp::carry;
use crate::registers::Change;

/// What lies before the first range has acted in retrace, if the accumulators are preset to it.
const IN_RETRACE: f64 = -1e12;
/// Nearer to a sample than this (steps) is on it.
const TIE: f64 = 1e-9;
/// A ramp flatter than this counts as one of this slope (full scales a second).
const FLATTEST: f64 = 1e3;

/// A word that a D/A takes.
#[derive(Debug, Clone, Copy)]
pub struct Taken {
    /// When, in steps from the first sample.
    pub at: f64,
    /// What the D/A multiplies by from then on.
    pub weight: f64,
    /// Area of its pulse for a product of full scale (seconds).
    pub pulse: f64,
}

/// Words of all D/As and turns of the polarity over a sweep.
#[derive(Debug, Clone)]
pub struct Words {
    /// By sum and term, in order of time; the first is there from the beginning.
    pub taken: [Vec<Vec<Taken>>; 3],
    /// When the polarity of an axis turns, in steps from the first sample.
    pub turns: Vec<(f64, usize)>,
    /// Samples that a word or a turn falls on: rounding says which step has it.
    pub ties: BTreeSet<i64>,
    /// Words in hold, and when a nominal D/A has them.
    pub held: Vec<(f64, [[f64; 9]; 4])>,
}

impl Words {
    /// Of a sweep of the array with these figures.
    pub fn of(sweep: &Sweep<'_>, figures: &Figures) -> Self {
        let (mut turns, mut held) = (Vec::new(), vec![(f64::NEG_INFINITY, sweep.hold)]);
        let (mut last, mut turned) = (f64::NEG_INFINITY, [f64::NEG_INFINITY; 2]);
        for change in sweep.changes {
            let at = acts(change, figures.to_words, sweep, figures).max(last);
            last = at;
            held.push((at, change.hold));
            if let Some((axis, _)) = change.fold {
                turned[axis] = acts(change, figures.to_polarity, sweep, figures).max(turned[axis]);
                turns.push((turned[axis], axis));
            }
        }
        // An axis waits for its own turn before, not for the other's, and not for words.
        turns.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let of_term = |sum: usize, term: usize| taken(&held, figures, sum, term);
        let taken: [Vec<Vec<Taken>>; 3] =
            [0, 1, 2].map(|sum| (0..TERMS).map(|term| of_term(sum, term)).collect());
        let words = taken.iter().flatten().flatten().map(|word| word.at);
        let instants = words.chain(turns.iter().map(|(at, _)| *at)).filter(|at| at.is_finite());
        let ties = instants.filter(|at| (at - at.round()).abs() < TIE).map(|at| at.round() as i64).collect();
        Self { taken, turns, ties, held }
    }
}

/// When something acts on the wires that comes `delay` seconds down the chain from the accumulator.
fn acts(change: &Change, delay: f64, sweep: &Sweep<'_>, figures: &Figures) -> f64 {
    if figures.preset && change.time <= 0.0 {
        return IN_RETRACE;
    }
    let delay = match (&figures.stops, change.fold) {
        (Some(stops), Some((axis, at_one))) => {
            let found = stops[2 * axis + usize::from(at_one)].found(slope(sweep, figures, axis, change.time));
            delay + found - figures.found
        }
        _ => delay,
    };
    change.time - (figures.lead - delay) / figures.step
}

/// How steep the ramp of an axis is at an instant (full scales a second).
fn slope(sweep: &Sweep<'_>, figures: &Figures, axis: usize, time: f64) -> f64 {
    let ranges = sweep.ranges;
    let pace = if time <= 0.0 {
        ranges[0]
    } else {
        let before = (time.floor() as usize).min(ranges.len() - 2);
        ranges[before + 1] - ranges[before]
    };
    sweep.direction[axis].abs() * pace / sweep.level.region_size() / figures.step
}

impl StopFigures {
    /// From the accumulator to the comparator's output on a ramp of `slope` (full scales a second), in seconds.
    fn found(&self, slope: f64) -> f64 {
        let slope = slope.max(FLATTEST);
        let [delay, charge] = self.delay;
        let overdrive = (2.0 * charge / slope).sqrt().min(self.longest - delay);
        self.ramp + delay + overdrive + self.outwards / slope
    }
}

/// What the D/A of a term takes over a sweep.
fn taken(held: &[(f64, [[f64; 9]; 4])], figures: &Figures, sum: usize, term: usize) -> Vec<Taken> {
    let cell = &figures.cells[sum][term];
    let [p, q] = [term / 6, term % 6];
    let (colour, order) = (p / 3 + 2 * (q / 3), [p % 3, q % 3]);
    let word = 3 * order[0] + order[1];
    let mut all: Vec<Taken> = Vec::new();
    let mut before: Option<(f64, i64)> = None;
    for (at, hold) in held {
        let value = hold[colour][word];
        if before.is_some_and(|(last, _)| last == value) {
            continue;
        }
        let (number, share) = coded(value, order, figures);
        let pulse = before.zip(figures.word_bits).map_or(0.0, |((_, from), bits)| {
            // Carries are those of offset binary.
            let offset = |number: i64| (number + (1 << (bits - 1))) as u32;
            figures.word_glitch * carry(offset(from), offset(number), bits)
        });
        all.push(Taken { at: at + cell.later / figures.step, weight: share * cell.factor, pulse });
        before = Some((value, number));
    }
    all
}

/// A word's number in its D/A (0 where it takes any), and its share of full scale there.
fn coded(word: f64, [p, q]: [usize; 2], figures: &Figures) -> (i64, f64) {
    let above = if p + q == 0 { figures.scales.datum } else { 0.0 };
    let share = (word - above) * PEAKS[p] * PEAKS[q] / figures.scales.height;
    let Some(bits) = figures.word_bits else { return (0, share) };
    let half = f64::from(1_u32 << (bits - 1));
    let number = (share * half + 0.5).floor().clamp(-half, half - 1.0);
    (number as i64, number / half)
}
