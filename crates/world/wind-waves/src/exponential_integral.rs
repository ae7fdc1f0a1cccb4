//! The exponential integral E1.

/// The constant of Euler.
const EULER: f64 = 0.577_215_664_901_532_9;

/// Below this the series converges fast, above it the continued fraction (chosen).
const SWITCH: f64 = 1.5;

/// Levels of the continued fraction (chosen): rounding from 1.5 on.
const LEVELS: u32 = 60;

/// `E1(x)`, the integral of `exp(-t) / t` from x, above 0, to infinity; good to 1e-14 of itself.
///
/// Series 5.1.11 and continued fraction 5.1.22 of Abramowitz and Stegun, Handbook of Mathematical Functions.
pub fn exponential_integral(x: f64) -> f64 {
    if x > SWITCH {
        let fraction = (1..=LEVELS).rev().fold(x, |below, level| {
            let level = f64::from(level);
            x + level / (1.0 + level / below)
        });
        return libm::exp(-x) / fraction;
    }
    let (mut term, mut sum, mut order) = (1.0, 0.0, 1.0);
    while f64::abs(term) > 1e-18 {
        term *= -x / order;
        sum -= term / order;
        order += 1.0;
    }
    sum - EULER - libm::log(x)
}
