//! The sphere of the mean lunar radius, to which all heights refer (section 15.4).

/// Mean lunar radius (m).
pub const LUNOID_RADIUS: f64 = 1_737_400.0;

/// How far the lunoid has dropped below its tangent plane at ground range `s` (m): `s^2 / 2R`.
pub fn parabolic_drop(s: f64) -> f64 {
    s * s / (2.0 * LUNOID_RADIUS)
}

#[cfg(test)]
mod tests {
    use super::parabolic_drop;

    #[test]
    fn check_values_of_23_5() {
        assert!((parabolic_drop(2380.0) - 1.63013698630137).abs() < 1e-13);
        assert!((parabolic_drop(40_000.0) - 460.4581558650858).abs() < 1e-10);
    }
}
