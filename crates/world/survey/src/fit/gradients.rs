//! Preconditioned conjugate gradients, and what their coefficients tell of the condition of the problem.

use landscape::CornerWords;
use rayon::prelude::*;

use super::normal::Normal;
use super::precondition::Preconditioner;

/// Conditions under which the iteration stops: the first one met ends it.
#[derive(Debug, Clone, Copy)]
pub struct Stop {
    /// Residual of the normal equations against the right-hand side, in the norm of the preconditioner.
    pub tolerance: f64,
    /// Greatest number of iterations.
    pub iterations: usize,
}

/// Solution and how it was reached.
#[derive(Debug)]
pub struct Solution {
    /// Nine words a corner.
    pub words: Vec<CornerWords>,
    /// Number of iterations that were made.
    pub iterations: usize,
    /// Last relative residual, as in [`Stop::tolerance`].
    pub residual: f64,
    /// Diagonal and off-diagonal of the Lanczos matrix that the iteration builds.
    pub lanczos: (Vec<f64>, Vec<f64>),
}

/// Solves `A words = right`, from zero; `progress` is told iteration and residual.
pub fn solve(
    normal: &Normal,
    preconditioner: &Preconditioner,
    right: Vec<CornerWords>,
    sums: &mut [CornerWords],
    stop: Stop,
    progress: &mut dyn FnMut(usize, f64),
) -> Solution {
    let [_, row] = normal.corners();
    let zero = || vec![[0.0; 9]; right.len()];
    let (mut words, mut steered, mut direction, mut image) = (zero(), zero(), zero(), zero());
    let mut residual = right;
    preconditioner.solve(&residual, &mut steered, &mut image);
    direction.copy_from_slice(&steered);
    let start = inner(&residual, &steered, row);
    let (mut rho, mut out) = (start, Lanczos::default());
    let mut relative = if start > 0.0 { 1.0 } else { 0.0 };
    let mut iterations = 0;
    while relative > stop.tolerance && iterations < stop.iterations {
        normal.apply(&direction, &mut image, sums);
        let curvature = inner(&direction, &image, row);
        if !(curvature > 0.0 && curvature.is_finite()) {
            break;
        }
        let alpha = rho / curvature;
        add_scaled(&mut words, alpha, &direction, row);
        add_scaled(&mut residual, -alpha, &image, row);
        preconditioner.solve(&residual, &mut steered, &mut image);
        let next = inner(&residual, &steered, row);
        let beta = next / rho;
        scale_and_add(&mut direction, beta, &steered, row);
        out.push(alpha, beta);
        rho = next;
        relative = (rho.max(0.0) / start).sqrt();
        iterations += 1;
        progress(iterations, relative);
    }
    Solution { words, iterations, residual: relative, lanczos: (out.diagonal, out.off_diagonal) }
}

/// Sum in fixed groups (one row of corners each), added in order.
fn inner(a: &[CornerWords], b: &[CornerWords], row: usize) -> f64 {
    let product = |(a, b): (&[CornerWords], &[CornerWords])| -> f64 {
        let mut sums = [0.0; 9];
        for (a, b) in a.iter().zip(b) {
            for index in 0..9 {
                sums[index] += a[index] * b[index];
            }
        }
        sums.iter().sum()
    };
    let rows: Vec<f64> = a.par_chunks(row).zip(b.par_chunks(row)).map(product).collect();
    rows.iter().sum()
}

fn add_scaled(to: &mut [CornerWords], factor: f64, by: &[CornerWords], row: usize) {
    to.par_chunks_mut(row).zip(by.par_chunks(row)).for_each(|(to, by)| {
        for (to, by) in to.as_flattened_mut().iter_mut().zip(by.as_flattened()) {
            *to += factor * by;
        }
    });
}

fn scale_and_add(to: &mut [CornerWords], factor: f64, by: &[CornerWords], row: usize) {
    to.par_chunks_mut(row).zip(by.par_chunks(row)).for_each(|(to, by)| {
        for (to, by) in to.as_flattened_mut().iter_mut().zip(by.as_flattened()) {
            *to = by + factor * *to;
        }
    });
}

/// The tridiagonal matrix whose eigenvalues approach those of the preconditioned normal equations from inside.
#[derive(Default)]
struct Lanczos {
    diagonal: Vec<f64>,
    off_diagonal: Vec<f64>,
    last: Option<(f64, f64)>,
}

impl Lanczos {
    fn push(&mut self, alpha: f64, beta: f64) {
        let carried = self.last.map_or(0.0, |(alpha, beta)| beta / alpha);
        if let Some((alpha, beta)) = self.last {
            self.off_diagonal.push(beta.max(0.0).sqrt() / alpha);
        }
        self.diagonal.push(1.0 / alpha + carried);
        self.last = Some((alpha, beta));
    }
}
