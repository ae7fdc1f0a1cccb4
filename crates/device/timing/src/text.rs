//! A record as tables that a person reads.

use std::fmt::{self, Write};

use crate::level_change::LevelChange;
use crate::missed::Missed;
use crate::record::TimingRecord;
use crate::task::Task;
use crate::totals::{DeadlineTotals, SweepMisses, Totals, UnitTotals};

/// Sweeps of which a table tells the misses.
const SWEEPS_SHOWN: usize = 12;

/// Changes of level that a table tells.
const LEVELS_SHOWN: usize = 24;

impl TimingRecord {
    /// Tables of the whole record: counters, deadlines, use of units, tasks, changes of level, misses by cause and by sweep. One without deadlines
    /// has its units and tasks alone.
    pub fn text(&self) -> String {
        let mut out = String::new();
        // A string takes whatever is written to it.
        let _ = write_tables(&mut out, self);
        out
    }
}

fn write_tables(out: &mut String, record: &TimingRecord) -> fmt::Result {
    let totals = Totals::of(record);
    write_head(out, record)?;
    write_tasks(out, record)?;
    if totals.deadlines.is_empty() {
        write_units(out, &totals)?;
        return write_frame_tasks(out, &totals);
    }
    write_counters(out, &totals)?;
    write_deadlines(out, &totals)?;
    write_units(out, &totals)?;
    write_frame_tasks(out, &totals)?;
    write_level_changes(out, record)?;
    write_causes(out, &totals)?;
    write_sweeps(out, &totals)
}

fn write_head(out: &mut String, record: &TimingRecord) -> fmt::Result {
    let TimingRecord { scenario, machine, inputs, master, frames, .. } = record;
    write!(out, "{scenario} on {machine}, master clock {master}, ")?;
    match frames.as_slice() {
        [] => writeln!(out, "no frame")?,
        [only] => writeln!(out, "frame {}", only.frame)?,
        [first, .., last] => writeln!(out, "{} frames, {} to {}", frames.len(), first.frame, last.frame)?,
    }
    writeln!(out, "inputs {inputs}")
}

/// The last line has their sum, in frames, too.
fn write_tasks(out: &mut String, record: &TimingRecord) -> fmt::Result {
    if record.before_mission.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{:<20} {:<16} {:>10} {:>14}", "before the mission", "task", "pieces", "ticks")?;
    for Task { unit, task, pieces, ticks } in &record.before_mission {
        writeln!(out, "{unit:<20} {task:<16} {pieces:>10} {ticks:>14}")?;
    }
    let ready = record.ready_after();
    write!(out, "{:<48} {ready:>14}", "ready after")?;
    let frame = record.frames.first().map_or(0, |frame| frame.ticks);
    if frame > 0 { writeln!(out, "  {:.2} frames", ready as f64 / frame as f64) } else { writeln!(out) }
}

fn write_counters(out: &mut String, totals: &Totals) -> fmt::Result {
    let sets = totals.sets;
    let rows = [
        ("folds", totals.folds),
        ("sets wanted", sets.wanted),
        ("sets loaded", sets.loaded),
        ("sets late", sets.late),
        ("sets wasted", sets.wasted),
        ("sets cancelled", sets.cancelled),
        ("words late", totals.late_words),
        ("vertices asked", totals.vertices.asked),
        ("vertices ready", totals.vertices.ready),
    ];
    // Of a generator that is no hybrid machine, what it counts are its tasks.
    let is_hybrid = rows.iter().any(|(_, total)| *total > 0);
    let levels = [("level changes", totals.level_changes)].into_iter().filter(|(_, total)| *total > 0);
    let rows = rows.into_iter().filter(|_| is_hybrid).chain(levels).chain([("events", totals.events)]);
    writeln!(out, "\n{:<16} {:>14} {:>14}", "counter", "total", "a frame")?;
    for (name, total) in rows {
        let mean = total as f64 / totals.frames.max(1) as f64;
        writeln!(out, "{name:<16} {total:>14} {mean:>14.1}")?;
    }
    Ok(())
}

fn write_deadlines(out: &mut String, totals: &Totals) -> fmt::Result {
    writeln!(out, "\n{:<16} {:>14} {:>14} {:>14}  least at", "deadline", "met", "missed", "least slack")?;
    for (deadline, found) in &totals.deadlines {
        let slack = found.slack;
        let met = slack.count.saturating_sub(slack.missed);
        let least = slack.least.map_or("-".to_owned(), |ticks| format!("{ticks} ticks"));
        let place = place_of(found);
        writeln!(out, "{deadline:<16} {met:>14} {:>14} {least:>14}  {place}", slack.missed)?;
    }
    Ok(())
}

fn place_of(found: &DeadlineTotals) -> String {
    match (found.worst_frame, &found.worst_miss) {
        (None, _) => "-".to_owned(),
        (Some(frame), None) => format!("frame {frame}"),
        (Some(frame), Some(missed)) => {
            format!("frame {frame}, {}{}", place_of_miss(missed), ground_of_miss(missed))
        }
    }
}

/// Corner and ground range of a miss, where it has them: `, corner 12 -4, range 1530.2 m`.
fn ground_of_miss(missed: &Missed) -> String {
    let corner = missed.region.map_or(String::new(), |[m, n]| format!(", corner {m} {n}"));
    let range = missed.range_m.map_or(String::new(), |range| format!(", range {range:.1} m"));
    corner + &range
}

/// Sweep, fold and register of a miss: `sweep 3, crossing 7, red x-first`.
pub(crate) fn place_of_miss(missed: &Missed) -> String {
    let mut place = format!("sweep {}", missed.sweep);
    if let Some(crossing) = missed.crossing {
        place += &format!(", crossing {crossing}");
    }
    let words = [&missed.colour, &missed.register].into_iter().flatten();
    for (index, word) in words.enumerate() {
        place += if index == 0 { ", " } else { " " };
        place += word;
    }
    if let Some(crater) = missed.crater {
        place += &format!(", crater {crater}");
    }
    if let Some(part) = &missed.part {
        place += &format!(", {part}");
    }
    place
}

fn write_units(out: &mut String, totals: &Totals) -> fmt::Result {
    let head = ["least", "mean", "most", "longest queue"];
    // Names of drums that several kinds share are longer than usual.
    let width = totals.units.keys().map(String::len).max().unwrap_or(0).max(20);
    writeln!(
        out,
        "\n{:<width$} {:>10} {:>12} {:>12}  {}",
        "unit at work", head[0], head[1], head[2], head[3]
    )?;
    for (name, unit) in &totals.units {
        let UnitTotals { least, mean, most, longest_queue, .. } = *unit;
        let [least, mean, most] = [least, mean, most].map(|part| format!("{:.2} %", 100.0 * part));
        writeln!(out, "{name:<width$} {least:>10} {mean:>12} {most:>12}  {longest_queue:>13}")?;
    }
    Ok(())
}

/// The share is of the frames' length.
fn write_frame_tasks(out: &mut String, totals: &Totals) -> fmt::Result {
    if totals.tasks.is_empty() {
        return Ok(());
    }
    let head = ["pieces a frame", "ticks a frame", "share"];
    let wide = totals.tasks.iter().map(|task| task.unit.len()).max().unwrap_or(0).max(10);
    writeln!(out, "\n{:<wide$} {:<16} {:>16} {:>18} {:>8}", "unit", "task", head[0], head[1], head[2])?;
    let frames = totals.frames.max(1) as f64;
    for Task { unit, task, pieces, ticks } in &totals.tasks {
        let [pieces, ticks_a_frame] = [*pieces, *ticks].map(|total| total as f64 / frames);
        let share = 100.0 * *ticks as f64 / totals.ticks as f64;
        writeln!(out, "{unit:<wide$} {task:<16} {pieces:>16.1} {ticks_a_frame:>18.1} {share:>6.2} %")?;
    }
    Ok(())
}

fn write_level_changes(out: &mut String, record: &TimingRecord) -> fmt::Result {
    let many = record.level_changes().count();
    if many == 0 {
        return Ok(());
    }
    writeln!(
        out,
        "\n{:<16} {:>8} {:>6} {:>4} {:>14} {:>10}",
        "level", "frame", "from", "to", "m away", "fraction"
    )?;
    for (frame, LevelChange { tile, from, to, distance_m, fraction, .. }) in
        record.level_changes().take(LEVELS_SHOWN)
    {
        writeln!(out, "{tile:<16} {frame:>8} {from:>6} {to:>4} {distance_m:>14.1} {fraction:>10.6}")?;
    }
    match many.saturating_sub(LEVELS_SHOWN) {
        0 => Ok(()),
        more => writeln!(out, "and {more} more changes; --json has them all"),
    }
}

fn write_causes(out: &mut String, totals: &Totals) -> fmt::Result {
    if totals.causes.is_empty() {
        return writeln!(out, "\nno misses");
    }
    writeln!(out, "\n{:<16} {:>14}", "cause", "misses")?;
    for (cause, misses) in &totals.causes {
        writeln!(out, "{cause:<16} {misses:>14}")?;
    }
    Ok(())
}

fn write_sweeps(out: &mut String, totals: &Totals) -> fmt::Result {
    let sweeps = totals.worst_sweeps();
    if sweeps.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{:<16} {:>14} {:>14}", "sweep", "misses", "in frames")?;
    for (sweep, SweepMisses { misses, frames }) in sweeps.iter().take(SWEEPS_SHOWN) {
        writeln!(out, "{sweep:<16} {misses:>14} {frames:>14}")?;
    }
    match sweeps.len().saturating_sub(SWEEPS_SHOWN) {
        0 => Ok(()),
        more => writeln!(out, "and {more} more sweeps"),
    }
}
