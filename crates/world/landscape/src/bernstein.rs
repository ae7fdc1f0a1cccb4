//! Polynomials on `[0, 1]` in Bernstein form, and the first place where one reaches zero.
//!
//! The value lies within the range of the coefficients, and the number of roots is at most the number of sign
//! changes among them, of the same parity (Descartes): bounds that hold, where sampling would guess. `[f64; N]` is
//! a polynomial of degree `N - 1`: its coefficient k belongs to the place `k / (N - 1)`.

/// Degree of terrain along a straight line: 5 in u and 5 in v.
pub const DEGREE: usize = 10;

/// Terrain along a straight line.
pub type Coefficients = [f64; DEGREE + 1];

/// Bisections before two roots that are still not apart count as a touch: 2^-50 of the interval.
pub const DEPTH: u32 = 50;

/// The first place in `[0, 1]` where the polynomial is 0 or above.
pub fn first_reach<const N: usize>(coefficients: &[f64; N]) -> Option<f64> {
    search(coefficients, 0.0, 1.0, DEPTH)
}

fn search<const N: usize>(c: &[f64; N], low: f64, width: f64, depth: u32) -> Option<f64> {
    if c[0] >= 0.0 {
        return Some(low);
    }
    match sign_changes(c) {
        0 => None,
        1 if c[N - 1] > 0.0 => Some(low + width * only_root(c)),
        _ if depth == 0 => Some(low),
        _ => {
            let (left, right) = halves(c);
            let half = 0.5 * width;
            search(&left, low, half, depth - 1).or_else(|| search(&right, low + half, half, depth - 1))
        }
    }
}

/// Changes of sign, zeros passed over.
fn sign_changes(c: &[f64]) -> usize {
    let mut positive = c[0] > 0.0;
    let mut changes = 0;
    for &value in &c[1..] {
        if value != 0.0 && (value > 0.0) != positive {
            positive = !positive;
            changes += 1;
        }
    }
    changes
}

/// De Casteljau's cut in the middle.
pub fn halves<const N: usize>(c: &[f64; N]) -> ([f64; N], [f64; N]) {
    let (mut left, mut right) = (*c, *c);
    for level in 1..N {
        for k in 0..N - level {
            right[k] = 0.5 * (right[k] + right[k + 1]);
        }
        left[level] = right[0];
    }
    (left, right)
}

/// The root of a polynomial that is below 0 at 0, above 0 at 1, and has one root between.
fn only_root<const N: usize>(c: &[f64; N]) -> f64 {
    bracketed_root(polygon_root(c), |at| [value(c, at), slope(c, at)])
}

/// The root between 0 and 1 of a function that is below 0 before it and above 0 behind it: Newton's steps from
/// `start`, kept in their bracket by bisection. The function gives value and derivative.
pub fn bracketed_root(start: f64, function: impl Fn(f64) -> [f64; 2]) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let mut at = start;
    for _ in 0..64 {
        let [here, slope] = function(at);
        if here < 0.0 {
            low = at
        } else {
            high = at
        }
        let newton = at - here / slope;
        let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
        if (next - at).abs() <= 1e-15 {
            return next;
        }
        at = next;
    }
    at
}

/// Where the control polygon first rises through zero: near the root, and at it for a straight line.
fn polygon_root<const N: usize>(c: &[f64; N]) -> f64 {
    let k = c.iter().position(|&value| value >= 0.0).unwrap_or(N - 1).max(1);
    (k as f64 - c[k] / (c[k] - c[k - 1])) / (N - 1) as f64
}

/// Returns the value of the polynomial at `x`.
pub fn value<const N: usize>(c: &[f64; N], x: f64) -> f64 {
    sum(N, x, |k| c[k])
}

/// Returns the derivative of the polynomial at `x`.
pub fn slope<const N: usize>(c: &[f64; N], x: f64) -> f64 {
    (N - 1) as f64 * sum(N - 1, x, |k| c[k + 1] - c[k])
}

fn sum(terms: usize, x: f64, coefficient: impl Fn(usize) -> f64) -> f64 {
    let (rest, degree) = (1.0 - x, (terms - 1) as f64);
    let (mut power, mut binomial, mut sum) = (1.0, 1.0, coefficient(0));
    for k in 1..terms {
        power *= x;
        binomial *= (degree - k as f64 + 1.0) / k as f64;
        sum = sum * rest + power * binomial * coefficient(k);
    }
    sum
}

/// Product; `P` is `A + B - 1`.
pub fn product<const A: usize, const B: usize, const P: usize>(a: &[f64; A], b: &[f64; B]) -> [f64; P] {
    let [by_a, by_b, by_p] = [A, B, P].map(binomials);
    let mut product = [0.0; P];
    for i in 0..A {
        for j in 0..B {
            product[i + j] += by_a[i] * a[i] * by_b[j] * b[j];
        }
    }
    std::array::from_fn(|k| product[k] / by_p[k])
}

/// Binomial coefficients of degree `terms - 1`, at most 15.
fn binomials(terms: usize) -> [f64; 16] {
    let mut row = [0.0; 16];
    row[0] = 1.0;
    for k in 1..terms {
        row[k] = row[k - 1] * (terms - k) as f64 / k as f64;
    }
    row
}

#[cfg(test)]
mod tests {
    use super::{Coefficients, DEGREE, first_reach, halves, product, slope, value};
    use proptest::prelude::*;

    /// Coefficients of `scale * prod (x - roots)`, raised to degree 10 by factors of 1.
    fn from_roots(roots: &[f64], scale: f64) -> Coefficients {
        let mut c = [0.0; DEGREE + 1];
        c[0] = scale;
        for degree in 1..=DEGREE {
            let [at_0, at_1] = roots.get(degree - 1).map_or([1.0, 1.0], |root| [-root, 1.0 - root]);
            let old = c;
            for k in 0..=degree {
                let share = k as f64 / degree as f64;
                let below = if k > 0 { share * at_1 * old[k - 1] } else { 0.0 };
                c[k] = below + (1.0 - share) * at_0 * old[k];
            }
        }
        c
    }

    #[test]
    fn values_of_a_product() {
        let c = from_roots(&[0.25, 0.5, 2.0], 3.0);
        for x in [0.0, 0.1, 0.5, 0.9, 1.0] {
            let expected = 3.0 * (x - 0.25) * (x - 0.5) * (x - 2.0);
            assert!((value(&c, x) - expected).abs() < 1e-14, "{x}");
        }
        let (left, right) = halves(&c);
        assert!((value(&left, 0.4) - value(&c, 0.2)).abs() < 1e-14);
        assert!((value(&right, 0.4) - value(&c, 0.7)).abs() < 1e-14);
    }

    #[test]
    fn products_and_slopes() {
        let (a, b) = ([1.0, -2.0, 0.5], [0.25, 3.0, -1.0, 2.0]);
        let p: [f64; 6] = product(&a, &b);
        for x in [0.0, 0.3, 0.8, 1.0] {
            assert!((value(&p, x) - value(&a, x) * value(&b, x)).abs() < 1e-14);
            let by_difference = (value(&p, x + 1e-6) - value(&p, x - 1e-6)) / 2e-6;
            assert!((slope(&p, x) - by_difference).abs() < 1e-8);
        }
    }

    #[test]
    fn touches_and_near_misses() {
        // -(x - 0.4)^2 touches zero; lowered it does not; raised it crosses sqrt(1e-6) before.
        let touch = from_roots(&[0.4, 0.4], -1.0);
        let shifted = |by: f64| touch.map(|value| value + by);
        assert!((first_reach(&shifted(1e-16)).unwrap() - 0.4).abs() < 1e-7);
        assert_eq!(first_reach(&shifted(-1e-12)), None);
        assert!((first_reach(&shifted(1e-6)).unwrap() - 0.399).abs() < 1e-12);
    }

    #[test]
    fn ends_and_flats() {
        assert_eq!(first_reach(&[0.0; DEGREE + 1]), Some(0.0));
        assert_eq!(first_reach(&[-1.0; DEGREE + 1]), None);
        assert_eq!(first_reach(&[1.0; DEGREE + 1]), Some(0.0));
        let line = from_roots(&[0.7], 1.0);
        assert!((first_reach(&line).unwrap() - 0.7).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn the_first_of_many_roots(mut roots in proptest::collection::vec(0.01..1.5f64, 1..=DEGREE)) {
            roots.sort_by(f64::total_cmp);
            let apart = roots.windows(2).all(|pair| pair[1] - pair[0] > 0.03);
            prop_assume!(apart);
            let sign = if roots.len() % 2 == 0 { -1.0 } else { 1.0 };
            let found = first_reach(&from_roots(&roots, sign));
            match roots[0] < 1.0 {
                true => prop_assert!((found.unwrap() - roots[0]).abs() < 1e-6, "{:?} {:?}", found, roots),
                false => prop_assert_eq!(found, None),
            }
        }
    }
}
