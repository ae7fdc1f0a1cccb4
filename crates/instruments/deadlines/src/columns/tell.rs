//! Columns, their lines and the totals, for people and programs.

use std::path::Path;

use serde_json::{Value, json};
use text::table;
use timing::{Deadline, Missed};

use super::four::Four;
use super::trace::{Reached, Trace};
use super::verdict::{Class, Column, Pixel, Way};
use super::{Limits, drawing};
use crate::DeadlineError;
use crate::misses::rows;

/// The columns of a frame that differ from those of the ideal machine, each traced to lines of the record.
pub struct TracedColumns<'a> {
    /// Scenario, machine and frame.
    pub(super) title: String,
    pub(super) limits: Limits,
    pub(super) four: &'a Four,
    /// Columns that differ, from left to right.
    pub(super) columns: Vec<Column>,
    pub(super) trace: Trace<'a>,
    /// Length of a sample (ns).
    pub(super) ns: f64,
}

impl TracedColumns<'_> {
    /// Whether every column that differs is traced, or the work of the parts alone.
    pub fn are_accounted_for(&self) -> bool {
        self.columns.iter().all(Column::is_accounted_for)
    }

    /// Draws both pictures, their difference and the class of every column: PNG or SVG, as the file is named.
    ///
    /// # Errors
    /// If the picture cannot be drawn or written.
    pub fn draw(&self, path: &Path) -> Result<(), DeadlineError> {
        drawing::write(self.four, &self.columns, [&self.title, &self.summary()], path)
    }

    /// What the columns come to, name and count.
    fn totals(&self) -> [(&'static str, usize); 5] {
        let count = |is: &dyn Fn(&Column) -> bool| self.columns.iter().filter(|column| is(column)).count();
        [
            ("compared", self.four.machine.columns()),
            ("differing", self.columns.len()),
            ("traced", count(&|column| column.is_accounted_for() && column.class != Class::Parts)),
            ("parts alone", count(&|column| column.class == Class::Parts)),
            ("untraced", count(&|column| !column.is_accounted_for())),
        ]
    }

    /// Columns of each class.
    fn classes(&self) -> [(Class, usize); 3] {
        Class::ALL.map(|class| (class, self.columns.iter().filter(|column| column.class == class).count()))
    }

    /// Columns, their lines and the totals as text.
    pub fn text(&self) -> String {
        let columns: String = self.columns.iter().map(|column| self.column(column)).collect();
        format!("{}\n{columns}\n{}\n", self.title, self.summary())
    }

    /// Totals and classes in one line.
    fn summary(&self) -> String {
        let totals = self.totals().map(|(name, count)| format!("{name} {count}")).join(", ");
        let classes = self.classes().map(|(class, count)| format!("{} {count}", class.word())).join(", ");
        format!("columns beyond {} levels: {totals}; by class: {classes}", self.limits.levels)
    }

    fn column(&self, column: &Column) -> String {
        let Pixel { column: number, line, difference, parts_alone, timing_alone, .. } = column.worst;
        let class = column.class.word();
        let head = format!(
            "\ncolumn {number}: {class}, {difference} levels at line {line}, {:.1} on average; \
             {parts_alone} remain without the timing, {timing_alone} without the parts\n",
            column.mean
        );
        let traced = column.timed.and_then(|pixel| Some((pixel, pixel.way?)));
        let body = traced.map_or(String::new(), |(pixel, way)| self.lines(&pixel, way));
        head + &body + &untraced(column)
    }

    fn lines(&self, pixel: &Pixel, way: Way) -> String {
        let found = self.trace.reached(pixel, way);
        let Reached { sweeps, drawn, lines, .. } = &found;
        let (first, last) = (sweeps.start(), sweeps.end());
        let mut out = format!(
            "line {}, {}, sweeps {first} to {last}: lines {}\n",
            pixel.line,
            ground(&found, way),
            lines.len()
        );
        if !lines.is_empty() {
            out += &table(&rows(self.told(lines).into_iter(), self.ns));
        }
        for [sweep, other] in drawn {
            out += &format!("sweep {sweep} is drawn with the set-up of sweep {other}\n");
        }
        out
    }

    /// Set-ups and bodies first, then those next to the pixel: as many of either.
    fn told<'m>(&self, lines: &[(u64, &'m Missed)]) -> Vec<(u64, &'m Missed)> {
        let is_of_a_fold = |(_, missed): &&(u64, &Missed)| {
            !matches!(missed.deadline, Deadline::SWEEP_SET_UP | Deadline::FRAME_TASKS)
        };
        let (folds, tasks): (Vec<_>, Vec<_>) = lines.iter().partition(is_of_a_fold);
        let nearest = folds.len().saturating_sub(self.limits.lines);
        tasks.into_iter().take(self.limits.lines).chain(folds.into_iter().skip(nearest)).collect()
    }

    /// The same as a document of schema `lunoid.timing.columns/1`.
    pub fn json(&self) -> Value {
        let columns: Vec<Value> = self.columns.iter().map(|column| self.column_json(column)).collect();
        let totals = self.totals().map(|(name, count)| (name.replace(' ', "_"), json!(count)));
        let classes = self.classes().map(|(class, count)| (class.word().to_owned(), json!(count)));
        json!({
            "schema": "lunoid.timing.columns/1",
            "frame": self.title,
            "levels": self.limits.levels,
            "totals": Value::Object(totals.into_iter().collect()),
            "classes": Value::Object(classes.into_iter().collect()),
            "columns": columns,
        })
    }

    fn column_json(&self, column: &Column) -> Value {
        let Pixel { column: number, line, difference, parts_alone, timing_alone, .. } = column.worst;
        let traced = column.timed.and_then(|pixel| Some((pixel, pixel.way?)));
        let trace = traced.map(|(pixel, way)| {
            let Reached { sweeps, range_m, drawn, lines } = self.trace.reached(&pixel, way);
            let told: Vec<Value> = self
                .told(&lines)
                .iter()
                .map(|(frame, missed)| json!({ "frame": frame, "missed": missed }))
                .collect();
            json!({
                "line": pixel.line,
                "through_parts": way == Way::ThroughParts,
                "sweeps": [sweeps.start(), sweeps.end()],
                "range_m": range_m,
                "drawn_with": drawn,
                "count": lines.len(),
                "lines": told,
            })
        });
        json!({
            "column": number,
            "class": column.class,
            "line": line,
            "largest": difference,
            "mean": column.mean,
            "without_timing": parts_alone,
            "without_parts": timing_alone,
            "trace": trace,
            "untraced_lines": column.untraced,
        })
    }
}

fn ground(found: &Reached<'_>, way: Way) -> String {
    match (found.range_m, way) {
        (Some(range), _) => format!("ground up to {range:.1} m"),
        (None, Way::Straight) => "sky".into(),
        (None, Way::ThroughParts) => "through the parts".into(),
    }
}

fn untraced(column: &Column) -> String {
    match column.untraced.len() {
        0 => String::new(),
        count => format!("UNTRACED: no line of the record reaches {count} of its pixels\n"),
    }
}
