//! Points in a plane of two logarithms: error against time, or against a step.

use crate::axis::{Axis, Scale};
use crate::bank_picture::check_panel;
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, INK, PAPER, SOFT, TRACES, mix};
use crate::frame::{BELOW, Frame, Header, LEFT, SMALL, TEXT};
use crate::labels::Labels;
use crate::lettering;
use crate::trace_picture::{ABOVE, RIGHT, TraceLook};
use crate::{Drawing, PlotError};

/// Half the width of a mark (pixels).
const MARK: f32 = 4.0;
/// From one row of the key to the next.
const LEADING: f32 = 18.0;
/// Room on either side of what is drawn, as a factor.
const MARGIN: f64 = 1.6;

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct PointSeries<'a> {
    /// Name in the key.
    pub name: &'a str,
    /// Places; those that a logarithm does not have are left out.
    pub points: Vec<[f64; 2]>,
    /// What stands beside each point, where there is room; may be shorter.
    pub labels: Vec<&'a str>,
    /// Whether a line joins them.
    pub joined: bool,
}

/// A slope to compare with: `y` grows with `x` to this power.
#[derive(Debug, Clone, PartialEq)]
pub struct SlopeGuide {
    /// What stands at its end.
    pub name: String,
    /// Power of `x` that `y` grows with.
    pub order: f64,
    /// A place on it.
    pub through: [f64; 2],
    /// From where to where it is drawn, along x.
    pub over: [f64; 2],
}

/// A panel of points on two logarithmic axes, with the points that no other beats joined by a line (`front`, may be empty)
/// and slopes to compare with.
///
/// # Errors
/// If a size is out of range or there is nothing to draw.
pub fn ladder_picture(
    [x, y]: [&str; 2],
    series: &[PointSeries<'_>],
    front: &[[f64; 2]],
    guides: &[SlopeGuide],
    look: &TraceLook,
) -> Result<Drawing, PlotError> {
    check_panel(look.width)?;
    check_panel(look.height)?;
    let (width, height) = (look.width as f32, look.height as f32);
    let header = Header::new(&look.title, &look.facts, width);
    let keys = rows(series, width);
    let top = header.height() + ABOVE + (keys.len().saturating_sub(1)) as f32 * LEADING;
    let mut canvas = Canvas::new((LEFT + width + RIGHT) as u32, (top + height + BELOW) as u32);
    header.draw(&mut canvas, LEFT);
    let area = Area { left: LEFT, top, width, height };
    let along = |axis: usize| {
        series.iter().flat_map(move |series| series.points.iter().map(move |point| point[axis]))
    };
    let ruler = |axis: usize, label: &str| {
        let mut ruler = Axis::new(label).logarithmic().settle(along(axis), 0.0)?;
        ruler.range = [ruler.range[0] / MARGIN, ruler.range[1] * MARGIN];
        Ok::<_, PlotError>(ruler)
    };
    let frame = Frame { area, x: ruler(0, x)?, y: ruler(1, y)? };
    debug_assert_eq!(frame.x.scale, Scale::Logarithmic);
    frame.grid(&mut canvas);
    canvas.clip(area);
    let pixels =
        |points: &[[f64; 2]]| -> Vec<(f32, f32)> { points.iter().map(|&[x, y]| frame.at(x, y)).collect() };
    canvas.line(&pixels(front), 5.0, mix(SOFT, PAPER, 0.65));
    for guide in guides {
        draw_guide(&mut canvas, &frame, guide);
    }
    for (index, series) in series.iter().enumerate() {
        let colour = TRACES[index % TRACES.len()];
        if series.joined {
            canvas.line(&pixels(&series.points), 1.5, colour);
        }
        pixels(&series.points).into_iter().for_each(|at| mark(&mut canvas, at, index, colour));
    }
    draw_labels(&mut canvas, &frame, series);
    canvas.unclip();
    frame.axes(&mut canvas, Some(x), y);
    draw_key(&mut canvas, &keys, series, (LEFT, header.height() + ABOVE - 8.0));
    Ok(canvas.finish())
}

/// Each where it covers nothing; one that has no room is left out, and the table has it.
fn draw_labels(canvas: &mut Canvas, frame: &Frame, series: &[PointSeries<'_>]) {
    let at = |point: &[f64; 2]| frame.at(point[0], point[1]);
    let points = series.iter().flat_map(|series| &series.points).map(at);
    let mut labels = Labels::new(frame.area, SMALL, MARK, points);
    for (point, label) in series.iter().flat_map(|series| series.points.iter().zip(&series.labels)) {
        if let Some(placed) = labels.place(label, at(point)) {
            if let Some(end) = placed.leader {
                canvas.line(&[at(point), end], 1.0, mix(SOFT, PAPER, 0.5));
            }
            canvas.text(label, placed.at, Anchor::Left, SMALL, SOFT);
        }
    }
}

fn draw_guide(canvas: &mut Canvas, frame: &Frame, guide: &SlopeGuide) {
    let value = |x: f64| guide.through[1] * libm::pow(x / guide.through[0], guide.order);
    let ends = guide.over.map(|x| frame.at(x, value(x)));
    canvas.dashed(&ends, 1.5, [6.0, 4.0], INK);
    let (x, y) = ends[1];
    canvas.text(&guide.name, (x - 6.0, y - 8.0), Anchor::Right, SMALL, INK);
}

/// A mark whose shape changes when the colours begin anew.
fn mark(canvas: &mut Canvas, (x, y): (f32, f32), index: usize, colour: Colour) {
    let points: Vec<(f32, f32)> = match index / TRACES.len() % 3 {
        0 => [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].into(),
        1 => [(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)].into(),
        _ => [(0.0, -1.3), (1.2, 1.0), (-1.2, 1.0)].into(),
    };
    let shape: Vec<(f32, f32)> = points.iter().map(|(dx, dy)| (x + MARK * dx, y + MARK * dy)).collect();
    canvas.polygon(&shape, colour);
}

/// The key in rows of at most `width` pixels: indices of the series of each.
fn rows(series: &[PointSeries<'_>], width: f32) -> Vec<Vec<usize>> {
    let mut rows: Vec<Vec<usize>> = vec![vec![]];
    let mut used = 0.0;
    for (index, series) in series.iter().enumerate() {
        let wide = entry(series.name);
        if used + wide > width && used > 0.0 {
            rows.push(vec![]);
            used = 0.0;
        }
        used += wide;
        if let Some(row) = rows.last_mut() {
            row.push(index);
        }
    }
    rows
}

/// Pixels of an entry of the key.
fn entry(name: &str) -> f32 {
    lettering::width(name, TEXT) + 4.0 * MARK + 18.0
}

fn draw_key(canvas: &mut Canvas, rows: &[Vec<usize>], series: &[PointSeries<'_>], (left, top): (f32, f32)) {
    for (row, entries) in rows.iter().enumerate() {
        let (mut x, y) = (left, top + row as f32 * LEADING);
        for &index in entries {
            let colour = TRACES[index % TRACES.len()];
            mark(canvas, (x + MARK, y - MARK), index, colour);
            canvas.text(series[index].name, (x + 3.0 * MARK + 2.0, y), Anchor::Left, TEXT, INK);
            x += entry(series[index].name);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{PointSeries, SlopeGuide, ladder_picture};
    use crate::TraceLook;

    fn series(points: Vec<[f64; 2]>) -> PointSeries<'static> {
        PointSeries { name: "samples", points, labels: vec!["125"], joined: true }
    }

    #[test]
    fn points_lie_where_their_logarithms_are() {
        let look = TraceLook { title: "t".into(), facts: vec![], width: 400, height: 300 };
        let points = vec![[1e-3, 1e-2], [1e-2, 1e-4]];
        let guide = SlopeGuide { name: "order 2".into(), order: 2.0, through: points[0], over: [1e-3, 1e-2] };
        let drawing =
            ladder_picture(["time", "error"], &[series(points.clone())], &points, &[guide], &look).unwrap();
        let svg = drawing.svg();
        assert!(svg.contains("<svg") && drawing.columns() > 400);
        // Nothing that a logarithm has: refused, not drawn at random.
        let bad = ladder_picture(["x", "y"], &[series(vec![[0.0, f64::NAN]])], &[], &[], &look);
        assert!(bad.is_err());
    }
}
