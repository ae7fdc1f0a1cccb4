//! Sampling points of every pixel of a screen: a pattern, and how it is turned from pixel to pixel.

use crate::pattern::{MOST_SAMPLES, OFFSET_UNIT, Pattern};

/// Points of the lattice in a pixel, along each axis. All points of a pattern lie on one lattice of 1/32 pixel.
pub(crate) const LATTICE: i32 = 32;

/// A pattern in each pixel, the same way round or turned.
#[derive(Debug, Clone)]
pub struct Sampling {
    pattern: Pattern,
    is_turned: bool,
    turns: [Offsets; 4],
    /// Distance of the lattice's first point from the pixel's corner (1/64 pixel): 0 or 1, alike on both axes.
    pub(crate) origin: i32,
    /// Least and greatest offset along either axis over all turns in use (lattice points).
    pub(crate) extent: [[i32; 2]; 2],
}

/// Offsets of the points of one pixel (lattice points), by axis; what is behind the last point is 0.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Offsets {
    pub x: [i32; MOST_SAMPLES],
    pub y: [i32; MOST_SAMPLES],
}

impl Sampling {
    /// The same pattern in every pixel.
    pub fn new(pattern: Pattern) -> Self {
        let offsets = pattern.offsets();
        let origin = i32::from(offsets[0][0] % 2);
        let mut first = Offsets::default();
        for (i, [x, y]) in offsets.iter().map(|offset| offset.map(i32::from)).enumerate() {
            (first.x[i], first.y[i]) = (x / 2, y / 2);
        }
        let count = offsets.len();
        let extent = [&first.x, &first.y].map(|along| {
            let along = along[..count].iter().copied();
            along.fold([LATTICE, 0], |[low, high], at| [low.min(at), high.max(at)])
        });
        Self { pattern, is_turned: false, turns: [first; 4], origin, extent }
    }

    /// The pattern turned by 0 to 3 quarter turns about the pixel's middle, by a hash of the pixel. `None` for
    /// [`Pattern::OffCentre16`]: it has points on the border of its pixel, which a turn moves to another pixel.
    pub fn turned(pattern: Pattern) -> Option<Self> {
        let mut sampling = Self::new(pattern);
        let [[left, right], [top, bottom]] = sampling.extent;
        let last = LATTICE - sampling.origin;
        let least = left.min(top).min(last - right).min(last - bottom);
        if least + sampling.origin == 0 {
            return None;
        }
        for turn in 1..4 {
            let Offsets { x, y } = sampling.turns[turn - 1];
            sampling.turns[turn] = Offsets { x: y.map(|y| last - y), y: x };
        }
        sampling.is_turned = true;
        sampling.extent = [[least, last - least]; 2];
        Some(sampling)
    }

    /// The pattern that is used.
    pub fn pattern(&self) -> Pattern {
        self.pattern
    }

    /// Number of sampling points of a pixel, 1 to 32.
    pub fn count(&self) -> usize {
        self.pattern.offsets().len()
    }

    /// Whether the pattern is turned from pixel to pixel.
    pub fn is_turned(&self) -> bool {
        self.is_turned
    }

    /// Places (pixels on the screen, exact) of the sampling points of a pixel, on the screen or beside it, in the order of the
    /// pattern.
    pub fn places(&self, [column, row]: [i32; 2]) -> impl Iterator<Item = [f64; 2]> {
        let Offsets { x, y } = &self.turns[self.turn([column, row])];
        let place = |pixel: i32, offset: i32| {
            f64::from(pixel) + f64::from(2 * offset + self.origin) / f64::from(OFFSET_UNIT)
        };
        (0..self.count()).map(move |i| [place(column, x[i]), place(row, y[i])])
    }

    /// Diameter (pixels) of the widest disc that can miss all sampling points.
    ///
    /// Turned pixels do not repeat. Every quadrant of a pixel holds a point whatever the turn, and a disc wider than a
    /// quadrant's two diagonals covers the quadrant in which its middle lies.
    pub fn widest_miss(&self) -> f64 {
        if self.is_turned { std::f64::consts::SQRT_2 } else { self.pattern.widest_miss() }
    }

    /// Which of its quarter turns a pixel has, 0 to 3.
    pub(crate) fn turn(&self, pixel: [i32; 2]) -> usize {
        if self.is_turned { quarter_turns(pixel) } else { 0 }
    }

    /// Offsets by quarter turn; all alike unless the pattern is turned.
    pub(crate) fn turns(&self) -> &[Offsets; 4] {
        &self.turns
    }
}

/// Quarter turns of a pixel, 0 to 3: the highest bits of a multiplicative hash. Chosen: any hash whose turns do not repeat
/// visibly would do.
fn quarter_turns(pixel: [i32; 2]) -> usize {
    let [column, row] = pixel.map(|at| at as u32);
    let mixed = column.wrapping_mul(0x9e37_79b1) ^ row.wrapping_mul(0x85eb_ca77);
    ((mixed ^ mixed >> 15).wrapping_mul(0x2c1b_3c6d) >> 30) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_those_of_the_pattern() {
        for pattern in Pattern::ALL {
            let places: Vec<_> = Sampling::new(pattern).places([3, 5]).collect();
            let stated = pattern
                .offsets()
                .iter()
                .map(|&[x, y]| [3.0 + f64::from(x) / 64.0, 5.0 + f64::from(y) / 64.0]);
            assert_eq!(places, stated.collect::<Vec<_>>(), "{}", pattern.name());
        }
    }

    #[test]
    fn a_turned_pixel_has_the_pattern_turned_about_its_middle() {
        for pattern in Pattern::ALL.into_iter().filter(|&pattern| pattern != Pattern::OffCentre16) {
            let sampling = Sampling::turned(pattern).unwrap();
            let (mut by_turn, straight) = ([0; 4], Sampling::new(pattern));
            for pixel in (0..64 * 64).map(|i| [i % 64, i / 64]) {
                let turn = sampling.turn(pixel);
                by_turn[turn] += 1;
                for (turned, [x, y]) in sampling.places(pixel).zip(straight.places(pixel)) {
                    let middle = pixel.map(|at| f64::from(at) + 0.5);
                    let from_middle = [x - middle[0], y - middle[1]];
                    let expected = (0..turn).fold(from_middle, |[x, y], _| [-y, x]);
                    assert_eq!([turned[0] - middle[0], turned[1] - middle[1]], expected);
                }
            }
            assert!(by_turn.iter().all(|times| (900..1150).contains(times)), "{by_turn:?}");
        }
        assert!(Sampling::turned(Pattern::OffCentre16).is_none());
    }

    #[test]
    fn every_quadrant_holds_a_point_whatever_the_turn() {
        for pattern in [Pattern::Four, Pattern::Eight, Pattern::Sixteen, Pattern::Grid16, Pattern::Lattice32]
        {
            let sampling = Sampling::turned(pattern).unwrap();
            for pixel in [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 1], [6, 2], [7, 3]] {
                let mut quadrants = [false; 4];
                for [x, y] in sampling.places(pixel) {
                    let halves =
                        [x - f64::from(pixel[0]), y - f64::from(pixel[1])].map(|at| usize::from(at > 0.5));
                    quadrants[2 * halves[1] + halves[0]] = true;
                }
                assert_eq!(quadrants, [true; 4], "{}", pattern.name());
            }
        }
    }
}
