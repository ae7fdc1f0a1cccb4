//! Many posts: conjugate gradients, each step led by a cycle over coarser grids.

use rayon::prelude::*;

use super::super::VoidError;
use super::super::holes::{Hole, neighbours};
use super::cycle::Cycle;

/// Most steps: a hundred is already far more than any shape of hole has needed (chosen), and those without a cycle need one a post.
const STEPS: [usize; 2] = [100, 10];

/// Posts that a thread takes at a time. Sums are made of theirs, in order.
const RUN: usize = 8192;

/// The equations of one hole; posts are counted within the hole.
pub(super) struct Equations {
    /// Number of neighbours of each post within the grid.
    degree: Vec<f64>,
    /// Neighbours that are voids of the hole; for others the number of posts, behind the last of which a 0 stands.
    beside: Vec<[u32; 4]>,
    /// Sum of the known neighbours' heights, from the mean of the rim (m).
    known: Vec<f64>,
    cycle: Option<Cycle>,
}

impl Equations {
    /// The equations of `hole`, heights counted from `mean` (m).
    pub fn of(shape: [usize; 2], heights: &[f64], hole: Hole, mean: f64) -> Self {
        let count = hole.posts.len() as u32;
        let of_post = |&post: &usize| {
            let (mut degree, mut known, mut beside) = (0.0, 0.0, [count; 4]);
            for (way, post) in neighbours(shape, post).enumerate() {
                degree += 1.0;
                match hole.posts.binary_search(&post) {
                    Ok(void) => beside[way] = void as u32,
                    Err(_) => known += heights[post] - mean,
                }
            }
            (degree, beside, known)
        };
        let all: Vec<(f64, [u32; 4], f64)> = hole.posts.par_iter().map(of_post).collect();
        Self {
            degree: all.iter().map(|part| part.0).collect(),
            beside: all.iter().map(|part| part.1).collect(),
            known: all.iter().map(|part| part.2).collect(),
            cycle: Cycle::over(shape, hole),
        }
    }

    /// Heights from the mean of the rim (m) at which no post is out of balance by more than `bound` (m).
    pub fn solve(&self, bound: f64) -> Result<Vec<f64>, VoidError> {
        let count = self.known.len();
        let (mut values, mut residual) = (vec![0.0; count], self.known.clone());
        // One more for neighbours that are no voids.
        let (mut direction, mut product) = (vec![0.0; count + 1], vec![0.0; count]);
        let mut energy = f64::INFINITY;
        let most = if self.cycle.is_some() { STEPS[0] } else { STEPS[1] * count + STEPS[0] };
        for _ in 0..most {
            let largest = largest(&residual);
            if largest <= bound {
                return Ok(values);
            }
            let led = self.led(&residual, largest);
            let before = std::mem::replace(&mut energy, dot(&residual, &led));
            blend(&mut direction, energy / before, &led);
            self.apply(&direction, &mut product);
            let step = energy / dot(&direction[..count], &product);
            add(&mut values, step, &direction);
            add(&mut residual, -step, &product);
        }
        Err(VoidError::NotConverged { residual: largest(&residual), steps: most })
    }

    fn apply(&self, values: &[f64], product: &mut [f64]) {
        product.par_chunks_mut(RUN).enumerate().for_each(|(run, product)| {
            for (post, product) in product.iter_mut().enumerate().map(|(at, part)| (run * RUN + at, part)) {
                let [a, b, c, d] = self.beside[post].map(|void| values[void as usize]);
                *product = self.degree[post] * values[post] - (a + b) - (c + d);
            }
        });
    }

    /// What the cycle makes of a residual whose largest part is `largest`; without one, each part over its diagonal.
    fn led(&self, residual: &[f64], largest: f64) -> Vec<f64> {
        match &self.cycle {
            Some(cycle) => cycle.correct(residual, largest),
            None => residual.iter().zip(&self.degree).map(|(part, degree)| part / degree).collect(),
        }
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    let of_run = |(one, other): (&[f64], &[f64])| one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>();
    one.par_chunks(RUN).zip(other.par_chunks(RUN)).map(of_run).collect::<Vec<_>>().iter().sum()
}

/// Adds `factor` times the values to a sum.
fn add(sum: &mut [f64], factor: f64, values: &[f64]) {
    sum.par_chunks_mut(RUN).zip(values.par_chunks(RUN)).for_each(|(sum, values)| {
        sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += factor * value);
    });
}

/// `factor` times what stands there, and the values.
fn blend(sum: &mut [f64], factor: f64, values: &[f64]) {
    sum.par_chunks_mut(RUN).zip(values.par_chunks(RUN)).for_each(|(sum, values)| {
        sum.iter_mut().zip(values).for_each(|(sum, value)| *sum = value + factor * *sum);
    });
}

fn largest(values: &[f64]) -> f64 {
    let of_run = |run: &[f64]| run.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    values.par_chunks(RUN).map(of_run).reduce(|| 0.0, f64::max)
}
