//! Which sampling points of a sub-area a triangle covers.

use crate::fixed::STEPS;
use crate::pattern::MOST_SAMPLES;
use crate::sampling::{LATTICE, Offsets, Sampling};
use crate::screen::{LARGEST_SIDE, SubArea};
use crate::triangle::{Edge, Triangle};

const SIDE: usize = LARGEST_SIDE as usize;

/// Steps of a corner's position between two points of the lattice.
const LATTICE_STEPS: i32 = STEPS / LATTICE;

/// Sampling points of a sub-area that a triangle covers, as bits.
///
/// Pixels have numbers: 8 times the row in the sub-area plus the column in it. One value is used for sub-area after sub-area.
#[derive(Debug, Clone)]
pub struct Coverage {
    full: u64,
    partial: u64,
    /// Bits of the partly covered pixels; all others hold what an earlier triangle left.
    masks: [u32; SIDE * SIDE],
    /// Bits of a whole pixel.
    all: u32,
}

impl Default for Coverage {
    fn default() -> Self {
        Self { full: 0, partial: 0, masks: [0; SIDE * SIDE], all: 0 }
    }
}

impl Coverage {
    /// Finds what `triangle` covers of `area`, for any triangle and any sub-area.
    pub fn find(&mut self, triangle: &Triangle, area: &SubArea, sampling: &Sampling) {
        (self.full, self.partial) = (0, 0);
        self.all = u32::MAX >> (MOST_SAMPLES - sampling.count());
        let Some(window) = Window::new(triangle, area) else { return };
        match (sampling.count(), sampling.is_turned()) {
            (1, _) => self.find_in::<1, 1>(triangle, &window, sampling),
            (4, false) => self.find_in::<4, 1>(triangle, &window, sampling),
            (4, true) => self.find_in::<4, 4>(triangle, &window, sampling),
            (8, false) => self.find_in::<8, 1>(triangle, &window, sampling),
            (8, true) => self.find_in::<8, 4>(triangle, &window, sampling),
            (16, false) => self.find_in::<16, 1>(triangle, &window, sampling),
            (16, true) => self.find_in::<16, 4>(triangle, &window, sampling),
            (_, false) => self.find_in::<MOST_SAMPLES, 1>(triangle, &window, sampling),
            (_, true) => self.find_in::<MOST_SAMPLES, 4>(triangle, &window, sampling),
        }
    }

    /// Pixels of which every sampling point is covered, as bits.
    pub fn full(&self) -> u64 {
        self.full
    }

    /// Pixels with covered points that [`Coverage::full`] does not count, as bits.
    pub fn partial(&self) -> u64 {
        self.partial
    }

    /// Covered sampling points of a pixel, 0 to 63, as bits in the order of the pattern.
    pub fn mask(&self, pixel: usize) -> u32 {
        match (self.full >> pixel & 1, self.partial >> pixel & 1) {
            (1, _) => self.all,
            (_, 1) => self.masks[pixel],
            _ => 0,
        }
    }

    /// Pixels with covered points, by number, and their bits.
    pub fn pixels(&self) -> impl Iterator<Item = (usize, u32)> {
        ones(self.full | self.partial).map(|pixel| (pixel, self.mask(pixel)))
    }

    fn find_in<const N: usize, const TURNS: usize>(
        &mut self,
        triangle: &Triangle,
        window: &Window,
        sampling: &Sampling,
    ) {
        let mut lines = [Line::<N, TURNS>::NONE; 3];
        let mut count = 0;
        for edge in &triangle.edges {
            match Crossing::new(edge, window, sampling) {
                Crossing::Outside => return,
                Crossing::Inside => {}
                Crossing::Through(first) => {
                    lines[count] = Line::new(edge, first, sampling);
                    count += 1;
                }
            }
        }
        if count == 0 {
            self.full = window.pixels();
            return;
        }
        // Lines beyond `count` are `NONE`, which no point lies outside.
        let [p, q, r] = &lines;
        let mut start = [p.start, q.start, r.start];
        for row in window.rows[0]..=window.rows[1] {
            let mut at = start;
            for column in window.columns[0]..=window.columns[1] {
                let pixel = row * SIDE + column;
                if all_inside([at[0] + p.least, at[1] + q.least, at[2] + r.least]) {
                    self.full |= 1 << pixel;
                } else if all_inside([at[0] + p.most, at[1] + q.most, at[2] + r.most]) {
                    let turn = if TURNS == 1 { 0 } else { sampling.turn(window.place(column, row)) };
                    let mask = samples(&lines[..count], &at, turn);
                    self.masks[pixel] = mask;
                    self.partial |= u64::from(mask != 0) << pixel;
                }
                at = [at[0] + p.right, at[1] + q.right, at[2] + r.right];
            }
            start = [start[0] + p.down, start[1] + q.down, start[2] + r.down];
        }
    }
}

/// The pixels of a sub-area that the box of a triangle meets.
struct Window {
    origin: [u32; 2],
    /// First and last column and row, counted in the sub-area.
    columns: [usize; 2],
    rows: [usize; 2],
}

impl Window {
    fn new(triangle: &Triangle, area: &SubArea) -> Option<Self> {
        let range = |axis: usize, low: i32, high: i32| {
            let origin = area.origin[axis] as i32;
            let first = low.div_euclid(STEPS) - origin;
            // The top-left rule keeps no point on the right or lower border of the box.
            let last = (high - 1).div_euclid(STEPS) - origin;
            let end = area.size[axis] as i32 - 1;
            (first <= end && last >= 0).then(|| [first.max(0) as usize, last.min(end) as usize])
        };
        let columns = range(0, triangle.low.x, triangle.high.x)?;
        let rows = range(1, triangle.low.y, triangle.high.y)?;
        Some(Self { origin: area.origin, columns, rows })
    }

    /// Place on the screen of a pixel of the sub-area.
    fn place(&self, column: usize, row: usize) -> [i32; 2] {
        [self.origin[0] as i32 + column as i32, self.origin[1] as i32 + row as i32]
    }

    /// Its pixels as bits.
    fn pixels(&self) -> u64 {
        let row = (1 << (self.columns[1] + 1)) - (1 << self.columns[0]);
        (self.rows[0]..=self.rows[1]).fold(0, |pixels, number| pixels | row << (number * SIDE))
    }
}

/// How an edge lies to the sampling points of a window.
enum Crossing {
    Outside,
    Inside,
    /// The edge function at the first lattice point of the window's first pixel.
    Through(i32),
}

impl Crossing {
    /// The lattice makes the integers short: with `x = 8 X + o`, and `y` alike, `a x + b y + c >= 0` holds just if
    /// `a X + b Y + floor((c + o (a + b)) / 8) >= 0`. Over a window that an edge crosses this stays below 2^31, a pixel beyond
    /// its borders included: `|a| + |b| < 2^22.01`, and a window spans 2^8 points of the lattice.
    fn new(edge: &Edge, window: &Window, sampling: &Sampling) -> Self {
        let Edge { a, b, c } = *edge;
        let origin = i64::from(sampling.origin * (LATTICE_STEPS / 2));
        let constant = (c + origin * (i64::from(a) + i64::from(b))).div_euclid(i64::from(LATTICE_STEPS));
        let at = |[x, y]: [i32; 2]| i64::from(a) * i64::from(x) + i64::from(b) * i64::from(y) + constant;
        let lattice = |axis: usize, pixel: usize| LATTICE * (window.origin[axis] as i32 + pixel as i32);
        let [[left, right], [top, bottom]] = sampling.extent;
        let x = [lattice(0, window.columns[0]) + left, lattice(0, window.columns[1]) + right];
        let y = [lattice(1, window.rows[0]) + top, lattice(1, window.rows[1]) + bottom];
        let [nearest_x, farthest_x] = if a > 0 { [x[1], x[0]] } else { x };
        let [nearest_y, farthest_y] = if b > 0 { [y[1], y[0]] } else { y };
        if at([nearest_x, nearest_y]) < 0 {
            Self::Outside
        } else if at([farthest_x, farthest_y]) >= 0 {
            Self::Inside
        } else {
            Self::Through(at([lattice(0, window.columns[0]), lattice(1, window.rows[0])]) as i32)
        }
    }
}

/// An edge that crosses a window: its function in steps of the lattice.
#[derive(Debug, Clone, Copy)]
struct Line<const N: usize, const TURNS: usize> {
    /// At the first lattice point of the row's first pixel.
    start: i32,
    /// From one pixel to the next, and from one row of pixels to the next.
    right: i32,
    down: i32,
    /// Greatest and least value over the sampling points of a pixel, less that at its first lattice point.
    most: i32,
    least: i32,
    /// Values at the sampling points, by quarter turn, less that at the pixel's first lattice point.
    samples: [[i32; N]; TURNS],
}

impl<const N: usize, const TURNS: usize> Line<N, TURNS> {
    const NONE: Self = Self { start: 0, right: 0, down: 0, most: 0, least: 0, samples: [[0; N]; TURNS] };

    fn new(edge: &Edge, start: i32, sampling: &Sampling) -> Self {
        let Edge { a, b, .. } = *edge;
        let [x, y] = sampling.extent;
        let [most_x, least_x] = if a > 0 { [x[1], x[0]] } else { x };
        let [most_y, least_y] = if b > 0 { [y[1], y[0]] } else { y };
        let mut samples = [[0; N]; TURNS];
        for turn in 0..TURNS {
            let Offsets { x, y } = &sampling.turns()[turn];
            for i in 0..N {
                samples[turn][i] = a * x[i] + b * y[i];
            }
        }
        Self {
            start,
            right: LATTICE * a,
            down: LATTICE * b,
            most: a * most_x + b * most_y,
            least: a * least_x + b * least_y,
            samples,
        }
    }
}

/// Sampling points of a pixel that lie inside all lines, as bits. `at` has the values at the pixel's first lattice point.
fn samples<const N: usize, const TURNS: usize>(lines: &[Line<N, TURNS>], at: &[i32; 3], turn: usize) -> u32 {
    let mut outside = [0; N];
    for k in 0..lines.len() {
        let samples = &lines[k].samples[turn];
        for i in 0..N {
            outside[i] |= at[k] + samples[i];
        }
    }
    !signs(&outside) & u32::MAX >> (MOST_SAMPLES - N)
}

/// Whether no value is below 0.
fn all_inside([p, q, r]: [i32; 3]) -> bool {
    p | q | r >= 0
}

/// Which values are below 0, as bits.
fn signs<const N: usize>(values: &[i32; N]) -> u32 {
    let mut bits = 0;
    for i in 0..N {
        bits |= (values[i] >> 31) & (1 << i);
    }
    bits as u32
}

/// Numbers of the bits that are set, from the lowest.
fn ones(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = bits.trailing_zeros() as usize;
        let rest = bits & bits.wrapping_sub(1);
        (bits != 0).then(|| {
            bits = rest;
            lowest
        })
    })
}
