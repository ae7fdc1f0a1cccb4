//! The scan converter of a picture that the yoke turns, or that is a part of what was written.

use std::array;

use fearless_simd::{Level, Simd, SimdBase, dispatch, f32x4};
use scenario::FieldOfView;

use crate::View;
use crate::read_out::{cell_of, centre};
use crate::tiles::{Sweeps, TILE, Tile};
use crate::upright::floor;

/// How far beyond half a cell a place may lie by rounding and still be on the raster.
const ROUNDING: f64 = 1e-6;

/// What is read, and into a picture of how many pixels.
pub(crate) struct Turned<'a> {
    pub sweeps: Sweeps<'a>,
    pub lines: usize,
    pub view: &'a View,
    pub columns: usize,
    pub height: usize,
}

/// Where the pixels of a tile lie in a line of the picture.
struct Places {
    /// On the raster; the others are dark.
    lit: [bool; TILE],
    /// The sweep to the left, and the share of the one to its right.
    left: [u32; TILE],
    share: [f32; TILE],
    /// Cells under the beam: from part `before` of the first on, up to part `within` of the last.
    first: [u32; TILE],
    last: [u32; TILE],
    before: [f32; TILE],
    within: [f32; TILE],
}

impl Turned<'_> {
    /// Reads a tile of the picture.
    ///
    /// What a beam as high as a line sees at a place: the mean of the cells under it along each of the four sweeps
    /// around it, and across them the cubic of Catmull and Rom, kept between the two nearest so that no edge rings (a
    /// linear spot would blur all that lies between sweeps, which turned is everything). A place beyond the outermost
    /// by more than half a sweep or half a cell is dark.
    pub fn read(&self, tile: &mut Tile<'_>) {
        let vectors = Level::new();
        let place = self.place();
        let (number, part) = ([0; TILE], [0.0; TILE]);
        let mut places = Places {
            lit: [false; TILE],
            left: number,
            share: part,
            first: number,
            last: number,
            before: part,
            within: part,
        };
        let column = tile.columns.start;
        let across = array::from_fn(|n| self.view.field.tan_half_width * centre(column + n, self.columns));
        for (line, row) in tile.rows.iter_mut().enumerate() {
            let y = self.view.field.tan_half_height * centre(line, self.height);
            dispatch!(vectors, simd => {
                self.aim(&across, y, &place, &mut places);
                self.read_line(simd, &places, row);
            });
        }
    }

    fn last_sweep(&self) -> usize {
        self.view.fan.sweeps as usize - 1
    }

    /// Where a place (X, Y) of the screen lies in the store: sweep n is at n, cell n reaches from n to n + 1.
    fn place(&self) -> impl Fn(f64, f64) -> [f64; 2] {
        let (upright, tangent_over_x) = (self.view.upright(), self.view.tangent_over_x());
        move |x, y| {
            let [x, y] = upright(x, y);
            let sweep = self.view.fan.position(x * tangent_over_x(y));
            [sweep, cell_of(y, self.view.raster.tan_half_height, self.lines) + 0.5]
        }
    }

    /// Aims at pixels at tangents `across` in a line at `y`.
    #[inline(always)]
    fn aim(&self, across: &[f64; TILE], y: f64, place: impl Fn(f64, f64) -> [f64; 2], places: &mut Places) {
        let (bottom, last_cell) = (self.lines as f64, (self.lines - 1) as f64);
        let last_sweep = self.last_sweep() as f64;
        let FieldOfView { tan_half_height, .. } = self.view.raster;
        let half_beam =
            0.5 * (bottom / tan_half_height * self.view.field.tan_half_height / self.height as f64);
        for (n, x) in across.iter().enumerate() {
            let [sweep, middle] = place(*x, y);
            places.lit[n] = (sweep >= -0.5 - ROUNDING)
                & (sweep <= last_sweep + 0.5 + ROUNDING)
                & (middle >= -ROUNDING)
                & (middle <= bottom + ROUNDING);
            let sweep = within(sweep, last_sweep);
            let (left, number) = floor(sweep);
            (places.left[n], places.share[n]) = (number, (sweep - left) as f32);
            let cell_at = |edge: f64| {
                let edge = within(edge, bottom);
                let (cell, number) = floor(within(edge, last_cell));
                (number, (edge - cell) as f32)
            };
            (places.first[n], places.before[n]) = cell_at(middle - half_beam);
            (places.last[n], places.within[n]) = cell_at(middle + half_beam);
        }
    }

    #[inline(always)]
    fn read_line<V: Simd>(&self, simd: V, places: &Places, pixels: &mut [f32]) {
        let last = self.last_sweep();
        let mut sums = [[0.0; 4]; TILE];
        for (n, sums) in sums.iter_mut().enumerate().take(pixels.len()) {
            let left = places.left[n] as usize;
            let (first, count) = (places.first[n] as usize, (places.last[n] - places.first[n]) as usize + 1);
            let cells = |sweep: usize| &self.sweeps.cells(sweep)[first..][..count];
            // At an end the outermost stands in for what is not there.
            let [before, after] = [left.saturating_sub(1), last.min(left + 2)];
            let cells = [cells(before), cells(left), cells(last.min(left + 1)), cells(after)];
            *sums = under_beam(simd, cells, places.before[n], places.within[n]);
        }
        let mut seen = [0.0; TILE];
        for (n, seen) in seen.iter_mut().enumerate() {
            let whole = (places.last[n] - places.first[n]) as i32 as f32;
            let height = whole - places.before[n] + places.within[n];
            let joined = join(sums[n].map(|sum| sum / height), places.share[n]);
            *seen = if places.lit[n] { joined } else { 0.0 };
        }
        pixels.copy_from_slice(&seen[..pixels.len()]);
    }
}

/// A place kept from 0 to `last`; one that is not a number is at `last`.
#[inline(always)]
fn within(place: f64, last: f64) -> f64 {
    let place = if place < 0.0 { 0.0 } else { place };
    if place < last { place } else { last }
}

/// Sums of the values of four sweeps under the beam, of which `cells` are those that it touches.
#[inline(always)]
fn under_beam<V: Simd>(simd: V, cells: [&[f32]; 4], before: f32, within: f32) -> [f32; 4] {
    let last = cells[0].len() - 1;
    let cell = |n: usize| f32x4::load_array(simd, cells.map(|cells| cells[n]));
    let fours = cells.map(|cells| cells[..last].as_chunks().0);
    let mut sum = f32x4::splat(simd, -0.0);
    for n in 0..last / 4 {
        for cell in transposed(fours.map(|fours| f32x4::load_array(simd, fours[n]))) {
            sum += cell;
        }
    }
    for n in last / 4 * 4..last {
        sum += cell(n);
    }
    let [before, within] = [before, within].map(|part| f32x4::splat(simd, part));
    (sum - before * cell(0) + within * cell(last)).to_array()
}

#[inline(always)]
fn transposed<V: Simd>([a, b, c, d]: [f32x4<V>; 4]) -> [f32x4<V>; 4] {
    let [even, odd] = [a.interleave(c), b.interleave(d)];
    let [[p, q], [r, s]] = [even.0.interleave(odd.0), even.1.interleave(odd.1)].map(<[_; 2]>::from);
    [p, q, r, s]
}

/// The cubic through the means of four sweeps, kept between the middle two; `u` is the share of the way between them.
#[inline(always)]
fn join([a, b, c, d]: [f32; 4], u: f32) -> f32 {
    let (u2, u3) = (u * u, u * u * u);
    let cubic = 0.5 * (2.0 * u2 - u - u3) * a
        + 0.5 * (2.0 - 5.0 * u2 + 3.0 * u3) * b
        + (0.5 * (u + 4.0 * u2 - 3.0 * u3) * c + 0.5 * (u3 - u2) * d);
    let [least, most] = if b < c { [b, c] } else { [c, b] };
    let cubic = if cubic < least { least } else { cubic };
    if cubic > most { most } else { cubic }
}

#[cfg(test)]
mod tests {
    use super::{ROUNDING, cell_of, centre};
    use crate::{Memory, View};
    use proptest::prelude::{prop_assert_eq, proptest};
    use scenario::{FieldOfView, Projection};
    use sweep_program::Fan;

    /// A store by itself: `lines` values a sweep.
    struct Store<'a> {
        values: &'a [f32],
        lines: usize,
    }

    impl Store<'_> {
        /// What a beam of `height` cells sees at a place.
        fn spot(&self, sweep: f64, line: f64, height: f64) -> f32 {
            let (sweeps, end) = (self.values.len() / self.lines, self.lines as f64);
            let (last, middle) = ((sweeps - 1) as f64, line + 0.5);
            let on_sweeps = (-0.5 - ROUNDING..=last + 0.5 + ROUNDING).contains(&sweep);
            if !on_sweeps || !(-ROUNDING..=end + ROUNDING).contains(&middle) {
                return 0.0;
            }
            let left = sweep.clamp(0.0, last) as usize;
            let u = (sweep.clamp(0.0, last) - left as f64) as f32;
            let (u2, u3) = (u * u, u * u * u);
            let shares = [2.0 * u2 - u - u3, 2.0 - 5.0 * u2 + 3.0 * u3, u + 4.0 * u2 - 3.0 * u3, u3 - u2];
            let around =
                [left.saturating_sub(1), left, left + 1, left + 2].map(|sweep| sweep.min(sweeps - 1));
            let edges = [middle - 0.5 * height, middle + 0.5 * height].map(|edge| edge.clamp(0.0, end));
            let means = around.map(|sweep| self.mean(sweep, edges));
            let [a, b, c, d] = [0, 1, 2, 3].map(|n| 0.5 * shares[n] * means[n]);
            (a + b + (c + d)).clamp(means[1].min(means[2]), means[1].max(means[2]))
        }

        /// Mean of the values of a sweep between two places.
        fn mean(&self, sweep: usize, edges: [f64; 2]) -> f32 {
            let values = &self.values[sweep * self.lines..][..self.lines];
            let [first, last] = edges.map(|edge| (edge as usize).min(self.lines - 1));
            let (before, within) = ((edges[0] - first as f64) as f32, (edges[1] - last as f64) as f32);
            let whole: f32 = values[first..last].iter().sum();
            let sum = whole - before * values[first] + within * values[last];
            sum / ((last - first) as f32 - before + within)
        }
    }

    proptest! {
        /// Pictures that are level, rolled and pitched, whole tiles and parts of them, in and beyond the raster, under
        /// beams of a part of a cell up to some ten.
        #[test]
        fn tiles_read_what_each_pixel_reads(
            sweeps in 1..150usize, lines in 1..300usize, [columns, height] in [1..150usize, 1..40usize],
            pitch in -0.5..0.5f64, roll in -0.5..0.5f64, level: bool, upright: bool, part in 0.8..2.0f64,
        ) {
            let [pitch, yoke] = [(level, pitch), (upright, roll)].map(|(none, angle)| if none { 0.0 } else { angle });
            let field = FieldOfView { tan_half_width: 0.47, tan_half_height: 0.27 };
            let raster = FieldOfView { tan_half_width: 0.47 * part, tan_half_height: 0.27 * part };
            let fan = Fan::covering(Projection::Exact, pitch, &raster, sweeps as u32).unwrap();
            let view = View { fan, projection: Projection::Exact, pitch, raster, field, yoke };
            let store: Vec<f32> = (0..sweeps * lines).map(|cell| libm::sinf(cell as f32)).collect();
            let mut picture = vec![0.0; columns * height];
            Memory::ScanConverter.read(&store, lines, columns, &view, &mut picture);
            let (sin, cos) = quantities::sin_cos(yoke);
            let beam = lines as f64 / raster.tan_half_height * field.tan_half_height / height as f64;
            for (index, found) in picture.iter().enumerate() {
                let x = field.tan_half_width * centre(index % columns, columns);
                let y = field.tan_half_height * centre(index / columns, height);
                let (x, y) = (cos * x - sin * y, sin * x + cos * y);
                let sweep = fan.position(x * view.tangent_over_x()(y));
                let cell = cell_of(y, raster.tan_half_height, lines);
                let alone = Store { values: &store, lines }.spot(sweep, cell, beam);
                prop_assert_eq!(found.to_bits(), alone.to_bits(), "pixel {}: {} and {}", index, found, alone);
            }
        }
    }
}
