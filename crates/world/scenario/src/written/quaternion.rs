//! Quaternions of attitudes.
//!
//! A quaternion, scalar last, turns vehicle axes (forward, starboard, down) into terrain axes (north, east, down):
//! `v_terrain = q v_vehicle q*`.

/// How far the length of a quaternion may be from 1: recorders write a few digits.
const LENGTH_TOLERANCE: f64 = 1e-2;

/// Heading, pitch and roll (rad) of the quaternion `[x, y, z, w]`.
///
/// # Errors
/// Its length, if that is further from 1 than one part in a hundred.
pub(super) fn angles(parts: [f64; 4]) -> Result<[f64; 3], f64> {
    let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
    if (length - 1.0).abs() > LENGTH_TOLERANCE {
        return Err(length);
    }
    Ok(unit_angles(parts.map(|part| part / length)))
}

/// Heading, pitch, roll (rad) of a unit quaternion, from the elements of `R = Phi Theta Psi`.
fn unit_angles([x, y, z, w]: [f64; 4]) -> [f64; 3] {
    let heading = libm::atan2(2.0 * (x * y + w * z), 1.0 - 2.0 * (y * y + z * z));
    let pitch = libm::asin((2.0 * (w * y - x * z)).clamp(-1.0, 1.0));
    let roll = libm::atan2(2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y));
    [heading, pitch, roll]
}

#[cfg(test)]
mod tests {
    use super::{angles, unit_angles};
    use landscape::Attitude;
    use quantities::{degrees, radians};

    /// Matrix of a unit quaternion, vehicle to terrain, by the textbook formula for `q v q*`.
    fn matrix([x, y, z, w]: [f64; 4]) -> [[f64; 3]; 3] {
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    }

    #[test]
    fn quarter_turns() {
        let half = 0.5f64.sqrt();
        let quarter = radians(90.0);
        assert!((unit_angles([0.0, 0.0, half, half])[0] - quarter).abs() < 1e-12, "a turn to starboard");
        assert!((unit_angles([half, 0.0, 0.0, half])[2] - quarter).abs() < 1e-12, "starboard down");
        let up = unit_angles([0.0, libm::sin(radians(15.0)), 0.0, libm::cos(radians(15.0))]);
        assert!((up[1] - radians(30.0)).abs() < 1e-12, "nose up");
    }

    /// The conversion that `docs/scenario-format.md` gives for east-north-up worlds.
    #[test]
    fn east_north_up_is_converted() {
        let converted = |[x, y, z, w]: [f64; 4]| {
            unit_angles([x + y, x - y, w - z, w + z].map(|part| part * 0.5f64.sqrt())).map(degrees)
        };
        let (sin, cos) = (libm::sin(radians(10.0)), libm::cos(radians(10.0)));
        // Along x, east; 20 degrees to port; 20 degrees nose up, about minus port; 20 degrees starboard down.
        let cases = [
            ([0.0, 0.0, 0.0, 1.0], [90.0, 0.0, 0.0]),
            ([0.0, 0.0, sin, cos], [70.0, 0.0, 0.0]),
            ([0.0, -sin, 0.0, cos], [90.0, 20.0, 0.0]),
            ([sin, 0.0, 0.0, cos], [90.0, 0.0, 20.0]),
        ];
        for (quaternion, expected) in cases {
            let found = converted(quaternion);
            assert!((0..3).all(|i| (found[i] - expected[i]).abs() < 1e-9), "{found:?} {expected:?}");
        }
    }

    #[test]
    fn the_matrix_is_that_of_section_4() {
        let parts = [0.1, -0.25, 0.4, 0.8];
        let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
        let quaternion = parts.map(|part| part / length);
        let [heading, pitch, roll] = angles(quaternion).unwrap();
        let ours = Attitude { roll, pitch, heading }.to_terrain();
        for (i, row) in matrix(quaternion).iter().enumerate() {
            for (j, expected) in row.iter().enumerate() {
                assert!((ours.col(j)[i] - expected).abs() < 1e-12, "R[{i}][{j}]");
            }
        }
    }
}
