//! A comparison as a diff that a person reads.

use std::fmt::{self, Write};

use crate::comparison::Comparison;
use crate::difference::Difference;

/// What is said of a baseline with another head, before anything else.
pub(crate) const OTHER_INPUTS: &str =
    "the baseline is of other inputs: check against the right one, or record it again";

impl Comparison {
    /// Verdict, differences of the head, then differences frame by frame: the first `limit`, and how many more there
    /// are. `-` is the baseline, `+` what was found.
    pub fn text(&self, limit: usize) -> String {
        let mut out = String::new();
        // A string takes whatever is written to it.
        let _ = self.write(&mut out, limit);
        out
    }

    fn write(&self, out: &mut String, limit: usize) -> fmt::Result {
        self.write_verdict(out)?;
        if !self.head.is_empty() {
            writeln!(out, "{OTHER_INPUTS}")?;
            out.push_str(&diff(&self.head, self.head.len()));
        }
        if !self.before_mission.is_empty() {
            writeln!(out, "@@ before the mission @@")?;
            out.push_str(&diff(&self.before_mission, self.before_mission.len()));
        }
        let mut left = limit;
        for frame in self.frames.iter().filter(|frame| !frame.differences.is_empty()) {
            if left > 0 {
                writeln!(out, "@@ frame {} @@", frame.frame)?;
                out.push_str(&lines(&frame.differences, left));
            }
            left = left.saturating_sub(frame.differences.len());
        }
        self.write_rest(out, limit)
    }

    fn write_verdict(&self, out: &mut String) -> fmt::Result {
        let Self { scenario, machine, frames, .. } = self;
        let (all, differ) = (frames.len(), self.frames_that_differ());
        if self.is_met() {
            return writeln!(out, "baseline met: {scenario} on {machine}, frames: {all}");
        }
        writeln!(out, "baseline not met: {scenario} on {machine}, frames that differ: {differ} of {all}")
    }

    fn write_rest(&self, out: &mut String, limit: usize) -> fmt::Result {
        let all: usize = self.frames.iter().map(|frame| frame.differences.len()).sum();
        match all.saturating_sub(limit) {
            0 => Ok(()),
            more => writeln!(out, "and {more} more"),
        }
    }
}

/// The first `limit` differences, and how many more there are.
pub(crate) fn diff(differences: &[Difference], limit: usize) -> String {
    match differences.len().saturating_sub(limit) {
        0 => lines(differences, limit),
        more => format!("{}and {more} more\n", lines(differences, limit)),
    }
}

fn lines(differences: &[Difference], limit: usize) -> String {
    differences.iter().take(limit).map(Difference::to_string).collect()
}

impl fmt::Display for Difference {
    /// One line for each side that has the value.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (sign, value) in [('-', &self.baseline), ('+', &self.found)] {
            if let Some(value) = value {
                writeln!(f, "{sign}{}: {value}", self.place)?;
            }
        }
        Ok(())
    }
}
