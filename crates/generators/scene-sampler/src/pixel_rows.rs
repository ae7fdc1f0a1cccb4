//! Waveforms along rows of the picture: a row stands for a sweep, its pixels for samples.

use generator::{Along, Scan};
use quantities::Timebase;
use scenario::View;
use signal::{Probe, Signal, Waveform};

/// How such signals run: row by row from the top. `place` is the signal that counts the pixels of a row.
pub fn pixel_scan(view: &View, place: &'static str) -> Option<Scan> {
    let timebase = Timebase::new(view.update, view.update, view.lines, view.columns, 0).ok()?;
    Some(Scan { line: "row", timebase, place, along: Along::Raster })
}

/// Records those of `signals` that `probe` wants, along the rows that it wants. `sample` tells what pixel `[column, line]` shows, `value` what a
/// signal has of that; the signal `place` has the pixel's column.
pub fn record_pixel_rows<S>(
    (frame, view): (u64, &View),
    signals: impl Iterator<Item = &'static Signal> + Clone,
    place: &str,
    probe: &mut Probe,
    sample: impl Fn([usize; 2]) -> S,
    value: impl Fn(&S, &str) -> f64,
) {
    for line in (0..view.lines).filter(|line| probe.wants_sweep(*line)).collect::<Vec<_>>() {
        let samples: Vec<S> =
            (0..view.columns as usize).map(|column| sample([column, line as usize])).collect();
        for signal in signals.clone().copied() {
            if probe.wants(&signal) {
                let of = |(column, sample): (usize, &S)| match signal.name == place {
                    true => column as f64,
                    false => value(sample, signal.name),
                };
                let values = samples.iter().enumerate().map(of).collect();
                probe.waveforms.push(Waveform { signal, frame, sweep: line, times: Vec::new(), values });
            }
        }
    }
}
