//! Moments: instants at which a clause is met.

use signal::Kind;

use crate::condition::{Per, Test};
use crate::states::runs;
use crate::sweep::{Points, Sweep, sample_of};

/// An instant and the sample that sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    pub time: f64,
    pub sample: usize,
}

impl Moment {
    fn at(time: f64) -> Self {
        Self { time, sample: sample_of(time) }
    }
}

/// A test that did not pass passes.
pub fn becomes(points: &Points<'_>, test: &Test) -> Vec<Moment> {
    let begun = runs(points, points.values(), test).into_iter().filter(|run| run.from > 0);
    begun.map(|run| Moment { time: run.begin, sample: points.sample(run.from) }).collect()
}

/// The value comes to `level`, having been more than `by` away.
pub fn edges(points: &Points<'_>, rising: bool, level: f64, by: f64) -> Vec<Moment> {
    let values = points.values();
    // A falling edge is the rising one of the mirrored signal.
    let mirrored = |value: f64| if rising { value } else { -value };
    let level = mirrored(level);
    let (mut is_armed, mut found) = (false, Vec::new());
    for (index, value) in values.iter().map(|&value| mirrored(value)).enumerate() {
        if is_armed && value >= level {
            let time = match index.checked_sub(1).map(|before| mirrored(values[before])) {
                Some(before) if points.is_curve() => index as f64 - (value - level) / (value - before),
                _ => points.time(index),
            };
            found.push(Moment { time, sample: points.sample(index) });
        }
        is_armed = value < level && (is_armed || value < level - by || by == 0.0);
    }
    found
}

/// A gate was high for less than a width, or has been for more.
pub fn pulses(sweep: &Sweep<'_>, points: &Points<'_>, longer: bool, width: f64, per: Per) -> Vec<Moment> {
    let values = points.values();
    let last = sweep.samples.saturating_sub(1) as f64;
    let mut found = Vec::new();
    for run in runs(points, values, &Test::Above(0.5)) {
        let has_end = run.until < values.len();
        let end = if has_end { points.time(run.until) } else { last };
        let over = sweep.after(points.time(run.from), width, per);
        let is_longer = over.is_some_and(|over| end > over);
        match (longer, over) {
            (true, Some(over)) if is_longer => found.push(Moment::at(over)),
            (false, over) if run.from > 0 && has_end && over.is_none_or(|over| end < over) => {
                found.push(Moment::at(end));
            }
            _ => {}
        }
    }
    found
}

/// Events of one signal, with a value that passes.
pub fn events(points: &Points<'_>, test: Option<&Test>) -> Vec<Moment> {
    debug_assert_eq!(points.waveform.signal.kind, Kind::Event);
    let passes = |index: &usize| test.is_none_or(|test| test.holds(points.values()[*index]));
    (0..points.values().len()).filter(passes).map(|index| Moment::at(points.time(index))).collect()
}
