//! The sphere of the mean lunar radius, to which all heights refer (section 15.4).

/// Mean lunar radius (m).
pub const LUNOID_RADIUS: f64 = 1_737_400.0;

/// By how much radii of one body may differ, as a share. Chosen: that of the Moon is known to less.
const SAME_BODY: f64 = 1e-3;

/// Whether two radii (m) are those of one body.
pub fn is_same_body(one: f64, other: f64) -> bool {
    (one - other).abs() <= SAME_BODY * other
}

/// How far the lunoid has dropped below its tangent plane at ground range `s` (m): `s^2 / 2R`.
#[inline]
pub fn parabolic_drop(s: f64) -> f64 {
    s * s / (2.0 * LUNOID_RADIUS)
}

/// How far the sphere itself has dropped below its tangent plane at ground range `s` (m), measured along that plane:
/// `R - sqrt(R^2 - s^2)`, in a form that keeps its digits near the eye. The sphere ends at `s = R`, where it has dropped by
/// R; beyond, `s^2 / R` keeps numbers finite and falling, and no ground is seen there.
#[inline]
pub fn spherical_drop(s: f64) -> f64 {
    let square = s * s;
    square / (LUNOID_RADIUS + (LUNOID_RADIUS * LUNOID_RADIUS - square).max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::{LUNOID_RADIUS, parabolic_drop, spherical_drop};

    #[test]
    fn check_values_of_23_5() {
        assert!((parabolic_drop(2380.0) - 1.63013698630137).abs() < 1e-13);
        assert!((parabolic_drop(40_000.0) - 460.4581558650858).abs() < 1e-10);
    }

    /// A right triangle of whole numbers: 3, 4, 5.
    #[test]
    fn the_sphere_in_closed_form() {
        let fifth = LUNOID_RADIUS / 5.0;
        assert!((spherical_drop(3.0 * fifth) - fifth).abs() < 1e-9);
        assert!((spherical_drop(4.0 * fifth) - 2.0 * fifth).abs() < 1e-9);
        assert_eq!([0.0, LUNOID_RADIUS].map(spherical_drop), [0.0, LUNOID_RADIUS]);
        assert!(spherical_drop(2.0 * LUNOID_RADIUS) > LUNOID_RADIUS);
    }

    /// The series of the square root: s^2 / 2R + s^4 / 8R^3 + s^6 / 16R^5.
    #[test]
    fn the_sphere_drops_by_the_next_term_more_than_the_parabola() {
        for s in [1.0, 1e3, 4e4, 2e5] {
            let share = (s / LUNOID_RADIUS) * (s / LUNOID_RADIUS);
            let next = s * s * share / (8.0 * LUNOID_RADIUS);
            let found = spherical_drop(s) - parabolic_drop(s);
            assert!(
                (found - next).abs() <= next * share + 1e-15 * parabolic_drop(s),
                "{s}: {found}, not {next}"
            );
        }
    }
}
