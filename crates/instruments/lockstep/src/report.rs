//! What a comparison comes to.

use std::collections::BTreeMap;
use std::fmt;

use generator::FrameCounts;
use interpreter::Event;

/// Where two signals part.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Name of the signal.
    pub signal: String,
    /// Frame of the mission.
    pub frame: u64,
    /// Sweep of the frame.
    pub sweep: u32,
    /// Sample of the sweep.
    pub sample: usize,
    /// Master tick since the start of the mission.
    pub tick: i64,
    /// Ground range of the sample (m).
    pub range: f64,
    /// Value of the machine's signal.
    pub machine: f64,
    /// Value of the interpreter's signal.
    pub interpreter: f64,
    /// Difference that is allowed.
    pub allowed: f64,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { signal, frame, sweep, sample, tick, range, machine, interpreter, allowed } = self;
        let off = machine - interpreter;
        write!(
            f,
            "{signal}, frame {frame}, sweep {sweep}, sample {sample}, tick {tick} ({range} m): machine {machine:e}, \
             interpreter {interpreter:e}, off by {off:e}, allowed {allowed:e}"
        )
    }
}

/// Where two event lists part: what each has there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EventDifference {
    /// Frame of the mission.
    pub frame: u64,
    /// Sweep of the frame; none for what belongs to no sweep.
    pub sweep: Option<u32>,
    /// The machine's event, if its list goes on.
    pub machine: Option<Event>,
    /// The interpreter's event, if its list goes on.
    pub interpreter: Option<Event>,
}

impl fmt::Display for EventDifference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let tell = |event: &Option<Event>| match event {
            None => "nothing more".to_owned(),
            Some(Event { tick, level: None, what }) => format!("tick {tick}, {what:?}"),
            Some(Event { tick, level: Some(level), what }) => {
                format!("tick {tick}, level {level}, {what:?}")
            }
        };
        let Self { frame, sweep, machine, interpreter } = self;
        let place = sweep.map_or(String::new(), |sweep| format!(", sweep {sweep}"));
        let [machine, interpreter] = [tell(machine), tell(interpreter)];
        write!(f, "events, frame {frame}{place}: machine {machine}; interpreter {interpreter}")
    }
}

/// Result of comparing one signal.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tally {
    /// Number of samples compared.
    pub samples: u64,
    /// Samples so near to a threshold that rounding decides.
    pub doubtful: u64,
    /// Largest difference, as a part of full scale.
    pub worst: f64,
    /// Samples not compared, by reason.
    pub not_compared: BTreeMap<&'static str, u64>,
}

/// Result of running both engines side by side.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Sweeps that ran on both.
    pub sweeps: u64,
    /// Result for each signal, by its name.
    pub signals: BTreeMap<String, Tally>,
    /// Events compared, by word.
    pub events: BTreeMap<&'static str, u64>,
    /// Events of sweeps in which rounding says which tick sees an instant.
    pub events_left_out: u64,
    /// Work counters of the machine, summed over the sweeps.
    pub counts: FrameCounts,
    /// First difference of a signal, in order of sweep, sample, drawing.
    pub difference: Option<Difference>,
    /// First difference of the event lists.
    pub event_difference: Option<EventDifference>,
}

impl Report {
    /// Adds another part; its first differences come after those that are here.
    pub fn add(&mut self, other: Self) {
        self.sweeps += other.sweeps;
        for (name, tally) in other.signals {
            let sum = self.signals.entry(name).or_default();
            sum.samples += tally.samples;
            sum.doubtful += tally.doubtful;
            sum.worst = sum.worst.max(tally.worst);
            for (reason, count) in tally.not_compared {
                *sum.not_compared.entry(reason).or_default() += count;
            }
        }
        for (word, count) in other.events {
            *self.events.entry(word).or_default() += count;
        }
        self.events_left_out += other.events_left_out;
        self.counts.join(&other.counts, machine::COUNTERS);
        self.difference = self.difference.take().or(other.difference);
        self.event_difference = self.event_difference.take().or(other.event_difference);
    }

    /// The first difference in words: events come before the signals that they make.
    pub fn first_difference(&self) -> Option<String> {
        let events = self.event_difference.as_ref().map(ToString::to_string);
        events.or_else(|| self.difference.as_ref().map(ToString::to_string))
    }

    /// The largest difference of any signal as a part of its full scale.
    pub fn worst(&self) -> f64 {
        self.signals.values().map(|tally| tally.worst).fold(0.0, f64::max)
    }

    /// Samples compared, of all signals.
    pub fn samples(&self) -> u64 {
        self.signals.values().map(|tally| tally.samples).sum()
    }
}
