//! What stands on a wire at each sample, for files that have a value a sample.

use signal::{Axis, Kind, Waveform};

/// Fills `out` with the value at each of `samples` samples: of the display axis the line that is there, of a wire told
/// when it changes what it holds.
pub fn hold(waveform: &Waveform, samples: usize, out: &mut Vec<f64>) {
    out.clear();
    let values = &waveform.values;
    match waveform.signal.axis {
        Axis::Ground | Axis::Line => out.extend_from_slice(values),
        Axis::Display => out.extend((0..samples).map(|sample| values[sample * values.len() / samples])),
        Axis::Changes => hold_changes(waveform, samples, out),
    }
}

fn hold_changes(waveform: &Waveform, samples: usize, out: &mut Vec<f64>) {
    let mut told = waveform.times.iter().zip(&waveform.values).peekable();
    let mut held = 0.0;
    for sample in 0..samples {
        while let Some((_, value)) = told.next_if(|(time, _)| **time <= sample as f64) {
            held = *value;
        }
        out.push(held);
    }
}

/// Fills `out` with what an event told at the sample that first sees it, the last sample if it comes after all; of
/// several at a sample the last.
pub fn pulses(waveform: &Waveform, samples: usize, out: &mut Vec<Option<f64>>) {
    debug_assert_eq!(waveform.signal.kind, Kind::Event);
    out.clear();
    out.resize(samples, None);
    for (time, value) in waveform.times.iter().zip(&waveform.values) {
        // The cast takes what is before the first sample to it.
        if let Some(last) = samples.checked_sub(1) {
            out[(time.ceil() as usize).min(last)] = Some(*value);
        }
    }
}
