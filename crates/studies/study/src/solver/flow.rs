//! Systems of ordinary differential equations, and one step of the methods that are held against the exact solution.

/// `y' = rate(t, y)`.
pub trait Flow<const N: usize> {
    /// The rate of every state.
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N];

    /// Derivative of the rate of state `i` with respect to state `j`, at `[i][j]`.
    fn jacobian(&self, t: f64, y: &[f64; N]) -> [[f64; N]; N];
}

/// Newton steps of an implicit method: the systems are linear, but for one product.
const NEWTON: usize = 3;

/// A step of the explicit Runge-Kutta method of order 4.
pub fn runge_kutta<const N: usize>(flow: &impl Flow<N>, t: f64, h: f64, y: &[f64; N]) -> [f64; N] {
    let first = flow.rate(t, y);
    let second = flow.rate(t + h / 2.0, &moved(y, h / 2.0, &first));
    let third = flow.rate(t + h / 2.0, &moved(y, h / 2.0, &second));
    let fourth = flow.rate(t + h, &moved(y, h, &third));
    std::array::from_fn(|i| y[i] + h / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]))
}

/// A step whose rate is taken by the share `late` at its end and by the rest at its start: 1 is backward Euler, 1/2 the
/// trapezoidal rule.
pub fn implicit<const N: usize>(flow: &impl Flow<N>, t: f64, h: f64, y: &[f64; N], late: f64) -> [f64; N] {
    let start = flow.rate(t, y);
    let known = moved(y, h * (1.0 - late), &start);
    let mut next = *y;
    for _ in 0..NEWTON {
        let rate = flow.rate(t + h, &next);
        let residual = std::array::from_fn(|i| next[i] - known[i] - h * late * rate[i]);
        let mut matrix = flow.jacobian(t + h, &next).map(|row| row.map(|entry| -h * late * entry));
        (0..N).for_each(|i| matrix[i][i] += 1.0);
        let change = solve(matrix, residual);
        next = std::array::from_fn(|i| next[i] - change[i]);
    }
    next
}

fn moved<const N: usize>(y: &[f64; N], h: f64, rate: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| y[i] + h * rate[i])
}

/// Gaussian elimination with the largest pivot of each column.
fn solve<const N: usize>(mut matrix: [[f64; N]; N], mut right: [f64; N]) -> [f64; N] {
    for column in 0..N {
        let larger = |&a: &usize, &b: &usize| matrix[a][column].abs().total_cmp(&matrix[b][column].abs());
        let pivot = (column..N).max_by(larger).unwrap_or(column);
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        for row in column + 1..N {
            let factor = matrix[row][column] / matrix[column][column];
            let above = matrix[column];
            (column..N).for_each(|k| matrix[row][k] -= factor * above[k]);
            right[row] -= factor * right[column];
        }
    }
    for row in (0..N).rev() {
        let known: f64 = (row + 1..N).map(|k| matrix[row][k] * right[k]).sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::{Flow, implicit, runge_kutta, solve};

    /// A pendulum: not linear, and its energy is known.
    struct Pendulum;

    impl Flow<2> for Pendulum {
        fn rate(&self, _: f64, &[angle, speed]: &[f64; 2]) -> [f64; 2] {
            [speed, -libm::sin(angle)]
        }
        fn jacobian(&self, _: f64, &[angle, _]: &[f64; 2]) -> [[f64; 2]; 2] {
            [[0.0, 1.0], [-libm::cos(angle), 0.0]]
        }
    }

    /// Speed at the bottom, dropped from a right angle: `sqrt 2`, a quarter of the period 7.416298709205487 later.
    fn off(steps: u32, step: impl Fn(f64, f64, &[f64; 2]) -> [f64; 2]) -> f64 {
        let (mut y, h) = ([std::f64::consts::FRAC_PI_2, 0.0], 7.416_298_709_205_487 / 4.0 / f64::from(steps));
        (0..steps).for_each(|k| y = step(f64::from(k) * h, h, &y));
        (y[1] + std::f64::consts::SQRT_2).abs() + y[0].abs()
    }

    #[test]
    fn methods_have_their_orders() {
        type Method<'a> = &'a dyn Fn(f64, f64, &[f64; 2]) -> [f64; 2];
        let order = |method: Method<'_>| libm::log2(off(64, method) / off(128, method));
        let explicit = order(&|t, h, y| runge_kutta(&Pendulum, t, h, y));
        let trapezoidal = order(&|t, h, y| implicit(&Pendulum, t, h, y, 0.5));
        let backward = order(&|t, h, y| implicit(&Pendulum, t, h, y, 1.0));
        assert!((explicit - 4.0).abs() < 0.1, "{explicit}");
        assert!((trapezoidal - 2.0).abs() < 0.05, "{trapezoidal}");
        assert!((backward - 1.0).abs() < 0.05, "{backward}");
    }

    #[test]
    fn equations_are_solved_with_a_zero_on_the_diagonal() {
        let found = solve([[0.0, 2.0, 1.0], [1.0, 0.0, 0.0], [3.0, 1.0, -1.0]], [7.0, 1.0, 2.0]);
        assert_eq!(found.map(f64::round), [1.0, 2.0, 3.0]);
    }
}
