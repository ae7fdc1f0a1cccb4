//! One sweep as on an oscilloscope with a logic analyser.
//!
//! ```text
//!  title, facts, key
//!            sweep time ─────────────────────────────
//!            caps of region crossings, flags of cursors
//!  height    ┌──────────────────────────────────────┐ V    ▒ picture
//!  slope     └──────────────────────────────────────┘ V    ▒ column
//!  gate      ▁▁▁▔▔▔▔▔▔▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁▁       ▒
//!  register  ⟨ 512 ⟩⟨ 514 ⟩⟨ 516 ⟩
//!            ground range ───────────────────────────
//!  readouts
//! ```

mod clock;
mod column;
mod crossing;
mod cursor;
mod key;
mod lane;
mod page;
mod panel;

use crate::bank_picture::PANEL;
use crate::canvas::{Anchor, Area, Canvas};
use crate::frame::{Header, SMALL, TEXT};
use crate::{Drawing, PlotError, lettering};

use clock::View;
use column::{LINES, STRIP, Strip};
use crossing::{CAPS, Verticals};
use cursor::{Cursors, Readouts};
use key::Key;
use lane::{LANE, Lane};
use panel::{Panel, room_above};

pub use clock::Clock;
pub use page::{
    Along, Crossing, Curve, Curves, Line, Logic, LogicLane, PictureColumn, Place, RegisterColour, Scope,
    ScopeLook, Theme, Upright, Volts,
};

/// Least width of a page (pixels).
const NARROWEST: u32 = 600;
/// Least room on the left for scales.
const LEFT: f32 = 96.0;
/// Room on the right for voltages.
const VOLTS: f32 = 54.0;
/// At the right edge of the page.
const EDGE: f32 = 22.0;
/// Ticks and labels above the first panel.
const OTHER: f32 = 26.0;
/// Ticks and labels below the last lane.
const BELOW: f32 = 52.0;

/// One sweep: curves with both scales, digital lanes, region crossings, cursors with readouts, and what the picture gets.
///
/// # Errors
/// If a size is out of range, the clock does not run, a signal has not as many values as samples, a place lies outside the
/// sweep, or there is nothing to draw.
pub fn scope_picture(scope: &Scope<'_>, look: &ScopeLook) -> Result<Drawing, PlotError> {
    check(scope, look)?;
    let layout = Layout::new(scope, look);
    let view = View::new(scope.clock, look.along, [look.from, look.to], layout.strip_of_time())?;
    let cursors = Cursors::new(&look.cursors, &view)?;
    let page = Page {
        scope,
        look,
        view: &view,
        verticals: Verticals::new(&scope.crossings, &view),
        coarse: Verticals::new(&scope.coarse, &view),
        readouts: Readouts::new(scope, &view, &cursors),
        cursors,
        layout,
    };
    page.draw()
}

/// The same as the text of an SVG file that is light or dark as its reader prefers, whatever the look's theme.
///
/// # Errors
/// Those of [`scope_picture`].
pub fn scope_svg(scope: &Scope<'_>, look: &ScopeLook) -> Result<String, PlotError> {
    let [light, dark] = [Theme::Light, Theme::Dark].map(|theme| ScopeLook { theme, ..look.clone() });
    Ok(scope_picture(scope, &light)?.svg_or_dark(&scope_picture(scope, &dark)?))
}

fn check(scope: &Scope<'_>, look: &ScopeLook) -> Result<(), PlotError> {
    for (found, least) in [(look.width, NARROWEST), (look.height, PANEL[0])] {
        let most = PANEL[1];
        if !(least..=most).contains(&found) {
            return Err(PlotError::PanelSize { found, least, most });
        }
    }
    scope.clock.check()?;
    let expected = scope.clock.ranges.len();
    for curve in scope.panels.iter().flat_map(|curves| &curves.curves) {
        let (what, found) = (curve.name.to_owned(), curve.values.len());
        if found != expected {
            return Err(PlotError::Count { what, found, expected });
        }
    }
    let is_empty = scope.panels.is_empty() && scope.lanes.is_empty();
    if is_empty { Err(PlotError::Empty { what: look.title.clone() }) } else { Ok(()) }
}

/// What does not depend on values.
struct Layout {
    left: f32,
    right: f32,
    width: f32,
    has_column: bool,
}

impl Layout {
    fn new(scope: &Scope<'_>, look: &ScopeLook) -> Self {
        let names = scope.lanes.iter().map(|lane| lettering::width(lane.name, SMALL) + 26.0);
        let left = names.fold(LEFT, f32::max).ceil();
        let has_column = scope.column.is_some_and(|column| !column.grey.is_empty());
        let volts = if scope.panels.iter().any(|curves| curves.volts.is_some()) { VOLTS } else { 0.0 };
        let column = if has_column { STRIP + LINES + 14.0 } else { 0.0 };
        let right = (look.width as f32 - EDGE - volts - column).max(left + 120.0).floor();
        Self { left, right, width: right - left, has_column }
    }

    /// The columns that the sweep takes.
    fn strip_of_time(&self) -> Area {
        Area { left: self.left, top: 0.0, width: self.width, height: 1.0 }
    }
}

struct Page<'p, 'a> {
    scope: &'p Scope<'a>,
    look: &'p ScopeLook,
    view: &'p View<'a>,
    verticals: Verticals,
    coarse: Verticals,
    readouts: Readouts,
    cursors: Cursors,
    layout: Layout,
}

impl<'p, 'a> Page<'p, 'a> {
    fn draw(&self) -> Result<Drawing, PlotError> {
        let width = self.layout.right - self.layout.left;
        let header = Header::new(&self.look.title, &self.look.facts, width);
        let room = self.look.width as f32 - EDGE - self.layout.left;
        let key = Key::new(!self.scope.blanked.is_empty(), &self.verticals, &self.coarse, room);
        let rows = [&self.verticals, &self.coarse].map(|level| if level.count > 0 { CAPS } else { 0.0 });
        let axis = header.height() + key.height() + OTHER;
        let top = axis + self.cursors.flags() + rows[0] + rows[1];
        let (panels, bottom) = self.panels(top)?;
        let lanes = self.lanes(bottom);
        let bottom = lanes.last().map_or(bottom, |lane| lane.area.bottom() + 4.0);
        let height = bottom + BELOW + self.readouts.height();
        let mut canvas = Canvas::of(self.look.theme.palette(), self.look.width, height.ceil() as u32);
        header.draw(&mut canvas, self.layout.left);
        key.draw(&mut canvas, self.layout.left, header.height() + 8.0);
        self.axes(&mut canvas, axis, bottom);
        self.cursors.draw_flags(&mut canvas, self.view, axis + 2.0);
        let areas = panels.iter().map(|panel| panel.area).chain(lanes_area(&lanes)).collect::<Vec<_>>();
        areas.iter().for_each(|area| self.background(&mut canvas, *area));
        if let Some(first) = areas.first() {
            let bottom = top.min(first.top);
            self.verticals.caps(&mut canvas, bottom);
            if self.coarse.count > 0 {
                self.coarse.caps(&mut canvas, bottom - rows[0]);
                let at = (self.layout.left - 10.0, bottom - rows[0] - 2.0);
                canvas.text("coarse", at, Anchor::Right, SMALL, canvas.palette().soft);
            }
        }
        panels.iter().for_each(|panel| panel.grid(&mut canvas));
        panels.iter().for_each(|panel| panel.draw(&mut canvas));
        lanes.iter().for_each(|lane| lane.draw(&mut canvas));
        lanes_area(&lanes).into_iter().for_each(|area| canvas.border(area, canvas.palette().soft));
        self.column(&mut canvas, &panels, &areas);
        areas.iter().for_each(|area| self.cursors.draw(&mut canvas, self.view, *area));
        let right = self.look.width as f32 - EDGE;
        self.readouts.draw(&mut canvas, 24.0, right, bottom + BELOW);
        Ok(canvas.finish())
    }

    /// Panels from `top` on, and where they end.
    fn panels(&self, mut top: f32) -> Result<(Vec<Panel<'p, 'a>>, f32), PlotError> {
        let Layout { left, width, .. } = self.layout;
        let mut panels = Vec::new();
        for curves in &self.scope.panels {
            top = (top + room_above(curves, width)).floor();
            let area = Area { left, top, width, height: self.look.height as f32 };
            panels.push(Panel::new(curves, self.view, area)?);
            top = area.bottom();
        }
        Ok((panels, top))
    }

    fn lanes(&self, top: f32) -> Vec<Lane<'p, 'a>> {
        let Layout { left, width, .. } = self.layout;
        let place = |(index, lane)| {
            let top = (top + 12.0 + LANE * index as f32).floor();
            Lane { lane, view: self.view, area: Area { left, top, width, height: LANE } }
        };
        self.scope.lanes.iter().enumerate().map(place).collect()
    }

    /// What lies below the curves: shades of what is blanked, upright lines.
    fn background(&self, canvas: &mut Canvas, area: Area) {
        let palette = canvas.palette();
        let [first, last] = self.view.window;
        for [from, to] in &self.scope.blanked {
            let [from, to] = [from, to].map(|instant| self.view.x(instant.clamp(first, last)));
            let (from, to) = (from.max(area.left), to.min(area.right()));
            canvas.fill(Area { left: from, width: to - from, ..area }, palette.shade);
        }
        for (x, label) in self.view.ticks() {
            if !label.is_empty() {
                canvas.fill(Area { left: x.floor(), width: 1.0, ..area }, palette.faint);
            }
        }
        self.verticals.draw(canvas, area);
    }

    /// The axis of the page below `bottom`, the other one above `top`.
    fn axes(&self, canvas: &mut Canvas, top: f32, bottom: f32) {
        let palette = canvas.palette();
        let line = self.view.clock.line;
        let ([place, near], [instant, short]) = (line.place(), line.instant());
        let (own, other) = match self.look.along {
            Along::Time => (line.instant_with_unit(instant), line.place_with_unit(near)),
            _ => (line.place_with_unit(place), line.instant_with_unit(short)),
        };
        let middle = self.layout.left + self.layout.width / 2.0;
        for (x, label) in apart(self.view.ticks()) {
            let tick = Area {
                left: x.floor(),
                top: bottom,
                width: 1.0,
                height: if label.is_empty() { 3.0 } else { 5.0 },
            };
            canvas.fill(tick, palette.soft);
            canvas.text(&label, (x, bottom + 18.0), Anchor::Middle, SMALL, palette.soft);
        }
        canvas.text(&own, (middle, bottom + 40.0), Anchor::Middle, TEXT, palette.ink);
        canvas
            .fill(Area { left: self.layout.left, top, width: self.layout.width, height: 1.0 }, palette.faint);
        for (x, label) in apart(self.view.other_ticks()) {
            canvas.fill(Area { left: x.floor(), top: top - 4.0, width: 1.0, height: 5.0 }, palette.soft);
            canvas.text(&label, (x, top - 8.0), Anchor::Middle, SMALL, palette.soft);
        }
        let at = (self.layout.left - 14.0, top - 8.0);
        canvas.text(&other, at, Anchor::Right, SMALL, palette.ink);
    }

    /// The picture column: beside the panel of display lines, where there is one, with leaders from its curve.
    fn column(&self, canvas: &mut Canvas, panels: &[Panel<'_, '_>], areas: &[Area]) {
        let (Some(column), Some(first), Some(last)) = (&self.scope.column, areas.first(), areas.last())
        else {
            return;
        };
        if !self.layout.has_column {
            return;
        }
        let lines = panels.iter().find(|panel| matches!(panel.curves.upright, Upright::Lines(_)));
        let bottom = panels.last().map_or(last.bottom(), |panel| panel.area.bottom());
        let (top, bottom) = lines.map_or((first.top, bottom), |panel| (panel.area.top, panel.area.bottom()));
        let left = (self.look.width as f32 - EDGE - STRIP - LINES).floor();
        let strip = Strip { column, area: Area { left, top, width: STRIP, height: (bottom - top).floor() } };
        strip.draw(canvas);
        if lines.is_some() {
            for (&instant, y) in self.cursors.0.iter().zip(strip.pointed(&self.cursors.0)) {
                let (Some(y), x, colour) = (y, self.view.x(instant), canvas.palette().cursor) else {
                    continue;
                };
                canvas.dashed(&[(x, y), (left - 10.0, y)], 1.0, [4.0, 3.0], colour);
            }
        }
        strip.point(canvas, &self.cursors.0);
    }
}

fn lanes_area(lanes: &[Lane<'_, '_>]) -> Option<Area> {
    let (first, last) = (lanes.first()?.area, lanes.last()?.area);
    Some(Area { top: first.top - 4.0, height: last.bottom() - first.top + 8.0, ..first })
}

/// Ticks whose labels do not touch: those that would keep their mark alone.
fn apart(ticks: Vec<(f32, String)>) -> Vec<(f32, String)> {
    let mut written = f32::NEG_INFINITY;
    let keep = |(x, label): (f32, String)| {
        let half = lettering::width(&label, SMALL) / 2.0;
        if label.is_empty() || x - half < written + 8.0 {
            return (x, String::new());
        }
        written = x + half;
        (x, label)
    };
    ticks.into_iter().map(keep).collect()
}
