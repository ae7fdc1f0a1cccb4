//! The normal equations of the fit, applied without being formed.
//!
//! A strip is one row of regions. Each strip adds to the row of corners south of it and to the row north of it;
//! strips are independent and their additions are summed in order, so the result has the same bits for any number
//! of threads.

use landscape::CornerWords;
use rayon::prelude::*;

use super::axis::Axis;
use super::roughness::{RegionWords, Roughness};

/// What the fit minimises: squared residuals of the used samples, plus bending, plus tension where samples lack.
#[derive(Debug)]
pub struct Normal<'a> {
    /// Samples to the north, by region.
    pub north: &'a Axis,
    /// Samples to the east, by region.
    pub east: &'a Axis,
    /// Which samples the fit may see: `line * columns + column`, lines south to north.
    pub used: &'a [bool],
    /// Samples from one line to the next in `used`.
    pub columns: usize,
    /// Weights of plate and membrane of each region, `strip * regions east + region`.
    pub stiffness: &'a [[f64; 2]],
    /// The two energies.
    pub roughness: &'a Roughness,
}

/// The two rows of corners to which a strip adds, one after the other.
type StripSums = [CornerWords];

impl Normal<'_> {
    /// Corners to the north and to the east.
    pub fn corners(&self) -> [usize; 2] {
        [self.north.regions() + 1, self.east.regions() + 1]
    }

    /// `out = A words`; `sums` is scratch of `2 * (corners east) * (regions north)`.
    pub fn apply(&self, words: &[CornerWords], out: &mut [CornerWords], sums: &mut [CornerWords]) {
        let columns = self.corners()[1];
        sums.par_chunks_mut(2 * columns).enumerate().for_each(|(strip, sums)| {
            sums.fill([0.0; 9]);
            let rows = &words[strip * columns..(strip + 2) * columns];
            self.add_samples(strip, sums, |line, along| self.weigh_surface(line, rows, along));
            self.add_roughness(strip, rows, sums);
        });
        self.gather(sums, out);
    }

    /// `out = B^T heights`, the right-hand side; `height(index)` is asked for used samples only.
    pub fn project(
        &self,
        height: impl Fn(usize) -> f64 + Sync,
        out: &mut [CornerWords],
        sums: &mut [CornerWords],
    ) {
        let columns = self.corners()[1];
        sums.par_chunks_mut(2 * columns).enumerate().for_each(|(strip, sums)| {
            sums.fill([0.0; 9]);
            self.add_samples(strip, sums, |line, along| {
                along.fill([0.0; 3]);
                self.along_line(line, along, |sample, _, _| height(sample));
            });
        });
        self.gather(sums, out);
    }

    /// Lines of a strip: `weigh` gives, for each corner to the east, what the samples of the line add there.
    fn add_samples(
        &self,
        strip: usize,
        sums: &mut StripSums,
        weigh: impl Fn(usize, &mut [[f64; 3]]),
    ) {
        let mut along = vec![[0.0; 3]; self.corners()[1]];
        let (south, north) = sums.split_at_mut(along.len());
        for line in self.north.of_region(strip) {
            weigh(line, &mut along);
            let w = &self.north.weights[line];
            for (corner, a) in along.iter().enumerate() {
                for p in 0..3 {
                    for q in 0..3 {
                        south[corner][3 * p + q] += w[p] * a[q];
                        north[corner][3 * p + q] += w[3 + p] * a[q];
                    }
                }
            }
        }
    }

    /// Surface at the used samples of a line, times their weights to the east.
    fn weigh_surface(&self, line: usize, rows: &[CornerWords], along: &mut [[f64; 3]]) {
        let (south, north) = rows.split_at(along.len());
        across_line(&self.north.weights[line], south, north, along);
        let surface = |_: usize, weights: &[f64; 6], at: &[f64; 6]| dot(weights, at);
        self.along_line(line, along, surface);
    }

    /// Replaces what stands at the corners by the sum over used samples of `value(sample, weights, corners)` times weights.
    #[inline]
    fn along_line(
        &self,
        line: usize,
        along: &mut [[f64; 3]],
        value: impl Fn(usize, &[f64; 6], &[f64; 6]) -> f64,
    ) {
        let mut left = [0.0; 3];
        for region in 0..self.east.regions() {
            let (a, b) = (along[region], along[region + 1]);
            let at = [a[0], a[1], a[2], b[0], b[1], b[2]];
            let mut sum = [left[0], left[1], left[2], 0.0, 0.0, 0.0];
            for column in self.east.of_region(region) {
                let sample = line * self.columns + column;
                if self.used[sample] {
                    let weights = &self.east.weights[column];
                    let v = value(sample, weights, &at);
                    for k in 0..6 {
                        sum[k] += weights[k] * v;
                    }
                }
            }
            along[region] = [sum[0], sum[1], sum[2]];
            left = [sum[3], sum[4], sum[5]];
        }
        along[self.east.regions()] = left;
    }

    fn add_roughness(&self, strip: usize, rows: &[CornerWords], sums: &mut StripSums) {
        let corners = self.corners()[1];
        for region in 0..self.east.regions() {
            let [plate, membrane] = self.stiffness[strip * self.east.regions() + region];
            let at = [region, region + 1, corners + region, corners + region + 1];
            let words: RegionWords = std::array::from_fn(|a| {
                std::array::from_fn(|b| rows[at[2 * (a / 3) + b / 3]][3 * (a % 3) + b % 3])
            });
            let force = self.roughness.apply(plate, membrane, &words);
            for (a, b) in (0..36).map(|i| (i / 6, i % 6)) {
                sums[at[2 * (a / 3) + b / 3]][3 * (a % 3) + b % 3] += force[a][b];
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

fn add(row: &mut [CornerWords], other: &[CornerWords]) {
    for (sum, words) in row.iter_mut().zip(other) {
        for index in 0..9 {
            sum[index] += words[index];
        }
    }
}
