//! Where the sweep passes from region to region, in the colours that are loaded there.

use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::mix;

use super::clock::View;
use super::page::{Crossing, RegisterColour};

/// Height of the row of caps above the first panel.
pub(crate) const CAPS: f32 = 22.0;
/// Upright lines are not closer than this.
const APART: f32 = 8.0;
/// Letters need this room.
const LETTERED: f32 = 19.0;
/// Size of the letters.
const LETTER: f32 = 10.5;

/// Crossings that are seen, thinned so that the page is not a wall of lines.
pub(crate) struct Verticals {
    kept: Vec<(f32, [RegisterColour; 2])>,
    /// Stretches in which some were left out.
    crowded: Vec<[f32; 2]>,
    /// All that are seen, drawn or not.
    pub count: usize,
}

impl Verticals {
    /// Those of a stretch of the sweep.
    pub fn new(crossings: &[Crossing], view: &View<'_>) -> Self {
        let seen = crossings.iter().filter(|crossing| view.shows(crossing.at));
        let mut all: Vec<(f32, [RegisterColour; 2])> = seen
            .map(|crossing| (view.x(crossing.at), crossing.loads))
            .filter(|(x, _)| x.is_finite())
            .collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut kept, mut crowded): (Vec<(f32, _)>, Vec<[f32; 2]>) = (Vec::new(), Vec::new());
        for &(x, loads) in &all {
            match kept.last() {
                Some(&(last, _)) if x - last < APART => match crowded.last_mut() {
                    Some(stretch) if last <= stretch[1] + APART => stretch[1] = x,
                    _ => crowded.push([last, x]),
                },
                _ => kept.push((x, loads)),
            }
        }
        Self { kept, crowded, count: all.len() }
    }

    /// How many are drawn.
    pub fn drawn(&self) -> usize {
        self.kept.len()
    }

    /// The colours of those that are seen.
    pub fn colours(&self) -> Vec<RegisterColour> {
        let loads = |colour: &RegisterColour| self.kept.iter().any(|(_, loads)| loads.contains(colour));
        RegisterColour::ALL.into_iter().filter(loads).collect()
    }

    /// Upright lines through `area`, to be drawn before the content.
    pub fn draw(&self, canvas: &mut Canvas, area: Area) {
        let palette = canvas.palette();
        for (x, loads) in &self.kept {
            let [under, over] = loads.map(|colour| mix(palette.paper, colour.of(palette), 0.6));
            let (x, bottom) = (x.floor() + 0.5, area.bottom());
            canvas.line(&[(x, area.top), (x, bottom)], 1.4, under);
            canvas.dashed(&[(x, area.top), (x, bottom)], 1.4, [7.0, 7.0], over);
        }
    }

    /// Caps with both colours and their letters in a row that ends at `bottom`; where lines were left out, a band.
    pub fn caps(&self, canvas: &mut Canvas, bottom: f32) {
        let palette = canvas.palette();
        for &[from, to] in &self.crowded {
            let band = Area { left: from, top: bottom - 3.0, width: to - from, height: 3.0 };
            canvas.fill(band, palette.soft);
        }
        for (index, &(x, loads)) in self.kept.iter().enumerate() {
            let before = index.checked_sub(1).map_or(f32::INFINITY, |before| x - self.kept[before].0);
            let after = self.kept.get(index + 1).map_or(f32::INFINITY, |after| after.0 - x);
            let wide = before.min(after);
            let side = (wide / 2.0 - 1.0).clamp(2.0, 6.0).floor();
            for (column, colour) in loads.iter().enumerate() {
                let left = x.floor() - side + side * column as f32;
                let cap = Area { left, top: bottom - 8.0, width: side, height: 6.0 };
                canvas.fill(cap, colour.of(palette));
            }
            if wide >= LETTERED {
                let text = loads.map(RegisterColour::letter).concat();
                canvas.text(&text, (x, bottom - 11.0), Anchor::Middle, LETTER, palette.soft);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{APART, Verticals};
    use crate::mark::Area;
    use crate::scope::{Along, Clock, Crossing, Line, RegisterColour, clock::View};

    #[test]
    fn a_thousand_crossings_are_thinned() {
        let ranges: Vec<f64> = (0..=1000).map(f64::from).collect();
        let area = Area { left: 0.0, top: 0.0, width: 500.0, height: 100.0 };
        let view = View::new(
            Clock { ranges: &ranges, period: 1.0, line: Line::Sweep },
            Along::Range,
            [None; 2],
            area,
        )
        .unwrap();
        let loads = [RegisterColour::Yellow, RegisterColour::Black];
        let crossing = |index: u32| Crossing { at: f64::from(index), loads };
        let crossings: Vec<Crossing> = (0..=1000).rev().map(crossing).collect();
        let verticals = Verticals::new(&crossings, &view);
        // Half a pixel apart: one in sixteen is drawn.
        assert_eq!((verticals.count, verticals.drawn()), (1001, 63));
        assert!(verticals.kept.windows(2).all(|pair| pair[1].0 - pair[0].0 >= APART));
        assert_eq!(verticals.crowded, [[0.0, 500.0]]);
        assert_eq!(verticals.colours(), loads);
        let few = Verticals::new(&crossings[..3], &view);
        assert_eq!((few.count, few.drawn()), (3, 1));
        assert_eq!(Verticals::new(&[], &view).drawn(), 0);
    }
}
