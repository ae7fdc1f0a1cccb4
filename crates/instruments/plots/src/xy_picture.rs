//! One value over another, sample by sample: X-Y, as an oscilloscope has it.

use crate::axis::{Axis, Ruler, extremes};
use crate::bank_picture::check_panel;
use crate::canvas::{Anchor, Area, Canvas};
use crate::frame::{BELOW, Frame, Header, LEFT, TEXT};
use crate::scope::Theme;
use crate::trace_picture::{ABOVE, RIGHT, TraceLook};
use crate::{Drawing, PlotError};

/// Room on either side of what is drawn, as a share of its extent.
const MARGIN: f64 = 0.04;
/// Half the width of the mark of a place (pixels).
const MARK: f32 = 4.0;

/// A value of one signal over that of another at the same samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Xy<'a> {
    /// What runs across and what runs up, each with its unit.
    pub labels: [&'a str; 2],
    /// Values of both at each sample; the trace breaks where one is not finite.
    pub points: Vec<[f64; 2]>,
    /// Places on the trace, each with its name.
    pub marks: Vec<(String, [f64; 2])>,
    /// Whether a length across is the same length up: both have one unit.
    pub even: bool,
}

/// Draws the beam of an oscilloscope whose two inputs are the two signals.
///
/// # Errors
/// If a size is out of range or there is nothing to draw.
pub fn xy_picture(xy: &Xy<'_>, theme: Theme, look: &TraceLook) -> Result<Drawing, PlotError> {
    check_panel(look.width)?;
    check_panel(look.height)?;
    let (width, height) = (look.width as f32, look.height as f32);
    let header = Header::new(&look.title, &look.facts, width);
    let top = header.height() + ABOVE;
    let size = ((LEFT + width + RIGHT) as u32, (top + height + BELOW) as u32);
    let mut canvas = Canvas::of(theme.palette(), size.0, size.1);
    header.draw(&mut canvas, LEFT);
    let area = Area { left: LEFT, top, width, height };
    let [x, y] = rulers(xy, f64::from(width / height))?;
    let frame = Frame { area, x, y };
    frame.grid(&mut canvas);
    canvas.clip(area);
    let (ink, soft) = (canvas.palette().traces[0], canvas.palette().ink);
    for stretch in xy.points.split(|point| !point.iter().all(|value| value.is_finite())) {
        let beam: Vec<(f32, f32)> = stretch.iter().map(|&[x, y]| frame.at(x, y)).collect();
        canvas.line(&beam, 1.5, ink);
    }
    for (name, [x, y]) in &xy.marks {
        let (across, down) = frame.at(*x, *y);
        let ring = [(-MARK, 0.0), (0.0, -MARK), (MARK, 0.0), (0.0, MARK), (-MARK, 0.0)];
        canvas.line(&ring.map(|(dx, dy)| (across + dx, down + dy)), 1.5, soft);
        canvas.text(name, (across + 2.0 * MARK, down - MARK), Anchor::Left, TEXT, soft);
    }
    canvas.unclip();
    frame.axes(&mut canvas, Some(xy.labels[0]), xy.labels[1]);
    Ok(canvas.finish())
}

/// The axes over all points; of one unit both have as many units a pixel, on a panel `aspect` times as wide as high.
fn rulers(xy: &Xy<'_>, aspect: f64) -> Result<[Ruler; 2], PlotError> {
    let drawn = xy.points.iter().filter(|point| point.iter().all(|value| value.is_finite()));
    let along = |axis: usize| drawn.clone().map(move |point| point[axis]);
    let settle = |axis: usize, range: Option<[f64; 2]>| {
        Axis { range, ..Axis::new(xy.labels[axis]) }.settle(along(axis), MARGIN)
    };
    let (Some(across), Some(up)) = (extremes(along(0)), extremes(along(1))) else {
        return Err(PlotError::Empty { what: xy.labels[0].to_owned() });
    };
    if !xy.even {
        return Ok([settle(0, None)?, settle(1, None)?]);
    }
    let extent = |[low, high]: [f64; 2]| high - low;
    let half = 0.5 * (1.0 + 2.0 * MARGIN) * extent(up).max(extent(across) / aspect);
    // A point that stands still has no extent of its own.
    let half = if half > 0.0 { half } else { 0.5 };
    let about =
        |[low, high]: [f64; 2], half: f64| Some([0.5 * (low + high) - half, 0.5 * (low + high) + half]);
    Ok([settle(0, about(across, half * aspect))?, settle(1, about(up, half))?])
}

#[cfg(test)]
mod tests {
    use super::{Xy, rulers, xy_picture};
    use crate::scope::Theme;
    use crate::trace_picture::TraceLook;

    fn square(even: bool) -> Xy<'static> {
        let points = vec![[0.0, 10.0], [4.0, 10.0], [4.0, 11.0], [f64::NAN, 0.0], [0.0, 11.0], [0.5, 10.5]];
        Xy { labels: ["a (m)", "b (m)"], points, marks: vec![("A".into(), [4.0, 11.0])], even }
    }

    #[test]
    fn signals_of_one_unit_have_one_scale() {
        for aspect in [0.5, 1.0, 3.0] {
            let [x, y] = rulers(&square(true), aspect).expect("rulers");
            let [across, up] = [x, y].map(|ruler| ruler.range[1] - ruler.range[0]);
            assert!((across - aspect * up).abs() < 1e-12, "{aspect}: {across}, {up}");
            assert!(x.range[0] < 0.0 && x.range[1] > 4.0 && y.range[0] < 10.0 && y.range[1] > 11.0);
        }
        let [x, y] = rulers(&square(false), 1.0).expect("rulers");
        assert!(x.range[1] - x.range[0] > 3.0 * (y.range[1] - y.range[0]));
    }

    #[test]
    fn the_beam_breaks_where_there_is_no_value() {
        let look = TraceLook { title: "t".into(), facts: vec![], width: 300, height: 300 };
        let strokes =
            |xy: &Xy| xy_picture(xy, Theme::Light, &look).map(|drawing| drawing.svg().matches('M').count());
        let broken = strokes(&square(true)).expect("a picture");
        let mut whole = square(true);
        whole.points[3] = [2.0, 11.0];
        assert_ne!(broken, strokes(&whole).expect("a picture"));
        whole.points.clear();
        assert!(strokes(&whole).is_err());
    }
}
