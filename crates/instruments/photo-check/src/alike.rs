//! How alike photograph and relief are, and how far their features lie apart.

use rayon::prelude::{IntoParallelIterator, ParallelIterator};

use crate::Overlay;

/// Farthest offset that is tried, each way (overlay pixels, chosen).
pub const REACH: i32 = 8;
/// Most pixels that are compared for an offset (chosen).
const MOST_PIXELS: usize = 200_000;
/// Least spread of light at which there is something to compare.
const LEAST_SPREAD: f64 = 1e-12;

/// How alike photograph and relief are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Likeness {
    /// Correlation as both lie, -1 to 1.
    pub correlation: f64,
    /// East and north (m) by which features of the photograph lie beside those of the relief, where both are most alike.
    pub offset: [f64; 2],
    /// Correlation at that offset.
    pub best_correlation: f64,
    /// Whether the offset lies at the end of what was tried: the true one may be larger.
    pub at_the_end: bool,
}

impl Overlay {
    /// How alike photograph and relief are; none where one of them is flat or they have no pixel in common.
    pub fn likeness(&self) -> Option<Likeness> {
        let correlation = self.correlation([0, 0], 1)?;
        let [columns, lines] = self.size();
        let stride = ((columns * lines).div_ceil(MOST_PIXELS) as f64).sqrt().ceil() as usize;
        let side = 2 * REACH + 1;
        let tried = (0..side * side).into_par_iter().filter_map(|index| {
            let moved = [index % side - REACH, index / side - REACH];
            Some((moved, self.correlation(moved, stride)?))
        });
        let tried: Vec<([i32; 2], f64)> = tried.collect();
        // The first of equals: the order is that of the list, whatever the threads.
        let best = tried.iter().copied().reduce(|best, next| if next.1 > best.1 { next } else { best });
        let ([right, down], best_correlation) = best?;
        let [line, column] = self.step();
        Some(Likeness {
            correlation,
            offset: [f64::from(right) * column, -f64::from(down) * line],
            best_correlation,
            at_the_end: right.abs() == REACH || down.abs() == REACH,
        })
    }

    /// Pearson's correlation of the relief with the photograph so many pixels to the right and down, over every `stride`-th pixel.
    fn correlation(&self, [right, down]: [i32; 2], stride: usize) -> Option<f64> {
        let [columns, lines] = self.size();
        let beside =
            |at: usize, by: i32, count: usize| at.checked_add_signed(by as isize).filter(|at| *at < count);
        let mut sums = Sums::default();
        for line in (0..lines).step_by(stride) {
            let Some(photo_line) = beside(line, down, lines) else { continue };
            for column in (0..columns).step_by(stride) {
                let Some(photo_column) = beside(column, right, columns) else { continue };
                let [photo, _] = self.lights(photo_column, photo_line);
                let [_, relief] = self.lights(column, line);
                if let (Some(photo), Some(relief)) = (photo, relief) {
                    sums.take(photo, relief);
                }
            }
        }
        sums.correlation()
    }
}

/// Running means and products of two rows of numbers (Welford 1962).
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    count: f64,
    mean: [f64; 2],
    squares: [f64; 2],
    product: f64,
}

impl Sums {
    fn take(&mut self, one: f64, other: f64) {
        self.count += 1.0;
        let off = [one - self.mean[0], other - self.mean[1]];
        self.mean = [0, 1].map(|k| self.mean[k] + off[k] / self.count);
        self.squares[0] += off[0] * (one - self.mean[0]);
        self.squares[1] += off[1] * (other - self.mean[1]);
        self.product += off[0] * (other - self.mean[1]);
    }

    fn correlation(&self) -> Option<f64> {
        let spread = (self.squares[0] * self.squares[1]).sqrt();
        (spread > LEAST_SPREAD * self.count).then(|| self.product / spread)
    }
}
