//! What holds in every timing record, whoever wrote it.

use std::collections::BTreeSet;

use crate::deadline::{BINS, Slack};
use crate::level_change::LevelChange;
use crate::missed::Missed;
use crate::record::{FORMAT, FrameTiming, TimingRecord, Vertices};
use crate::task::Task;

/// Words of a register set: bits of [`Missed::words`].
const WORDS: u16 = 9;

/// Something that cannot be so: where, what is found, and what is expected.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{place}: found {found}, expected {expected}")]
pub struct Fault {
    /// Keys down to the value.
    pub place: String,
    /// Value that was found there.
    pub found: String,
    /// What could stand there.
    pub expected: String,
}

impl Fault {
    fn new(place: impl Into<String>, found: impl ToString, expected: impl Into<String>) -> Self {
        Self { place: place.into(), found: found.to_string(), expected: expected.into() }
    }

    fn within(self, place: &str) -> Self {
        Self { place: format!("{place}, {}", self.place), ..self }
    }
}

type Checked = Result<(), Fault>;

impl TimingRecord {
    /// Whether the record holds together: frames in rising order, sums of bins, finite instants, hashes of
    /// hexadecimal digits, units named once.
    ///
    /// # Errors
    /// The first [`Fault`].
    pub fn check(&self) -> Result<(), Fault> {
        if self.format != FORMAT {
            return Err(Fault::new("format", self.format, FORMAT.to_string()));
        }
        check_hex("inputs", &self.inputs, None)?;
        check_tasks("before_mission", &self.before_mission)?;
        if self.frames.is_empty() {
            return Err(Fault::new("frames", "none", "at least one"));
        }
        for pair in self.frames.windows(2) {
            let [before, frame] = [pair[0].frame, pair[1].frame];
            if frame <= before {
                return Err(Fault::new("frames", frame, format!("a frame above {before}, in rising order")));
            }
        }
        self.frames.iter().try_for_each(|frame| {
            check_frame(frame).map_err(|fault| fault.within(&format!("frame {}", frame.frame)))
        })
    }
}

fn check_tasks(list: &str, tasks: &[Task]) -> Checked {
    let mut names = BTreeSet::new();
    tasks.iter().try_for_each(|Task { unit, task, pieces, ticks }| {
        let place = |key: &str| format!("{list}, {unit} {task}{key}");
        if !names.insert([unit, task]) {
            return Err(Fault::new(place(""), "it twice", "every task of a unit once"));
        }
        let mut counts = [("pieces", pieces), ("ticks", ticks)].into_iter();
        match counts.find(|(_, count)| **count == 0) {
            Some((key, _)) => Err(Fault::new(place(&format!(", {key}")), 0, "at least 1")),
            None => Ok(()),
        }
    })
}

fn check_frame(frame: &FrameTiming) -> Checked {
    if frame.ticks == 0 {
        return Err(Fault::new("ticks", 0, "at least 1"));
    }
    check_hex("events_blake3", &frame.events_blake3, Some(2 * blake3::OUT_LEN))?;
    let Vertices { asked, ready } = frame.vertices;
    if ready > asked {
        return Err(Fault::new("vertices.ready", ready, format!("at most the {asked} asked for")));
    }
    for (deadline, slack) in &frame.deadlines {
        check_slack(slack).map_err(|fault| fault.within(&format!("deadlines.{deadline}")))?;
    }
    let mut names = BTreeSet::new();
    for unit in &frame.units {
        if !names.insert(&unit.unit) {
            return Err(Fault::new("units", format!("{} twice", unit.unit), "every unit once"));
        }
    }
    check_tasks("tasks", &frame.tasks)?;
    check_level_changes(&frame.level_changes)?;
    let mut misses = frame.misses.iter().enumerate();
    misses.try_for_each(|(index, missed)| {
        check_missed(missed).map_err(|fault| fault.within(&format!("misses[{index}]")))
    })
}

fn check_hex(place: &str, text: &str, digits: Option<usize>) -> Checked {
    let is_hex = text.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f'));
    if is_hex && digits.map_or(!text.is_empty(), |digits| text.len() == digits) {
        return Ok(());
    }
    let many = digits.map_or(String::new(), |digits| format!("{digits} "));
    Err(Fault::new(place, format!("`{text}`"), format!("{many}lower-case hexadecimal digits")))
}

fn check_slack(slack: &Slack) -> Checked {
    let sum = |bins: &[u64]| bins.iter().try_fold(0u64, |sum, &bin| sum.checked_add(bin));
    if sum(&slack.bins) != Some(slack.count) {
        return Err(Fault::new("count", slack.count, "the sum of the bins"));
    }
    if sum(&slack.bins[..BINS / 2]) != Some(slack.missed) {
        return Err(Fault::new("missed", slack.missed, "the sum of the first eight bins"));
    }
    if slack.least.map(Slack::bin_of) != slack.bins.iter().position(|&count| count > 0) {
        let found = slack.least.map_or("none".to_owned(), |least| least.to_string());
        return Err(Fault::new("least", found, "a slack of the first bin that is not empty"));
    }
    Ok(())
}

fn check_level_changes(changes: &[LevelChange]) -> Checked {
    let mut tiles = BTreeSet::new();
    changes.iter().try_for_each(|LevelChange { tile, from, to, distance_m, fraction, borders_m }| {
        let place = |key: &str| format!("level_changes, {tile}{key}");
        if !tiles.insert(tile) {
            return Err(Fault::new(place(""), "it twice", "every tile once"));
        }
        if from == to {
            return Err(Fault::new(place(", to"), to, "another level than `from`"));
        }
        if !(distance_m.is_finite() && *distance_m >= 0.0) {
            return Err(Fault::new(place(", distance_m"), distance_m, "metres, 0 or more"));
        }
        let [south, west, north, east] = borders_m;
        if !(borders_m.iter().all(|border| border.is_finite()) && south < north && west < east) {
            let found = format!("{borders_m:?}");
            return Err(Fault::new(place(", borders_m"), found, "south, west, north, east in metres"));
        }
        match (0.0..=1.0).contains(fraction) {
            true => Ok(()),
            false => Err(Fault::new(place(", fraction"), fraction, "0 to 1")),
        }
    })
}

fn check_missed(missed: &Missed) -> Checked {
    let instants = [("due", Some(missed.due)), ("came", missed.came), ("range_m", missed.range_m)];
    for (place, value) in instants {
        if let Some(value) = value.filter(|value| !value.is_finite()) {
            return Err(Fault::new(place, value, "a finite number"));
        }
    }
    if missed.words >> WORDS != 0 {
        return Err(Fault::new(
            "words",
            missed.words,
            format!("bits of {WORDS} words, at most {}", (1 << WORDS) - 1),
        ));
    }
    Ok(())
}
