//! The column of the picture that the sweep leaves, with its lines.

use crate::axis::Ruler;
use crate::canvas::{Anchor, Area, Canvas};
use crate::frame::{SMALL, TEXT};

use super::clock::between;
use super::page::PictureColumn;

/// Width of the strip.
pub(crate) const STRIP: f32 = 30.0;
/// Room on its right for its lines.
pub(crate) const LINES: f32 = 66.0;
const TICK: f32 = 5.0;

/// The strip in its area.
pub(crate) struct Strip<'p, 'a> {
    pub column: &'p PictureColumn<'a>,
    pub area: Area,
}

impl Strip<'_, '_> {
    /// Grey from the top, with the line axis on its right.
    pub fn draw(&self, canvas: &mut Canvas) {
        let (area, palette) = (self.area, canvas.palette());
        canvas.image(area, |_, line| [self.grey(line); 3]);
        let frame = Area {
            left: area.left - 1.0,
            top: area.top - 1.0,
            width: area.width + 2.0,
            height: area.height + 2.0,
        };
        canvas.border(frame, palette.soft);
        let lines = Ruler::linear([0.0, self.column.grey.len().max(1) as f64]);
        for tick in lines.round_ticks(area.height, 36.0) {
            let y = self.y(tick.value);
            canvas.fill(Area { left: frame.right(), top: y.floor(), width: TICK, height: 1.0 }, palette.soft);
            let at = (frame.right() + TICK + 4.0, y + 4.0);
            canvas.text(&tick.label, at, Anchor::Left, SMALL, palette.soft);
        }
        let at = (area.right() + LINES - 4.0, area.top + area.height / 2.0);
        canvas.text_upwards("line of the picture", at, TEXT, palette.ink);
    }

    /// The mean of the lines that a line of pixels covers, in codes of a display.
    fn grey(&self, pixel: u32) -> u8 {
        let lines = self.column.grey.len() as f64;
        let edge = |pixel: u32| f64::from(pixel) / f64::from(self.area.height) * lines;
        let (from, to) = (edge(pixel), edge(pixel + 1));
        let part = |line: usize| {
            let share = (to.min(line as f64 + 1.0) - from.max(line as f64)).max(0.0);
            share * self.column.grey.get(line).copied().filter(|grey| grey.is_finite()).unwrap_or(0.0)
        };
        let sum: f64 = (from as usize..=to as usize).map(part).fold(0.0, |sum, part| sum + part);
        (sum / (to - from) * 255.0 + 0.5).clamp(0.0, 255.0) as u8
    }

    /// Line of pixels of a line of the picture.
    fn y(&self, line: f64) -> f32 {
        self.area.top + (line / self.column.grey.len().max(1) as f64) as f32 * self.area.height
    }

    /// Arrows at the lines to which the machine writes at `instants`, where they are in the picture.
    pub fn point(&self, canvas: &mut Canvas, instants: &[f64]) {
        for at in self.pointed(instants).into_iter().flatten() {
            let (x, colour) = (self.area.left - 2.0, canvas.palette().cursor);
            canvas.polygon(&[(x, at), (x - 8.0, at - 5.0), (x - 8.0, at + 5.0)], colour);
        }
    }

    /// Lines of pixels to which the machine writes at `instants`.
    pub fn pointed(&self, instants: &[f64]) -> Vec<Option<f32>> {
        let lines = self.column.grey.len() as f64;
        let place = |&instant: &f64| {
            let line = between(self.column.line?, instant);
            (0.0..=lines).contains(&line).then(|| self.y(line))
        };
        instants.iter().map(place).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Strip;
    use crate::mark::Area;
    use crate::scope::PictureColumn;

    #[test]
    fn lines_keep_their_light() {
        let area = Area { left: 0.0, top: 0.0, width: 30.0, height: 3.0 };
        let grey = [1.0, 0.0, 1.0, 0.0, 1.0, 0.0];
        let strip = Strip { column: &PictureColumn { grey: &grey, line: None }, area };
        assert_eq!([0, 1, 2].map(|pixel| strip.grey(pixel)), [128; 3]);
        let strip = Strip { column: &PictureColumn { grey: &[0.0, 1.0], line: None }, area };
        assert_eq!([0, 2].map(|pixel| strip.grey(pixel)), [0, 255]);
        assert!((127..=128).contains(&strip.grey(1)));
        let none = Strip { column: &PictureColumn { grey: &[], line: Some(&[]) }, area };
        assert_eq!((none.grey(1), none.pointed(&[0.0])), (0, vec![None]));
    }
}
