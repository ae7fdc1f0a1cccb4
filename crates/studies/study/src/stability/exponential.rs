//! The exponential of a matrix: what a linear system does over a time, however stiff it is.

/// Terms of the series: a norm of 1/2 leaves less than a rounding.
const TERMS: u32 = 16;

/// `e^matrix - 1`, by the series of `matrix / 2^k` and k squarings. The identity is left out, so that slow modes beside
/// fast ones keep their digits.
pub fn exponential_less_one<const N: usize>(matrix: &[[f64; N]; N]) -> [[f64; N]; N] {
    let norm = matrix.iter().map(|row| row.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max);
    // Norm = share 2^exponent with a share of 1/2 to 1: so many halvings make it a half at most.
    let squarings = (libm::frexp(norm).1 + 1).max(0);
    let part = matrix.map(|row| row.map(|entry| libm::scalbn(entry, -squarings)));
    let (mut term, mut sum) = (part, part);
    for n in 2..=TERMS {
        term = product(&term, &part).map(|row| row.map(|entry| entry / f64::from(n)));
        sum = added(&sum, &term);
    }
    for _ in 0..squarings {
        sum = added(&added(&sum, &sum), &product(&sum, &sum));
    }
    sum
}

fn product<const N: usize>(a: &[[f64; N]; N], b: &[[f64; N]; N]) -> [[f64; N]; N] {
    a.map(|row| std::array::from_fn(|column| (0..N).map(|k| row[k] * b[k][column]).sum()))
}

fn added<const N: usize>(a: &[[f64; N]; N], b: &[[f64; N]; N]) -> [[f64; N]; N] {
    std::array::from_fn(|row| std::array::from_fn(|column| a[row][column] + b[row][column]))
}

#[cfg(test)]
mod tests {
    use super::exponential_less_one;

    #[test]
    fn a_turn_of_any_angle_is_a_rotation() {
        for angle in [0.0, 1e-6, 0.3, 2.0, 1e3, 1e6] {
            let [[cos, sin], [minus, same]] = exponential_less_one(&[[0.0, angle], [-angle, 0.0]]);
            let off = [cos + 1.0 - libm::cos(angle), sin - libm::sin(angle), minus + sin, same - cos];
            assert!(off.iter().all(|off| off.abs() < 1e-15 * (1.0 + angle)), "{angle}: {off:?}");
        }
    }

    /// Poles damped a million times critically: after the fast mode of 2e6 has gone, the slow one has moved by 5e-7.
    #[test]
    fn a_slow_mode_beside_a_fast_one_keeps_its_digits() {
        let damping = 1e6;
        let found = exponential_less_one(&[[0.0, 1.0], [-1.0, -2.0 * damping]]);
        let moved = libm::expm1(-0.5 / damping) + 0.25 / (damping * damping);
        assert!((found[0][0] - moved).abs() < 1e-9 * moved.abs(), "{:e} {moved:e}", found[0][0]);
    }
}
