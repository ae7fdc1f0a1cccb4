//! Sums of two doubles: some 106 bits, for a reference that f64 is held against.

use std::ops::{Add, Mul, Sub};

/// `high + low`, `low` at most half a unit in the last place of `high`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// `a / b`, its quotient and what that leaves.
    pub fn ratio(a: f64, b: f64) -> Self {
        let high = a / b;
        joined(high, libm::fma(-high, b, a) / b)
    }

    /// Returns the nearest f64 of the sum.
    pub fn to_f64(self) -> f64 {
        self.high + self.low
    }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let high = self.high + other.high;
        let of_other = high - self.high;
        let lost = (self.high - (high - of_other)) + (other.high - of_other);
        joined(high, lost + self.low + other.low)
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self { high: -other.high, low: -other.low }
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let lost = libm::fma(self.high, other.high, -high);
        joined(high, lost + (self.high * other.low + self.low * other.high))
    }
}

/// The sum of a value and of one that is far smaller.
fn joined(high: f64, low: f64) -> Double {
    let sum = high + low;
    Double { high: sum, low: low - (sum - high) }
}

#[cfg(test)]
mod tests {
    use super::Double;

    #[test]
    fn products_keep_what_f64_drops() {
        let tiny = libm::ldexp(1.0, -40);
        let one = Double::from(1.0) + Double::from(tiny);
        // (1 + t)^2 - 1 - 2 t = t^2, of which f64 keeps nothing.
        let left = one * one - Double::from(1.0) - Double::from(2.0 * tiny);
        assert_eq!(left.to_f64(), tiny * tiny);
        assert_eq!((1.0 + tiny) * (1.0 + tiny) - 1.0 - 2.0 * tiny, 0.0);
    }

    #[test]
    fn a_third_three_times_is_one() {
        let third = Double::ratio(1.0, 3.0);
        assert!((third * Double::from(3.0) - Double::from(1.0)).to_f64().abs() < 1e-31);
    }
}
