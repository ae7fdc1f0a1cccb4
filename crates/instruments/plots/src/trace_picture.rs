//! Waveforms and digital lines against a common axis.

use crate::axis::{Axis, Ruler};
use crate::bank_picture::check_panel;
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, FAINT, INK, PAPER, SOFT, TRACES, dash, mix};
use crate::flow::{flow, rows};
use crate::frame::{BELOW, Frame, Header, LEFT, SMALL};
use crate::lettering;
use crate::{Drawing, PlotError};

/// Room on the right of the panels (pixels).
pub(crate) const RIGHT: f32 = 28.0;
/// Room above a panel for a legend of one row.
pub(crate) const ABOVE: f32 = 24.0;
/// From one row of a legend to the next.
const ROW: f32 = 18.0;
/// Length of the line beside a name of the legend, and room between them.
const SWATCH: f32 = 20.0;
const BESIDE: f32 = 8.0;
/// Room between a name of the legend and the next line.
const APART: f32 = 18.0;
/// From one digital line to the next.
const LANE: f32 = 26.0;
/// Height of a digital line when high.
const HIGH: f32 = 14.0;

/// A waveform: `y[i]` at `x[i]`; it breaks where a value is not finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trace<'a> {
    /// Name in the legend.
    pub name: &'a str,
    /// Places on the common axis.
    pub x: &'a [f64],
    /// Values, in the unit of the panel.
    pub y: &'a [f64],
}

/// Waveforms of one unit, drawn over each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel<'a> {
    /// What they are, with unit.
    pub axis: Axis,
    /// In the order of the legend.
    pub traces: Vec<Trace<'a>>,
}

/// A digital line: from `x[i]` to `x[i + 1]` it is `high[i]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lane<'a> {
    /// Name, at its left.
    pub name: &'a str,
    /// Places on the common axis, one more than states.
    pub x: &'a [f64],
    /// States of the line, each high or low.
    pub high: &'a [bool],
}

/// How waveforms are drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceLook {
    /// Title at the top of the picture.
    pub title: String,
    /// Lines below the title.
    pub facts: Vec<String>,
    /// Width of the panels, 120 to 8000 pixels.
    pub width: u32,
    /// Height of each panel, 120 to 8000 pixels.
    pub height: u32,
}

impl TraceLook {
    /// Panels of 900 by 240 pixels.
    pub fn titled(title: impl Into<String>) -> Self {
        Self { title: title.into(), facts: vec![], width: 900, height: 240 }
    }
}

/// Panels of waveforms one below the other, then digital lines, all over the axis `x`.
///
/// # Errors
/// If a size is out of range, a trace has not as many values as places, or there is nothing to draw.
pub fn trace_picture(
    x: &Axis,
    panels: &[Panel<'_>],
    lanes: &[Lane<'_>],
    look: &TraceLook,
) -> Result<Drawing, PlotError> {
    check_panel(look.width)?;
    check_panel(look.height)?;
    check_counts(panels, lanes)?;
    let places =
        panels.iter().flat_map(|p| &p.traces).flat_map(|t| t.x).chain(lanes.iter().flat_map(|l| l.x));
    let ruler = x.settle(places.copied(), 0.0)?;
    let width = look.width as f32;
    let header = Header::new(&look.title, &look.facts, width);
    let areas = panel_areas(panels, (LEFT, header.height()), look);
    let lanes_top = areas.last().map_or(header.height(), Area::bottom);
    let lanes_height = if lanes.is_empty() { 0.0 } else { LANE * lanes.len() as f32 + ABOVE };
    let bottom = lanes_top + lanes_height;
    let mut canvas = Canvas::new((LEFT + width + RIGHT) as u32, (bottom + BELOW) as u32);
    header.draw(&mut canvas, LEFT);
    for (index, (panel, &area)) in panels.iter().zip(&areas).enumerate() {
        let last = index + 1 == panels.len() && lanes.is_empty();
        draw_panel(&mut canvas, panel, area, ruler, last.then_some(x.label.as_str()))?;
    }
    if !lanes.is_empty() {
        let area = Area { left: LEFT, top: lanes_top + ABOVE, width, height: lanes_height - ABOVE };
        draw_lanes(&mut canvas, lanes, area, ruler, &x.label);
    }
    Ok(canvas.finish())
}

fn check_counts(panels: &[Panel<'_>], lanes: &[Lane<'_>]) -> Result<(), PlotError> {
    let traces = panels.iter().flat_map(|p| &p.traces).map(|t| (t.name, t.y.len(), t.x.len()));
    let lanes = lanes.iter().map(|l| (l.name, l.high.len(), l.x.len().saturating_sub(1)));
    for (name, found, expected) in traces.chain(lanes) {
        if found != expected {
            return Err(PlotError::Count { what: name.into(), found, expected });
        }
    }
    Ok(())
}

/// Where panels lie below one another from `top` on, each with room for its legend.
pub(crate) fn panel_areas(panels: &[Panel<'_>], (left, top): (f32, f32), look: &TraceLook) -> Vec<Area> {
    let (width, height) = (look.width as f32, look.height as f32);
    let mut top = top;
    let area_of = |panel| {
        let more = rows(&legend_places(&legend_widths(panel), width)) - 1;
        let area = Area { left, top: top + ABOVE + ROW * more as f32, width, height };
        top = area.bottom();
        area
    };
    panels.iter().map(area_of).collect()
}

pub(crate) fn draw_panel(
    canvas: &mut Canvas,
    panel: &Panel<'_>,
    area: Area,
    x: Ruler,
    x_label: Option<&str>,
) -> Result<(), PlotError> {
    let y = panel.axis.settle(panel.traces.iter().flat_map(|trace| trace.y).copied(), 0.06)?;
    let frame = Frame { area, x, y };
    frame.grid(canvas);
    canvas.clip(area);
    for (index, trace) in panel.traces.iter().enumerate() {
        draw_trace(canvas, &frame, trace, index);
    }
    canvas.unclip();
    frame.axes(canvas, x_label, &panel.axis.label);
    draw_legend(canvas, panel, area);
    Ok(())
}

fn draw_trace(canvas: &mut Canvas, frame: &Frame, trace: &Trace<'_>, index: usize) {
    let points: Vec<(f32, f32)> = trace.x.iter().zip(trace.y).map(|(&x, &y)| frame.at(x, y)).collect();
    for run in points.split(|(x, y)| !(x.is_finite() && y.is_finite())) {
        styled(canvas, run, 1.6, index);
    }
}

/// A line in the colour, and with the dash, of the trace number `index`.
fn styled(canvas: &mut Canvas, points: &[(f32, f32)], width: f32, index: usize) {
    canvas.stroke(points, width, dash(index), TRACES[index % TRACES.len()]);
}

/// How wide the names of a legend are, each with its line.
fn legend_widths(panel: &Panel<'_>) -> Vec<f32> {
    panel.traces.iter().map(|trace| SWATCH + BESIDE + lettering::width(trace.name, SMALL)).collect()
}

fn legend_places(widths: &[f32], room: f32) -> Vec<(usize, f32)> {
    flow(widths.iter().copied(), APART, room)
}

/// Names with their lines above the panel, every row at the right.
fn draw_legend(canvas: &mut Canvas, panel: &Panel<'_>, area: Area) {
    let widths = legend_widths(panel);
    let places = legend_places(&widths, area.width);
    let last = rows(&places) - 1;
    for (index, &(row, left)) in places.iter().enumerate() {
        let in_row = places.iter().zip(&widths).filter(|((other, _), _)| *other == row);
        let end = in_row.map(|((_, left), width)| left + width).fold(0.0, f32::max);
        let (left, base) = (area.right() - end + left, area.top - 8.0 - ROW * (last - row) as f32);
        styled(canvas, &[(left, base - 4.0), (left + SWATCH, base - 4.0)], 2.4, index);
        let name = panel.traces[index].name;
        canvas.text(name, (left + SWATCH + BESIDE, base), Anchor::Left, SMALL, INK);
    }
}

fn draw_lanes(canvas: &mut Canvas, lanes: &[Lane<'_>], area: Area, x: Ruler, x_label: &str) {
    let frame = Frame { area, x, y: Ruler::linear([0.0, 1.0]) };
    frame.grid_across(canvas);
    for (index, lane) in lanes.iter().enumerate() {
        let low = (area.top + LANE * (index + 1) as f32 - 6.0).floor();
        let colour = TRACES[index % TRACES.len()];
        canvas.fill(Area { left: area.left, top: low, width: area.width, height: 1.0 }, FAINT);
        canvas.text(lane.name, (area.left - 10.0, low - 2.0), Anchor::Right, SMALL, INK);
        canvas.clip(area);
        draw_lane(canvas, &frame, lane, low, colour);
        canvas.unclip();
    }
    canvas.border(area, SOFT);
    frame.x_axis(canvas, x_label);
}

fn draw_lane(canvas: &mut Canvas, frame: &Frame, lane: &Lane<'_>, low: f32, colour: Colour) {
    let mut at = 0;
    for run in lane.high.chunk_by(|a, b| a == b) {
        let [from, to] = [at, at + run.len()].map(|index| frame.at(lane.x[index], 0.0).0);
        let top = if run[0] { low - HIGH } else { low };
        let band = Area { left: from, top, width: to - from, height: low - top };
        canvas.fill(band, mix(PAPER, colour, 0.3));
        canvas.line(&[(from, top + 0.5), (to, top + 0.5)], 1.2, colour);
        if at > 0 {
            canvas.line(&[(from, low + 1.0), (from, low - HIGH)], 1.2, colour);
        }
        at += run.len();
    }
}
