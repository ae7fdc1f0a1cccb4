//! Use of units: measured, and by formula.

use timing::{FrameTiming, TimingRecord, Totals};

use super::level::LevelFigures;
use super::report::{Row, row};
use crate::Rehearsal;

/// Returns a row for the use of each unit (%), measured and by formula.
pub fn unit_rows(rehearsal: &Rehearsal, record: &TimingRecord, levels: &[LevelFigures]) -> Vec<Row> {
    let totals = Totals::of(record);
    let cpu = &rehearsal.stage.settings.cpu;
    let vertices = (cpu.vertex * totals.vertices.asked) as f64 / totals.ticks as f64;
    let formulas = UnitFormulas { levels, turning: turning(rehearsal) / 10.0, vertices };
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
            ["drum", name, _] => {
                let level = self.levels.iter().find(|level| level.name == name);
                let load = level.and_then(|level| Some(level.budget.drum?.load * self.turning));
                (load, "R^2 omega/(2 d^2) (latency + record)")
            }
            _ => (None, ""),
        }
    }
}

/// Turning rate of the view, mean over the mission (degrees/s).
fn turning(rehearsal: &Rehearsal) -> f64 {
    let course = rehearsal.stage.scenery.course();
    let turn = |pair: &[scenario::Pose]| {
        let full = 2.0 * std::f64::consts::PI;
        let turn = (pair[1].attitude.heading - pair[0].attitude.heading).abs() % full;
        turn.min(full - turn)
    };
    let time = course.first().zip(course.last()).map_or(0.0, |(first, last)| last.time - first.time);
    if time > 0.0 { quantities::degrees(course.windows(2).map(turn).sum::<f64>()) / time } else { 0.0 }
}
