//! Axes and rotations of section 4.
//!
//! Terrain axes (U, V, W): north, east, down. Vehicle axes (U', V', W'): forward, starboard, down, with the
//! origin at the driver's eye. View-plane: X right, Y down, at distance D ahead; here D = 1.

use glam::{DMat3, DVec3};
use quantities::sin_cos;

/// Roll, pitch and heading (rad), right-handed, applied in that order; positive: starboard down, nose up, turn
/// to starboard.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Attitude {
    /// Roll about U' (rad); positive with starboard down.
    pub roll: f64,
    /// Pitch about V' (rad); positive with the nose up.
    pub pitch: f64,
    /// About W, clockwise from north.
    pub heading: f64,
}

/// Cosine of the pitch below which heading and roll cannot be told apart. Chosen: far above rounding, and half a milliarcsecond from the
/// vertical.
const STEEPEST: f64 = 1e-8;

impl Attitude {
    /// `R = Phi Theta Psi`: from vehicle axes to terrain axes.
    pub fn to_terrain(&self) -> DMat3 {
        let ((sp, cp), (st, ct)) = (sin_cos(self.roll), sin_cos(self.pitch));
        let (sh, ch) = sin_cos(self.heading);
        let psi = DMat3::from_cols(DVec3::X, DVec3::new(0.0, cp, sp), DVec3::new(0.0, -sp, cp));
        let theta = DMat3::from_cols(DVec3::new(ct, 0.0, -st), DVec3::Y, DVec3::new(st, 0.0, ct));
        let phi = DMat3::from_cols(DVec3::new(ch, sh, 0.0), DVec3::new(-sh, ch, 0.0), DVec3::Z);
        phi * theta * psi
    }

    /// The attitude whose [`to_terrain`](Self::to_terrain) is `rotation`: pitch within a right angle, heading and roll within half a
    /// turn. Straight up and straight down, where heading and roll are about one axis, the roll is 0.
    pub fn of_terrain(rotation: &DMat3) -> Self {
        let [ahead, aside, below] = [rotation.x_axis, rotation.y_axis, rotation.z_axis];
        let level = (ahead.x * ahead.x + ahead.y * ahead.y).sqrt();
        let pitch = libm::atan2(-ahead.z, level);
        if level < STEEPEST {
            return Self { roll: 0.0, pitch, heading: libm::atan2(-aside.x, aside.y) };
        }
        let (roll, heading) = (libm::atan2(aside.z, below.z), libm::atan2(ahead.y, ahead.x));
        Self { roll, pitch, heading }
    }

    /// Attitude of a vehicle that stands on ground of slopes `[hx, hy]` with a heading (section 4).
    pub fn on_slope([hx, hy]: [f64; 2], heading: f64) -> Self {
        let (sh, ch) = sin_cos(heading);
        let (forward, starboard) = (hx * ch + hy * sh, hy * ch - hx * sh);
        let pitch = libm::atan(forward);
        Self { roll: -libm::atan(starboard * libm::cos(pitch)), pitch, heading }
    }
}

#[cfg(test)]
mod tests {
    use super::Attitude;
    use glam::DVec3;
    use quantities::{degrees, radians};

    #[test]
    fn check_values_of_23_6() {
        let attitude = Attitude { roll: radians(10.0), pitch: radians(-5.0), heading: radians(30.0) };
        let r = attitude.to_terrain();
        let rows = [
            [0.8627299156628209, -0.5055106824686105, 0.01249169846504515],
            [0.4980973490458728, 0.8453013140017739, -0.1932995587691509],
            [0.08715574274765817, 0.1729873939250895, 0.9810602621904069],
        ];
        for (i, row) in rows.iter().enumerate() {
            for (j, expected) in row.iter().enumerate() {
                assert!((r.col(j)[i] - expected).abs() < 1e-15, "R[{i}][{j}]");
            }
        }
        let moved = r * DVec3::new(3.0, 1.0, -0.5) + DVec3::new(0.0, 0.0, -2.0);
        let expected = DVec3::new(2.07643321528733, 2.436243140523968, -2.056075508927139);
        assert!((moved - expected).length() < 1e-14);
    }

    #[test]
    fn a_rotation_gives_its_attitude_back() {
        for (roll, pitch, heading) in [(10.0, -5.0, 30.0), (-170.0, 80.0, -100.0), (0.0, 0.0, 180.0)] {
            let attitude = Attitude { roll: radians(roll), pitch: radians(pitch), heading: radians(heading) };
            let found = Attitude::of_terrain(&attitude.to_terrain());
            let [found, attitude] = [found, attitude].map(|a| DVec3::new(a.roll, a.pitch, a.heading));
            assert!((found - attitude).length() < 1e-14, "{found} {attitude}");
        }
    }

    #[test]
    fn straight_down_has_a_heading_and_no_roll() {
        let attitude = Attitude { roll: radians(20.0), pitch: radians(-90.0), heading: radians(50.0) };
        let found = Attitude::of_terrain(&attitude.to_terrain());
        assert!(found.roll == 0.0 && (degrees(found.heading) - 70.0).abs() < 1e-12, "{found:?}");
        assert!((found.to_terrain().x_axis - attitude.to_terrain().x_axis).length() < 1e-15);
    }

    #[test]
    fn attitude_of_a_slope() {
        let attitude = Attitude::on_slope([0.1, -0.05], radians(30.0));
        assert!((degrees(attitude.pitch) - 3.525110958385265).abs() < 1e-13);
        assert!((degrees(attitude.roll) - 5.320310303701491).abs() < 1e-13);
        let down = attitude.to_terrain() * DVec3::Z;
        let expected = DVec3::new(0.09938079899999065, -0.04969039949999533, 0.9938079899999065);
        assert!((down - expected).length() < 1e-15);
    }
}
