//! The harmonic fill of one hole: Laplace's equation on its posts, by conjugate gradients.
//!
//! The matrix is that of a graph: the number of neighbours on the diagonal, -1 for each neighbour that is a void too. It is positive
//! definite, because every hole has a rim. Heights are taken from the mean of the rim, so a plane far above the datum loses no digits.

use super::VoidError;
use super::holes::{Hole, neighbours};

/// Largest imbalance of a post that is left, by the range of the rim's heights (chosen).
const BALANCE: f64 = 1e-13;

/// The equations of one hole; posts are counted within the hole.
struct Equations {
    /// Number of neighbours of each post within the grid.
    degree: Vec<f64>,
    /// Neighbours that are voids of the hole.
    voids: Vec<Vec<usize>>,
    /// Sum of the known neighbours' heights, from the mean of the rim (m).
    known: Vec<f64>,
}

impl Equations {
    fn of(shape: [usize; 2], heights: &[f64], hole: &Hole, mean: f64) -> Self {
        let around = |&post: &usize| neighbours(shape, post).collect::<Vec<_>>();
        let all: Vec<Vec<usize>> = hole.posts.iter().map(around).collect();
        let inside =
            |beside: &[usize]| beside.iter().filter_map(|post| hole.posts.binary_search(post).ok()).collect();
        let outside = |beside: &[usize]| {
            beside.iter().filter(|&&post| !heights[post].is_nan()).map(|&post| heights[post] - mean).sum()
        };
        Self {
            degree: all.iter().map(|beside| beside.len() as f64).collect(),
            voids: all.iter().map(|beside| inside(beside)).collect(),
            known: all.iter().map(|beside| outside(beside)).collect(),
        }
    }

    fn apply(&self, values: &[f64], product: &mut [f64]) {
        for (post, product) in product.iter_mut().enumerate() {
            let beside: f64 = self.voids[post].iter().map(|&void| values[void]).sum();
            *product = self.degree[post] * values[post] - beside;
        }
    }

    /// Heights from the mean of the rim (m) at which no post is out of balance by more than `bound` (m).
    fn solve(&self, bound: f64) -> Result<Vec<f64>, VoidError> {
        let count = self.known.len();
        let (mut values, mut residual) = (vec![0.0; count], self.known.clone());
        let (mut direction, mut product) = (residual.clone(), vec![0.0; count]);
        let mut energy = dot(&residual, &residual);
        let most = 10 * count + 100;
        for _ in 0..most {
            if largest(&residual) <= bound {
                return Ok(values);
            }
            self.apply(&direction, &mut product);
            let step = energy / dot(&direction, &product);
            add(&mut values, step, &direction);
            add(&mut residual, -step, &product);
            let before = std::mem::replace(&mut energy, dot(&residual, &residual));
            for (direction, residual) in direction.iter_mut().zip(&residual) {
                *direction = residual + energy / before * *direction;
            }
        }
        Err(VoidError::NotConverged { residual: largest(&residual), steps: most })
    }
}

/// Fills one hole harmonically.
pub(super) fn fill(shape: [usize; 2], heights: &mut [f64], hole: &Hole) -> Result<(), VoidError> {
    let rim = || hole.rim.iter().map(|&post| heights[post]);
    let (low, high) = (rim().fold(f64::INFINITY, f64::min), rim().fold(f64::NEG_INFINITY, f64::max));
    let mean = rim().sum::<f64>() / hole.rim.len() as f64;
    // A flat rim leaves the rounding of its mean: the bound is never below that.
    let bound = BALANCE * (high - low).max(low.abs()).max(high.abs()).max(f64::MIN_POSITIVE);
    let values = Equations::of(shape, heights, hole, mean).solve(bound)?;
    for (&post, value) in hole.posts.iter().zip(values) {
        // Rounding may leave the range by a unit in the last place; the law says never.
        heights[post] = (mean + value).clamp(low, high);
    }
    Ok(())
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

fn add(sum: &mut [f64], factor: f64, values: &[f64]) {
    for (sum, value) in sum.iter_mut().zip(values) {
        *sum += factor * value;
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}
