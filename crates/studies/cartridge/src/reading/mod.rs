//! What is read off a run, and how far it is from what the cartridge says.

mod bench;
mod brightness;
mod changes;
mod deviation;
mod digital;
mod display_line;
mod edge_shift;
mod fourier_line;
mod frame;
mod hidden;
mod horizon_line;
mod noise;
mod signal;
mod statistic;
mod turned;
mod turns;
mod waits;

pub use deviation::Deviation;

use serde::Deserialize;

use crate::scene::{CartridgeScene, Case, Seen};

/// The signal of ground range.
pub(crate) const RANGE: &str = "sweep.range";

/// What is read from a scene, and what it should be.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Reading {
    /// A signal at every sample of every sweep. Tolerance: full scales.
    Signal(signal::SignalReading),
    /// A signal of sweep 0 at some ground ranges. Tolerance: its unit.
    Samples(signal::SamplesReading),
    /// A number that says how a signal errs. Tolerance: the number's unit.
    Statistic(statistic::StatisticReading),
    /// The line that the error of a signal has at some wavelength to the north. Tolerance: the signal's unit.
    FourierLine(fourier_line::FourierLineReading),
    /// Ground ranges at which a ramp of sweep 0 turns, between samples. Tolerance: m.
    Turns(turns::TurnsReading),
    /// Ground ranges at which a signal of the middle sweep goes from one half of its span to the other. Tolerance: m.
    Changes(changes::ChangesReading),
    /// Way by which edges across the heading are displaced, mean of all sweeps. Tolerance: m.
    EdgeShift(edge_shift::EdgeShiftReading),
    /// Folds of the frame. Tolerance: counts.
    Folds(digital::FoldsReading),
    /// Register sets asked for at a fold. Tolerance: counts.
    SetsAFold(digital::SetsAFoldReading),
    /// Where ground of one brightness ends, in every column. Tolerance: lines.
    HorizonLine(horizon_line::HorizonLineReading),
    /// Lambert's value of a plane on some lines of every column. Tolerance: reflectivity.
    Brightness(brightness::BrightnessReading),
    /// Ground of the middle column that is hidden, with ground seen on both sides. Tolerance: m, at each end.
    Hidden(hidden::HiddenReading),
    /// The farthest ground seen, against `sqrt(2 R H)`. Tolerance: a part of it.
    LunoidHorizonRange(hidden::HorizonRangeReading),
    /// The deflection of every sample that is written, against the perspective of its elevation. Tolerance: lines.
    DisplayLine(display_line::DisplayLineReading),
    /// Worst response time of a task of the processor, by the recurrence of fixed priorities. Tolerance: master ticks.
    Response(digital::ResponseReading),
    /// Deadlines of a kind that were missed. Tolerance: counts.
    Missed(digital::MissedReading),
    /// Share of the frame in which a unit is at work. Tolerance: shares.
    Utilisation(digital::UtilisationReading),
    /// Share of the sweeps that are drawn as the one before. Tolerance: shares.
    RepeatedSweeps(digital::RepeatedSweepsReading),
    /// Output of a part at every step, by its textbook response. Tolerance: full scales.
    Output(bench::OutputReading),
    /// The peak behind a fold of the input of a lag. Tolerance: full scales, or µs.
    Peak(bench::PeakReading),
    /// Time in which an amplifier settles. Tolerance: ns.
    Settling(bench::SettlingReading),
    /// Times at which a comparator trips. Tolerance: ns.
    Trips(bench::TripsReading),
    /// Output less input of a part. Tolerance: the number's unit.
    OutputError(bench::OutputErrorReading),
    /// A number that says what noise is like. Tolerance: the number's unit.
    Noise(noise::NoiseReading),
    /// Waits of a drum. Tolerance: turns.
    Waits(waits::WaitsReading),
    /// What a turn on the spot asks of the drums. Tolerance: the number's unit.
    Turned(turned::TurnedReading),
    /// Pixels after a way out and back. Tolerance: pixels.
    RoundTrip(waits::RoundTripReading),
    /// A plane that has one value on some pixels of each frame. Tolerance: the plane's unit.
    Pixels(frame::PlaneReading),
    /// The sum of a plane over some pixels of each frame. Tolerance: the plane's unit, times pixels.
    Sum(frame::PlaneReading),
    /// A number that the generator counts in each frame. Tolerance: counts.
    Counter(frame::CounterReading),
    /// The distance of level ground on some pixels. Tolerance: a part of it.
    GroundDistance(frame::GroundDistanceReading),
}

impl Reading {
    /// Its word in files, and what it looks at.
    pub fn label(&self) -> String {
        match self {
            Self::Signal(reading) => format!("signal {}", reading.signal),
            Self::Samples(reading) => format!("samples {}", reading.signal),
            Self::Statistic(reading) => format!("{} of {}", reading.statistic.word(), reading.signal),
            Self::FourierLine(reading) => format!("fourier-line {}", reading.signal),
            Self::Turns(reading) => format!("turns {}", reading.signal),
            Self::Changes(reading) => format!("changes {}", reading.signal),
            Self::EdgeShift(reading) => format!("edge-shift {}", reading.signal),
            Self::Folds(_) => "folds".into(),
            Self::SetsAFold(_) => "sets-a-fold".into(),
            Self::HorizonLine(_) => "horizon-line".into(),
            Self::Brightness(_) => "brightness".into(),
            Self::Hidden(_) => "hidden".into(),
            Self::LunoidHorizonRange(_) => "lunoid-horizon-range".into(),
            Self::DisplayLine(_) => "display-line".into(),
            Self::Response(reading) => format!("response {}", reading.task.word()),
            Self::Missed(reading) => format!("missed {}", reading.deadline),
            Self::Utilisation(reading) => format!("utilisation {}", reading.unit),
            Self::RepeatedSweeps(_) => "repeated-sweeps".into(),
            Self::Output(_) => "output".into(),
            Self::Peak(_) => "peak".into(),
            Self::Settling(_) => "settling".into(),
            Self::Trips(_) => "trips".into(),
            Self::OutputError(reading) => format!("{} of output", reading.statistic.word()),
            Self::Noise(reading) => format!("noise {}", reading.measure.word()),
            Self::Waits(reading) => format!("waits {}", reading.measure.word()),
            Self::Turned(reading) => format!("turned {}", reading.measure.word()),
            Self::RoundTrip(_) => "round-trip".into(),
            Self::Pixels(reading) => format!("pixels of {}", reading.plane),
            Self::Sum(reading) => format!("sum of {}", reading.plane),
            Self::Counter(reading) => format!("counter {}", reading.counter),
            Self::GroundDistance(_) => "ground-distance".into(),
        }
    }

    /// Whether it can be read off scenes of a kind.
    pub fn is_for(&self, scene: &CartridgeScene) -> bool {
        let kind = match self {
            Self::Output(_) | Self::Peak(_) | Self::Settling(_) | Self::Trips(_) | Self::OutputError(_) => {
                "part"
            }
            Self::Noise(_) => "noise",
            Self::Waits(_) => "drum",
            Self::Turned(_) => "turn",
            Self::RoundTrip(_) => "view",
            Self::Pixels(_) | Self::Sum(_) | Self::Counter(_) | Self::GroundDistance(_) => "scenario",
            _ => "machine",
        };
        kind == scene.kind()
    }

    /// Signals that it looks at, each one that the machine has.
    pub fn signals(&self) -> Vec<&str> {
        let one = |signal: &'static str| vec![RANGE, signal];
        match self {
            Self::Signal(signal::SignalReading { signal, .. })
            | Self::Samples(signal::SamplesReading { signal, .. })
            | Self::Statistic(statistic::StatisticReading { signal, .. })
            | Self::FourierLine(fourier_line::FourierLineReading { signal, .. })
            | Self::EdgeShift(edge_shift::EdgeShiftReading { signal, .. })
            | Self::Changes(changes::ChangesReading { signal, .. }) => vec![RANGE, signal],
            Self::Turns(turns) => [RANGE].into_iter().chain(turns.signals()).collect(),
            Self::Hidden(_) | Self::LunoidHorizonRange(_) => one("dpp.blank"),
            Self::DisplayLine(_) => vec![RANGE, "dpp.elevation", "dpp.blank", "dpp.y"],
            Self::RepeatedSweeps(_) => one("tg.height"),
            _ => Vec::new(),
        }
    }

    /// Whether `exact`, which has no signals, can be read by it.
    pub fn needs_signals(&self) -> bool {
        let also_by_pixels = matches!(self, Self::Hidden(_) | Self::LunoidHorizonRange(_));
        !self.signals().is_empty() && !also_by_pixels
    }

    /// Whether it looks at the digital side.
    pub fn looks_at_timing(&self) -> bool {
        matches!(self, Self::SetsAFold(_) | Self::Response(_) | Self::Missed(_) | Self::Utilisation(_))
    }

    /// How far what is seen is from what is meant, where it is farthest.
    pub fn deviation(&self, meant: &Case, seen: &Seen) -> Result<Deviation, String> {
        match (meant, seen) {
            (Case::Machine(meant), Seen::Machine(seen)) => match self {
                Self::Signal(reading) => reading.deviation(meant, seen),
                Self::Samples(reading) => reading.deviation(seen),
                Self::Statistic(reading) => reading.deviation(meant, seen),
                Self::FourierLine(reading) => reading.deviation(meant, seen),
                Self::Turns(reading) => reading.deviation(seen),
                Self::Changes(reading) => reading.deviation(meant, seen),
                Self::EdgeShift(reading) => reading.deviation(meant, seen),
                Self::Folds(reading) => reading.deviation(seen),
                Self::SetsAFold(reading) => reading.deviation(seen),
                Self::HorizonLine(reading) => reading.deviation(meant, seen),
                Self::Brightness(reading) => reading.deviation(meant, seen),
                Self::Hidden(reading) => reading.deviation(meant, seen),
                Self::LunoidHorizonRange(reading) => reading.deviation(meant, seen),
                Self::DisplayLine(reading) => reading.deviation(meant, seen),
                Self::Response(reading) => reading.deviation(meant, seen),
                Self::Missed(reading) => reading.deviation(seen),
                Self::Utilisation(reading) => reading.deviation(seen),
                Self::RepeatedSweeps(reading) => reading.deviation(meant, seen),
                _ => self.not_of(meant.model.name.as_str()),
            },
            (Case::Part(meant), Seen::Part(seen)) => match self {
                Self::Output(reading) => reading.deviation(meant, seen),
                Self::Peak(reading) => reading.deviation(meant, seen),
                Self::Settling(reading) => reading.deviation(meant, seen),
                Self::Trips(reading) => reading.deviation(seen),
                Self::OutputError(reading) => reading.deviation(seen),
                _ => self.not_of("a part"),
            },
            (Case::Noise(_), Seen::Noise(seen)) => match self {
                Self::Noise(reading) => reading.deviation(seen),
                _ => self.not_of("noise"),
            },
            (Case::Drum(meant), Seen::Drum(seen)) => match self {
                Self::Waits(reading) => reading.deviation(meant, seen),
                _ => self.not_of("a drum"),
            },
            (Case::Turn(meant), Seen::Turn(seen)) => match self {
                Self::Turned(reading) => reading.deviation(meant, seen),
                _ => self.not_of("a turn"),
            },
            (Case::View(_), Seen::View(seen)) => match self {
                Self::RoundTrip(_) => Ok(waits::round_trip(seen)),
                _ => self.not_of("a view"),
            },
            (Case::Scenario(meant), Seen::Scenario(seen)) => match self {
                Self::Pixels(reading) => reading.of_pixels(meant, seen),
                Self::Sum(reading) => reading.of_sum(meant, seen),
                Self::Counter(reading) => reading.deviation(meant, seen),
                Self::GroundDistance(reading) => reading.deviation(meant, seen),
                _ => self.not_of("a scenario"),
            },
            _ => self.not_of("another kind of scene"),
        }
    }

    fn not_of(&self, what: &str) -> Result<Deviation, String> {
        Err(format!("{} cannot be read off {what}", self.label()))
    }
}
