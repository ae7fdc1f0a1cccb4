//! Digital events of one sweep below its analog ramps, all over ground range.

use crate::axis::{Axis, Ruler};
use crate::bank_picture::check_panel;
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, FAINT, INK, LATE, PAPER, SOFT, TRACES, mix};
use crate::frame::{BELOW, Frame, Header, LEFT, SMALL};
use crate::trace_picture::{ABOVE, Panel, RIGHT, TraceLook, draw_panel, panel_areas};
use crate::{Drawing, PlotError};

/// From one lane to the next (pixels).
const LANE: f32 = 22.0;
/// Height of a bar in its lane.
const BAR: f32 = 12.0;
/// Room for the lane's name, in addition to that of an axis.
const NAMES: f32 = 44.0;

/// What a stretch of a lane is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stretch {
    /// Asked for, and on its way.
    OnItsWay,
    /// There, and waiting to be used.
    Ready,
    /// Wanted, and not there yet.
    Late,
}

/// A stretch of the common axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Begin of the stretch on the common axis.
    pub from: f64,
    /// End of the stretch on the common axis.
    pub to: f64,
    /// Kind of the stretch, which decides how it is drawn.
    pub stretch: Stretch,
}

/// Events of one register.
#[derive(Debug, Clone, PartialEq)]
pub struct EventLane {
    /// Name, at its left.
    pub name: String,
    /// In any order; what is late is drawn last.
    pub spans: Vec<Span>,
}

/// Instants that concern all lanes.
#[derive(Debug, Clone, PartialEq)]
pub struct Stops {
    /// Name in the legend: `X stop`.
    pub name: String,
    /// Places on the common axis.
    pub at: Vec<f64>,
}

/// Everything in a timeline.
#[derive(Debug, Clone, PartialEq)]
pub struct Timeline<'a> {
    /// Axis that panels and lanes have in common.
    pub x: Axis,
    /// Panels of analog signals, from top to bottom.
    pub panels: Vec<Panel<'a>>,
    /// Upright lines through the lanes, one colour each.
    pub stops: Vec<Stops>,
    /// Lanes from top to bottom.
    pub lanes: Vec<EventLane>,
}

/// Panels of waveforms one below the other, then lanes of events with the stops through them.
///
/// # Errors
/// If a size is out of range, a trace has not as many values as places, or there is nothing to draw.
pub fn timeline_picture(timeline: &Timeline<'_>, look: &TraceLook) -> Result<Drawing, PlotError> {
    check_panel(look.width)?;
    check_panel(look.height)?;
    let x = timeline.x.settle(timeline.places(), 0.0)?;
    let (left, width) = (LEFT + NAMES, look.width as f32);
    let header = Header::new(&look.title, &look.facts, width);
    let areas = panel_areas(&timeline.panels, (left, header.height()), look);
    let lanes_top = areas.last().map_or(header.height(), Area::bottom) + ABOVE;
    let lanes = Area { left, top: lanes_top, width, height: LANE * timeline.lanes.len().max(1) as f32 };
    let mut canvas = Canvas::new((left + width + RIGHT) as u32, (lanes.bottom() + BELOW) as u32);
    header.draw(&mut canvas, left);
    for (panel, &area) in timeline.panels.iter().zip(&areas) {
        draw_panel(&mut canvas, panel, area, x, None)?;
    }
    draw_lanes(&mut canvas, timeline, &Frame { area: lanes, x, y: Ruler::linear([0.0, 1.0]) });
    Ok(canvas.finish())
}

impl Timeline<'_> {
    fn places(&self) -> impl Iterator<Item = f64> {
        let traces = self.panels.iter().flat_map(|panel| &panel.traces).flat_map(|trace| trace.x);
        let stops = self.stops.iter().flat_map(|stops| &stops.at);
        let spans = self.lanes.iter().flat_map(|lane| &lane.spans).flat_map(|span| [&span.from, &span.to]);
        traces.chain(stops).chain(spans).copied()
    }
}

fn draw_lanes(canvas: &mut Canvas, timeline: &Timeline<'_>, frame: &Frame) {
    let area = frame.area;
    frame.grid_across(canvas);
    for (index, stops) in timeline.stops.iter().enumerate() {
        draw_stops(canvas, frame, stops, index);
    }
    draw_legend(canvas, timeline, area);
    for (index, lane) in timeline.lanes.iter().enumerate() {
        let base = (area.top + LANE * (index + 1) as f32 - 5.0).floor();
        canvas.fill(Area { top: base, height: 1.0, ..area }, FAINT);
        canvas.text(&lane.name, (area.left - 10.0, base - 1.0), Anchor::Right, SMALL, INK);
        draw_lane(canvas, frame, lane, base);
    }
    canvas.border(area, SOFT);
    frame.x_axis(canvas, &timeline.x.label);
}

fn draw_stops(canvas: &mut Canvas, frame: &Frame, stops: &Stops, index: usize) {
    let Area { top, height, .. } = frame.area;
    for place in stops.at.iter().filter(|&&place| is_inside(frame, place)) {
        let (x, _) = frame.at(*place, 0.0);
        canvas.fill(Area { left: x.floor(), top, width: 1.0, height }, stop_colour(index));
    }
}

fn stop_colour(index: usize) -> Colour {
    mix(PAPER, TRACES[index % TRACES.len()], 0.55)
}

fn is_inside(frame: &Frame, place: f64) -> bool {
    (0.0..=1.0).contains(&frame.x.share(place))
}

/// Late stretches over all others; each at least a pixel wide, so that none is lost.
fn draw_lane(canvas: &mut Canvas, frame: &Frame, lane: &EventLane, base: f32) {
    let Area { left, .. } = frame.area;
    for stretch in [Stretch::Ready, Stretch::OnItsWay, Stretch::Late] {
        for span in lane.spans.iter().filter(|span| span.stretch == stretch) {
            let [from, to] = [span.from, span.to].map(|place| frame.at(place, 0.0).0);
            let (from, to) = (from.max(left), to.min(frame.area.right()));
            if from.is_finite() && to >= from {
                let band = Area { left: from, top: base - BAR, width: (to - from).max(1.0), height: BAR };
                canvas.fill(band, colour_of(stretch));
            }
        }
    }
}

fn colour_of(stretch: Stretch) -> Colour {
    match stretch {
        Stretch::OnItsWay => TRACES[2],
        Stretch::Ready => mix(PAPER, TRACES[2], 0.3),
        Stretch::Late => LATE,
    }
}

/// Names of the stretches and of the stops, above the lanes.
fn draw_legend(canvas: &mut Canvas, timeline: &Timeline<'_>, area: Area) {
    let stretches = [
        ("on its way", colour_of(Stretch::OnItsWay)),
        ("ready", colour_of(Stretch::Ready)),
        ("late", colour_of(Stretch::Late)),
    ];
    let stops =
        timeline.stops.iter().enumerate().map(|(index, stops)| (stops.name.as_str(), stop_colour(index)));
    let entries: Vec<(&str, Colour)> = stretches.into_iter().chain(stops).collect();
    crate::bar_picture::legend(canvas, &entries, area);
}
