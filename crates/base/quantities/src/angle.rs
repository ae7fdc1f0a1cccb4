//! Angles are radians inside; degrees exist only where a file or a person is met.

use std::f64::consts::PI;

/// Radians of an angle given in degrees.
pub fn radians(degrees: f64) -> f64 {
    degrees * (PI / 180.0)
}

/// Degrees of an angle given in radians.
pub fn degrees(radians: f64) -> f64 {
    radians * (180.0 / PI)
}

/// Sine and cosine of `angle` (radians), exact at multiples of a quarter turn given in degrees.
///
/// `cos(90 deg)` in floating point is 6e-17, not 0. A sweep along an axis must not drift towards the other
/// pair of limit stops, so values within 2e-16 of 0 are taken as 0 (our choice).
pub fn sin_cos(angle: f64) -> (f64, f64) {
    let clean = |v: f64| if v.abs() < 2e-16 { 0.0 } else { v };
    (clean(libm::sin(angle)), clean(libm::cos(angle)))
}

/// The same direction in `[0, 2 pi)`.
pub fn wrap_heading(angle: f64) -> f64 {
    let turn = 2.0 * PI;
    let wrapped = angle - turn * (angle / turn).floor();
    if wrapped < turn { wrapped } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{degrees, radians, sin_cos, wrap_heading};

    #[test]
    fn quarter_turns_are_exact() {
        assert_eq!(sin_cos(radians(90.0)), (1.0, 0.0));
        assert_eq!(sin_cos(radians(180.0)), (0.0, -1.0));
        assert_eq!(sin_cos(radians(-90.0)), (-1.0, 0.0));
    }

    #[test]
    fn headings_wrap_into_one_turn() {
        assert!((degrees(wrap_heading(radians(-30.0))) - 330.0).abs() < 1e-12);
        assert_eq!(wrap_heading(-1e-300), 0.0);
    }
}
