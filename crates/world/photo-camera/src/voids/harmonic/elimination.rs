//! Few posts: the equations are solved by elimination (Cholesky's), without a step too many.

use super::super::holes::{Hole, neighbours};

/// Most posts of a hole that is solved so. Chosen: the work grows with their cube.
pub(super) const MOST_POSTS: usize = 24;

/// Room for the lower triangle of a matrix, used again from hole to hole.
#[derive(Default)]
pub(super) struct Elimination {
    matrix: Vec<f64>,
}

impl Elimination {
    /// Writes the heights of the posts from `mean` (m) into `values`.
    pub fn solve(&mut self, shape: [usize; 2], heights: &[f64], hole: Hole, mean: f64, values: &mut [f64]) {
        let count = hole.posts.len();
        self.matrix.clear();
        self.matrix.resize(count * count, 0.0);
        for (row, &post) in hole.posts.iter().enumerate() {
            let (mut degree, mut known) = (0.0, 0.0);
            for beside in neighbours(shape, post) {
                degree += 1.0;
                if !heights[beside].is_nan() {
                    known += heights[beside] - mean;
                } else if beside < post {
                    // Posts ascend, so a void before this one stands before it in the list.
                    let column = hole.posts[..row].partition_point(|&other| other < beside);
                    self.matrix[row * count + column] = -1.0;
                }
            }
            self.matrix[row * count + row] = degree;
            values[row] = known;
        }
        self.factorise(count);
        self.substitute(count, values);
    }

    /// The matrix becomes its factor L, with L times its transpose the matrix.
    fn factorise(&mut self, count: usize) {
        for row in 0..count {
            for column in 0..=row {
                let [this, other] = [row, column].map(|at| &self.matrix[at * count..][..column]);
                let sum: f64 = this.iter().zip(other).map(|(a, b)| a * b).sum();
                let rest = self.matrix[row * count + column] - sum;
                let diagonal = self.matrix[column * count + column];
                self.matrix[row * count + column] = if row == column { rest.sqrt() } else { rest / diagonal };
            }
        }
    }

    /// Solves with the factor, then with its transpose.
    fn substitute(&self, count: usize, values: &mut [f64]) {
        let at = |row: usize, column: usize| self.matrix[row * count + column];
        for row in 0..count {
            let sum: f64 = (0..row).map(|column| at(row, column) * values[column]).sum();
            values[row] = (values[row] - sum) / at(row, row);
        }
        for row in (0..count).rev() {
            let sum: f64 = (row + 1..count).map(|column| at(column, row) * values[column]).sum();
            values[row] = (values[row] - sum) / at(row, row);
        }
    }
}
