//! Timing as numbers with labels, for plots.

use crate::deadline::{Deadline, Slack};
use crate::record::{FrameTiming, TimingRecord};

impl FrameTiming {
    /// Every unit with its utilisation (0..=1; more if its work runs over), in the order of the record.
    pub fn unit_utilisation(&self) -> Vec<(String, f64)> {
        self.units.iter().map(|unit| (unit.unit.clone(), self.utilisation(unit))).collect()
    }
}

impl TimingRecord {
    /// Label (ticks of slack) and number of deadlines of one kind, over all frames.
    pub fn slack_histogram(&self, deadline: Deadline) -> Vec<(String, f64)> {
        let mut slack = Slack::default();
        for found in self.frames.iter().filter_map(|frame| frame.deadlines.get(&deadline)) {
            slack.merge(found);
        }
        slack.histogram()
    }

    /// Frame and utilisation of one unit, for the frames that have it.
    pub fn utilisation_over_frames(&self, unit: &str) -> Vec<(u64, f64)> {
        let of_frame = |frame: &FrameTiming| {
            let found = frame.units.iter().find(|found| found.unit == unit)?;
            Some((frame.frame, frame.utilisation(found)))
        };
        self.frames.iter().filter_map(of_frame).collect()
    }
}
