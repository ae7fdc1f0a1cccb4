//! Two timings of one frame, value by value. Every structure is taken apart by name: a value that joins a record later
//! cannot be forgotten here.

use std::collections::{BTreeMap, BTreeSet};

use crate::comparison::Tolerance;
use crate::deadline::{Deadline, Slack};
use crate::difference::{Difference, Differences, pairs};
use crate::level_change::LevelChange;
use crate::missed::Missed;
use crate::record::{FrameTiming, Sets, UnitUse, Vertices};
use crate::task::Task;
use crate::text::place_of_miss;

/// Everything in which `found` is not as `baseline`: digital times and counters exactly, analog instants within
/// `tolerance`, misses by identity.
pub(crate) fn frame_differences(
    baseline: &FrameTiming,
    found: &FrameTiming,
    tolerance: &Tolerance,
) -> Vec<Difference> {
    let FrameTiming {
        frame,
        ticks,
        folds,
        sets,
        late_words,
        vertices,
        deadlines,
        units,
        tasks,
        level_changes,
        misses,
        events,
        events_blake3,
    } = baseline;
    let mut differences = Differences::default();
    differences.exact("frame", frame, &found.frame);
    differences.exact("ticks", ticks, &found.ticks);
    differences.exact("folds", folds, &found.folds);
    differences.sets(sets, &found.sets);
    differences.exact("late_words", late_words, &found.late_words);
    differences.vertices(vertices, &found.vertices);
    differences.deadlines(deadlines, &found.deadlines);
    differences.units(units, &found.units);
    differences.tasks("tasks", tasks, &found.tasks);
    differences.level_changes(level_changes, &found.level_changes, tolerance);
    differences.misses(misses, &found.misses, tolerance);
    differences.exact("events", events, &found.events);
    differences.exact("events_blake3", events_blake3, &found.events_blake3);
    differences.0
}

type Slacks = BTreeMap<Deadline, Slack>;

impl Differences {
    fn sets(&mut self, baseline: &Sets, found: &Sets) {
        let Sets { wanted, loaded, late, wasted, cancelled } = *baseline;
        self.exact("sets.wanted", wanted, found.wanted);
        self.exact("sets.loaded", loaded, found.loaded);
        self.exact("sets.late", late, found.late);
        self.exact("sets.wasted", wasted, found.wasted);
        self.exact("sets.cancelled", cancelled, found.cancelled);
    }

    fn vertices(&mut self, baseline: &Vertices, found: &Vertices) {
        let Vertices { asked, ready } = *baseline;
        self.exact("vertices.asked", asked, found.asked);
        self.exact("vertices.ready", ready, found.ready);
    }

    fn deadlines(&mut self, baseline: &Slacks, found: &Slacks) {
        let all: BTreeSet<Deadline> = baseline.keys().chain(found.keys()).copied().collect();
        for deadline in all {
            let place = format!("deadlines.{deadline}");
            let described = |slack: &Slack| format!("{} deadlines, {} missed", slack.count, slack.missed);
            match (baseline.get(&deadline), found.get(&deadline)) {
                (Some(baseline), Some(found)) => self.slack(&place, baseline, found),
                (baseline, found) => self.option(place, baseline.map(described), found.map(described)),
            }
        }
    }

    fn slack(&mut self, place: &str, baseline: &Slack, found: &Slack) {
        let Slack { count, missed, least, bins } = *baseline;
        self.exact(format!("{place}.count"), count, found.count);
        self.exact(format!("{place}.missed"), missed, found.missed);
        self.option(format!("{place}.least"), least, found.least);
        for (bin, (baseline, found)) in bins.into_iter().zip(found.bins).enumerate() {
            self.exact(format!("{place}.bins[{}]", Slack::bin_label(bin)), baseline, found);
        }
    }

    fn units(&mut self, baseline: &[UnitUse], found: &[UnitUse]) {
        for (name, baseline, found) in pairs(baseline, found, |unit| unit.unit.as_str()) {
            let place = format!("units.{name}");
            let described = |unit: &UnitUse| format!("{} ticks at work", unit.busy);
            match (baseline, found) {
                (Some(baseline), Some(found)) => self.unit(&place, baseline, found),
                (baseline, found) => self.option(place, baseline.map(described), found.map(described)),
            }
        }
    }

    fn unit(&mut self, place: &str, baseline: &UnitUse, found: &UnitUse) {
        let UnitUse { unit: _, busy, longest_queue } = *baseline;
        self.exact(format!("{place}.busy"), busy, found.busy);
        self.exact(format!("{place}.longest_queue"), longest_queue, found.longest_queue);
    }

    /// Tasks of `list`, by unit and name.
    pub(crate) fn tasks(&mut self, list: &str, baseline: &[Task], found: &[Task]) {
        let described = |task: &Task| format!("{} pieces, {} ticks", task.pieces, task.ticks);
        for ((unit, task), baseline, found) in pairs(baseline, found, |task| (&task.unit, &task.task)) {
            let place = format!("{list}.{unit}.{task}");
            match (baseline, found) {
                (Some(baseline), Some(found)) => {
                    self.exact(format!("{place}.pieces"), baseline.pieces, found.pieces);
                    self.exact(format!("{place}.ticks"), baseline.ticks, found.ticks);
                }
                (baseline, found) => self.option(place, baseline.map(described), found.map(described)),
            }
        }
    }

    fn level_changes(&mut self, baseline: &[LevelChange], found: &[LevelChange], tolerance: &Tolerance) {
        let described = |change: &LevelChange| format!("level {} to {}", change.from, change.to);
        for (tile, baseline, found) in pairs(baseline, found, |change| change.tile.as_str()) {
            let place = format!("level_changes.{tile}");
            match (baseline, found) {
                (Some(baseline), Some(found)) => self.level_change(&place, baseline, found, tolerance),
                (baseline, found) => self.option(place, baseline.map(described), found.map(described)),
            }
        }
    }

    fn level_change(
        &mut self,
        place: &str,
        baseline: &LevelChange,
        found: &LevelChange,
        tolerance: &Tolerance,
    ) {
        let LevelChange { tile: _, from, to, distance_m, fraction, borders_m } = *baseline;
        self.exact(format!("{place}.from"), from, found.from);
        self.exact(format!("{place}.to"), to, found.to);
        let distances = [distance_m, found.distance_m].map(Some);
        self.near(format!("{place}.distance_m"), distances[0], distances[1], tolerance.metres);
        self.exact(format!("{place}.fraction"), fraction, found.fraction);
        for (side, (own, other)) in borders_m.into_iter().zip(found.borders_m).enumerate() {
            self.near(format!("{place}.borders_m[{side}]"), Some(own), Some(other), tolerance.metres);
        }
    }

    fn misses(&mut self, baseline: &[Missed], found: &[Missed], tolerance: &Tolerance) {
        for (_, baseline, found) in pairs(baseline, found, identity) {
            match (baseline, found) {
                (Some(baseline), Some(found)) => self.missed(baseline, found, tolerance),
                (Some(gone), None) => self.tell(place(gone), Some(described(gone)), None),
                (None, Some(new)) => self.tell(place(new), None, Some(described(new))),
                (None, None) => {}
            }
        }
    }

    fn missed(&mut self, baseline: &Missed, found: &Missed, tolerance: &Tolerance) {
        let Missed { due, came, range_m, region, words, cause, .. } = baseline;
        let Tolerance { samples, metres } = *tolerance;
        let place = place(baseline);
        let corner = |region: Option<[i64; 2]>| region.map(|[m, n]| format!("{m} {n}"));
        self.near(format!("{place}.due"), Some(*due), Some(found.due), samples);
        self.near(format!("{place}.came"), *came, found.came, samples);
        self.near(format!("{place}.range_m"), *range_m, found.range_m, metres);
        self.option(format!("{place}.region"), corner(*region), corner(found.region));
        self.exact(format!("{place}.words"), *words, found.words);
        self.exact(format!("{place}.cause"), *cause, found.cause);
    }
}

type Identity<'a> = (u32, Option<u32>, Deadline, [Option<&'a str>; 3], Option<u32>);

/// What makes two misses of a frame one and the same.
fn identity(missed: &Missed) -> Identity<'_> {
    let Missed { deadline, sweep, crossing, colour, register, part, crater, .. } = missed;
    let words = [colour, register, part].map(Option::as_deref);
    (*sweep, *crossing, *deadline, words, *crater)
}

fn place(missed: &Missed) -> String {
    format!("miss ({}, {})", place_of_miss(missed), missed.deadline)
}

fn described(missed: &Missed) -> String {
    let Missed { due, region, range_m, words, cause, .. } = missed;
    let came = match (missed.came, missed.lateness()) {
        (Some(came), Some(late)) => format!("came {came} ({late:.3} late)"),
        _ => "never came".to_owned(),
    };
    let corner = region.map_or(String::new(), |[m, n]| format!(", corner {m} {n}"));
    let range = range_m.map_or(String::new(), |range| format!(", range {range} m"));
    format!("due {due}, {came}{corner}{range}, words {words:#05x}, {cause}")
}
