//! Quintic Hermite basis of the Lagrange 2-2 polynomial (report III.A.1; derivatives corrected).
//!
//! `g_ip` has r-th derivative 1 at `z = i` for `r = p` and 0 for the other r in 0..=2 and at the other end.
//! Six values are always ordered `[g00, g01, g02, g10, g11, g12]`, index `3 i + p`.

use signal::Number;

/// Coefficients of `g_0p(z)`, `p` = 0, 1, 2, ascending powers of z: the three kinds of function generator.
pub const NEAR: [[f64; 6]; 3] =
    [[1.0, 0.0, 0.0, -10.0, 15.0, -6.0], [0.0, 1.0, 0.0, -6.0, 8.0, -3.0], [0.0, 0.0, 0.5, -1.5, 1.5, -0.5]];

/// Coefficients of `g_1p(z)`, ascending powers of z.
pub const FAR: [[f64; 6]; 3] =
    [[0.0, 0.0, 0.0, 10.0, -15.0, 6.0], [0.0, 0.0, 0.0, -4.0, 7.0, -3.0], [0.0, 0.0, 0.0, 0.5, -1.0, 0.5]];

/// `g_ip(z)`, in factored form, which keeps full relative precision near both ends.
#[inline(always)]
pub fn values<T: Number>(z: T) -> [T; 6] {
    let k = |value| z.like(value);
    let w = k(1.0) - z;
    let (z2, w2) = (z * z, w * w);
    let (z3, w3) = (z2 * z, w2 * w);
    [
        w3 * (k(1.0) + z * (k(3.0) + k(6.0) * z)),
        z * w3 * (k(1.0) + k(3.0) * z),
        k(0.5) * z2 * w3,
        z3 * (k(10.0) + z * (k(-15.0) + k(6.0) * z)),
        z3 * w * (k(3.0) * z - k(4.0)),
        k(0.5) * z3 * w2,
    ]
}

/// `d g_ip / dz`. Four of the six printed in III.C.3 are wrong; these follow from [`values`].
#[inline(always)]
pub fn derivatives<T: Number>(z: T) -> [T; 6] {
    let k = |value| z.like(value);
    let w = k(1.0) - z;
    let (z2, w2) = (z * z, w * w);
    [
        k(-30.0) * z2 * w2,
        w2 * (k(1.0) - k(3.0) * z) * (k(1.0) + k(5.0) * z),
        k(0.5) * z * w2 * (k(2.0) - k(5.0) * z),
        k(30.0) * z2 * w2,
        -z2 * (k(2.0) - k(3.0) * z) * (k(6.0) - k(5.0) * z),
        k(0.5) * z2 * w * (k(3.0) - k(5.0) * z),
    ]
}

/// `d^2 g_ip / dz^2`.
pub fn second_derivatives(z: f64) -> [f64; 6] {
    let w = 1.0 - z;
    [
        -60.0 * z * w * (1.0 - 2.0 * z),
        -12.0 * z * w * (3.0 - 5.0 * z),
        w * (1.0 + z * (-8.0 + 10.0 * z)),
        60.0 * z * w * (1.0 - 2.0 * z),
        12.0 * z * w * (5.0 * z - 2.0),
        z * (3.0 + z * (-12.0 + 10.0 * z)),
    ]
}

#[cfg(test)]
mod tests {
    use super::{FAR, NEAR, derivatives, second_derivatives, values};

    /// Check values of table 23.1: z, the six values, the six derivatives.
    const TABLE: [(f64, [f64; 6], [f64; 6]); 3] = [
        (
            0.25,
            [0.896484375, 0.1845703125, 0.01318359375, 0.103515625, -0.0380859375, 0.00439453125],
            [-1.0546875, 0.31640625, 0.052734375, 1.0546875, -0.37109375, 0.041015625],
        ),
        (
            0.7,
            [0.16308, 0.05859, 0.006615, 0.83692, -0.19551, 0.015435],
            [-1.323, -0.4455, -0.04725, 1.323, 0.1225, -0.03675],
        ),
        (
            0.001,
            [0.999999990014994, 9.99994007997e-4, 4.985014995e-7, 9.985006e-9, -3.993003e-9, 4.990005e-10],
            [-2.994003e-5, 0.999982031985, 9.955059975e-4, 2.994003e-5, -1.1972015e-5, 1.4960025e-6],
        ),
    ];

    #[test]
    fn check_table_23_1() {
        for (z, expected, slopes) in TABLE {
            for i in 0..6 {
                let error = (values(z)[i] - expected[i]).abs() / expected[i].abs();
                assert!(error < 1e-13, "g[{i}]({z}) = {}", values(z)[i]);
                let error = (derivatives(z)[i] - slopes[i]).abs() / slopes[i].abs();
                assert!(error < 1e-13, "g'[{i}]({z}) = {}", derivatives(z)[i]);
            }
        }
    }

    #[test]
    fn kronecker_property_at_both_ends() {
        for (end, z) in [0.0, 1.0].into_iter().enumerate() {
            let by_order = [values(z), derivatives(z), second_derivatives(z)];
            for (r, found) in by_order.iter().enumerate() {
                for (index, &value) in found.iter().enumerate() {
                    let expected = f64::from(u8::from(index == 3 * end + r));
                    assert_eq!(value, expected, "derivative {r} of g[{index}] at {z}");
                }
            }
        }
    }

    #[test]
    fn monomials_agree_with_the_factored_form() {
        for step in 0..=64 {
            let z = f64::from(step) / 64.0;
            for p in 0..3 {
                let horner = |c: &[f64; 6]| c.iter().rev().fold(0.0, |sum, &k| sum * z + k);
                assert!((horner(&NEAR[p]) - values(z)[p]).abs() < 1e-14);
                assert!((horner(&FAR[p]) - values(z)[3 + p]).abs() < 1e-14);
            }
        }
    }
}
