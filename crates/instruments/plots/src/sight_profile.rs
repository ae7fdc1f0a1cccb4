//! A line of sight over the ground below it.

use crate::axis::{Ruler, extremes};
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, INK, LATE, TRACES};
use crate::frame::{BELOW, Frame, Header, LEFT, SMALL};
use crate::{Drawing, PlotError};

const WIDTH: f32 = 800.0;
const HEIGHT: f32 = 320.0;
/// Room to the right of the panel (pixels).
const RIGHT: f32 = 24.0;
const GROUND: Colour = [190, 182, 168];

/// Ground and line at places along a line of sight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SightProfile<'a> {
    /// Distance (m) from the observer, height (m) of the ground (NaN where there is none), height (m) of the line: one row a place,
    /// distances ascending.
    pub places: &'a [[f64; 3]],
    /// Distance (m) of the first ground above the line.
    pub blocker: Option<f64>,
    /// Title, which says what was looked at.
    pub title: &'a str,
    /// Lines below the title.
    pub facts: &'a [String],
}

/// The line of sight over the ground, heights above the datum.
///
/// # Errors
/// If there are fewer than two places, or a distance or a height of the line is no number.
pub fn sight_profile(profile: &SightProfile<'_>) -> Result<Drawing, PlotError> {
    let places = profile.places;
    if places.len() < 2 {
        return Err(PlotError::Count { what: "places".into(), found: places.len(), expected: 2 });
    }
    for found in places.iter().flat_map(|[distance, _, line]| [*distance, *line]) {
        if !found.is_finite() {
            return Err(PlotError::Value { what: "place".into(), found, expected: "a finite number" });
        }
    }
    let heights = places.iter().flat_map(|[_, ground, line]| [*ground, *line]).filter(|h| !h.is_nan());
    let [low, high] = extremes(heights).unwrap_or([0.0, 1.0]);
    let margin = (0.08 * (high - low)).max(1e-3);
    let header = Header::new(profile.title, profile.facts, WIDTH);
    let area = Area { left: LEFT, top: header.height() + 16.0, width: WIDTH, height: HEIGHT };
    let x = Ruler::linear([places[0][0], places[places.len() - 1][0]]);
    let frame = Frame { area, x, y: Ruler::linear([low - margin, high + margin]) };
    let mut canvas = Canvas::new((area.right() + RIGHT) as u32, (area.bottom() + BELOW) as u32);
    header.draw(&mut canvas, LEFT);
    frame.grid(&mut canvas);
    canvas.clip(area);
    draw_ground(&mut canvas, &frame, places);
    let line: Vec<(f32, f32)> = places.iter().map(|[distance, _, line]| frame.at(*distance, *line)).collect();
    canvas.line(&line, 2.0, TRACES[0]);
    if let Some(distance) = profile.blocker {
        let (x, _) = frame.at(distance, low);
        canvas.dashed(&[(x, area.top), (x, area.bottom())], 1.5, [6.0, 4.0], LATE);
    }
    canvas.unclip();
    frame.axes(&mut canvas, Some("distance from the observer (m)"), "height (m)");
    let legend = "blue: line of sight; dashed red: first ground above it";
    canvas.text(legend, (area.right(), area.top - 6.0), Anchor::Right, SMALL, INK);
    Ok(canvas.finish())
}

/// Ground as filled stretches; where there is none, nothing.
fn draw_ground(canvas: &mut Canvas, frame: &Frame, places: &[[f64; 3]]) {
    let bottom = frame.area.bottom();
    for stretch in places.split(|[_, ground, _]| ground.is_nan()).filter(|stretch| stretch.len() > 1) {
        let top = stretch.iter().map(|[distance, ground, _]| frame.at(*distance, *ground));
        let mut points: Vec<(f32, f32)> = top.collect();
        let (first, last) = (points[0].0, points[points.len() - 1].0);
        points.extend([(last, bottom), (first, bottom)]);
        canvas.polygon(&points, GROUND);
    }
}
