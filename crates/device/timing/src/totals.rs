//! Sums and extremes over the frames of a record.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::deadline::{Deadline, Slack};
use crate::missed::{Cause, Missed};
use crate::record::{FrameTiming, Sets, TimingRecord, UnitUse, Vertices};
use crate::task::Task;

/// A record as a whole. Sums stay at the largest number rather than run over.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Totals {
    /// Number of frames of the record.
    pub frames: u64,
    /// Their length (master ticks).
    pub ticks: u64,
    /// Folds of both ramps.
    pub folds: u64,
    /// What became of the register sets.
    pub sets: Sets,
    /// Words after the stop they were meant for.
    pub late_words: u64,
    /// Counts of the vertices of polyhedra.
    pub vertices: Vertices,
    /// Number of digital events.
    pub events: u64,
    /// When the tasks before the mission are done, one after another (master ticks).
    pub ready_after: u64,
    /// Every kind of deadline.
    pub deadlines: BTreeMap<Deadline, DeadlineTotals>,
    /// Every unit, by name.
    pub units: BTreeMap<String, UnitTotals>,
    /// Tasks of the frames, each with the pieces and ticks of all of them, in the order in which they are first met.
    pub tasks: Vec<Task>,
    /// Tiles of ground that took another level of detail.
    pub level_changes: u64,
    /// Number of misses by cause.
    pub causes: BTreeMap<Cause, u64>,
    /// Misses by sweep: what stands in one column of the picture.
    pub sweeps: BTreeMap<u32, SweepMisses>,
}

/// One kind of deadline over all frames.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct DeadlineTotals {
    /// Slack of all deadlines of the kind.
    pub slack: Slack,
    /// The first frame with the least slack.
    pub worst_frame: Option<u64>,
    /// The miss of that frame that came last after its time.
    pub worst_miss: Option<Missed>,
}

/// One unit over the frames that have it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct UnitTotals {
    /// Utilisation of the idlest frame, of all frames together, and of the busiest frame.
    pub least: f64,
    /// Time at work over time.
    pub mean: f64,
    /// Of the busiest frame.
    pub most: f64,
    /// Most requests that waited at one time.
    pub longest_queue: u32,
    #[serde(skip)]
    busy: u64,
    #[serde(skip)]
    ticks: u64,
}

/// Misses of one sweep over all frames.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct SweepMisses {
    /// Number of misses of the sweep.
    pub misses: u64,
    /// In how many frames.
    pub frames: u64,
}

impl Totals {
    /// Of all frames of `record`.
    pub fn of(record: &TimingRecord) -> Self {
        let mut totals = Self { ready_after: record.ready_after(), ..Self::default() };
        for frame in &record.frames {
            totals.add(frame);
        }
        totals
    }

    /// The sweep and its misses, most misses first.
    pub fn worst_sweeps(&self) -> Vec<(u32, SweepMisses)> {
        let mut sweeps: Vec<_> = self.sweeps.iter().map(|(&sweep, &misses)| (sweep, misses)).collect();
        sweeps.sort_by_key(|&(sweep, found)| (u64::MAX - found.misses, sweep));
        sweeps
    }

    fn add(&mut self, frame: &FrameTiming) {
        self.frames += 1;
        sum(&mut self.ticks, frame.ticks);
        sum(&mut self.folds, frame.folds);
        sum(&mut self.late_words, frame.late_words);
        sum(&mut self.vertices.asked, frame.vertices.asked);
        sum(&mut self.vertices.ready, frame.vertices.ready);
        sum(&mut self.events, frame.events);
        sum(&mut self.level_changes, frame.level_changes.len() as u64);
        self.sets.add(&frame.sets);
        for (&deadline, slack) in &frame.deadlines {
            self.deadlines.entry(deadline).or_default().add(deadline, slack, frame);
        }
        for unit in &frame.units {
            let first = UnitTotals::new();
            self.units.entry(unit.unit.clone()).or_insert(first).add(unit, frame);
        }
        frame.tasks.iter().for_each(|task| self.add_task(task));
        self.add_misses(&frame.misses);
    }

    fn add_task(&mut self, more: &Task) {
        let same = |known: &&mut Task| (&known.unit, &known.task) == (&more.unit, &more.task);
        match self.tasks.iter_mut().find(same) {
            Some(known) => {
                sum(&mut known.pieces, more.pieces);
                sum(&mut known.ticks, more.ticks);
            }
            None => self.tasks.push(more.clone()),
        }
    }

    fn add_misses(&mut self, misses: &[Missed]) {
        let mut of_frame = BTreeMap::<u32, u64>::new();
        for missed in misses {
            *self.causes.entry(missed.cause).or_default() += 1;
            *of_frame.entry(missed.sweep).or_default() += 1;
        }
        for (sweep, count) in of_frame {
            let found = self.sweeps.entry(sweep).or_default();
            found.misses += count;
            found.frames += 1;
        }
    }
}

fn sum(total: &mut u64, more: u64) {
    *total = total.saturating_add(more);
}

impl Sets {
    fn add(&mut self, more: &Self) {
        let Self { wanted, loaded, late, wasted, cancelled } = *more;
        sum(&mut self.wanted, wanted);
        sum(&mut self.loaded, loaded);
        sum(&mut self.late, late);
        sum(&mut self.wasted, wasted);
        sum(&mut self.cancelled, cancelled);
    }
}

impl DeadlineTotals {
    fn add(&mut self, deadline: Deadline, slack: &Slack, frame: &FrameTiming) {
        let least = |slack: &Slack| slack.least.unwrap_or(i64::MAX);
        if slack.least.is_some() && (self.worst_frame.is_none() || least(slack) < least(&self.slack)) {
            self.worst_frame = Some(frame.frame);
            self.worst_miss = latest(deadline, &frame.misses).cloned();
        }
        self.slack.merge(slack);
    }
}

/// The first of those that came last after their time.
fn latest(deadline: Deadline, misses: &[Missed]) -> Option<&Missed> {
    let lateness = |missed: &Missed| missed.lateness().unwrap_or(f64::INFINITY);
    let ours = misses.iter().filter(|missed| missed.deadline == deadline);
    ours.reduce(|worst, missed| if lateness(missed) > lateness(worst) { missed } else { worst })
}

impl UnitTotals {
    fn new() -> Self {
        let least = f64::INFINITY;
        Self { least, mean: 0.0, most: 0.0, longest_queue: 0, busy: 0, ticks: 0 }
    }

    fn add(&mut self, unit: &UnitUse, frame: &FrameTiming) {
        sum(&mut self.busy, unit.busy);
        sum(&mut self.ticks, frame.ticks);
        let used = frame.utilisation(unit);
        self.least = self.least.min(used);
        self.most = self.most.max(used);
        self.mean = self.busy as f64 / self.ticks as f64;
        self.longest_queue = self.longest_queue.max(unit.longest_queue);
    }
}
