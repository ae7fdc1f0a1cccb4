//! The scan converter of a picture whose lines are those that were written.

use std::array;

use fearless_simd::prelude::{SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch, f32x8};
use signal::{LANES, Number, turn_square};

use crate::View;
use crate::read_out::centre;
use crate::tiles::{Sweeps, TILE, Tile};

/// From here on the floats are the whole numbers: a smaller one added to it is rounded to a whole number, which then
/// stands in its lowest bits.
const WHOLE: f64 = 4_503_599_627_370_496.0;

/// The whole number below a place from 0 on, and the same as a number of a cell.
#[inline(always)]
pub(crate) fn floor(place: f64) -> (f64, u32) {
    let nearest = (place + WHOLE) - WHOLE;
    let below = if nearest > place { nearest - 1.0 } else { nearest };
    (below, (below + WHOLE).to_bits() as u32)
}

/// What is read, and into how many columns.
pub(crate) struct Upright<'a> {
    pub sweeps: Sweeps<'a>,
    pub lines: usize,
    pub view: &'a View,
    pub columns: usize,
}

/// Where the pixels of a tile lie in a line: between a sweep and the one to its right, and the share of that.
struct Places {
    left: [u32; TILE],
    share: [f32; TILE],
}

impl Upright<'_> {
    /// Reads a tile of the picture.
    pub fn read(&self, tile: &mut Tile<'_>) {
        dispatch!(Level::new(), simd => self.read_by(simd, tile));
    }

    #[inline(always)]
    fn read_by<V: Simd>(&self, simd: V, tile: &mut Tile<'_>) {
        let (tangent_over_x, field) = (self.view.tangent_over_x(), self.view.field);
        let mut places = [const { Places { left: [0; TILE], share: [0.0; TILE] } }; LANES];
        // Twice the columns from the middle of the picture.
        let first = tile.columns.start;
        let offsets = array::from_fn(|n| (2 * (first + n) + 1) as f64 - self.columns as f64);
        for (eight, rows) in tile.rows.chunks_mut(LANES).enumerate() {
            let first = LANES * eight;
            for (line, places) in (first..first + rows.len()).zip(&mut places) {
                let y = field.tan_half_height * centre(line, self.lines);
                let scale = field.tan_half_width * tangent_over_x(y) / self.columns as f64;
                self.aim(&offsets, scale, places);
            }
            self.read_lines(simd, first, &places, rows);
        }
    }

    /// The places of columns at `offsets`; `scale` is the tangent of half a column.
    #[inline(always)]
    fn aim(&self, offsets: &[f64; TILE], scale: f64, places: &mut Places) {
        let last = f64::from(self.view.fan.sweeps - 1);
        for (n, offset) in offsets.iter().enumerate() {
            let position = self.view.fan.position(offset * scale).at_least(0.0);
            let position = if position < last { position } else { last };
            let (left, number) = floor(position);
            (places.left[n], places.share[n]) = (number, (position - left) as f32);
        }
    }

    /// Reads up to eight lines: squares of eight columns by eight lines between the same sweeps, which are nearly all, and the
    /// others pixel by pixel.
    #[inline(always)]
    fn read_lines<V: Simd>(&self, simd: V, first: usize, places: &[Places; LANES], rows: &mut [&mut [f32]]) {
        let width = rows[0].len();
        for n in (0..width).step_by(LANES) {
            let eight = n..width.min(n + LANES);
            let is_square = rows.len() == LANES && eight.len() == LANES && are_between_the_same(places, n);
            if is_square {
                self.read_square(simd, first, places, n, |line, values| {
                    values.store_slice(&mut rows[line][eight.clone()]);
                });
            } else {
                for ((line, places), row) in (first..).zip(places).zip(&mut *rows) {
                    self.read_pixels(line, places, n, &mut row[eight.clone()]);
                }
            }
        }
    }

    /// Eight lines from `first` on of the eight columns from `n` of the tile on, line by line.
    #[inline(always)]
    fn read_square<V: Simd>(
        &self,
        simd: V,
        first: usize,
        places: &[Places; LANES],
        n: usize,
        mut put: impl FnMut(usize, f32x8<V>),
    ) {
        let last = self.view.fan.sweeps - 1;
        let mut sides = [[f32x8::simd_from(simd, 0.0); LANES]; 2];
        for k in 0..LANES {
            let left = places[0].left[n + k];
            for (side, sweep) in sides.iter_mut().zip([left, last.min(left + 1)]) {
                side[k] = f32x8::from_slice(simd, &self.sweeps.cells(sweep as usize)[first..][..LANES]);
            }
        }
        sides.iter_mut().for_each(turn_square);
        for (line, places) in places.iter().enumerate() {
            let [left, right] = [sides[0][line], sides[1][line]];
            let share = f32x8::from_slice(simd, &places.share[n..n + LANES]);
            put(line, left + share * (right - left));
        }
    }

    /// Pixels of a line from column `from` of the tile on.
    #[inline(always)]
    fn read_pixels(&self, line: usize, places: &Places, from: usize, pixels: &mut [f32]) {
        let last = self.view.fan.sweeps - 1;
        let places = places.left[from..].iter().zip(&places.share[from..]);
        for (pixel, (&left, &share)) in pixels.iter_mut().zip(places) {
            let cell = |sweep: u32| self.sweeps.cells(sweep as usize)[line];
            let (left, right) = (cell(left), cell(last.min(left + 1)));
            *pixel = left + share * (right - left);
        }
    }
}

/// Whether the eight columns from `n` of a tile on have the same sweep to their left in every line.
#[inline(always)]
fn are_between_the_same(places: &[Places; LANES], n: usize) -> bool {
    let mut differing = 0;
    for line in &places[1..] {
        for k in n..n + LANES {
            differing |= line.left[k] ^ places[0].left[k];
        }
    }
    differing == 0
}

#[cfg(test)]
mod tests {
    use super::centre;
    use crate::{Memory, View};
    use proptest::prelude::{prop_assert_eq, proptest};
    use scenario::{FieldOfView, Projection};
    use sweep_program::Fan;

    /// A pixel of the scan converter by itself.
    fn pixel(store: &[f32], lines: usize, columns: usize, view: &View, [column, line]: [usize; 2]) -> f32 {
        let last = view.fan.sweeps as usize - 1;
        let y = view.field.tan_half_height * centre(line, lines);
        let scale = view.field.tan_half_width * view.tangent_over_x()(y) / columns as f64;
        let offset = (2 * column + 1) as f64 - columns as f64;
        let position = view.fan.position(offset * scale).clamp(0.0, last as f64);
        let left = position as usize;
        let share = (position - left as f64) as f32;
        let cell = |sweep: usize| store[sweep * lines + line];
        cell(left) + share * (cell(last.min(left + 1)) - cell(left))
    }

    proptest! {
        /// Pictures that are wider and narrower than their sweeps, level and pitched, whole bands and parts of them.
        #[test]
        fn tiles_read_what_each_pixel_reads(
            sweeps in 1..150usize, lines in 1..40usize, columns in 1..150usize, pitch in -0.5..0.5f64, level: bool,
        ) {
            let field = FieldOfView { tan_half_width: 0.47, tan_half_height: 0.27 };
            let pitch = if level { 0.0 } else { pitch };
            let fan = Fan::covering(Projection::Exact, pitch, &field, sweeps as u32).unwrap();
            let view = View { fan, projection: Projection::Exact, pitch, raster: field, field, yoke: 0.0 };
            let store: Vec<f32> = (0..sweeps * lines).map(|cell| libm::sinf(cell as f32)).collect();
            let places = || (0..lines).flat_map(|line| (0..columns).map(move |column| [column, line]));
            let mut picture = vec![0.0; columns * lines];
            Memory::ScanConverter.read(&store, lines, columns, &view, &mut picture);
            for (found, place) in picture.iter().zip(places()) {
                let alone = pixel(&store, lines, columns, &view, place);
                prop_assert_eq!(found.to_bits(), alone.to_bits(), "{:?}", place);
            }
            let mut picture = vec![0.0; sweeps * lines];
            Memory::Digital.read(&store, lines, sweeps, &view, &mut picture);
            for (cell, value) in store.iter().enumerate() {
                prop_assert_eq!(picture[cell % lines * sweeps + cell / lines], *value);
            }
        }
    }
}
