//! Estimates of how well the samples determine the words.

use landscape::CornerWords;

use super::axis::Axis;
use super::precondition::{AxisFactor, region_matrix};
use super::roughness::AxisMatrix;

/// Steps of the power iterations; the estimate is from below and within some percent after these.
const STEPS: usize = 60;

/// Condition of the normal matrix of one axis without voids, each word scaled to unit diagonal.
pub fn of_grid(axis: &Axis, roughness: &AxisMatrix, factor: &AxisFactor) -> f64 {
    let scale = diagonal(axis, roughness);
    let largest = power(&scale, |v| {
        divide(v, &scale);
        let image = multiply(axis, roughness, v);
        v.copy_from_slice(&image);
        divide(v, &scale);
    });
    let inverse_of_smallest = power(&scale, |v| {
        scale_by(v, &scale);
        factor.solve_row(v);
        scale_by(v, &scale);
    });
    largest * inverse_of_smallest
}

/// Root of the diagonal, in words 0..3 of each corner.
fn diagonal(axis: &Axis, roughness: &AxisMatrix) -> Vec<CornerWords> {
    let mut sums = vec![[0.0; 9]; axis.regions() + 1];
    for region in 0..axis.regions() {
        let matrix = region_matrix(axis, region, roughness);
        for a in 0..6 {
            sums[region + a / 3][a % 3] += matrix[a][a];
        }
    }
    sums.iter().map(|words| words.map(f64::sqrt)).collect()
}

fn multiply(axis: &Axis, roughness: &AxisMatrix, v: &[CornerWords]) -> Vec<CornerWords> {
    let mut out = vec![[0.0; 9]; v.len()];
    for region in 0..axis.regions() {
        let matrix = region_matrix(axis, region, roughness);
        for (a, b) in (0..36).map(|i| (i / 6, i % 6)) {
            out[region + a / 3][a % 3] += matrix[a][b] * v[region + b / 3][b % 3];
        }
    }
    out
}

fn divide(v: &mut [CornerWords], by: &[CornerWords]) {
    v.iter_mut().zip(by).for_each(|(v, by)| (0..3).for_each(|i| v[i] /= by[i].max(f64::MIN_POSITIVE)));
}

fn scale_by(v: &mut [CornerWords], by: &[CornerWords]) {
    v.iter_mut().zip(by).for_each(|(v, by)| (0..3).for_each(|i| v[i] *= by[i]));
}

/// Growth of a vector under repeated application of a positive operator.
fn power(like: &[CornerWords], apply: impl Fn(&mut [CornerWords])) -> f64 {
    let word = |n: usize, i: usize| quantities::unit_interval(1, &[n as u64, i as u64]) - 0.5;
    let mut v: Vec<CornerWords> =
        (0..like.len()).map(|n| std::array::from_fn(|i| if i < 3 { word(n, i) } else { 0.0 })).collect();
    let mut growth = 1.0;
    for _ in 0..STEPS {
        let norm = v.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
        v.iter_mut().flatten().for_each(|x| *x /= norm);
        apply(&mut v);
        growth = v.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
    }
    growth
}

/// Largest over smallest eigenvalue of a symmetric tridiagonal matrix, by bisection; 1 for an empty one.
pub fn of_lanczos((diagonal, off_diagonal): &(Vec<f64>, Vec<f64>)) -> f64 {
    let size = diagonal.len();
    if size == 0 {
        return 1.0;
    }
    let reach = |i: usize| {
        let left = if i > 0 { off_diagonal[i - 1].abs() } else { 0.0 };
        diagonal[i] + left + off_diagonal.get(i).map_or(0.0, |v| v.abs())
    };
    let top = (0..size).map(reach).fold(0.0, f64::max);
    let bisect = |wanted: usize| {
        let (mut low, mut high) = (0.0, top);
        for _ in 0..200 {
            // Geometric steps where possible: the smallest eigenvalue may lie many decades down.
            let middle = if low > 0.0 { (low * high).sqrt() } else { high * 1e-3 };
            if low == 0.0 && middle < top * 1e-30 {
                break;
            }
            if count_below(diagonal, off_diagonal, middle) >= wanted { high = middle } else { low = middle }
        }
        high
    };
    bisect(size) / bisect(1)
}

/// Eigenvalues below `x` (Sturm's count).
fn count_below(diagonal: &[f64], off_diagonal: &[f64], x: f64) -> usize {
    let (mut count, mut pivot) = (0, 1.0);
    for (i, d) in diagonal.iter().enumerate() {
        let coupling = if i > 0 { off_diagonal[i - 1] * off_diagonal[i - 1] / pivot } else { 0.0 };
        pivot = d - x - coupling;
        if pivot == 0.0 {
            pivot = f64::MIN_POSITIVE;
        }
        count += usize::from(pivot < 0.0);
    }
    count
}

#[cfg(test)]
mod tests {
    use super::{of_grid, of_lanczos};
    use crate::fit::axis::Axis;
    use crate::fit::precondition::AxisFactor;
    use crate::fit::roughness::axis_matrix;

    #[test]
    fn condition_of_the_second_difference() {
        // Eigenvalues 2 - 2 cos(k pi / (n + 1)).
        let n = 50;
        let found = of_lanczos(&(vec![2.0; n], vec![-1.0; n - 1]));
        let angle = std::f64::consts::PI / (n + 1) as f64;
        let expected = (1.0 + libm::cos(angle)) / (1.0 - libm::cos(angle));
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }

    #[test]
    fn a_small_eigenvalue_is_found() {
        let found = of_lanczos(&(vec![1.0, 1e-12, 3.0], vec![0.0, 0.0]));
        assert!((found / 3e12 - 1.0).abs() < 1e-9, "{found}");
    }

    #[test]
    fn a_dense_axis_has_the_condition_of_the_quintic_element() {
        let axis = Axis::new(40, 10.0, 0.0, 0.25, 1601);
        let bend = axis_matrix(2).map(|row| row.map(|v| 1e-9 * v));
        let factor = AxisFactor::new(&axis, &bend);
        let found = of_grid(&axis, &bend, &factor);
        assert!((100.0..1000.0).contains(&found), "{found}");
    }
}
