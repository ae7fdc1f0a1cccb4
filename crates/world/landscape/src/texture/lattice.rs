//! Patterns on a lattice: stored over one region, or hashed over the whole ground. Places are from lattice point (0, 0).

use std::ops::{Add, Mul, Sub};

use fearless_simd::prelude::{Bytes, ExtractToken, SimdBase, SimdFrom, SimdInt};
use fearless_simd::{Simd, f32x16, f64x8, i32x16, u32x16};
use quantities::hash_words;
use signal::{Both, Double, LANES, Real};

/// 1.5 * 2^52: added to a number of less than 2^51 it leaves the nearest whole number in the low bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// `place` (in cells) rounded to the lattice line before it, plus [`ROUND`]. On a line itself that may be the line before
/// and the way from it 1: the same value. Additions only, since rounding to whole numbers is a call on plain processors.
#[inline(always)]
fn rounded(place: f64) -> f64 {
    (place - 0.5) + ROUND
}

/// Number of the lattice line: its low 32 bits.
#[inline(always)]
fn line(rounded: f64) -> u32 {
    rounded.to_bits() as u32
}

/// Way from the lattice line, 0..=1.
#[inline(always)]
fn way(place: f64) -> f64 {
    place - (rounded(place) - ROUND)
}

/// Smooth-step in both directions between four corners, `[west, east]` of the south, then of the north; for one lane or
/// for all.
#[inline(always)]
fn join<T>([south, north]: [[T; 2]; 2], ways: [T; 2], three: T) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    let [u, v] = ways;
    let [u, v] = [u * u * (three - (u + u)), v * v * (three - (v + v))];
    let south = south[0] + v * (south[1] - south[0]);
    let north = north[0] + v * (north[1] - north[0]);
    south + u * (north - south)
}

/// A value of -1..1 in steps of 2^-23 from 24 random bits: exact in f32.
#[inline(always)]
fn value(bits: u32) -> f32 {
    ((bits >> 8) as i32 - (1 << 23)) as f32 * (1.0 / 8_388_608.0)
}

/// Variant 2: lattice values from a hash of their place, over the whole ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Hashed {
    inverse_cell: f64,
    seed: u32,
}

/// Odd multipliers of the two lattice numbers. The nearest place that shows the same pattern is 35614 cells away (the
/// shortest vector that both take to 0 in 32 bits).
const STRIDE: [u32; 2] = [0x9e37_79b1, 0x85eb_ca77];

impl Hashed {
    /// A pattern of `cell` (m).
    pub(super) fn new(seed: u64, cell: f64) -> Self {
        Self { inverse_cell: 1.0 / cell, seed: (seed >> 32) as u32 }
    }

    /// The pattern at (x, y) (m), -1..=1.
    pub fn at(&self, x: f64, y: f64) -> f64 {
        let places = [x * self.inverse_cell, y * self.inverse_cell];
        let key = self.key(places.map(|place| line(rounded(place))));
        let corner = |offset| f64::from(value(scramble(key.wrapping_add(offset))));
        join(CORNERS.map(|pair| pair.map(corner)), places.map(way), 3.0)
    }

    /// [`at`](Self::at) at twice eight places side by side; the same bits in f64.
    #[inline(always)]
    pub fn sixteen<L: Simd, S: Real>(&self, places: [[f64x8<L>; 2]; 2]) -> S::Double<L> {
        let simd = places[0][0].token();
        let [first, second] = [self.cells(places[0]), self.cells(places[1])];
        let rows = line_numbers([first.lines[0], second.lines[0]]);
        let columns = line_numbers([first.lines[1], second.lines[1]]);
        let key = rows * STRIDE[0] + columns * STRIDE[1] + self.seed;
        // No `map` and no closure: what they are handed is not always compiled for the width of the vectors.
        let south = [steps::<L, S>(simd, key), steps::<L, S>(simd, key + CORNERS[0][1])];
        let north = [steps::<L, S>(simd, key + CORNERS[1][0]), steps::<L, S>(simd, key + CORNERS[1][1])];
        let ways = [
            S::Double::of(S::narrow(first.ways[0]), S::narrow(second.ways[0])),
            S::Double::of(S::narrow(first.ways[1]), S::narrow(second.ways[1])),
        ];
        let splat = |value| S::Double::splat(simd, S::from_f64(value));
        // A power of two: whether corners are taken in its steps or what they join to, the bits are the same.
        join([south, north], ways, splat(3.0)) * splat(1.0 / 8_388_608.0)
    }

    /// The cells of eight places.
    #[inline(always)]
    fn cells<L: Simd>(&self, [x, y]: [f64x8<L>; 2]) -> Cells<L> {
        let [x, y] = [x * self.inverse_cell, y * self.inverse_cell];
        let lines = [(x - 0.5) + ROUND, (y - 0.5) + ROUND];
        Cells { lines, ways: [x - (lines[0] - ROUND), y - (lines[1] - ROUND)] }
    }

    /// Hash key of the south-west corner of a cell.
    #[inline(always)]
    fn key(&self, [row, column]: [u32; 2]) -> u32 {
        let key = row.wrapping_mul(STRIDE[0]).wrapping_add(column.wrapping_mul(STRIDE[1]));
        key.wrapping_add(self.seed)
    }
}

/// Cells of eight places.
struct Cells<L: Simd> {
    /// Lattice lines before the places, plus [`ROUND`].
    lines: [f64x8<L>; 2],
    /// Ways from those lattice lines to the places (cells, 0..=1).
    ways: [f64x8<L>; 2],
}

/// From the key of a cell's south-west corner to those of all four.
const CORNERS: [[u32; 2]; 2] = [[0, STRIDE[1]], [STRIDE[0], STRIDE[0].wrapping_add(STRIDE[1])]];

/// 32 well-mixed bits (a two-round finaliser of the hash-prospector project): two products, where [`hash_words`] takes
/// ten.
#[inline(always)]
fn scramble(key: u32) -> u32 {
    let key = (key ^ (key >> 16)).wrapping_mul(0x21f0_aaad);
    let key = (key ^ (key >> 15)).wrapping_mul(0xd35a_2d97);
    key ^ (key >> 15)
}

/// [`value`] of what [`scramble`] makes of twice eight keys, in steps of 2^-23.
#[inline(always)]
fn steps<L: Simd, S: Real>(simd: L, keys: u32x16<L>) -> S::Double<L> {
    let keys = (keys ^ (keys >> 16)) * 0x21f0_aaad;
    let keys = (keys ^ (keys >> 15)) * 0xd35a_2d97;
    // The last round, cut down to 24 bits of which the first is turned and made a sign: three words, one instruction.
    let (signed, mixed): (i32x16<L>, i32x16<L>) = (keys.bitcast(), (keys >> 23).bitcast());
    let steps = ((signed >> 8) ^ mixed ^ (-1 << 23)).to_float::<f32x16<L>>();
    let mut out = Both::default();
    for lane in 0..2 * LANES {
        out.0[lane] = S::from_f64(f64::from(steps[lane]));
    }
    S::Double::load(simd, &out)
}

/// Numbers of twice eight lattice lines: the low halves of their words.
#[inline(always)]
fn line_numbers<L: Simd>([first, second]: [f64x8<L>; 2]) -> u32x16<L> {
    let (first, second): (u32x16<L>, u32x16<L>) = (first.bitcast(), second.bitcast());
    first.unzip_low(second)
}

/// Variant 1: lattice values of one region, read through the folded coordinates of section 6.2, so that every region
/// shows them, mirrored at its edges. With absolute parity the pattern stays fixed to the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Stored {
    /// 1 / region size.
    inverse_region: f64,
    /// Cells along an edge.
    cells: usize,
    /// `(cells + 1)^2` lattice values, east fastest. Those on an edge are shared by the regions it parts.
    values: Vec<f32>,
}

/// Most cells along the edge of a region: 16 MB of values a layer.
const MOST_CELLS: f64 = 2048.0;

impl Stored {
    /// A pattern of about `cell` (m) over regions of `region_size` (m).
    pub(super) fn new(seed: u64, cell: f64, region_size: f64) -> Self {
        let cells = (region_size / cell).round().clamp(1.0, MOST_CELLS) as usize;
        let points = cells as u64 + 1;
        let values = (0..points * points)
            .map(|index| value((hash_words(seed, &[index / points, index % points]) >> 32) as u32));
        let mut stored = Self { inverse_region: 1.0 / region_size, cells, values: values.collect() };
        stored.take_off_the_mean();
        stored
    }

    /// Makes the mean over the region zero. Values on an edge lie half in it, those in its corners a quarter. Scaled so
    /// that all stay within -1..=1.
    fn take_off_the_mean(&mut self) {
        let points = self.cells + 1;
        let weight = |index: usize| if index == 0 || index == self.cells { 0.5 } else { 1.0 };
        let weighted = self
            .values
            .iter()
            .enumerate()
            .map(|(index, &value)| weight(index / points) * weight(index % points) * f64::from(value));
        let mean = weighted.sum::<f64>() / (self.cells * self.cells) as f64;
        let scale = 1.0 / (1.0 + mean.abs());
        for value in &mut self.values {
            *value = ((f64::from(*value) - mean) * scale) as f32;
        }
    }

    /// Cells along an edge of a region.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// The pattern at (x, y) (m), -1..=1.
    pub fn at(&self, x: f64, y: f64) -> f64 {
        let ((row, u), (column, v)) = (self.cell_of(x), self.cell_of(y));
        join(self.corners(row, column).map(|pair| pair.map(f64::from)), [u, v], 3.0)
    }

    /// [`at`](Self::at) at eight places side by side; the same bits in f64.
    #[inline(always)]
    pub fn eight<L: Simd, S: Real>(&self, [x, y]: [f64x8<L>; 2]) -> S::Vector<L> {
        let simd = x.token();
        let (mut values, mut ways) = ([[[S::ZERO; LANES]; 2]; 2], [[S::ZERO; LANES]; 2]);
        for lane in 0..LANES {
            let ((row, u), (column, v)) = (self.cell_of(x[lane]), self.cell_of(y[lane]));
            let corners = self.corners(row, column);
            for i in 0..2 {
                for j in 0..2 {
                    values[i][j][lane] = S::from_f64(f64::from(corners[i][j]));
                }
                ways[i][lane] = S::from_f64([u, v][i]);
            }
        }
        let [south, north] = &values;
        let south =
            [S::Vector::<L>::from_slice(simd, &south[0]), S::Vector::<L>::from_slice(simd, &south[1])];
        let north =
            [S::Vector::<L>::from_slice(simd, &north[0]), S::Vector::<L>::from_slice(simd, &north[1])];
        let ways = [S::Vector::<L>::from_slice(simd, &ways[0]), S::Vector::<L>::from_slice(simd, &ways[1])];
        join([south, north], ways, S::Vector::<L>::simd_from(simd, S::from_f64(3.0)))
    }

    /// Lattice line before the folded coordinate, and the way from it in cells.
    #[inline(always)]
    fn cell_of(&self, place: f64) -> (usize, f64) {
        let regions = place * self.inverse_region;
        let folded = regions - 2.0 * ((0.5 * regions + ROUND) - ROUND);
        let cells = folded.abs() * self.cells as f64;
        // At X = 1 the last cell is meant, whichever way the place is rounded.
        let line = (line(rounded(cells)) as usize).min(self.cells - 1);
        (line, cells - line as f64)
    }

    #[inline(always)]
    fn corners(&self, row: usize, column: usize) -> [[f32; 2]; 2] {
        let at = row * (self.cells + 1) + column;
        let next = at + self.cells + 1;
        [[self.values[at], self.values[at + 1]], [self.values[next], self.values[next + 1]]]
    }
}
