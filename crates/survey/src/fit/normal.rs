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
    /// Nothing: the sample tests the fit.
    HeldOut,
    /// There is no sample: bends and stretches as little as possible.
    Void,
}

/// What the fit minimises: squared residuals at the used places, bending and tension at the voids, and a little
/// bending everywhere.
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
    /// Weight of `h_uu^2 + 2 h_uv^2 + h_vv^2` at a void.
    pub void_plate: f64,
    /// Weight of `h_u^2 + h_v^2` at a void.
    pub void_membrane: f64,
    /// Bending of all regions.
    pub roughness: &'a Roughness,
}

/// The surface at the corners to the east of one line: value and two derivatives in u, each with three in v.
struct Line([Vec<[f64; 3]>; 3]);

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
            let mut at = Line::new(columns);
            for line in self.north.of_region(strip) {
                let orders = self.orders(line);
                at.set(&self.weights(line)[..orders], rows);
                if orders == 1 {
                    self.weigh_samples(line, &mut at.0[0], |_, weights, at| dot(weights, at));
                } else {
                    self.weigh_with_voids(line, &mut at);
                }
                at.add_to(&self.weights(line)[..orders], sums);
            }
            self.add_roughness(rows, sums);
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
            let mut at = Line::new(columns);
            for line in self.north.of_region(strip) {
                self.weigh_samples(line, &mut at.0[0], |sample, _, _| height(sample));
                at.add_to(&self.weights(line)[..1], sums);
            }
        });
        self.gather(sums, out);
    }

    /// Weights of value, slope and curvature in u on a line.
    fn weights(&self, line: usize) -> [&[f64; 6]; 3] {
        [&self.north.weights[line], &self.north.slopes[line], &self.north.curvatures[line]]
    }

    /// Derivative orders in u that a line needs: voids need slope and curvature.
    fn orders(&self, line: usize) -> usize {
        let row = &self.places[line * self.columns..][..self.east.samples()];
        if row.contains(&Place::Void) { 3 } else { 1 }
    }

    /// Replaces what stands at the corners by the sum over used samples of `value(sample, weights, corners)` times
    /// the weights.
    #[inline]
    fn weigh_samples(
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
                if self.places[sample] == Place::Used {
                    let weights = &self.east.weights[column];
                    add_scaled(&mut sum, value(sample, weights, &corners), weights);
                }
            }
            [at[region], left] = halves(sum);
        }
        at[self.east.regions()] = left;
    }

    /// The same for value, slope and curvature, with the energies at voids.
    fn weigh_with_voids(&self, line: usize, at: &mut Line) {
        let (plate, membrane) = (self.void_plate, self.void_membrane);
        let mut left = [[0.0; 3]; 3];
        for region in 0..self.east.regions() {
            let corners: [[f64; 6]; 3] =
                std::array::from_fn(|order| both(at.0[order][region], at.0[order][region + 1]));
            let mut sum = left.map(|left| both(left, [0.0; 3]));
            for column in self.east.of_region(region) {
                let g = &self.east.weights[column];
                match self.places[line * self.columns + column] {
                    Place::Used => add_scaled(&mut sum[0], dot(g, &corners[0]), g),
                    Place::HeldOut => {}
                    Place::Void => {
                        let (slope, curvature) = (&self.east.slopes[column], &self.east.curvatures[column]);
                        add_scaled(&mut sum[0], membrane * dot(slope, &corners[0]), slope);
                        add_scaled(&mut sum[0], plate * dot(curvature, &corners[0]), curvature);
                        add_scaled(&mut sum[1], membrane * dot(g, &corners[1]), g);
                        add_scaled(&mut sum[1], 2.0 * plate * dot(slope, &corners[1]), slope);
                        add_scaled(&mut sum[2], plate * dot(g, &corners[2]), g);
                    }
                }
            }
            for order in 0..3 {
                [at.0[order][region], left[order]] = halves(sum[order]);
            }
        }
        for order in 0..3 {
            at.0[order][self.east.regions()] = left[order];
        }
    }

    fn add_roughness(&self, rows: &[CornerWords], sums: &mut [CornerWords]) {
        let corners = self.corners()[1];
        for region in 0..self.east.regions() {
            let at = [region, region + 1, corners + region, corners + region + 1];
            let words: RegionWords = std::array::from_fn(|a| {
                std::array::from_fn(|b| rows[at[2 * (a / 3) + b / 3]][3 * (a % 3) + b % 3])
            });
            let force = self.roughness.apply(&words);
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

impl Line {
    fn new(corners: usize) -> Self {
        Self(std::array::from_fn(|_| vec![[0.0; 3]; corners]))
    }

    /// Takes the line from the corners south and north of it; one set of weights a derivative order.
    fn set(&mut self, weights: &[&[f64; 6]], rows: &[CornerWords]) {
        let (south, north) = rows.split_at(rows.len() / 2);
        for (weights, at) in weights.iter().zip(&mut self.0) {
            across_line(weights, south, north, at);
        }
    }

    /// Adjoint of [`set`](Self::set).
    fn add_to(&self, weights: &[&[f64; 6]], sums: &mut [CornerWords]) {
        let (south, north) = sums.split_at_mut(sums.len() / 2);
        for (w, at) in weights.iter().zip(&self.0) {
            for ((south, north), a) in south.iter_mut().zip(north.iter_mut()).zip(at) {
                for (p, q) in (0..9).map(|i| (i / 3, i % 3)) {
                    south[3 * p + q] += w[p] * a[q];
                    north[3 * p + q] += w[3 + p] * a[q];
                }
            }
        }
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

#[inline]
fn add_scaled(sum: &mut [f64; 6], factor: f64, by: &[f64; 6]) {
    for k in 0..6 {
        sum[k] += factor * by[k];
    }
}

/// Three words of a corner and three of the next.
#[inline]
pub fn both(a: [f64; 3], b: [f64; 3]) -> [f64; 6] {
    [a[0], a[1], a[2], b[0], b[1], b[2]]
}

fn halves(sum: [f64; 6]) -> [[f64; 3]; 2] {
    [[sum[0], sum[1], sum[2]], [sum[3], sum[4], sum[5]]]
}

fn add(row: &mut [CornerWords], other: &[CornerWords]) {
    for (sum, words) in row.iter_mut().zip(other) {
        for index in 0..9 {
            sum[index] += words[index];
        }
    }
}
