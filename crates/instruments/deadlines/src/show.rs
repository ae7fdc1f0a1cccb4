//! Deadlines of some frames: totals, the critical path, the misses of some sweeps.

use std::ops::Range;

use serde_json::{Value, json};
use timing::{FrameTiming, TimingRecord, Totals};

use crate::critical_path::{Chain, chains};
use crate::{DeadlineError, Rehearsal, Routine, misses};

/// A timing record with the critical path of its tightest frame.
pub struct Deadlines<'a> {
    record: &'a TimingRecord,
    /// The frame whose path it is.
    frame: u64,
    chains: Vec<Chain>,
    /// Length of a master tick, and of a sample (ns).
    lengths: [f64; 2],
}

impl<'a> Deadlines<'a> {
    /// Finds the critical path of `record`, made by `rehearsal`.
    ///
    /// # Errors
    /// If a pose cannot be drawn.
    pub fn of(rehearsal: &Rehearsal, record: &'a TimingRecord) -> Result<Self, DeadlineError> {
        let frame = tightest(record);
        let poses = rehearsal.poses(&[frame.frame])?;
        let chains = chains(rehearsal, &poses[0].pose, frame)?;
        let timebase = &rehearsal.stage.settings.timebase;
        let lengths = [timebase.master, timebase.sample_rate()].map(|rate| 1e9 / rate.hertz());
        Ok(Self { record, frame: frame.frame, chains, lengths })
    }

    /// Record and path as text, with every miss in `sweeps`, columns of the picture from 0 at the left.
    pub fn text(&self, sweeps: Option<&Range<u64>>) -> String {
        let Self { record, frame, lengths: [tick, sample], .. } = self;
        let chains: String = self.chains.iter().map(|chain| chain.text(*tick)).collect();
        let misses = sweeps.map_or(String::new(), |sweeps| misses::text(record, sweeps, *sample));
        format!("{}\ncritical path of frame {frame}\n{chains}{misses}", record.text())
    }

    /// The same as a document of schema `lunoid.timing.show/1`.
    pub fn json(&self) -> Value {
        document(self.record, json!({ "frame": self.frame, "chains": self.chains }))
    }

    /// The document of a record without deadlines, which has no critical path. `routines` stand beside what the source reports.
    pub fn json_without(record: &TimingRecord, routines: &[Routine]) -> Value {
        let mut document = document(record, Value::Null);
        if !routines.is_empty() {
            document["routines"] = json!(routines);
        }
        document
    }
}

fn document(record: &TimingRecord, critical_path: Value) -> Value {
    json!({
        "schema": "lunoid.timing.show/1",
        "record": record,
        "totals": Totals::of(record),
        "critical_path": critical_path,
    })
}

/// The frame with the least slack of all; the first of several.
fn tightest(record: &TimingRecord) -> &FrameTiming {
    let least = |frame: &FrameTiming| {
        let all = frame.deadlines.values().filter_map(|slack| slack.least);
        all.min().unwrap_or(i64::MAX)
    };
    let mut frames = record.frames.iter();
    let first = &record.frames[0];
    frames
        .by_ref()
        .fold(first, |tightest, frame| if least(frame) < least(tightest) { frame } else { tightest })
}
