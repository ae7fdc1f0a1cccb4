//! Timing of the digital side over some frames of a run, as much of it as a page shows.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use timing::{Cause, Deadline, FrameTiming, Sets, Slack, TimingRecord, Totals, UnitTotals};

/// Timing over some frames.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TimingSummary {
    /// Frames that were summed up, ascending.
    pub frames: Vec<u64>,
    /// Period of the master clock (s).
    pub tick_s: f64,
    /// Length of all of them (master ticks); 0 in a folder of before it was told.
    #[serde(default)]
    pub ticks: u64,
    /// Folds of both ramps.
    pub folds: u64,
    /// Words after the stop they were meant for.
    pub late_words: u64,
    /// What became of the register sets.
    pub sets: Sets,
    /// Every kind of deadline that the machine has.
    pub deadlines: Vec<DeadlineLine>,
    /// Every unit, by name.
    pub units: Vec<UnitLine>,
    /// Number of misses by their cause.
    pub causes: BTreeMap<Cause, u64>,
    /// Sweeps with misses, ascending, and how many they have.
    pub sweeps: Vec<(u32, u64)>,
    /// Sweeps with misses, ascending, of each of the frames; none in a folder of before they were told.
    #[serde(default)]
    pub late: Vec<Vec<u32>>,
}

/// One kind of deadline.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DeadlineLine {
    /// Kind of the deadline.
    pub deadline: Deadline,
    /// Slack of all (master ticks).
    pub slack: Slack,
    /// The first frame with the least slack.
    pub worst_frame: Option<u64>,
}

/// One unit: time at work over time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UnitLine {
    /// Name of the unit.
    pub unit: String,
    /// Of the idlest frame.
    pub least: f64,
    /// Use over all frames, 0 to 1.
    pub mean: f64,
    /// Of the busiest frame.
    pub most: f64,
    /// Most requests that waited at one time.
    pub longest_queue: u32,
}

impl TimingSummary {
    /// Of all frames of `record`, whose master clock has the period `tick_s` (s).
    pub fn of(record: &TimingRecord, tick_s: f64) -> Self {
        let totals = Totals::of(record);
        let deadline = |(deadline, line): (Deadline, timing::DeadlineTotals)| DeadlineLine {
            deadline,
            slack: line.slack,
            worst_frame: line.worst_frame,
        };
        let unit = |(unit, line): (String, UnitTotals)| {
            let UnitTotals { least, mean, most, longest_queue, .. } = line;
            UnitLine { unit, least, mean, most, longest_queue }
        };
        let late = |frame: &FrameTiming| {
            let mut sweeps: Vec<u32> = frame.misses.iter().map(|miss| miss.sweep).collect();
            sweeps.sort_unstable();
            sweeps.dedup();
            sweeps
        };
        Self {
            frames: record.frames.iter().map(|frame| frame.frame).collect(),
            tick_s,
            ticks: totals.ticks,
            folds: totals.folds,
            late_words: totals.late_words,
            sets: totals.sets,
            deadlines: totals.deadlines.into_iter().map(deadline).collect(),
            units: totals.units.into_iter().map(unit).collect(),
            causes: totals.causes,
            late: record.frames.iter().map(late).collect(),
            sweeps: totals.sweeps.into_iter().map(|(sweep, found)| (sweep, found.misses)).collect(),
        }
    }
}
