//! What was measured beside what the formulas say.

use generator::SizedFigure;
use scenario::PoseRow;
use serde::Serialize;
use serde_json::{Value, json};
use text::{named_frames, table};
use timing::TimingRecord;

use super::blend::BlendFigures;
use super::level::LevelFigures;
use super::search::Search;
use super::units::unit_rows;
use crate::{Other, Rehearsal};

/// One figure of a table, measured and by formula.
#[derive(Debug, Clone, Serialize)]
pub struct Row {
    /// Name of the figure, ending in its unit.
    key: String,
    /// Meaning of the figure, in words.
    meaning: String,
    /// Value measured by running the machine.
    measured: Option<f64>,
    /// Value that the formula gives.
    formula: Option<f64>,
    /// Measured value divided by the value of the formula.
    ratio: Option<f64>,
    /// The formula in the symbols of hardware section 4.
    law: &'static str,
}

pub(super) fn row(
    key: impl Into<String>,
    meaning: impl Into<String>,
    measured: impl Into<Option<f64>>,
    formula: impl Into<Option<f64>>,
    law: &'static str,
) -> Row {
    let (measured, formula) = (measured.into(), formula.into());
    let ratio = measured.zip(formula).filter(|&(_, formula)| formula != 0.0).map(|(found, of)| found / of);
    Row { key: key.into(), meaning: meaning.into(), measured, formula, ratio, law }
}

impl From<SizedFigure> for Row {
    fn from(figure: SizedFigure) -> Self {
        let SizedFigure { key, meaning, measured, formula, law } = figure;
        row(key, meaning, measured, formula, law)
    }
}

/// Figures measured and by formula, and what was searched for.
pub struct Report {
    head: String,
    /// Tables, each with its title and rows.
    tables: Vec<(String, Vec<Row>)>,
    searches: Vec<Search>,
    /// Lines of the picture from which a tear shows; nothing without tears.
    shows: Option<f64>,
    frames: Vec<u64>,
}

impl Report {
    pub(super) fn new(
        rehearsal: &Rehearsal,
        record: &TimingRecord,
        (levels, blend): (&[LevelFigures], Option<&BlendFigures>),
        poses: &[PoseRow],
        shows: f64,
    ) -> Self {
        let frames: Vec<u64> = poses.iter().map(|row| row.frame).collect();
        let head = format!("{} on {}, {}", record.scenario, record.machine, named_frames(&frames));
        let mut tables: Vec<_> = levels.iter().map(|level| (title(level), level_rows(level))).collect();
        tables.extend(blend.map(|blend| (blend.title(), blend.rows())));
        tables.push(("use of units".into(), unit_rows(rehearsal, record, levels)));
        Self { head, tables, searches: Vec::new(), shows: Some(shows), frames }
    }

    /// Figures of a generator that is no hybrid machine; `None` if it has no formulas.
    pub fn of(other: &Other, record: &TimingRecord) -> Option<Self> {
        let rows: Vec<Row> = other.figures(record).into_iter().map(Row::from).collect();
        let frames: Vec<u64> = record.frames.iter().map(|frame| frame.frame).collect();
        let head = format!("{} on {}, {}", record.scenario, record.machine, named_frames(&frames));
        let is_there = !rows.is_empty();
        let tables = vec![("units of a frame".into(), rows)];
        is_there.then_some(Self { head, tables, searches: Vec::new(), shows: None, frames })
    }

    /// The same with what was searched for.
    pub fn with(self, searches: Vec<Search>) -> Self {
        Self { searches, ..self }
    }

    /// A document of schema `lunoid.sizing/1`.
    pub fn json(&self) -> Value {
        let tables = self.tables.iter().map(|(title, rows)| json!({ "title": title, "rows": rows }));
        json!({
            "schema": "lunoid.sizing/1",
            "frames": self.frames,
            "tables": tables.collect::<Vec<_>>(),
            "a_tear_shows_from_lines": self.shows,
            "searches": self.searches,
        })
    }

    /// Returns the figures and searches as tables for people.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n", self.head);
        for (title, rows) in &self.tables {
            text += &format!("\n{title}\n{}", table(&cells(rows)));
        }
        if let Some(lines) = self.shows.filter(|_| !self.searches.is_empty()) {
            text += &format!(
                "\nslowest parts with no step of {lines} lines or more\n{}",
                table(&self.search_cells())
            );
        }
        text
    }

    fn search_cells(&self) -> Vec<Vec<String>> {
        let ns = |value: Option<f64>| value.map_or("-".into(), |value| format!("{value:.0} ns"));
        let found = |search: &Search| match (search.slowest_ns, search.any) {
            (None, _) => "none: tears show at 0 ns".into(),
            (Some(_), true) => "any: a whole sweep would do".into(),
            (slowest, false) => ns(slowest),
        };
        let head = ["part", "slowest", "is", ""].map(String::from).into();
        let rows = self
            .searches
            .iter()
            .map(|search| vec![search.key.into(), found(search), ns(search.is_ns), search.what.into()]);
        [head].into_iter().chain(rows).collect()
    }
}

fn cells(rows: &[Row]) -> Vec<Vec<String>> {
    let number = |value: Option<f64>| value.map_or("-".into(), four_digits);
    let head = ["quantity", "measured", "formula", "ratio", "law"].map(String::from).into();
    let lines = rows.iter().map(|row| {
        let ratio = row.ratio.map_or("-".into(), |ratio| format!("{ratio:.3}"));
        vec![row.meaning.clone(), number(row.measured), number(row.formula), ratio, row.law.into()]
    });
    [head].into_iter().chain(lines).collect()
}

/// Four significant digits; more where they stand before the point.
fn four_digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    if value.abs() < 1e-4 {
        return format!("{value:.1e}");
    }
    let mut decimals = 3;
    let mut scaled = value.abs();
    while scaled >= 10.0 && decimals > 0 {
        (scaled, decimals) = (scaled / 10.0, decimals - 1);
    }
    while scaled < 1.0 {
        (scaled, decimals) = (scaled * 10.0, decimals + 1);
    }
    format!("{value:.decimals$}")
}

fn title(level: &LevelFigures) -> String {
    let LevelFigures { name, region_size, range, sweeps, .. } = level;
    format!("{name} level: {sweeps} sweeps of {range:.0} m over regions of {region_size} m")
}

fn level_rows(level: &LevelFigures) -> Vec<Row> {
    let LevelFigures { budget, sweeps, frames, .. } = level;
    let [mean, least, most] = level.crossings;
    let sweep = |count: u64| count as f64 / (*sweeps).max(1) as f64;
    let frame = |count: u64| count as f64 / (*frames).max(1) as f64;
    let words = |sets: u64| 9.0 * sweep(sets) / (1e6 * budget.sweep.active);
    let crossings = &budget.crossings;
    let straight = level.range / level.region_size;
    let ns = |index: usize| level.urgent.map(|urgent| 1e9 * urgent[index]);
    let by_formula = |ticks: f64| 1e9 * (budget.loader.urgent + ticks * level.tick);
    vec![
        row("crossings", "crossings a sweep, mean", mean, crossings.mean, "4 R/(pi d), mean over azimuth"),
        row(
            "crossings_here",
            "  of these azimuths",
            mean,
            level.crossings_at_azimuths,
            "R (|cos| + |sin|)/d",
        ),
        row("crossings_least", "  least", least, straight, "R/d, along an axis"),
        row("crossings_most", "  most", most, crossings.worst, "sqrt(2) R/d, along a diagonal"),
        row("words_used_us", "words used/µs", words(level.used), 1e-6 * crossings.words_used, "18 n/Ta"),
        row(
            "words_loaded_us",
            "words loaded/µs",
            words(level.brought),
            1e-6 * crossings.words_loaded,
            "36 n/Ta",
        ),
        row(
            "t_u_mean_ns",
            "fold to urgent set, mean (ns)",
            ns(0),
            by_formula(0.5),
            "t_u, a fold seen half a tick late",
        ),
        row("t_u_most_ns", "  at worst", ns(1), by_formula(1.0), "t_u and a tick"),
        row(
            "late_urgent",
            "late urgent sets a sweep",
            sweep(level.late_urgent),
            level.late_expected / (*sweeps).max(1) as f64,
            "sum of v t_u |sin 2 theta|/d^2",
        ),
        row(
            "late_urgent_mean",
            "  constant rate, mean azimuth",
            sweep(level.late_urgent),
            budget.loader.late,
            "R v t_u 2/(pi d^2)",
        ),
        row("late", "late sets a sweep, all", sweep(level.late), None, ""),
        row("tears", "tears a frame", frame(level.late), None, "late sets"),
        row("tears_seen", "  that show", frame(level.seen), None, "S0(e) times the corners' difference"),
    ]
}

#[cfg(test)]
mod tests {
    use super::four_digits;

    #[test]
    fn figures_have_four_digits() {
        let texts = [0.0, 21.22, 0.000_123, 6.3662, 123_456.7, 1e-17].map(four_digits);
        assert_eq!(texts, ["0", "21.22", "0.0001230", "6.366", "123457", "1.0e-17"]);
    }
}
