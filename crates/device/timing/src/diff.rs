//! A comparison as a diff that a person reads.

use std::fmt::{self, Write};

use crate::comparison::{Comparison, MovedEvent};
use crate::difference::Difference;

/// What is said of a baseline with another head whose keys are not known.
const UNKNOWN_KEYS: &str =
    "the baseline is of other inputs; it is older than the keys of a record, so it cannot name them";

/// What is said where no key differs.
const SAME_KEYS: &str = "the baseline is of other inputs, though every key is the same: ground, path, a file that the scenario names, or the program differs";

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
        for allowed in &self.allowed {
            let side = if allowed.is_met { "within" } else { "beyond" };
            writeln!(out, "{side} {}: {}", allowed.bound, allowed.told())?;
        }
        if !self.head.is_empty() {
            writeln!(out, "{}", self.cause())?;
            out.push_str(&diff(&self.keys, KEYS));
        }
        if let Some(event) = &self.first_event {
            write!(out, "{event}")?;
        }
        if !self.totals.is_empty() {
            writeln!(out, "totals:")?;
            self.totals.iter().try_for_each(|total| writeln!(out, "  {}", from_to(total)))?;
        }
        if !self.head.is_empty() {
            writeln!(out, "@@ head @@")?;
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

    /// In what the baseline's run is another one.
    pub(crate) fn cause(&self) -> String {
        match (self.has_keys, self.keys.len()) {
            (false, _) => UNKNOWN_KEYS.to_owned(),
            (true, 0) => SAME_KEYS.to_owned(),
            (true, 1) => format!("the baseline is of other inputs: {} differs", self.keys[0].place),
            (true, many) => format!("the baseline is of other inputs: {many} keys differ"),
        }
    }

    /// The totals that moved, in one line.
    pub(crate) fn totals_line(&self) -> String {
        self.totals.iter().map(from_to).collect::<Vec<_>>().join(", ")
    }

    fn write_verdict(&self, out: &mut String) -> fmt::Result {
        let Self { scenario, machine, frames, .. } = self;
        let (all, differ) = (frames.len(), self.frames_that_differ());
        if self.is_same() {
            return writeln!(out, "baseline met: {scenario} on {machine}, frames: {all}");
        }
        if self.is_met() {
            write!(
                out,
                "baseline met within what is allowed: {scenario} on {machine}, frames that differ: {differ} of {all}"
            )?;
            return match self.head.is_empty() {
                true => writeln!(out),
                false => writeln!(out, "; {}", self.cause()),
            };
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

/// Keys that are told one by one.
const KEYS: usize = 20;

/// A number of the baseline and what it is now.
fn from_to(total: &Difference) -> String {
    let told = |value: &Option<String>| value.clone().unwrap_or_else(|| "none".to_owned());
    format!("{} {} to {}", total.place, told(&total.baseline), told(&total.found))
}

impl fmt::Display for MovedEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { frame, sweep, baseline, found } = self;
        let place = sweep.map_or(String::new(), |sweep| format!(", sweep {sweep}"));
        let told = |event: &Option<String>| event.clone().unwrap_or_else(|| "nothing".to_owned());
        writeln!(f, "first event that moved: frame {frame}{place}")?;
        writeln!(f, "-{}", told(baseline))?;
        writeln!(f, "+{}", told(found))
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
