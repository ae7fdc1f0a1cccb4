//! Fitted ground beside what the fit leaves.

use crate::axis::{Ruler, number};
use crate::bank_picture::{check_panel, sun_text};
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, HATCH, INK, PAPER, VOID, of_height, of_residual};
use crate::frame::{BAR_ROOM, BELOW, Frame, Header, LEFT, SMALL, colour_bar, map_frame, map_size};
use crate::ground::GroundMap;
use crate::residuals::{Figures, Spot};
use crate::{Drawing, PlotError, Residuals};
use landscape::{Level, Sun};
use std::f64::consts::PI;

/// Height of the histogram (pixels).
const HISTOGRAM: f32 = 170.0;
/// Room between maps and histogram for the legend.
const GAP: f32 = 30.0;
/// Bars of the histogram.
const BARS: usize = 81;
/// Colour of the bars.
const BAR_COLOUR: Colour = [132, 150, 168];

/// How a survey is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct SurveyLook {
    /// Title, which says what was surveyed.
    pub title: String,
    /// Lines below the title; the figures of the residuals are added.
    pub facts: Vec<String>,
    /// The longer side of each map, 120 to 8000 pixels.
    pub longest: u32,
}

impl SurveyLook {
    /// Maps of 560 pixels.
    pub fn titled(title: impl Into<String>) -> Self {
        Self { title: title.into(), facts: vec![], longest: 560 }
    }
}

/// The fitted ground of `level`, beside it the residuals of its samples (each pixel its worst one, voids hatched),
/// below their histogram with the normal distribution of the same RMS.
///
/// # Errors
/// If the maps are too small or too large, or the residuals do not fit their raster or are all void.
pub fn survey_picture(
    level: &Level,
    sun: Sun,
    residuals: &Residuals<'_>,
    look: &SurveyLook,
) -> Result<Drawing, PlotError> {
    check_panel(look.longest)?;
    residuals.check()?;
    let figures = residuals.figures()?;
    let [south, west, north, east] = level.extent();
    let (width, height) = map_size([north - south, east - west], look.longest);
    let pitch = (LEFT + width + BAR_ROOM).max(300.0);
    let header = Header::new(&look.title, &facts(sun, &figures, look), 2.0 * pitch - LEFT - 16.0);
    let left = Area { left: LEFT, top: header.height(), width, height };
    let right = Area { left: (LEFT + pitch).floor(), ..left };
    let top = left.bottom() + BELOW + GAP;
    let strip = Area { left: LEFT, top, width: right.right() - LEFT, height: HISTOGRAM };
    let mut canvas = Canvas::new((2.0 * pitch) as u32, (strip.bottom() + BELOW) as u32);
    header.draw(&mut canvas, LEFT);
    draw_ground(&mut canvas, level, sun, left);
    draw_residuals(&mut canvas, level, residuals, &figures, right);
    draw_histogram(&mut canvas, residuals, &figures, strip);
    Ok(canvas.finish())
}

fn facts(sun: Sun, figures: &Figures, look: &SurveyLook) -> Vec<String> {
    let own = format!(
        "residuals of {} samples: RMS {}, largest {}; {} places without a sample; {}",
        number(figures.count as f64, 0),
        metres(figures.rms),
        metres(figures.worst),
        number(figures.voids as f64, 0),
        sun_text(sun),
    );
    look.facts.iter().cloned().chain([own]).collect()
}

/// Three digits of a length.
fn metres(length: f64) -> String {
    let digits = if length > 0.0 { 2 - libm::log10(length).floor() as i32 } else { 0 };
    format!("{} m", number(length, digits.clamp(0, 5) as usize))
}

fn draw_ground(canvas: &mut Canvas, level: &Level, sun: Sun, area: Area) {
    let ground = GroundMap::sample(level, area, sun);
    ground.draw(canvas, area, false);
    draw_axes(canvas, level, area);
    colour_bar(canvas, area, ground.ruler(), "fitted height (m)", of_height);
}

fn draw_residuals(
    canvas: &mut Canvas,
    level: &Level,
    residuals: &Residuals<'_>,
    figures: &Figures,
    area: Area,
) {
    let [south, west, north, east] = level.extent();
    let steps = [(north - south) / f64::from(area.height), (east - west) / f64::from(area.width)];
    canvas.image(area, |column, line| {
        let x = north - f64::from(line) * steps[0];
        let y = west + f64::from(column) * steps[1];
        match residuals.spot([x - steps[0], x], [y, y + steps[1]]) {
            Spot::Outside => PAPER,
            Spot::Void if (column + line) % 7 < 2 => HATCH,
            Spot::Void => VOID,
            Spot::Worst(residual) => of_residual(residual / figures.limit),
        }
    });
    draw_axes(canvas, level, area);
    let ruler = Ruler::linear([-figures.limit, figures.limit]);
    colour_bar(canvas, area, ruler, "sample − fit (m)", |share| of_residual(2.0 * share - 1.0));
}

fn draw_axes(canvas: &mut Canvas, level: &Level, area: Area) {
    let (frame, unit) = map_frame(area, level.extent());
    frame.axes(canvas, Some(&format!("east ({unit})")), &format!("north ({unit})"));
}

fn draw_histogram(canvas: &mut Canvas, residuals: &Residuals<'_>, figures: &Figures, area: Area) {
    let counts = counts(residuals.values, figures.limit);
    let most = counts.iter().copied().max().unwrap_or(0).max(1) as f64;
    let x = Ruler::linear([-figures.limit, figures.limit]);
    let frame = Frame { area, x, y: Ruler::linear([0.0, 1.08 * most]) };
    frame.grid(canvas);
    canvas.clip(area);
    for (bar, count) in counts.iter().enumerate() {
        let left = (area.left + area.width * bar as f32 / BARS as f32).round();
        let right = (area.left + area.width * (bar + 1) as f32 / BARS as f32).round();
        let (_, top) = frame.at(0.0, *count as f64);
        let bar = Area { left, top, width: right - left - 1.0, height: area.bottom() - top };
        canvas.fill(bar, BAR_COLOUR);
    }
    let normal: Vec<(f32, f32)> = normal(figures).into_iter().map(|(x, y)| frame.at(x, y)).collect();
    canvas.line(&normal, 1.4, INK);
    canvas.unclip();
    frame.axes(canvas, Some("sample − fit (m); the outermost bars hold all beyond"), "samples");
    let legend = (area.right(), area.top - 9.0);
    canvas.text("line: normal distribution of the same RMS", legend, Anchor::Right, SMALL, INK);
}

/// Samples in each bar; what lies beyond the limit counts in the outermost.
fn counts(values: &[f64], limit: f64) -> [u64; BARS] {
    let mut counts = [0; BARS];
    for value in values.iter().filter(|value| value.is_finite()) {
        let bar = (value / limit + 1.0) / 2.0 * BARS as f64;
        counts[(bar.max(0.0) as usize).min(BARS - 1)] += 1;
    }
    counts
}

/// Expected samples a bar along the scale, were the residuals normal.
fn normal(figures: &Figures) -> Vec<(f64, f64)> {
    let bar = 2.0 * figures.limit / BARS as f64;
    let peak = figures.count as f64 * bar / ((2.0 * PI).sqrt() * figures.rms);
    let point = |step: i32| {
        let x = figures.limit * f64::from(step) / 200.0;
        (x, peak * libm::exp(-0.5 * (x / figures.rms) * (x / figures.rms)))
    };
    if figures.rms > 0.0 { (-200..=200).map(point).collect() } else { vec![] }
}

#[cfg(test)]
mod tests {
    use super::{BARS, counts, metres};

    #[test]
    fn every_sample_counts_once() {
        let values = [-9.0, -1.0, 0.0, 0.001, 1.0, 9.0, f64::NAN];
        let found = counts(&values, 1.0);
        assert_eq!((found[0], found[BARS / 2], found[BARS - 1]), (2, 2, 2));
        assert_eq!(found.iter().sum::<u64>(), 6);
    }

    #[test]
    fn lengths_have_three_digits() {
        assert_eq!((metres(0.012345), metres(12.345)), ("0.0123 m".into(), "12.3 m".into()));
        assert_eq!((metres(0.0), metres(1234.5)), ("0 m".into(), "1234 m".into()));
    }
}
