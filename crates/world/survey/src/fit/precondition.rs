//! Preconditioner: the fit to a full grid of samples, as the product of two one-dimensional fits.
//!
//! `(G_x + a K_x) (x) (G_y + a K_y)`, with G the normal matrix of one axis and K its bending energy, is close to
//! the two-dimensional normal matrix when no sample is missing; each factor is block tridiagonal and is solved
//! exactly. What conjugate gradients are left to do comes from voids alone.

use landscape::CornerWords;
use rayon::prelude::*;

use super::axis::Axis;
use super::roughness::AxisMatrix;

type Block = [[f64; 3]; 3];

/// Cholesky factor of a block tridiagonal matrix, 3 x 3 blocks, one a corner.
#[derive(Debug)]
pub struct AxisFactor {
    /// Inverse of the diagonal block of the factor (lower triangle).
    inverse: Vec<Block>,
    /// Block left of the diagonal; zero at the first corner.
    below: Vec<Block>,
}

impl AxisFactor {
    /// Factor of `sum of weights weights^T + roughness` over the regions of the axis.
    pub fn new(axis: &Axis, roughness: &AxisMatrix) -> Self {
        let corners = axis.regions() + 1;
        let (mut diagonal, mut lower) = (vec![[[0.0; 3]; 3]; corners], vec![[[0.0; 3]; 3]; corners]);
        for region in 0..axis.regions() {
            let normal = region_matrix(axis, region, roughness);
            for (p, q) in (0..9).map(|i| (i / 3, i % 3)) {
                diagonal[region][p][q] += normal[p][q];
                diagonal[region + 1][p][q] += normal[3 + p][3 + q];
                lower[region + 1][p][q] += normal[3 + p][q];
            }
        }
        Self::factor(&diagonal, &lower)
    }

    fn factor(diagonal: &[Block], lower: &[Block]) -> Self {
        let mut out = Self { inverse: Vec::new(), below: Vec::new() };
        for corner in 0..diagonal.len() {
            let mut pivot = diagonal[corner];
            let mut below = [[0.0; 3]; 3];
            if corner > 0 {
                let previous: &Block = &out.inverse[corner - 1];
                below = product(&lower[corner], &transposed(previous));
                let square = product(&below, &transposed(&below));
                for (p, q) in (0..9).map(|i| (i / 3, i % 3)) {
                    pivot[p][q] -= square[p][q];
                }
            }
            out.inverse.push(inverse_of_factor(&pivot, &diagonal[corner]));
            out.below.push(below);
        }
        out
    }

    /// Solves in place for one row of corners, for the three derivative orders of the other axis at once.
    pub fn solve_row(&self, row: &mut [CornerWords]) {
        for corner in 0..row.len() {
            if corner > 0 {
                let (done, open) = row.split_at_mut(corner);
                subtract(&self.below[corner], &done[corner - 1], &mut open[0]);
            }
            row[corner] = times(&self.inverse[corner], &row[corner]);
        }
        for corner in (0..row.len()).rev() {
            if corner + 1 < row.len() {
                let (open, done) = row.split_at_mut(corner + 1);
                subtract(&transposed(&self.below[corner + 1]), &done[0], &mut open[corner]);
            }
            row[corner] = times(&transposed(&self.inverse[corner]), &row[corner]);
        }
    }
}

/// The preconditioner as its two factors, one per axis.
#[derive(Debug)]
pub struct Preconditioner {
    north: AxisFactor,
    east: AxisFactor,
}

impl Preconditioner {
    /// From the factors of the two axes.
    pub fn new(north: AxisFactor, east: AxisFactor) -> Self {
        Self { north, east }
    }

    /// `out = M^-1 residual`; `scratch` is as long as both.
    pub fn solve(&self, residual: &[CornerWords], out: &mut [CornerWords], scratch: &mut [CornerWords]) {
        let (lines, columns) = (self.north.inverse.len(), self.east.inverse.len());
        out.copy_from_slice(residual);
        out.par_chunks_mut(columns).for_each(|row| self.east.solve_row(row));
        transpose(out, scratch, lines, columns);
        scratch.par_chunks_mut(lines).for_each(|row| self.north.solve_row(row));
        transpose(scratch, out, columns, lines);
    }
}

/// Exchanges north and east: corners and, in each, the orders of the derivatives.
fn transpose(from: &[CornerWords], to: &mut [CornerWords], lines: usize, columns: usize) {
    to.par_chunks_mut(lines).enumerate().for_each(|(column, row)| {
        for (line, words) in row.iter_mut().enumerate() {
            let source = &from[line * columns + column];
            for (index, word) in words.iter_mut().enumerate() {
                *word = source[index % 3 * 3 + index / 3];
            }
        }
    });
}

/// Normal matrix of the six words that one region has along the axis.
pub fn region_matrix(axis: &Axis, region: usize, roughness: &AxisMatrix) -> AxisMatrix {
    let mut normal = *roughness;
    for sample in axis.of_region(region) {
        let w = &axis.weights[sample];
        for (a, b) in (0..36).map(|i| (i / 6, i % 6)) {
            normal[a][b] += w[a] * w[b];
        }
    }
    normal
}

/// Inverse of the Cholesky factor of `pivot`. A pivot lost in rounding is held above 1e-13 of the diagonal: the
/// preconditioner stays positive definite, and only its quality suffers.
fn inverse_of_factor(pivot: &Block, diagonal: &Block) -> Block {
    let mut l = [[0.0; 3]; 3];
    for j in 0..3 {
        let rest = (0..j).map(|k| l[j][k] * l[j][k]).sum::<f64>();
        l[j][j] = (pivot[j][j] - rest).max(1e-13 * diagonal[j][j]).max(f64::MIN_POSITIVE).sqrt();
        for i in j + 1..3 {
            let rest = (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            l[i][j] = (pivot[i][j] - rest) / l[j][j];
        }
    }
    let mut inverse = [[0.0; 3]; 3];
    for j in 0..3 {
        inverse[j][j] = 1.0 / l[j][j];
        for i in j + 1..3 {
            let sum = (j..i).map(|k| l[i][k] * inverse[k][j]).sum::<f64>();
            inverse[i][j] = -sum / l[i][i];
        }
    }
    inverse
}

fn transposed(block: &Block) -> Block {
    let [[a, b, c], [d, e, f], [g, h, i]] = *block;
    [[a, d, g], [b, e, h], [c, f, i]]
}

fn product(a: &Block, b: &Block) -> Block {
    std::array::from_fn(|p| std::array::from_fn(|q| (0..3).map(|k| a[p][k] * b[k][q]).sum()))
}

/// `block` applied to the second index of nine words.
fn times(block: &Block, words: &CornerWords) -> CornerWords {
    let mut out = [0.0; 9];
    for p in 0..3 {
        for q in 0..3 {
            let w = &words[3 * p..3 * p + 3];
            out[3 * p + q] = block[q][0] * w[0] + block[q][1] * w[1] + block[q][2] * w[2];
        }
    }
    out
}

fn subtract(block: &Block, words: &CornerWords, from: &mut CornerWords) {
    let product = times(block, words);
    for index in 0..9 {
        from[index] -= product[index];
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, AxisFactor, region_matrix};
    use crate::fit::roughness::axis_matrix;

    #[test]
    fn the_factor_solves_its_matrix() {
        let axis = Axis::new(4, 10.0, 0.0, 2.0, 21);
        let bend = axis_matrix(2).map(|row| row.map(|v| 1e-3 * v));
        let factor = AxisFactor::new(&axis, &bend);
        let x: Vec<[f64; 9]> = (0..5u64)
            .map(|n| std::array::from_fn(|i| quantities::unit_interval(7, &[n, i as u64]) - 0.5))
            .collect();
        let mut b = vec![[0.0; 9]; 5];
        for region in 0..4 {
            let matrix = region_matrix(&axis, region, &bend);
            for (p, a, c) in (0..108).map(|i| (i / 36, i / 6 % 6, i % 6)) {
                b[region + a / 3][3 * p + a % 3] += matrix[a][c] * x[region + c / 3][3 * p + c % 3];
            }
        }
        factor.solve_row(&mut b);
        for (found, expected) in b.iter().flatten().zip(x.iter().flatten()) {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }
}
