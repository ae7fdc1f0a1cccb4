//! Use of units: measured, and by formula.

use std::collections::BTreeMap;

use hardware_model::{BankPlace, KindBank};
use machine::BankDemand;
use quantities::{degrees, radians};
use timing::{FrameTiming, TimingRecord, Totals};

use super::level::LevelFigures;
use super::report::{Row, row};
use crate::Rehearsal;

/// Returns a row for the use of each unit (%), measured and by formula.
pub fn unit_rows(rehearsal: &Rehearsal, record: &TimingRecord, levels: &[LevelFigures]) -> Vec<Row> {
    let totals = Totals::of(record);
    let cpu = &rehearsal.stage.settings.cpu;
    let vertices = (cpu.vertex * totals.vertices.asked) as f64 / totals.ticks as f64;
    let mut kinds = kind_loads(rehearsal, levels);
    // A kind that the scenario does not have has no unit.
    kinds
        .retain(|kind| totals.units.keys().any(|unit| unit.starts_with("drum.") && unit.contains(kind.name)));
    let turning = turning(rehearsal) / 10.0;
    let formulas = UnitFormulas { levels, turning, vertices, kinds };
    let rows = totals.units.iter().map(|(name, unit)| {
        let (formula, law) = formulas.of(name);
        row(format!("{name}_pct"), format!("{name} (%)"), 100.0 * unit.mean, formula.map(|f| 100.0 * f), law)
    });
    rows.chain(crossing_row(rehearsal, record, levels)).collect()
}

/// One crossing by interrupt, where the processor serves them.
fn crossing_row(rehearsal: &Rehearsal, record: &TimingRecord, levels: &[LevelFigures]) -> Option<Row> {
    let busy = |frame: &FrameTiming| {
        frame.units.iter().find(|unit| unit.unit == "cpu.interrupts").map(|unit| unit.busy)
    };
    let ticks: u64 = record.frames.iter().filter_map(busy).sum();
    let folds: u64 = record.frames.iter().map(|frame| frame.folds).sum();
    let us = 1e6 / rehearsal.stage.settings.timebase.master.hertz();
    let measured = (folds > 0).then(|| us * ticks as f64 / folds as f64);
    let formula = levels.first().map(|level| 1e6 * level.budget.cpu.crossing);
    let meaning = "one crossing by interrupt (µs)";
    (ticks > 0).then(|| {
        row("cpu_crossing_us", meaning, measured, formula, "t_int + instructions, if all are served")
    })
}

/// Shares of time by formula.
struct UnitFormulas<'a> {
    levels: &'a [LevelFigures],
    /// How fast the view turns, as a share of 10 degrees/s, for which the drum's formula stands.
    turning: f64,
    /// Share of time that the processor spends on the vertices asked for.
    vertices: f64,
    /// Kinds of data on drums.
    kinds: Vec<KindLoad>,
}

impl UnitFormulas<'_> {
    fn of(&self, unit: &str) -> (Option<f64>, &'static str) {
        let sum = |share: fn(&LevelFigures) -> f64| self.levels.iter().map(share).sum::<f64>();
        let once = |share: fn(&LevelFigures) -> f64| self.levels.first().map_or(0.0, share);
        let [set_ups, tables] =
            [once(|level| level.budget.cpu.sweep_setup), once(|level| level.budget.cpu.frame_tables)];
        let [interrupts, words] =
            [sum(|level| level.budget.cpu.interrupts), sum(|level| level.budget.cpu.loads)];
        match unit.split('.').collect::<Vec<_>>()[..] {
            ["cpu"] => (Some(interrupts + words + set_ups + tables + self.vertices), "all of its tasks"),
            ["cpu", "interrupts"] => (Some(interrupts), "n (t_int + instructions)/T"),
            ["cpu", "words"] => (Some(words), "36 n words/T, by program or stolen"),
            ["cpu", "set-ups"] => (Some(set_ups), "a set-up/T"),
            ["cpu", "tables"] => (Some(tables), "tables f"),
            ["cpu", "vertices"] => (Some(self.vertices), "vertices asked for, each its time"),
            ["loader", _] | ["io-processor"] => {
                (Some(sum(|level| level.budget.loader.busy / level.budget.sweep.period)), "4 sets a crossing")
            }
            ["drum", bank, _] => (self.bank(bank), DRUM_LAW),
            ["drum", _, _, kind] => (self.kind(kind), DRUM_LAW),
            _ => (None, ""),
        }
    }
}

impl UnitFormulas<'_> {
    /// Share of the time of a bank's drums, of all kinds of data that lie on them.
    fn bank(&self, bank: &str) -> Option<f64> {
        let of_others = self.kinds.iter().filter(|kind| kind.on == bank && kind.name != bank);
        self.kind(bank).map(|own| own + of_others.map(|kind| kind.load * self.turning).sum::<f64>())
    }

    /// Share of the time of the drums that one kind of data takes.
    fn kind(&self, name: &str) -> Option<f64> {
        let kind = self.kinds.iter().find(|kind| kind.name == name);
        kind.map(|kind| kind.load * self.turning)
    }
}

/// What a kind of data takes of the drums that it lies on.
struct KindLoad {
    name: &'static str,
    /// Kind after which the drums are called.
    on: &'static str,
    /// Share of their time in a turn of 10 degrees/s.
    load: f64,
}

const DRUM_LAW: &str = "R^2 omega/(2 d^2) k (latency + record), k records for d x d";

/// The kinds of data on drums. A square of those beside terrain has as many records as the squares in sight have in the mean as the
/// mission begins.
fn kind_loads(rehearsal: &Rehearsal, levels: &[LevelFigures]) -> Vec<KindLoad> {
    let settings = &rehearsal.stage.settings;
    let (banks, Some(drum)) = (&settings.kind_banks, settings.data_banks.drum) else { return Vec::new() };
    let on = |name, place| if place == BankPlace::Together { "fine" } else { name };
    let terrain = levels.iter().filter_map(|level| {
        let place = if level.name == "coarse" { banks.coarse } else { BankPlace::Apart };
        Some(KindLoad { name: level.name, on: on(level.name, place), load: level.budget.drum?.load })
    });
    let demands = rehearsal.pool.install(|| rehearsal.control.demands(0));
    let asked: BTreeMap<&str, u64> = demands.iter().flatten().map(first_asked).collect();
    let of_squares = |name, bank: &KindBank| {
        let side = f64::from(bank.record_regions) * levels.first()?.region_size;
        let reach = settings.range.end / side;
        let squares = |angle: f64| 0.5 * reach * reach * angle;
        let in_sight = squares(2.0 * libm::atan(settings.raster.field.tan_half_width));
        let records = asked.get(name).map_or(0.0, |&records| records as f64 / in_sight);
        let word = drum.word.max(settings.data_banks.channels.word);
        let ticks = 0.5 * drum.rotation as f64 + f64::from(bank.record_words) * word;
        let fetch = ticks / settings.timebase.master.hertz();
        let load = squares(radians(10.0)) * records * fetch / f64::from(drum.count);
        (bank.place != BankPlace::Local).then(|| KindLoad { name, on: on(name, bank.place), load })
    };
    let others =
        [("features", &banks.features), ("shadows", &banks.shadows), ("polyhedra", &banks.polyhedra)];
    terrain.chain(others.into_iter().filter_map(|(name, bank)| of_squares(name, bank))).collect()
}

/// Kind of a demand, and the records that its first frame asks for.
fn first_asked(demand: &BankDemand) -> (&'static str, u64) {
    let pieces = demand.asked.first().into_iter().flatten();
    (demand.kind.name(), pieces.map(|piece| u64::from(piece.records)).sum())
}

/// Turning rate of the view, mean over the mission (degrees/s).
fn turning(rehearsal: &Rehearsal) -> f64 {
    let course = rehearsal.stage.scenery.course().to_vec();
    let turn = |pair: &[scenario::Pose]| {
        let full = 2.0 * std::f64::consts::PI;
        let turn = (pair[1].attitude.heading - pair[0].attitude.heading).abs() % full;
        turn.min(full - turn)
    };
    let time = course.first().zip(course.last()).map_or(0.0, |(first, last)| last.time - first.time);
    if time > 0.0 { degrees(course.windows(2).map(turn).sum::<f64>()) / time } else { 0.0 }
}
