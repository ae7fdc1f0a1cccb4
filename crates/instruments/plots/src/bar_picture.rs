//! Histograms of one kind below one another.

use crate::axis::{Axis, Ruler};
use crate::bank_picture::check_panel;
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, INK, LATE, SOFT, TRACES};
use crate::frame::{BELOW, Frame, Header, LEFT, SMALL, TEXT};
use crate::lettering;
use crate::trace_picture::{RIGHT, TraceLook};
use crate::{Drawing, PlotError};

/// Room above a panel for its legend.
const ABOVE: f32 = 30.0;
/// Room below a panel for its edges.
const EDGES: f32 = 30.0;
/// Room between a bar and the edge of its bin (pixels).
const GAP: f32 = 2.0;
/// Where the logarithmic axis of counts begins: a bin of one deadline can be seen.
const LEAST: f64 = 0.5;

/// Counts in bins side by side, on a logarithmic axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Bars {
    /// Name of what is counted.
    pub name: String,
    /// How many are in each bin.
    pub counts: Vec<f64>,
    /// Labels between the bins, one less than bins.
    pub edges: Vec<String>,
    /// How many bins, from the left, hold what went wrong.
    pub wrong: usize,
    /// Names of what is in those bins and of what is in all others, in the legend.
    pub kinds: [&'static str; 2],
}

/// Panels of bars below one another. `x` says what the bins are, `y` what is counted.
///
/// # Errors
/// If a size is out of range, labels and bins do not go together, or there is nothing to draw.
pub fn bar_picture(x: &str, y: &str, panels: &[Bars], look: &TraceLook) -> Result<Drawing, PlotError> {
    check_panel(look.width)?;
    check_panel(look.height)?;
    if panels.is_empty() {
        return Err(PlotError::Empty { what: look.title.clone() });
    }
    panels.iter().try_for_each(check_labels)?;
    let (width, height) = (look.width as f32, look.height as f32);
    let header = Header::new(&look.title, &look.facts, width);
    let pitch = ABOVE + height + EDGES;
    let bottom = header.height() + pitch * panels.len() as f32;
    let mut canvas = Canvas::new((LEFT + width + RIGHT) as u32, (bottom + BELOW - EDGES) as u32);
    header.draw(&mut canvas, LEFT);
    for (index, bars) in panels.iter().enumerate() {
        let top = header.height() + pitch * index as f32 + ABOVE;
        draw_bars(&mut canvas, bars, Area { left: LEFT, top, width, height }, y)?;
    }
    canvas.text(x, (LEFT + width / 2.0, bottom + 14.0), Anchor::Middle, TEXT, INK);
    Ok(canvas.finish())
}

fn check_labels(bars: &Bars) -> Result<(), PlotError> {
    let (found, expected) = (bars.edges.len(), bars.counts.len().saturating_sub(1));
    if found == expected {
        Ok(())
    } else {
        Err(PlotError::Count { what: bars.name.clone(), found, expected })
    }
}

fn draw_bars(canvas: &mut Canvas, bars: &Bars, area: Area, y: &str) -> Result<(), PlotError> {
    let most = bars.counts.iter().copied().fold(1.0, f64::max);
    let counts = Axis::new(y).logarithmic().over([LEAST, 2.0 * most]).settle([].into_iter(), 0.0)?;
    let bins = Ruler::linear([0.0, bars.counts.len().max(1) as f64]);
    let frame = Frame { area, x: bins, y: counts };
    frame.grid_along(canvas);
    for (bin, &count) in bars.counts.iter().enumerate().filter(|(_, count)| **count > 0.0) {
        let (left, top) = frame.at(bin as f64, count.max(LEAST));
        let (right, bottom) = frame.at((bin + 1) as f64, LEAST);
        let bar = Area { left: left + GAP, top, width: right - left - 2.0 * GAP, height: bottom - top };
        canvas.fill(bar, if bin < bars.wrong { LATE } else { TRACES[0] });
    }
    frame.axes(canvas, None, y);
    for (index, label) in bars.edges.iter().enumerate() {
        let (middle, _) = frame.at((index + 1) as f64, LEAST);
        canvas.text(label, (middle, area.bottom() + 17.0), Anchor::Middle, SMALL, SOFT);
    }
    canvas.text(&bars.name, (area.left, area.top - 9.0), Anchor::Left, TEXT, INK);
    let [wrong, right] = bars.kinds;
    legend(canvas, &[(wrong, LATE), (right, TRACES[0])], area);
    Ok(())
}

/// Names with a patch of their colour, at the right above `area`.
pub(crate) fn legend(canvas: &mut Canvas, entries: &[(&str, Colour)], area: Area) {
    let mut right = area.right();
    let base = area.top - 8.0;
    for &(name, colour) in entries.iter().rev() {
        canvas.text(name, (right, base), Anchor::Right, SMALL, INK);
        right -= lettering::width(name, SMALL) + 8.0;
        canvas.line(&[(right - 20.0, base - 4.0), (right, base - 4.0)], 6.0, colour);
        right -= 20.0 + 18.0;
    }
}
