//! A sweep as the changes of its wires, in order of time: what VCD and FST hold.

use quantities::TimebaseError;
use signal::{Axis, Waveform};

use crate::clock::Clock;
use crate::header::Form;
use crate::{Header, SweepTraces};

/// Picoseconds between two pulses of a wire: each has its beginning and its end.
const APART: u64 = 2;

/// A wire takes a value, or a pulse comes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Picoseconds from the start of the frame.
    pub time: u64,
    /// Place of the wire in the header.
    pub wire: usize,
    /// Its value from here on; what is told, for a pulse.
    pub value: f64,
}

/// Turns sweeps into changes; buffers are used again.
#[derive(Debug)]
pub struct Timeline {
    clock: Clock,
    forms: Vec<Form>,
    /// Instants of the samples of a sweep, and of its lines.
    samples: Vec<f64>,
    lines: Vec<f64>,
    /// Values that stand, and when each wire was told last.
    standing: Vec<f64>,
    told: Vec<Option<u64>>,
    /// End of the sweeps before: what belongs to the retrace before a sweep may not be told before it.
    floor: u64,
    changes: Vec<Change>,
}

impl Timeline {
    /// Nothing told yet.
    ///
    /// # Errors
    /// If the clocks do not fit in 64 bits.
    pub fn new(header: &Header) -> Result<Self, TimebaseError> {
        Ok(Self {
            clock: Clock::new(header)?,
            forms: header.wires.iter().map(|wire| Form::of(&wire.signal)).collect(),
            samples: (0..header.samples()).map(|sample| sample as f64).collect(),
            lines: (0..header.lines as usize).map(|line| header.line_instant(line)).collect(),
            standing: Vec::new(),
            told: vec![None; header.wires.len()],
            floor: 0,
            changes: Vec::new(),
        })
    }

    /// How each wire is written.
    pub fn forms(&self) -> &[Form] {
        &self.forms
    }

    /// The values at time zero: the first that each wire has, 0 where it has none.
    pub fn begin(&mut self, traces: &SweepTraces<'_>) -> &[f64] {
        let first = |waveform: &Waveform| waveform.values.first().copied().unwrap_or(0.0);
        let pulse = |form: &Form| *form == Form::Pulse;
        let values = traces.waveforms.iter().zip(&self.forms);
        self.standing =
            values.map(|(waveform, form)| if pulse(form) { 0.0 } else { first(waveform) }).collect();
        &self.standing
    }

    /// What changes in a sweep. A wire that keeps its value is not told again; at one picosecond a wire has its last
    /// value, and two pulses of a wire stand [`APART`].
    pub fn changes(&mut self, traces: &SweepTraces<'_>) -> &[Change] {
        self.changes.clear();
        for (wire, waveform) in traces.waveforms.iter().enumerate() {
            self.follow(wire, traces.sweep, waveform);
        }
        self.changes.sort_by_key(|change| change.time);
        self.floor = self.changes.last().map_or(self.floor, |change| change.time);
        &self.changes
    }

    fn follow(&mut self, wire: usize, sweep: u32, waveform: &Waveform) {
        let form = self.forms[wire];
        let instants = match waveform.signal.axis {
            Axis::Ground | Axis::Line => &self.samples,
            Axis::Display => &self.lines,
            Axis::Changes => &waveform.times,
        };
        for (&instant, &value) in instants.iter().zip(&waveform.values) {
            if form != Form::Pulse && self.standing[wire].to_bits() == value.to_bits() {
                continue;
            }
            let earliest =
                self.told[wire].map_or(0, |told| if form == Form::Pulse { told + APART } else { told });
            let time = self.clock.at(sweep, instant).max(earliest).max(self.floor);
            match self.changes.last_mut() {
                Some(last) if last.wire == wire && last.time == time => last.value = value,
                _ => self.changes.push(Change { time, wire, value }),
            }
            (self.told[wire], self.standing[wire]) = (Some(time), value);
        }
    }

    /// When the sweeps end, retrace included.
    pub fn end(&self, header: &Header) -> u64 {
        self.clock.at(header.sweeps.end, 0.0)
    }
}
