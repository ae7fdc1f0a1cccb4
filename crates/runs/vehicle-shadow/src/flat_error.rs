//! What taking the ground as flat costs (section 19.7).

/// Angle (rad) between the lines of sight to the edge of a shadow where flat ground has it and where it is: the
/// vehicle's top at height `top`, the view port at `eye`, the edge at `distance` on flat ground, which in truth lies
/// `rise` higher where the ray meets it (all m, or all in one unit).
///
/// The ray through the top comes down to the height z = `rise` at the distance `d (1 - z / Hv)`.
pub fn flat_error(top: f64, eye: f64, rise: f64, distance: f64) -> f64 {
    let (nearer, lower) = ((1.0 - rise / top) * distance, eye - rise);
    let sine = distance * rise * (1.0 - eye / top);
    let cosine = eye * lower + distance * nearer;
    libm::atan2(sine.abs(), cosine)
}

/// The same for small angles, `z (1 - h / Hv) / d`: the report's 1/20 rad.
pub fn small_flat_error(top: f64, eye: f64, rise: f64, distance: f64) -> f64 {
    (rise * (1.0 - eye / top) / distance).abs()
}

#[cfg(test)]
mod tests {
    use super::{flat_error, small_flat_error};

    #[test]
    fn check_values_of_23_6() {
        for (z, d, expected) in [
            (2.0, 20.0, 0.05963071313116939),
            (-2.0, 20.0, 0.03881544608146369),
            (2.0, 100.0, 0.01247595903028127),
        ] {
            assert!((flat_error(10.0, 5.0, z, d) - expected).abs() < 1e-16, "{z} {d}");
        }
    }

    /// The report's worked example is the small-angle value.
    #[test]
    fn the_worked_example_is_one_in_twenty() {
        assert_eq!(small_flat_error(10.0, 5.0, 2.0, 20.0), 1.0 / 20.0);
        assert_eq!((1.0 / flat_error(10.0, 5.0, 2.0, 20.0)).round(), 17.0);
    }

    #[test]
    fn there_is_none_at_the_height_of_the_top_or_on_flat_ground() {
        assert_eq!(flat_error(10.0, 10.0, 2.0, 20.0), 0.0);
        assert_eq!(flat_error(10.0, 5.0, 0.0, 20.0), 0.0);
    }
}
