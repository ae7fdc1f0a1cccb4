//! Utilisation over the mission, and slack by kind of deadline.

use std::collections::BTreeMap;
use std::path::Path;

use ::plots::{Axis, Bars, Panel, Trace, TraceLook, bar_picture, trace_picture};
use timing::{Deadline, DeadlineTotals, Slack, TimingRecord, Totals};

use crate::DeadlineError;

/// A name, and its steps.
type Line = (String, Vec<f64>, Vec<f64>);

/// Draws the use of every unit over the frames of the record: PNG or SVG, as the file is named.
///
/// # Errors
/// If the plot cannot be drawn or written.
pub fn write_utilisation(record: &TimingRecord, path: &Path) -> Result<(), DeadlineError> {
    let mut families: BTreeMap<String, Vec<Line>> = BTreeMap::new();
    for unit in Totals::of(record).units.into_keys() {
        families.entry(label(&unit)).or_default().push(line(record, &unit));
    }
    let panels: Vec<Panel<'_>> = families.iter().map(|(label, lines)| panel(label, lines)).collect();
    let mut told = vec![facts(record)];
    if record.frames.windows(2).any(|pair| pair[1].frame != pair[0].frame + 1) {
        told.push("what a frame has is drawn up to the next one that was recorded".into());
    }
    let look = TraceLook { height: 160, facts: told, ..TraceLook::titled("Use of units") };
    let picture =
        trace_picture(&Axis::new("frame").whole(), &panels, &[], &look).map_err(DeadlineError::Plot)?;
    picture.write(path).map_err(DeadlineError::Write)
}

/// Label of the panel of a unit: units that differ in the last part of their names alone share one, and so do those of one part.
fn label(unit: &str) -> String {
    let family = unit.rsplit_once('.').map_or("units", |(family, _)| family);
    format!("{family} (%)")
}

/// Steps: what a frame has lasts until the next of the record.
fn line(record: &TimingRecord, unit: &str) -> Line {
    let found = record.utilisation_over_frames(unit);
    let mut line = (unit.to_owned(), Vec::new(), Vec::new());
    for (index, &(frame, used)) in found.iter().enumerate() {
        let next = found.get(index + 1).map_or(frame + 1, |&(next, _)| next);
        line.1.extend([frame as f64, next as f64]);
        line.2.extend([100.0 * used; 2]);
    }
    line
}

fn panel<'a>(label: &str, lines: &'a [Line]) -> Panel<'a> {
    let most = lines.iter().flat_map(|line| &line.2).copied().fold(1.0, f64::max);
    let traces = lines.iter().map(|(name, x, y)| Trace { name, x, y }).collect();
    // An idle unit is a line above the axis, not on it.
    Panel { axis: Axis::new(label).over([-0.04 * most, 1.08 * most]), traces }
}

/// Draws histograms of the time that was left (ticks), one panel a kind of deadline: PNG or SVG, as the file is named.
///
/// # Errors
/// If the plot cannot be drawn or written.
pub fn write_slack(record: &TimingRecord, path: &Path) -> Result<(), DeadlineError> {
    let totals = Totals::of(record);
    let edges: Vec<String> = Slack::edges().into_iter().map(ticks_text).collect();
    let bars = |(deadline, found): (&Deadline, &DeadlineTotals)| {
        let slack = found.slack;
        let name = format!("{deadline}: {} of {} missed", slack.missed, slack.count);
        let counts = slack.bins.map(|count| count as f64).into();
        let (edges, wrong) = (edges.clone(), slack.bins.len() / 2);
        Bars { name, counts, edges, wrong, kinds: ["missed", "met"] }
    };
    let panels: Vec<Bars> = totals.deadlines.iter().map(bars).collect();
    let look = TraceLook { height: 150, facts: vec![facts(record)], ..TraceLook::titled("Slack") };
    let x = format!("ticks of {} from ready to due", record.master);
    let picture = bar_picture(&x, "deadlines", &panels, &look).map_err(DeadlineError::Plot)?;
    picture.write(path).map_err(DeadlineError::Write)
}

/// 8 192 as 8k, 1 048 576 as 1M.
fn ticks_text(ticks: i64) -> String {
    let size = ticks.unsigned_abs();
    let (number, unit) = match size {
        0..1_000 => (size, ""),
        1_000..1_000_000 => (size / 1_000, "k"),
        _ => (size / 1_000_000, "M"),
    };
    format!("{}{number}{unit}", if ticks < 0 { "−" } else { "" })
}

fn facts(record: &TimingRecord) -> String {
    let frames: Vec<u64> = record.frames.iter().map(|frame| frame.frame).collect();
    let [first, last] = [frames.first(), frames.last()].map(|frame| frame.copied().unwrap_or(0));
    let count = frames.len();
    let frames = if count == 1 { "frame" } else { "frames" };
    format!("{} on {}, {count} {frames} from {first} to {last}", record.scenario, record.machine)
}

#[cfg(test)]
mod tests {
    use timing::Slack;

    use super::{label, ticks_text};

    #[test]
    fn units_of_a_kind_share_a_panel() {
        assert_eq!(["drum.fine.0", "drum.fine.1"].map(label), ["drum.fine (%)"; 2]);
        assert_eq!(["cpu", "edge"].map(label), ["units (%)"; 2]);
    }

    #[test]
    fn edges_are_short() {
        let texts: Vec<String> = Slack::edges().into_iter().map(ticks_text).collect();
        let right = ["0", "1", "8", "128", "1k", "8k", "131k", "1M"];
        assert_eq!(texts[7..], right);
        assert_eq!(texts[0], "−1M");
    }
}
