//! A record held to a baseline.

use serde::Serialize;
use serde_json::{Value, json};

use crate::difference::{Difference, Differences, pairs};
use crate::frame_differences::frame_differences;
use crate::record::TimingRecord;

/// How far analog values may be apart. Everything digital is exact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Tolerance {
    /// Instants on the sweep clock: when a word was due, when it came (samples).
    pub(crate) samples: f64,
    /// Ground ranges (m).
    pub(crate) metres: f64,
}

/// A tolerance under which a comparison says nothing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("tolerance in {unit}: found {found}, expected a finite number of at least 0")]
pub struct ToleranceError {
    /// `samples` or `metres`.
    pub unit: &'static str,
    /// The number given.
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
    /// Tasks before the mission.
    pub before_mission: Vec<Difference>,
    /// Every frame of either side, rising.
    pub frames: Vec<FrameComparison>,
}

/// One frame.
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
    Comparison {
        scenario: found.scenario.clone(),
        machine: found.machine.clone(),
        tolerance: *tolerance,
        head: head_differences(baseline, found),
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
    let TimingRecord { format, scenario, machine, inputs, master, before_mission: _, frames: _ } = baseline;
    let mut differences = Differences::default();
    differences.exact("format", format, &found.format);
    differences.exact("scenario", scenario, &found.scenario);
    differences.exact("machine", machine, &found.machine);
    differences.exact("inputs", inputs, &found.inputs);
    differences.exact("master", master, &found.master);
    differences.0
}

impl Comparison {
    /// Whether the record is as the baseline says.
    pub fn is_met(&self) -> bool {
        self.head.is_empty() && self.before_mission.is_empty() && self.frames_that_differ() == 0
    }

    /// Frames with a difference.
    pub fn frames_that_differ(&self) -> usize {
        self.frames.iter().filter(|frame| !frame.differences.is_empty()).count()
    }

    /// The whole comparison as a document; keys as the fields here, and `met`.
    pub fn json(&self) -> Value {
        let Self { scenario, machine, tolerance, head, before_mission, frames } = self;
        json!({
            "met": self.is_met(),
            "scenario": scenario,
            "machine": machine,
            "tolerance": tolerance,
            "head": head,
            "before_mission": before_mission,
            "frames": frames,
        })
    }
}
