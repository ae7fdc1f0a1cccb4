//! Cursors and what they read.

use crate::PlotError;
use crate::axis::reading;
use crate::canvas::{Anchor, Area, Canvas};
use crate::frame::SMALL;
use crate::lettering;

use super::clock::{View, between};
use super::page::{Along, Curves, Line, Logic, LogicLane, Place, Scope, Volts};
use super::panel::styled;

/// Height of a row of readouts.
const ROW: f32 = 18.0;
/// Room above the readouts, with their heading.
const HEADING: f32 = 34.0;
/// Digits of a readout.
const DIGITS: i32 = 5;
/// Side of a flag.
const FLAG: f32 = 15.0;
const NAMES: [&str; 2] = ["A", "B"];
const DASHES: [[f32; 2]; 2] = [[7.0, 3.0], [2.0, 2.0]];

/// Up to two instants that are read.
pub(crate) struct Cursors(pub Vec<f64>);

impl Cursors {
    /// Places the cursors that were asked for; each must lie in the part that is drawn.
    pub fn new(places: &[Place], view: &View<'_>) -> Result<Self, PlotError> {
        if places.len() > NAMES.len() {
            let what = "cursors".to_owned();
            return Err(PlotError::Count { what, found: places.len(), expected: NAMES.len() });
        }
        let instant = |place: &Place| {
            let instant = view.clock.instant_of(*place)?;
            let (Place::Range(found) | Place::Time(found)) = *place;
            let expected = "a place in the part that is drawn";
            let outside = || PlotError::Value { what: "cursor".into(), found, expected };
            if view.shows(instant) { Ok(instant) } else { Err(outside()) }
        };
        Ok(Self(places.iter().map(instant).collect::<Result<_, _>>()?))
    }

    /// Height of the row of flags.
    pub fn flags(&self) -> f32 {
        if self.0.is_empty() { 0.0 } else { FLAG + 4.0 }
    }

    /// Upright lines through `area`, over the content.
    pub fn draw(&self, canvas: &mut Canvas, view: &View<'_>, area: Area) {
        for (&instant, dash) in self.0.iter().zip(DASHES) {
            let x = view.x(instant);
            canvas.dashed(&[(x, area.top), (x, area.bottom())], 1.3, dash, canvas.palette().cursor);
        }
    }

    /// Their names, in a row that begins at `top`.
    pub fn draw_flags(&self, canvas: &mut Canvas, view: &View<'_>, top: f32) {
        let palette = canvas.palette();
        for (&instant, name) in self.0.iter().zip(NAMES) {
            let x = view.x(instant);
            let flag = Area { left: (x - FLAG / 2.0).floor(), top, width: FLAG, height: FLAG };
            canvas.fill(flag, palette.cursor);
            canvas.text(name, (flag.left + FLAG / 2.0, top + 11.5), Anchor::Middle, SMALL, palette.paper);
        }
    }
}

/// One row: name, the style of its curve, its cells.
#[derive(Debug, Clone, PartialEq)]
struct Row {
    name: String,
    style: Option<usize>,
    cells: Vec<String>,
}

/// The readouts of a page.
pub(crate) struct Readouts {
    heading: Vec<String>,
    rows: Vec<Row>,
}

impl Readouts {
    /// Every value at both cursors, their difference, and its slope along the axis of the page.
    pub fn new(scope: &Scope<'_>, view: &View<'_>, cursors: &Cursors) -> Self {
        if cursors.0.is_empty() {
            return Self { heading: Vec::new(), rows: Vec::new() };
        }
        let has_volts = scope.panels.iter().any(|curves| curves.volts.is_some());
        let (table, line) = (Table { view, at: &cursors.0, has_volts }, view.clock.line);
        let places = [
            table.place(line.place()[0], line.place_unit(), |instant| view.clock.range_at(instant)),
            table.place(line.instant()[0], line.unit(), |instant| view.clock.time_at(instant)),
        ];
        let curves = scope.panels.iter().flat_map(|curves| table.curves(curves));
        let lanes = scope.lanes.iter().map(|lane| table.lane(lane));
        Self { heading: table.heading(), rows: places.into_iter().chain(curves).chain(lanes).collect() }
    }

    /// Pixels that they take.
    pub fn height(&self) -> f32 {
        if self.rows.is_empty() { 0.0 } else { HEADING + ROW * self.rows.len() as f32 + 10.0 }
    }

    /// Draws them in columns from `left` on.
    pub fn draw(&self, canvas: &mut Canvas, left: f32, right: f32, top: f32) {
        let palette = canvas.palette();
        if self.rows.is_empty() {
            return;
        }
        let widest = self.rows.iter().map(|row| lettering::width(&row.name, SMALL)).fold(0.0, f32::max);
        let first = left + 34.0 + widest;
        let pitch = ((right - first) / self.heading.len() as f32).min(130.0);
        let column = |index: usize| first + pitch * (index + 1) as f32;
        let mut base = top + HEADING - 10.0;
        for (index, text) in self.heading.iter().enumerate() {
            canvas.text(text, (column(index), base), Anchor::Right, SMALL, palette.cursor);
        }
        let width = column(self.heading.len() - 1) - left;
        canvas.fill(Area { left, top: base + 5.0, width, height: 1.0 }, palette.faint);
        for row in &self.rows {
            base += ROW;
            if let Some(style) = row.style {
                styled(canvas, &[(left, base - 4.0), (left + 22.0, base - 4.0)], 2.6, style);
            }
            canvas.text(&row.name, (left + 28.0, base), Anchor::Left, SMALL, palette.ink);
            for (index, cell) in row.cells.iter().enumerate() {
                canvas.text(cell, (column(index), base), Anchor::Right, SMALL, palette.ink);
            }
        }
    }
}

struct Table<'p, 'a> {
    view: &'p View<'a>,
    at: &'p [f64],
    /// Whether there is a column of voltages beside that of values.
    has_volts: bool,
}

impl Table<'_, '_> {
    fn heading(&self) -> Vec<String> {
        let of_each = NAMES.iter().take(self.at.len());
        let of_each = of_each.flat_map(|name| self.with_volts(format!("at {name}"), "(V)".to_owned()));
        let per = match (self.view.along, self.view.clock.line) {
            (Along::Time, Line::Sweep) => "slope, a µs",
            (Along::Time, Line::Row) => "slope, a point",
            (_, Line::ScanLine) => "slope, a sample",
            _ => "slope, a m",
        };
        let of_both = ["B − A".to_owned(), per.to_owned()];
        of_each.chain(of_both.into_iter().filter(|_| self.at.len() > 1)).collect()
    }

    /// A cell, and that of its voltage, where there are any.
    fn with_volts(&self, cell: String, volts: String) -> Vec<String> {
        if self.has_volts { vec![cell, volts] } else { vec![cell] }
    }

    /// What lies between the cursors along the axis of the page.
    fn run(&self) -> f64 {
        let along = |instant: f64| match self.view.along {
            Along::Time => self.view.clock.time_at(instant),
            _ => self.view.clock.range_at(instant),
        };
        along(self.at[1]) - along(self.at[0])
    }

    fn place(&self, name: &str, unit: &str, of: impl Fn(f64) -> f64) -> Row {
        let values: Vec<f64> = self.at.iter().map(|&instant| of(instant)).collect();
        Row { name: name.to_owned(), style: None, cells: self.cells(&values, unit, None) }
    }

    fn curves(&self, curves: &Curves<'_>) -> Vec<Row> {
        let row = |(style, curve): (usize, &super::page::Curve<'_>)| {
            let values: Vec<f64> = self.at.iter().map(|&instant| between(curve.values, instant)).collect();
            let cells = self.cells(&values, &curves.unit, curves.volts);
            Row { name: curve.name.to_owned(), style: Some(style), cells }
        };
        curves.curves.iter().enumerate().map(row).collect()
    }

    fn cells(&self, values: &[f64], unit: &str, volts: Option<Volts>) -> Vec<String> {
        let voltage = |value: f64| volts.map_or(String::new(), |volts| cell(volts.of(value), ""));
        let mut cells: Vec<String> =
            values.iter().flat_map(|&value| self.with_volts(cell(value, unit), voltage(value))).collect();
        if let [a, b] = values {
            cells.extend([cell(b - a, unit), cell((b - a) / self.run(), "")]);
        }
        cells
    }

    fn lane(&self, lane: &LogicLane<'_>) -> Row {
        let states =
            self.at.iter().flat_map(|&instant| self.with_volts(state(&lane.logic, instant), String::new()));
        let mut cells: Vec<String> = states.collect();
        if let (Logic::Pulses(pulses), [a, b]) = (&lane.logic, self.at) {
            let inside = a.min(*b)..=a.max(*b);
            let count = pulses.iter().filter(|(at, _)| inside.contains(at)).count();
            cells.push(format!("{count} event{}", if count == 1 { "" } else { "s" }));
        }
        Row { name: lane.name.to_owned(), style: None, cells }
    }
}

/// What stands on a lane at an instant; pulses stand nowhere.
fn state(logic: &Logic, instant: f64) -> String {
    match logic {
        Logic::Levels(changes) => {
            held(changes, instant).map_or("", |high| if *high { "1" } else { "0" }).to_owned()
        }
        Logic::Words(changes, _) => {
            held(changes, instant).map_or(String::new(), |word| word.clone().unwrap_or("none".into()))
        }
        Logic::Pulses(_) => String::new(),
    }
}

fn held<T>(changes: &[(f64, T)], instant: f64) -> Option<&T> {
    let after = changes.partition_point(|(at, _)| *at <= instant);
    changes.get(after.checked_sub(1)?).map(|(_, value)| value)
}

/// A number with its unit; nothing for what is not a number, as the slope between cursors at one place.
fn cell(value: f64, unit: &str) -> String {
    match (value.is_finite(), unit) {
        (false, _) => String::new(),
        (true, "") => reading(value, DIGITS),
        (true, unit) => format!("{} {unit}", reading(value, DIGITS)),
    }
}
