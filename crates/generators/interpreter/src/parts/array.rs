//! One array along one sweep: what it is driven by, and the circuit from there on.

use landscape::Level;

use super::chain::Chain;
use super::drawn::Drawn;
use super::figures::Figures;
use super::words::Words;
use crate::ramp::Ramp;
use crate::registers::Change;
use crate::walk::Sample;

/// What an array is swept with.
#[derive(Debug, Clone, Copy)]
pub struct Sweep<'a> {
    /// Ground that the array draws.
    pub level: &'a Level,
    /// Name of the array in draws: `tg` or `mtg`.
    pub name: &'a str,
    /// What the seed drew.
    pub drawn: &'a Drawn<'a>,
    /// Cosine and sine of the azimuth.
    pub direction: [f64; 2],
    /// Ground range of the samples (m).
    pub ranges: &'a [f64],
    /// Both ramps as the sweep begins.
    pub ramps: &'a [Ramp; 2],
    /// Words in hold as the sweep begins.
    pub hold: [[f64; 9]; 4],
    /// What changes on the digital side.
    pub changes: &'a [Change],
    /// Number of the sweep over all frames.
    pub number: u64,
}

/// An array as one sweep drives it; instants are in steps from the first sample.
#[derive(Debug, Clone)]
pub struct Array {
    /// Figures of its parts.
    pub figures: Figures,
    /// Words of its D/As, and turns of the polarity.
    pub words: Words,
    /// Sample at which everything is at rest.
    pub begins: i64,
    /// Both accumulators at that sample and at all later ones.
    pub accumulators: Vec<[f64; 2]>,
    /// Corners of the triangle in each accumulator: instant and value.
    pub corners: [Vec<[f64; 2]>; 2],
    /// Polarity of both axes before any turn.
    pub polarity: [f64; 2],
    /// What the datum is trimmed by (m).
    pub trim: f64,
    /// Side of a region (m).
    pub region_size: f64,
}

impl Array {
    /// The array with these figures along a sweep of so many samples.
    pub fn of(sweep: &Sweep<'_>, figures: &Figures, samples: usize) -> Self {
        let words = Words::of(sweep, figures);
        let lead = figures.lead / figures.step;
        // The accumulators leave the eye's foot a sample before the first, and the beam is behind them.
        let begins = -(1.0 + lead).ceil() as i64;
        let mut ramps = Accumulators::new(sweep);
        let at_eye = (if figures.preset { f64::NEG_INFINITY } else { begins as f64 }, ramps.at(0.0));
        let at_foot = Chain::at_rest(sweep, figures, &words, at_eye);
        let trim = at_foot.right(&words, at_eye) - at_foot.height();
        let range = |sample: i64| accumulated(sweep.ranges, sample as f64 + lead, figures.preset);
        let accumulators: Vec<_> = (begins..samples as i64).map(|sample| ramps.at(range(sample))).collect();
        let corners = [0, 1].map(|axis| corners(sweep, figures, axis, &accumulators));
        Self {
            figures: figures.clone(),
            words,
            begins,
            corners,
            accumulators,
            polarity: sweep.ramps.each_ref().map(|ramp| ramp.polarity),
            trim,
            region_size: sweep.level.region_size(),
        }
    }

    /// Puts what the parts make of the sweep into `samples`, which have what ideal parts make of it: `between` of them from one
    /// step of the array to the next.
    pub fn pass(&self, sweep: &Sweep<'_>, between: usize, samples: &mut [Sample]) {
        let Some(&first) = self.accumulators.first() else { return };
        let mut chain = Chain::at_rest(sweep, &self.figures, &self.words, (self.begins as f64, first));
        let mut ramps = Accumulators::new(sweep);
        for (number, pair) in (self.begins + 1..).zip(self.accumulators.windows(2)) {
            let before = (between > 1).then(|| chain.clone());
            chain.step(number, pair[0], pair[1]);
            for step in 1..=between as i64 {
                let place = (number - 1) * between as i64 + step;
                let Some(sample) = usize::try_from(place).ok().and_then(|place| samples.get_mut(place))
                else {
                    continue;
                };
                let share = step as f64 / between as f64;
                let at = number as f64 - 1.0 + share;
                let triangle = ramps.at(self.range(sweep, at));
                match before.as_ref().filter(|_| step < between as i64) {
                    Some(before) => {
                        before.towards(&chain, number, share).put(at, self.trim, triangle, sample)
                    }
                    None => chain.put(at, self.trim, triangle, sample),
                }
            }
        }
    }

    /// Ground range in the accumulators as the beam is at an instant (steps).
    fn range(&self, sweep: &Sweep<'_>, at: f64) -> f64 {
        accumulated(sweep.ranges, at + self.figures.lead / self.figures.step, self.figures.preset)
    }
}

/// Ground range in the accumulators, as time goes for them (steps).
fn accumulated(ranges: &[f64], time: f64, preset: bool) -> f64 {
    let time = if preset { time.max(0.0) } else { time };
    if time <= 0.0 {
        return ranges[0] * (1.0 + time).max(0.0);
    }
    let before = (time.floor() as usize).min(ranges.len() - 2);
    ranges[before] + (ranges[before + 1] - ranges[before]) * (time - before as f64)
}

/// Corners of the triangle of an axis: the range programme bends at its samples, and the ramp folds between them. The first is that
/// of rest, where `accumulators` begin.
fn corners(sweep: &Sweep<'_>, figures: &Figures, axis: usize, accumulators: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let lead = figures.lead / figures.step;
    let begins = -(1.0 + lead).ceil();
    let end = begins + accumulators.len() as f64;
    let leaves = if figures.preset { 0.0 } else { -1.0 };
    let mut ramps = Accumulators::new(sweep);
    let mut bend = |time: f64| ramps.at(accumulated(sweep.ranges, time, figures.preset))[axis];
    // The accumulators are ahead of the beam: behind the last sample they go on at its rate.
    let last = sweep.ranges.len() as i64 + lead.ceil() as i64;
    let bends = (-1..=last).map(|sample| (sample as f64, None));
    let folds = sweep.changes.iter().filter_map(|change| {
        let (_, at_one) = change.fold.filter(|(folded, _)| *folded == axis)?;
        Some((change.time, Some(if at_one { 1.0 } else { 0.0 })))
    });
    let mut points: Vec<(f64, Option<f64>)> =
        bends.chain(folds).filter(|(time, _)| *time >= leaves).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let moves = points.into_iter().map(|(time, fold)| [time - lead, fold.unwrap_or_else(|| bend(time))]);
    let rest = [begins, accumulators[0][axis]];
    [rest].into_iter().chain(moves.filter(|[at, _]| *at > begins && *at <= end)).collect()
}

/// The triangle in both accumulators, up to the last fold of the sweep; then they stop.
struct Accumulators {
    ramps: [Ramp; 2],
    folds: [usize; 2],
}

impl Accumulators {
    fn new(sweep: &Sweep<'_>) -> Self {
        let of_axis = |axis: usize| {
            let folds = sweep.changes.iter().filter_map(|change| change.fold);
            folds.filter(|(folded, _)| *folded == axis).count()
        };
        Self { ramps: sweep.ramps.clone(), folds: [0, 1].map(of_axis) }
    }

    fn at(&mut self, range: f64) -> [f64; 2] {
        let Self { ramps, folds } = self;
        std::array::from_fn(|axis| {
            while folds[axis] > 0 && ramps[axis].stop() <= range {
                ramps[axis].fold();
                folds[axis] -= 1;
            }
            ramps[axis].value(range).clamp(0.0, 1.0)
        })
    }
}
