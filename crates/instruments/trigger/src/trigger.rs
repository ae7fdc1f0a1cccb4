//! A condition on the wires of a machine.

use std::ops::Range;

use signal::{Axis, Kind, Signal, Unit, Waveform, Wire};

use crate::condition::{Clause, Condition};
use crate::moments::{Moment, becomes, edges, events, pulses};
use crate::states::{Stretch, both, is_saturated, level, saturated};
use crate::sweep::{RANGE, Sweep, value_at};
use crate::{ConditionError, Fault};

/// What of a machine a condition is held against.
#[derive(Debug, Clone, Copy)]
pub struct Machine<'m> {
    /// The wires that it has.
    pub wires: &'m [Wire],
    /// Voltage of either sign at which its amplifiers clip (V); none if they do not.
    pub saturation: Option<f64>,
    /// Length of a sample (µs).
    pub sample_us: f64,
}

/// Where a voltage is at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    pub signal: Signal,
    /// Value at 0 V.
    datum: f64,
    /// How far from there, in the unit of the signal.
    most: f64,
}

impl Limit {
    fn new(wire: &Wire, saturation: Option<f64>) -> Self {
        let share = saturation.filter(|_| wire.volts > 0.0).map_or(1.0, |volts| volts / wire.volts);
        Self { signal: wire.signal, datum: wire.datum, most: wire.full_scale * share }
    }

    /// How much of the way to the limit a value is.
    pub fn share(&self, value: f64) -> f64 {
        (value - self.datum).abs() / self.most
    }
}

/// A signal's value where the condition was met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Signal that was read.
    pub signal: Signal,
    /// Its value at the sample, or what an event told, in the unit of the signal.
    pub value: f64,
}

/// A place of a sweep where the condition is met.
#[derive(Debug, Clone, PartialEq)]
pub struct Hit {
    /// Instant, in samples of the sweep, or lines of the display.
    pub time: f64,
    /// The first sample, or line, at which it is met: at or after the instant.
    pub sample: usize,
    /// Ground range of the instant (m); none down the display.
    pub range: Option<f64>,
    /// The signals that are named, those that tell something.
    pub readings: Vec<Reading>,
}

/// A condition that can be searched for.
#[derive(Debug, Clone, PartialEq)]
pub struct Trigger {
    clauses: Vec<Clause>,
    limits: Vec<Limit>,
    axis: Axis,
    sample_us: f64,
}

/// What a clause comes to in one sweep.
enum Met {
    State(Vec<Stretch>),
    Moments(Vec<Moment>),
}

impl Trigger {
    /// `condition` on a machine.
    ///
    /// # Errors
    /// If a signal is of a block that the machine has not.
    pub fn new(condition: &Condition, machine: &Machine<'_>) -> Result<Self, ConditionError> {
        let mut clauses = condition.clauses.clone();
        let has = |signal: &Signal| machine.wires.iter().any(|wire| wire.signal.name == signal.name);
        for clause in &mut clauses {
            let left_out = clause.named().iter().find(|named| !has(&named.signal)).cloned();
            if let Clause::Event { any, .. } = clause {
                any.retain(|named| has(&named.signal));
            }
            let is_any = matches!(clause, Clause::Event { any, .. } if !any.is_empty());
            if let Some(named) = left_out.filter(|_| !is_any) {
                let fault = Fault::LeftOut { name: named.signal.name, block: named.signal.block() };
                return Err(ConditionError { text: condition.text.clone(), place: named.place, fault });
            }
        }
        let limits = limits(&clauses, machine);
        Ok(Self { clauses, limits, axis: condition.axis, sample_us: machine.sample_us })
    }

    /// Names of the signals that [`find`](Self::find) looks at, each once; those that are named come first.
    pub fn signals(&self) -> Vec<&'static str> {
        let named = self.clauses.iter().flat_map(Clause::named).map(|named| named.signal.name);
        let range = Some(RANGE).filter(|_| self.axis == Axis::Ground);
        let mut names: Vec<&'static str> = Vec::new();
        for name in named.chain(self.limits.iter().map(|limit| limit.signal.name)).chain(range) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// Places of one sweep where the condition is met, in order; `waveforms` are those of [`signals`](Self::signals) in
    /// that sweep. The trigger is armed at the samples `armed`: none but these are found.
    pub fn find(&self, waveforms: &[Waveform], armed: Range<usize>) -> Vec<Hit> {
        let sweep = Sweep::new(waveforms, self.axis, self.sample_us);
        let armed = armed.start..armed.end.min(sweep.samples);
        if armed.is_empty() {
            return Vec::new();
        }
        let mut holds = vec![Stretch { begin: armed.start as f64, first: armed.start, end: armed.end }];
        let mut moments = Vec::new();
        for clause in &self.clauses {
            match self.met(clause, &sweep) {
                Met::State(stretches) => holds = both(&holds, &stretches),
                Met::Moments(own) => moments.push(own),
            }
        }
        let met = together(&holds, moments);
        met.into_iter().map(|moment| self.hit(&sweep, moment)).collect()
    }

    fn met(&self, clause: &Clause, sweep: &Sweep<'_>) -> Met {
        let points = |name: &str| sweep.of(name);
        match clause {
            Clause::Level { of, slope, test } => {
                let points = points(of.signal.name);
                Met::State(points.map_or_else(Vec::new, |points| level(sweep, &points, *slope, test)))
            }
            Clause::Saturated(of, _) => {
                let is_meant =
                    |limit: &&Limit| of.as_ref().is_none_or(|of| of.signal.name == limit.signal.name);
                Met::State(saturated(
                    sweep,
                    &self.limits.iter().filter(is_meant).copied().collect::<Vec<_>>(),
                ))
            }
            Clause::Edge { of, rising, level, by } => {
                let points = points(of.signal.name);
                Met::Moments(points.map_or_else(Vec::new, |points| edges(&points, *rising, *level, *by)))
            }
            Clause::Becomes { of, test } => {
                Met::Moments(points(of.signal.name).map_or_else(Vec::new, |points| becomes(&points, test)))
            }
            Clause::Pulse { of, longer, width, per } => {
                let points = points(of.signal.name);
                Met::Moments(
                    points.map_or_else(Vec::new, |points| pulses(sweep, &points, *longer, *width, *per)),
                )
            }
            Clause::Event { any, test } => {
                let points = any.iter().filter_map(|named| points(named.signal.name));
                let mut all: Vec<Moment> = points.flat_map(|points| events(&points, test.as_ref())).collect();
                all.sort_by(|a, b| a.time.total_cmp(&b.time));
                Met::Moments(all)
            }
        }
    }

    fn hit(&self, sweep: &Sweep<'_>, moment: Moment) -> Hit {
        let mut readings: Vec<Reading> = Vec::new();
        for reading in self.clauses.iter().flat_map(|clause| self.readings(clause, sweep, moment)) {
            if readings.iter().all(|known| known.signal.name != reading.signal.name) {
                readings.push(reading);
            }
        }
        let range = sweep.range_at(moment.time).filter(|_| self.axis == Axis::Ground);
        Hit { time: moment.time, sample: moment.sample, range, readings }
    }

    fn readings(&self, clause: &Clause, sweep: &Sweep<'_>, moment: Moment) -> Vec<Reading> {
        let value_at = |signal: &Signal| {
            let points = sweep.of(signal.name)?;
            let value = match signal.kind {
                Kind::Event => told_at(points.waveform, moment)?,
                Kind::Analog | Kind::Gate | Kind::Bus => value_at(points.waveform, moment.sample)?,
            };
            Some(Reading { signal: *signal, value })
        };
        match clause {
            Clause::Saturated(None, _) => {
                let readings = self.limits.iter().map(|limit| (limit, value_at(&limit.signal)));
                let at_limit = |(limit, reading): (&Limit, Option<Reading>)| {
                    reading.filter(|reading| is_saturated(limit, reading.value))
                };
                readings.filter_map(at_limit).collect()
            }
            clause => clause.named().iter().filter_map(|named| value_at(&named.signal)).collect(),
        }
    }
}

/// Limits of all voltages that some clause may find saturated.
fn limits(clauses: &[Clause], machine: &Machine<'_>) -> Vec<Limit> {
    let is_wanted = |signal: &Signal| {
        clauses.iter().any(|clause| match clause {
            // A ramp is at full scale where it ends, and so is a function generator.
            Clause::Saturated(None, _) => {
                signal.kind == Kind::Analog
                    && signal.axis == Axis::Ground
                    && signal.prefix() != "sweep"
                    && signal.unit != Unit::Number
            }
            Clause::Saturated(Some(of), _) => of.signal.name == signal.name,
            _ => false,
        })
    };
    let wanted = machine.wires.iter().filter(|wire| is_wanted(&wire.signal));
    wanted.map(|wire| Limit::new(wire, machine.saturation)).collect()
}

/// What an event told at a moment; of several at its sample the one at the instant itself.
fn told_at(waveform: &Waveform, moment: Moment) -> Option<f64> {
    let exact = waveform.times.iter().position(|time| *time == moment.time);
    exact.map_or_else(|| value_at(waveform, moment.sample), |index| waveform.values.get(index).copied())
}

/// Where everything is met: where the states begin to hold together, or the moments that fall into them.
fn together(holds: &[Stretch], mut moments: Vec<Vec<Moment>>) -> Vec<Moment> {
    let is_held = |moment: &Moment| {
        let next = holds.partition_point(|stretch| stretch.end <= moment.sample);
        holds.get(next).is_some_and(|stretch| stretch.first <= moment.sample)
    };
    let Some(mut met) = moments.pop() else {
        return holds.iter().map(|stretch| Moment { time: stretch.begin, sample: stretch.first }).collect();
    };
    met.retain(is_held);
    for others in moments {
        met.dedup_by_key(|moment| moment.sample);
        met.retain_mut(|moment| {
            let other = others.iter().find(|other| other.sample == moment.sample);
            other.inspect(|other| moment.time = moment.time.max(other.time)).is_some()
        });
    }
    met
}
