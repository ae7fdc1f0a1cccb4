//! One wire: what the machine has at samples, and what the second engine has at every step.

use signal::{Axis, Unit, Waveform};

/// The waveform at `steps` a sample: `own` is the second engine's, as far as it goes. Without it an analog wire goes straight.
pub fn merged(wave: Waveform, own: Option<&[f64]>, steps: usize) -> Waveform {
    let Waveform { signal, times, values, .. } = wave;
    let times = times.into_iter().map(|time| time * steps as f64).collect();
    let values = match signal.axis {
        Axis::Ground => between(&values, own.unwrap_or(&[]), steps, signal.unit == Unit::Gate),
        Axis::Display | Axis::Changes | Axis::Line => values,
    };
    Waveform { times, values, ..wave }
}

fn between(samples: &[f64], own: &[f64], steps: usize, is_gate: bool) -> Vec<f64> {
    let value = |place: usize| {
        let (sample, step) = (place / steps, place % steps);
        let from = samples[sample];
        let Some(&to) = samples.get(sample + 1).filter(|_| step > 0) else { return from };
        let straight = |from: f64, to: f64| from + (to - from) * (step as f64 / steps as f64);
        match (own.get(place).zip(own.get((sample + 1) * steps)), is_gate) {
            (Some((there, _)), true) => *there,
            (Some((there, end)), false) => there + straight(from - own[sample * steps], to - end),
            (None, true) => from,
            (None, false) => straight(from, to),
        }
    };
    (0..samples.len().saturating_sub(1) * steps + samples.len().min(1)).map(value).collect()
}
