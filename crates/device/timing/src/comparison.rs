//! A record held to a baseline.

use std::collections::BTreeSet;

use serde::Serialize;
use serde_json::{Value, json};

use crate::allowance::{Allowance, Allowed, NoSuchDeadline};
use crate::deadline::{Deadline, Slack};
use crate::difference::{Difference, Differences, pairs};
use crate::frame_differences::frame_differences;
use crate::missed::Cause;
use crate::record::TimingRecord;
use crate::totals::Totals;

/// How far analog values may be apart. Everything digital is exact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Tolerance {
    /// Instants on the sweep clock: when a word was due, when it came (samples).
    pub(crate) samples: f64,
    /// Distance that ground ranges may be apart (m).
    pub(crate) metres: f64,
}

/// A tolerance under which a comparison says nothing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("tolerance in {unit}: found {found}, expected a finite number of at least 0")]
pub struct ToleranceError {
    /// Name of the unit: `samples` or `metres`.
    pub unit: &'static str,
    /// Number that was given as tolerance.
    pub found: f64,
}

impl Tolerance {
    /// Of instants (samples) and of ground ranges (metres).
    ///
    /// # Errors
    /// [`ToleranceError`] for a number that is negative or not finite.
    pub fn new(samples: f64, metres: f64) -> Result<Self, ToleranceError> {
        for (unit, found) in [("samples", samples), ("metres", metres)] {
            if !found.is_finite() || found < 0.0 {
                return Err(ToleranceError { unit, found });
            }
        }
        Ok(Self { samples, metres })
    }
}

impl Default for Tolerance {
    /// A millionth of a sample and of a metre: below anything that a picture shows, above rounding.
    fn default() -> Self {
        Self { samples: 1e-6, metres: 1e-6 }
    }
}

/// What differs between a baseline and a record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// Scenario of the record.
    pub scenario: String,
    /// Hardware model of the record.
    pub machine: String,
    /// What was let pass.
    pub tolerance: Tolerance,
    /// Format, scenario, machine, inputs, master clock. Anything here, and the baseline is of another run.
    pub head: Vec<Difference>,
    /// Keys of model, scenario and command line whose values differ, where the inputs do.
    pub keys: Vec<Difference>,
    /// Whether the baseline says what its keys were.
    pub has_keys: bool,
    /// The first event of all frames that moved, where somebody has looked for it.
    pub first_event: Option<MovedEvent>,
    /// Totals over the frames that both have: late words, late sets, misses and least slack of each deadline, misses by cause.
    pub totals: Vec<Difference>,
    /// Bounds within which the record may differ; none if it must be the same.
    pub allowed: Vec<Allowed>,
    /// Tasks before the mission.
    pub before_mission: Vec<Difference>,
    /// Every frame of either side, rising.
    pub frames: Vec<FrameComparison>,
}

/// An event that is not where the baseline has it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct MovedEvent {
    /// Frame of the mission.
    pub frame: u64,
    /// Its sweep; none of an event of the whole frame.
    pub sweep: Option<u32>,
    /// The event of the baseline, with its tick; none if the baseline has fewer.
    pub baseline: Option<String>,
    /// What was found there, with its tick.
    pub found: Option<String>,
}

/// Differences of one frame.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FrameComparison {
    /// Frame of the mission.
    pub frame: u64,
    /// In the order of the record; none if it is as in the baseline.
    pub differences: Vec<Difference>,
}

/// Holds `found` to `baseline`: digital times, counters and the hash of the ordered events to the last bit, analog
/// instants within `tolerance`, misses by identity (frame, sweep, fold, deadline, colour, register), units by name.
pub fn compare(baseline: &TimingRecord, found: &TimingRecord, tolerance: &Tolerance) -> Comparison {
    let frames = pairs(&baseline.frames, &found.frames, |frame| frame.frame);
    let compared = frames.into_iter().map(|(frame, baseline, found)| {
        let differences = match (baseline, found) {
            (Some(baseline), Some(found)) => frame_differences(baseline, found, tolerance),
            (baseline, found) => missing_frame(baseline.is_some(), found.is_some()),
        };
        FrameComparison { frame, differences }
    });
    let mut before_mission = Differences::default();
    before_mission.tasks("before_mission", &baseline.before_mission, &found.before_mission);
    let head = head_differences(baseline, found);
    let keys = if head.is_empty() { Vec::new() } else { key_differences(baseline, found) };
    Comparison {
        scenario: found.scenario.clone(),
        machine: found.machine.clone(),
        tolerance: *tolerance,
        head,
        keys,
        has_keys: !baseline.keys.is_empty(),
        first_event: None,
        totals: total_differences(baseline, found),
        allowed: Vec::new(),
        before_mission: before_mission.0,
        frames: compared.collect(),
    }
}

fn missing_frame(in_baseline: bool, in_found: bool) -> Vec<Difference> {
    let mut differences = Differences::default();
    let recorded = |is_there: bool| is_there.then_some("recorded");
    differences.option("frame", recorded(in_baseline), recorded(in_found));
    differences.0
}

fn head_differences(baseline: &TimingRecord, found: &TimingRecord) -> Vec<Difference> {
    let TimingRecord { format, scenario, machine, inputs, keys: _, master, before_mission: _, frames: _ } =
        baseline;
    let mut differences = Differences::default();
    differences.exact("format", format, &found.format);
    differences.exact("scenario", scenario, &found.scenario);
    differences.exact("machine", machine, &found.machine);
    differences.exact("inputs", inputs, &found.inputs);
    differences.exact("master", master, &found.master);
    differences.0
}

fn key_differences(baseline: &TimingRecord, found: &TimingRecord) -> Vec<Difference> {
    let mut differences = Differences::default();
    if !baseline.keys.is_empty() {
        let all: BTreeSet<&String> = baseline.keys.keys().chain(found.keys.keys()).collect();
        all.into_iter().for_each(|key| differences.option(key, baseline.keys.get(key), found.keys.get(key)));
    }
    differences.0
}

fn total_differences(baseline: &TimingRecord, found: &TimingRecord) -> Vec<Difference> {
    let has = |record: &TimingRecord, number: u64| record.frames.iter().any(|frame| frame.frame == number);
    let of_both = |record: &TimingRecord| {
        let mut record = record.clone();
        record.frames.retain(|frame| has(baseline, frame.frame) && has(found, frame.frame));
        Totals::of(&record)
    };
    let [baseline, found] = [baseline, found].map(of_both);
    let mut differences = Differences::default();
    differences.exact("late words", baseline.late_words, found.late_words);
    differences.exact("late sets", baseline.sets.late, found.sets.late);
    let deadlines: BTreeSet<Deadline> =
        baseline.deadlines.keys().chain(found.deadlines.keys()).copied().collect();
    for deadline in deadlines {
        let slack = |totals: &Totals| totals.deadlines.get(&deadline).map(|found| found.slack);
        let [ours, theirs] = [slack(&baseline), slack(&found)];
        let missed = |slack: &Option<Slack>| slack.as_ref().map(|slack| slack.missed);
        let least = |slack: &Option<Slack>| slack.as_ref().and_then(|slack| slack.least);
        differences.option(format!("missed, {deadline}"), missed(&ours), missed(&theirs));
        differences.option(format!("least slack, {deadline}"), least(&ours), least(&theirs));
    }
    let causes: BTreeSet<Cause> = baseline.causes.keys().chain(found.causes.keys()).copied().collect();
    for cause in causes {
        let of = |totals: &Totals| totals.causes.get(&cause).copied().unwrap_or(0);
        differences.exact(format!("misses by {cause}"), of(&baseline), of(&found));
    }
    differences.0
}

impl Comparison {
    /// The same with bounds: `found` may differ from `baseline` as long as its totals are within each of them.
    ///
    /// # Errors
    /// If a bound is of a deadline that neither of them has.
    pub fn within(
        mut self,
        bounds: &[Allowance],
        [baseline, found]: [&TimingRecord; 2],
    ) -> Result<Self, NoSuchDeadline> {
        let [before, now] = [baseline, found].map(Totals::of);
        bounds.iter().try_for_each(|bound| bound.known_to([&before, &now]))?;
        self.allowed = bounds.iter().map(|bound| bound.of(&now)).collect();
        Ok(self)
    }

    /// Whether the record is as the baseline says, or within the bounds if there are any.
    pub fn is_met(&self) -> bool {
        match self.allowed.as_slice() {
            [] => self.is_same(),
            allowed => allowed.iter().all(|allowed| allowed.is_met),
        }
    }

    /// Returns whether nothing differs from the baseline.
    pub fn is_same(&self) -> bool {
        self.head.is_empty() && self.before_mission.is_empty() && self.frames_that_differ() == 0
    }

    /// Frames with a difference.
    pub fn frames_that_differ(&self) -> usize {
        self.frames.iter().filter(|frame| !frame.differences.is_empty()).count()
    }

    /// The whole comparison as a document; keys as the fields here, and `met`.
    pub fn json(&self) -> Value {
        let Self {
            scenario,
            machine,
            tolerance,
            head,
            keys,
            first_event,
            totals,
            allowed,
            before_mission,
            frames,
            ..
        } = self;
        json!({
            "met": self.is_met(),
            "scenario": scenario,
            "machine": machine,
            "tolerance": tolerance,
            "head": head,
            "keys": keys,
            "first_event": first_event,
            "totals": totals,
            "allowed": allowed,
            "before_mission": before_mission,
            "frames": frames,
        })
    }
}
