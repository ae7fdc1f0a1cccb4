//! What is said before the first sweep, and one sweep.

use std::ops::Range;
use std::path::Path;

use quantities::Timebase;
use signal::{Axis, Kind, Signal, Waveform, Wire};

use crate::WaveformError;

/// What a file of waveforms is about.
#[derive(Debug, Clone, PartialEq)]
pub struct Header {
    /// What is shown, in a line.
    pub title: String,
    /// Where it comes from: keys and words, in the order in which they are told.
    pub provenance: Vec<(String, String)>,
    /// The wires that are written, in their order.
    pub wires: Vec<Wire>,
    /// Clocks: period and number of samples, retrace, sweeps a frame, all exact.
    pub timebase: Timebase,
    /// Lines of the display axis.
    pub lines: u32,
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// The sweeps, which come in this order.
    pub sweeps: Range<u32>,
}

/// One sweep: a waveform a wire of the header, in its order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepTraces<'a> {
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// Sweep of the frame.
    pub sweep: u32,
    /// Waveforms of the sweep, one for each wire.
    pub waveforms: &'a [Waveform],
}

impl Header {
    /// Samples that are drawn in a sweep.
    pub(crate) fn samples(&self) -> usize {
        self.timebase.active_samples as usize
    }

    /// What one sweep of the file is called: a line, if it is one of the read beam.
    pub(crate) fn row_name(&self) -> &'static str {
        let of_lines = self.wires.iter().all(|wire| wire.signal.axis == Axis::Line);
        if of_lines { "line" } else { "sweep" }
    }

    /// How many sweeps there are.
    pub(crate) fn count(&self) -> u32 {
        self.sweeps.end - self.sweeps.start
    }

    /// Instant of a line of the display axis, in samples from the start of its sweep.
    pub(crate) fn line_instant(&self, line: usize) -> f64 {
        line as f64 * self.samples() as f64 / f64::from(self.lines)
    }

    /// Sees that `traces` is sweep `next` of this header, and that every number in it is one.
    pub(crate) fn check(
        &self,
        path: &Path,
        next: u32,
        traces: &SweepTraces<'_>,
    ) -> Result<(), WaveformError> {
        let wrong = |found: String, expected: String| {
            Err(WaveformError::Sweep { path: path.to_owned(), sweep: traces.sweep, found, expected })
        };
        if (traces.frame, traces.sweep) != (self.frame, next) || next >= self.sweeps.end {
            let found = format!("frame {}, sweep {}", traces.frame, traces.sweep);
            return wrong(found, format!("frame {}, sweep {next} of {:?}", self.frame, self.sweeps));
        }
        let names = |signals: &mut dyn Iterator<Item = &'static str>| signals.collect::<Vec<_>>().join(", ");
        if !traces.waveforms.iter().map(|waveform| waveform.signal).eq(self.signals()) {
            let found = names(&mut traces.waveforms.iter().map(|waveform| waveform.signal.name));
            return wrong(found, names(&mut self.signals().map(|signal| signal.name)));
        }
        for waveform in traces.waveforms {
            let (found, expected) = self.lengths(waveform);
            if found != expected {
                let of = |[times, values]: [usize; 2]| {
                    format!("{values} values at {times} instants of {}", waveform.signal.name)
                };
                return wrong(of(found), of(expected));
            }
            expect_finite(path, waveform)?;
        }
        Ok(())
    }

    fn signals(&self) -> impl Iterator<Item = Signal> + '_ {
        self.wires.iter().map(|wire| wire.signal)
    }

    /// Instants and values that a waveform has, and that it should have.
    fn lengths(&self, waveform: &Waveform) -> ([usize; 2], [usize; 2]) {
        let found = [waveform.times.len(), waveform.values.len()];
        let expected = match waveform.signal.axis {
            Axis::Ground | Axis::Line => [0, self.samples()],
            Axis::Display => [0, self.lines as usize],
            Axis::Changes => [found[0], found[0]],
        };
        (found, expected)
    }
}

fn expect_finite(path: &Path, waveform: &Waveform) -> Result<(), WaveformError> {
    let all = || waveform.values.iter().chain(&waveform.times).copied();
    match all().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(WaveformError::NotFinite {
            path: path.to_owned(),
            signal: waveform.signal.name,
            sweep: waveform.sweep,
            index,
            value: all().nth(index).unwrap_or(f64::NAN),
        }),
    }
}

/// How a wire is written where there are numbers, bits and pulses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// A real number (64-bit floating point).
    Real,
    /// One bit: low or high.
    Bit,
    /// A whole number, 32 bits, two's complement.
    Word,
    /// A pulse, with a number.
    Pulse,
}

impl Form {
    /// The form of a signal. A gate of the display axis is a share of its line where the pixel rule takes means.
    pub fn of(signal: &Signal) -> Self {
        match (signal.kind, signal.axis) {
            (Kind::Analog, _) | (Kind::Gate, Axis::Display) => Self::Real,
            (Kind::Gate, _) => Self::Bit,
            (Kind::Bus, _) if signal.unit.is_counted() => Self::Word,
            (Kind::Bus, _) => Self::Real,
            (Kind::Event, _) => Self::Pulse,
        }
    }
}

/// Whether a gate is open.
pub(crate) fn is_high(value: f64) -> bool {
    value > 0.5
}

/// The voltage on a wire (V); the value itself on wires that have none.
pub(crate) fn volts(wire: &Wire, value: f64) -> f64 {
    if has_volts(wire) { (value - wire.datum) / wire.full_scale * wire.volts } else { value }
}

/// Whether a wire carries a voltage.
pub(crate) fn has_volts(wire: &Wire) -> bool {
    wire.volts > 0.0 && wire.full_scale > 0.0
}

#[cfg(test)]
mod tests {
    use signal::{Kind, Signal, Unit};

    use super::Form;

    /// A corner is counted; a word of a register is as many metres, and its fraction is kept.
    #[test]
    fn what_is_counted_is_whole() {
        let bus = |unit| Form::of(&Signal::digital("tg.red.word0", unit, Kind::Bus, "", ""));
        assert_eq!(bus(Unit::Corner), Form::Word);
        assert_eq!(bus(Unit::Metre), Form::Real);
    }
}
