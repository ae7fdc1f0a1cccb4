//! Truncated Taylor series in two variables: the algebra that differentiates a relief exactly.

use crate::{CornerWords, WORDS};
use std::ops::{Add, Mul, Sub};

/// Coefficients of `u^p v^q` for p, q in 0..=2, index `3 p + q`; higher powers of u or of v are dropped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Jet([f64; WORDS]);

/// p! q! for each word.
const FACTORIALS: [f64; WORDS] = [1.0, 1.0, 2.0, 1.0, 1.0, 2.0, 2.0, 2.0, 4.0];

impl Jet {
    /// The linear field `value + slopes[0] u + slopes[1] v`.
    pub fn linear(value: f64, slopes: [f64; 2]) -> Self {
        Self([value, slopes[1], 0.0, slopes[0], 0.0, 0.0, 0.0, 0.0, 0.0])
    }

    /// The field whose derivatives are `words`.
    pub fn from_words(words: &CornerWords) -> Self {
        Self(std::array::from_fn(|index| words[index] / FACTORIALS[index]))
    }

    /// Adds the field's derivatives to `words`.
    pub fn add_to(&self, words: &mut CornerWords) {
        for index in 0..WORDS {
            words[index] += self.0[index] * FACTORIALS[index];
        }
    }

    /// The field's value at the corner.
    pub fn value(&self) -> f64 {
        self.0[0]
    }

    /// `factor` times the field.
    pub fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|c| c * factor))
    }

    /// The field with `offset` added.
    pub fn plus(mut self, offset: f64) -> Self {
        self.0[0] += offset;
        self
    }

    /// `f(field)`, of the Taylor coefficients of f at [`value`](Self::value).
    ///
    /// Five suffice: without its constant the field has no fifth power of total degree within u^2 v^2.
    pub fn compose(self, taylor: [f64; 5]) -> Self {
        let rest = self.plus(-self.value());
        let [c0, c1, c2, c3, c4] = taylor;
        let inner = (rest.scaled(c4).plus(c3) * rest).plus(c2);
        ((inner * rest).plus(c1) * rest).plus(c0)
    }

    /// Returns the series of `exp(field)`.
    pub fn exp(self) -> Self {
        let e = libm::exp(self.value());
        self.compose([e, e, e / 2.0, e / 6.0, e / 24.0])
    }

    /// `sin(field)`, the field in radians.
    pub fn sin(self) -> Self {
        let (s, c) = libm::sincos(self.value());
        self.compose([s, c, -s / 2.0, -c / 6.0, s / 24.0])
    }

    /// Returns the series of the field squared.
    pub fn square(self) -> Self {
        self * self
    }
}

impl Add for Jet {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|index| self.0[index] + other.0[index]))
    }
}

impl Sub for Jet {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|index| self.0[index] - other.0[index]))
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut product = [0.0; WORDS];
        for (p, q) in (0..3).flat_map(|p| (0..3).map(move |q| (p, q))) {
            for (a, b) in (0..3 - p).flat_map(|a| (0..3 - q).map(move |b| (a, b))) {
                product[3 * (p + a) + q + b] += self.0[3 * p + q] * other.0[3 * a + b];
            }
        }
        Self(product)
    }
}

#[cfg(test)]
mod tests {
    use super::Jet;

    /// u and v at (0.3, -0.2).
    fn variables() -> (Jet, Jet) {
        (Jet::linear(0.3, [1.0, 0.0]), Jet::linear(-0.2, [0.0, 1.0]))
    }

    fn words(jet: Jet) -> [f64; 9] {
        let mut words = [0.0; 9];
        jet.add_to(&mut words);
        words
    }

    #[test]
    fn derivatives_of_a_separable_exponential() {
        // exp(2u - 3v) has derivatives 2^p (-3)^q times itself.
        let (u, v) = variables();
        let value = libm::exp(1.2);
        let found = words((u.scaled(2.0) - v.scaled(3.0)).exp());
        for (index, found) in found.into_iter().enumerate() {
            let expected = [1.0, 2.0, 4.0][index / 3] * [1.0, -3.0, 9.0][index % 3] * value;
            assert!((found - expected).abs() < 1e-12, "word {index}: {found} against {expected}");
        }
    }

    #[test]
    fn derivatives_of_a_sine_of_a_product() {
        // sin(uv): closed forms by hand, s = uv.
        let (u, v) = variables();
        let (s, c) = libm::sincos(-0.06);
        let (x, y) = (0.3, -0.2);
        let found = words((u * v).sin());
        let expected = [
            s,
            x * c,
            -x * x * s,
            y * c,
            c - x * y * s,
            -2.0 * x * s - x * x * y * c,
            -y * y * s,
            -2.0 * y * s - x * y * y * c,
            -2.0 * s - 4.0 * x * y * c + x * x * y * y * s,
        ];
        for index in 0..9 {
            assert!((found[index] - expected[index]).abs() < 1e-15, "word {index}");
        }
    }

    #[test]
    fn words_come_back() {
        let (u, v) = variables();
        let jet = (u * v + u).exp();
        assert_eq!(Jet::from_words(&words(jet)), jet);
    }
}
