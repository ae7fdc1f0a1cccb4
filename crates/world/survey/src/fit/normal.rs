//! The normal equations of the fit, applied without being formed.
//!
//! A strip is one row of regions. Each strip adds to the row of corners south of it and to the row north of it;
//! strips are independent and their additions are summed in order, so the result has the same bits for any number
//! of threads.

use landscape::CornerWords;
use rayon::prelude::*;

use super::axis::Axis;
use super::roughness::{RegionWords, Roughness};

/// What the fit does with a sample place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Comes near the sample.
    Used,
    /// Knows only the filled height: the sample tests the fit.
    HeldOut,
    /// Knows only the filled height: there is no sample.
    Void,
}

/// What the fit minimises: weighted squares of the residuals at all places, and bending.
#[derive(Debug)]
pub struct Normal<'a> {
    /// Places to the north, by region.
    pub north: &'a Axis,
    /// Places to the east, by region.
    pub east: &'a Axis,
    /// `line * columns + column`, lines south to north.
    pub places: &'a [Place],
    /// From one line to the next in `places`.
    pub columns: usize,
    /// Weight of a filled height; that of a used sample is 1.
    pub filled_weight: f64,
    /// Bending of a region.
    pub roughness: &'a Roughness,
}

impl Normal<'_> {
    /// Corners to the north and to the east.
    pub fn corners(&self) -> [usize; 2] {
        [self.north.regions() + 1, self.east.regions() + 1]
    }

    /// `out = A words`; `sums` is scratch of `2 * (corners east) * (regions north)`.
    pub fn apply(&self, words: &[CornerWords], out: &mut [CornerWords], sums: &mut [CornerWords]) {
        let columns = self.corners()[1];
        sums.par_chunks_mut(2 * columns).enumerate().for_each(|(strip, sums)| {
            let rows = &words[strip * columns..(strip + 2) * columns];
            let (south, north) = rows.split_at(columns);
            self.sum_strip(strip, sums, |line, at| {
                across_line(&self.north.weights[line], south, north, at);
                self.along_line(line, at, |_, weights, corners| dot(weights, corners));
            });
            self.add_roughness(rows, sums);
        });
        self.gather(sums, out);
    }

    /// `out = B^T W heights`, the right-hand side; `heights` as [`places`](Self::places).
    pub fn project(&self, heights: &[f64], out: &mut [CornerWords], sums: &mut [CornerWords]) {
        let columns = self.corners()[1];
        sums.par_chunks_mut(2 * columns).enumerate().for_each(|(strip, sums)| {
            self.sum_strip(strip, sums, |line, at| self.along_line(line, at, |sample, _, _| heights[sample]));
        });
        self.gather(sums, out);
    }

    /// Sums over the lines of a strip; `weigh` gives what a line adds at each corner to the east.
    fn sum_strip(&self, strip: usize, sums: &mut [CornerWords], weigh: impl Fn(usize, &mut [[f64; 3]])) {
        sums.fill([0.0; 9]);
        let (south, north) = sums.split_at_mut(sums.len() / 2);
        let mut at = vec![[0.0; 3]; south.len()];
        for line in self.north.of_region(strip) {
            weigh(line, &mut at);
            let w = &self.north.weights[line];
            for ((south, north), a) in south.iter_mut().zip(north.iter_mut()).zip(&at) {
                for (p, q) in (0..9).map(|i| (i / 3, i % 3)) {
                    south[3 * p + q] += w[p] * a[q];
                    north[3 * p + q] += w[3 + p] * a[q];
                }
            }
        }
    }

    /// Replaces what stands at the corners by the weighted sum over the places of a line of
    /// `value(sample, weights, corners)` times the weights.
    #[inline]
    fn along_line(
        &self,
        line: usize,
        at: &mut [[f64; 3]],
        value: impl Fn(usize, &[f64; 6], &[f64; 6]) -> f64,
    ) {
        let mut left = [0.0; 3];
        for region in 0..self.east.regions() {
            let corners = both(at[region], at[region + 1]);
            let mut sum = both(left, [0.0; 3]);
            for column in self.east.of_region(region) {
                let sample = line * self.columns + column;
                let weights = &self.east.weights[column];
                let mut value = value(sample, weights, &corners);
                if self.places[sample] != Place::Used {
                    value *= self.filled_weight;
                }
                for k in 0..6 {
                    sum[k] += weights[k] * value;
                }
            }
            at[region] = [sum[0], sum[1], sum[2]];
            left = [sum[3], sum[4], sum[5]];
        }
        at[self.east.regions()] = left;
    }

    fn add_roughness(&self, rows: &[CornerWords], sums: &mut [CornerWords]) {
        let corners = self.corners()[1];
        for region in 0..self.east.regions() {
            let at = [region, region + 1, corners + region, corners + region + 1];
            let mut words: RegionWords = [[0.0; 6]; 6];
            for corner in 0..4 {
                let stored = &rows[at[corner]];
                for (p, q) in (0..9).map(|i| (i / 3, i % 3)) {
                    words[corner / 2 * 3 + p][corner % 2 * 3 + q] = stored[3 * p + q];
                }
            }
            let force = self.roughness.apply(&words);
            for corner in 0..4 {
                let sum = &mut sums[at[corner]];
                for (p, q) in (0..9).map(|i| (i / 3, i % 3)) {
                    sum[3 * p + q] += force[corner / 2 * 3 + p][corner % 2 * 3 + q];
                }
            }
        }
    }

    /// Adds the rows that two neighbouring strips have in common.
    fn gather(&self, sums: &[CornerWords], out: &mut [CornerWords]) {
        let [lines, columns] = self.corners();
        let strip_row = |strip: usize, side: usize| &sums[(2 * strip + side) * columns..][..columns];
        out.par_chunks_mut(columns).enumerate().for_each(|(line, row)| {
            row.fill([0.0; 9]);
            if line > 0 {
                add(row, strip_row(line - 1, 1));
            }
            if line + 1 < lines {
                add(row, strip_row(line, 0));
            }
        });
    }
}

/// Height and its derivatives along v at each corner to the east, for one line of samples.
pub fn across_line(weights: &[f64; 6], south: &[CornerWords], north: &[CornerWords], out: &mut [[f64; 3]]) {
    let [a, b, c, d, e, f] = *weights;
    for ((s, n), out) in south.iter().zip(north).zip(out) {
        for q in 0..3 {
            out[q] = a * s[q] + b * s[3 + q] + c * s[6 + q] + d * n[q] + e * n[3 + q] + f * n[6 + q];
        }
    }
}

/// Sum of six products.
#[inline]
pub fn dot(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) + (a[3] * b[3] + a[4] * b[4] + a[5] * b[5])
}

/// Three words of a corner and three of the next.
#[inline]
pub fn both(a: [f64; 3], b: [f64; 3]) -> [f64; 6] {
    [a[0], a[1], a[2], b[0], b[1], b[2]]
}

fn add(row: &mut [CornerWords], other: &[CornerWords]) {
    for (sum, words) in row.iter_mut().zip(other) {
        for index in 0..9 {
            sum[index] += words[index];
        }
    }
}
