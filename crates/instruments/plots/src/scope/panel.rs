//! Panels of curves: legend, grid, both scales, traces.

use crate::PlotError;
use crate::axis::{Axis, Ruler};
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::dash;
use crate::flow::{flow, rows};
use crate::frame::{SMALL, TEXT};
use crate::lettering;

use super::clock::View;
use super::page::{Curve, Curves, Upright};

/// Height of a row of the legend.
const ROW: f32 = 18.0;
/// Room between the legend and what stands above it.
const ABOVE: f32 = 8.0;
/// Length of the line beside a name of the legend.
const SWATCH: f32 = 22.0;
/// Length of a tick.
const TICK: f32 = 5.0;

/// A line in the style of a curve.
pub(crate) fn styled(canvas: &mut Canvas, points: &[(f32, f32)], width: f32, index: usize) {
    let traces = &canvas.palette().traces;
    canvas.stroke(points, width, dash(index), traces[index % traces.len()]);
}

/// Places of the names of the legend within `width`.
fn legend(curves: &Curves<'_>, width: f32) -> Vec<(usize, f32)> {
    let needs = |curve: &Curve<'_>| SWATCH + 6.0 + lettering::width(curve.name, SMALL);
    flow(curves.curves.iter().map(needs), 24.0, width)
}

/// Pixels above a panel for its legend.
pub(crate) fn room_above(curves: &Curves<'_>, width: f32) -> f32 {
    ABOVE + ROW * rows(&legend(curves, width)) as f32
}

/// A panel of curves over a stretch of the sweep.
pub(crate) struct Panel<'p, 'a> {
    pub curves: &'p Curves<'a>,
    pub view: &'p View<'a>,
    pub area: Area,
    y: Ruler,
}

impl<'p, 'a> Panel<'p, 'a> {
    /// Settles the scale over what is seen.
    pub fn new(curves: &'p Curves<'a>, view: &'p View<'a>, area: Area) -> Result<Self, PlotError> {
        let axis = match curves.upright {
            Upright::Values => Axis::new(&curves.label),
            Upright::Lines(lines) => Axis::new(&curves.label).over([0.0, f64::from(lines.max(1))]),
        };
        let [first, last] = view.window;
        let (first, last) = (first.floor() as usize, last.ceil() as usize);
        let seen = curves.curves.iter().flat_map(|curve| curve.values.iter().take(last + 1).skip(first));
        let y = axis.settle(seen.copied(), 0.08)?;
        Ok(Self { curves, view, area, y })
    }

    /// Line of a value.
    pub fn y(&self, value: f64) -> f32 {
        self.area.top + self.down(self.y.share(value)) * self.area.height
    }

    fn down(&self, share: f64) -> f32 {
        if matches!(self.curves.upright, Upright::Lines(_)) { share as f32 } else { 1.0 - share as f32 }
    }

    /// Level lines, to be drawn before the content.
    pub fn grid(&self, canvas: &mut Canvas) {
        let Area { left, width, .. } = self.area;
        for tick in self.y.round_ticks(self.area.height, 36.0) {
            let top = self.y(tick.value).floor();
            canvas.fill(Area { left, top, width, height: 1.0 }, canvas.palette().faint);
        }
    }

    /// Curves, the first on top.
    pub fn draw(&self, canvas: &mut Canvas) {
        canvas.clip(self.area);
        for (index, curve) in self.curves.curves.iter().enumerate().rev() {
            let [first, last] = self.view.window;
            let samples = first.floor() as usize..(last.ceil() as usize + 1).min(curve.values.len());
            let points: Vec<(f32, f32)> =
                samples.map(|k| (self.view.x(k as f64), self.y(curve.values[k]))).collect();
            for run in points.split(|(x, y)| !(x.is_finite() && y.is_finite())) {
                match thinned(run)[..] {
                    [(x, y)] => styled(canvas, &[(x - 1.5, y), (x + 1.5, y)], 3.0, index),
                    ref points => styled(canvas, points, 1.6, index),
                }
            }
        }
        canvas.unclip();
        self.scales(canvas);
        self.legend(canvas);
    }

    fn scales(&self, canvas: &mut Canvas) {
        let (area, palette) = (self.area, canvas.palette());
        canvas.border(area, palette.soft);
        for tick in self.y.round_ticks(area.height, 36.0) {
            let (y, left) = (self.y(tick.value), area.left - TICK);
            canvas.fill(Area { left, top: y.floor(), width: TICK, height: 1.0 }, palette.soft);
            canvas.text(&tick.label, (left - 4.0, y + 4.0), Anchor::Right, SMALL, palette.soft);
        }
        let (middle, label) = (area.top + area.height / 2.0, &self.curves.label);
        canvas.text_upwards(label, (area.left - 70.0, middle), fitting(label, area.height), palette.ink);
        self.volts(canvas);
    }

    /// The same heights as voltages, on the right.
    fn volts(&self, canvas: &mut Canvas) {
        let Some(volts) = self.curves.volts else { return };
        let (area, palette) = (self.area, canvas.palette());
        let ends = self.y.range.map(|value| volts.of(value));
        if !(ends.iter().all(|end| end.is_finite()) && ends[1] > ends[0]) {
            return;
        }
        let ruler = Ruler::linear(ends);
        for tick in ruler.round_ticks(area.height, 36.0) {
            let y = area.top + self.down(ruler.share(tick.value)) * area.height;
            canvas.fill(Area { left: area.right(), top: y.floor(), width: TICK, height: 1.0 }, palette.soft);
            let at = (area.right() + TICK + 4.0, y + 4.0);
            canvas.text(&tick.label, at, Anchor::Left, SMALL, palette.soft);
        }
        let at = (area.right() + TICK + 4.0, area.top - 8.0);
        canvas.text("V", at, Anchor::Left, SMALL, palette.ink);
    }

    fn legend(&self, canvas: &mut Canvas) {
        let (area, ink) = (self.area, canvas.palette().ink);
        let top = area.top - room_above(self.curves, area.width) + ABOVE;
        for (index, (row, left)) in legend(self.curves, area.width).into_iter().enumerate() {
            let (left, base) = (area.left + left, top + ROW * row as f32 + 11.0);
            styled(canvas, &[(left, base - 4.0), (left + SWATCH, base - 4.0)], 2.6, index);
            let name = self.curves.curves[index].name;
            canvas.text(name, (left + SWATCH + 6.0, base), Anchor::Left, SMALL, ink);
        }
    }
}

/// The size at which a text is not longer than `room`.
fn fitting(text: &str, room: f32) -> f32 {
    TEXT * (room / lettering::width(text, TEXT).max(1.0)).min(1.0)
}

/// Points that are seen: of those in one half of a pixel, the first, the lowest, the highest and the last.
fn thinned(points: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let half = |point: &(f32, f32)| (2.0 * point.0).floor();
    let groups = points.chunk_by(|a, b| half(a) == half(b));
    groups.flat_map(|group| if group.len() > 4 { extremes(group) } else { group.to_vec() }).collect()
}

fn extremes(group: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let by_line = |a: &usize, b: &usize| group[*a].1.total_cmp(&group[*b].1);
    let places = || 0..group.len();
    let ends = [0, group.len() - 1];
    let all = ends.into_iter().chain(places().min_by(by_line)).chain(places().max_by(by_line));
    let kept: std::collections::BTreeSet<usize> = all.collect();
    kept.into_iter().map(|index| group[index]).collect()
}

#[cfg(test)]
mod tests {
    use super::thinned;

    #[test]
    fn a_spike_of_one_sample_is_seen() {
        let mut points: Vec<(f32, f32)> = (0..1000).map(|k| (k as f32 / 100.0, 50.0)).collect();
        points[537].1 = 3.0;
        let kept = thinned(&points);
        assert!(kept.len() <= 80, "{}", kept.len());
        assert!(kept.contains(&(5.37, 3.0)));
        assert_eq!((kept[0], kept[kept.len() - 1]), (points[0], points[999]));
        assert!(kept.is_sorted_by(|a, b| a.0 <= b.0));
    }
}
