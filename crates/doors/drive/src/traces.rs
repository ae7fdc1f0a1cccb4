//! Signals of some sweeps of a frame.

use std::ops::Range;

use diagnostics::Problem;
use limits::Limit;
use scope::{Choice, Look, Looking, expect_known};
use signal::{Axis, Signal, Waveform, Wire};

use crate::{Drive, DriveError, Viewpoint};

/// A signal in all sweeps that were asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// Signal that was recorded.
    pub signal: Signal,
    /// Value at full scale, in the unit of the signal; 1 for digital signals, and where there is no wire.
    pub full_scale: f64,
    /// Its values, sweep after sweep; as many a sweep as the axis has, but of signals told when they change.
    pub values: Vec<f64>,
    /// Number of values in each sweep.
    pub counts: Vec<usize>,
    /// Instants of the values in samples from the start of the sweep; empty but for signals told when they change.
    pub times: Vec<f64>,
}

/// Signals of some sweeps.
#[derive(Debug, Clone, PartialEq)]
pub struct Traces {
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// Sweeps that were recorded, ascending.
    pub sweeps: Range<u32>,
    /// In the order of the signal table.
    pub signals: Vec<Trace>,
    /// Names of signals without a wire in this machine; they are 0 throughout.
    pub left_out: Vec<&'static str>,
    /// Place of each sample of each sweep (m): ground range, or the place across of a generator with rows; sweep after sweep.
    pub places: Vec<f64>,
    /// Name of the signal that says the place.
    pub place: &'static str,
}

impl Drive {
    /// Signals that match any of `patterns` in `sweeps` of frame `frame` of the path.
    ///
    /// # Errors
    /// If there is no such frame, or as [`Viewpoint::probe`].
    pub fn probe(&self, patterns: &[String], frame: u64, sweeps: Range<u32>) -> Result<Traces, DriveError> {
        self.at(frame)?.probe(patterns, sweeps)
    }
}

impl Viewpoint<'_> {
    /// Signals that match any of `patterns`, with * for any run of characters, in `sweeps`.
    ///
    /// # Errors
    /// If the generator has no signals, a pattern names none, there is no such sweep, or the pose cannot be drawn.
    pub fn probe(&self, patterns: &[String], sweeps: Range<u32>) -> Result<Traces, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let (file, generator) = (drive.file(), &drive.opened.generator);
        let table = generator.signals();
        expect_known(table, patterns, generator.name()).map_err(|error| DriveError::of(file, &error))?;
        let no_scan =
            || DriveError::asked(file, format!("{} has no signals", generator.name()), "a hardware model");
        let scan = generator.scan(&bench.stage.view).ok_or_else(no_scan)?;
        self.expect_sweeps(&sweeps, scan.timebase.sweeps)?;
        let choice = Choice::of(table, &bench.session.wires(), patterns);
        self.expect_signals(&choice)?;
        let raster = [bench.stage.view.columns as usize, bench.stage.view.lines as usize];
        let look = Look { session: &*bench.session, pool: &drive.pool, frame: *frame, pose, raster };
        let names = choice.names().into_iter().chain([scan.place]).map(str::to_owned).collect();
        let waveforms = look.at(names, sweeps.clone()).map_err(|error| DriveError::of(file, &error))?;
        let signals = choice.wires.iter().map(|wire| trace(wire, &sweeps, &waveforms)).collect();
        let places = of_signal(scan.place, &waveforms).flat_map(|wave| wave.values.iter().copied()).collect();
        Ok(Traces { frame: *frame, sweeps, signals, left_out: choice.left_out, places, place: scan.place })
    }

    pub(crate) fn expect_sweeps(&self, sweeps: &Range<u32>, all: u32) -> Result<(), DriveError> {
        if sweeps.start < sweeps.end && sweeps.end <= all {
            return Ok(());
        }
        let title = format!("no sweeps {}..{}: a frame has sweeps 0..{all}", sweeps.start, sweeps.end);
        let problem =
            Problem::of_file(self.drive.file(), title).found(format!("{}..{}", sweeps.start, sweeps.end));
        Err(problem.expected(format!("a range inside 0..{all}")).into())
    }

    fn expect_signals(&self, choice: &Choice) -> Result<(), DriveError> {
        let count = choice.wires.len() as u64;
        match Limit::Signals.allows(count) {
            true => Ok(()),
            false => {
                let title = format!("{count} signals at once");
                let expected = format!("at most {}", Limit::Signals.value());
                Err(DriveError::asked(self.drive.file(), title, expected))
            }
        }
    }
}

fn of_signal<'a>(name: &'a str, waveforms: &'a [Waveform]) -> impl Iterator<Item = &'a Waveform> {
    waveforms.iter().filter(move |wave| wave.signal.name == name)
}

/// One signal of all sweeps; what was not recorded has no wire, and is 0 at every sample.
fn trace(wire: &Wire, sweeps: &Range<u32>, waveforms: &[Waveform]) -> Trace {
    let length = |axis: Axis| {
        waveforms.iter().find(|wave| wave.signal.axis == axis).map_or(0, |wave| wave.values.len())
    };
    let (signal, full_scale) = (wire.signal, wire.full_scale);
    let mut trace = Trace { signal, full_scale, values: Vec::new(), counts: Vec::new(), times: Vec::new() };
    for sweep in sweeps.clone() {
        match of_signal(signal.name, waveforms).find(|wave| wave.sweep == sweep) {
            Some(wave) => {
                trace.values.extend_from_slice(&wave.values);
                trace.times.extend_from_slice(&wave.times);
                trace.counts.push(wave.values.len());
            }
            None => {
                let count = if signal.axis == Axis::Changes { 0 } else { length(signal.axis) };
                trace.values.extend(std::iter::repeat_n(0.0, count));
                trace.counts.push(count);
            }
        }
    }
    trace
}
