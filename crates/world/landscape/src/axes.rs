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
    fn attitude_of_a_slope() {
        let attitude = Attitude::on_slope([0.1, -0.05], radians(30.0));
        assert!((degrees(attitude.pitch) - 3.525110958385265).abs() < 1e-13);
        assert!((degrees(attitude.roll) - 5.320310303701491).abs() < 1e-13);
        let down = attitude.to_terrain() * DVec3::Z;
        let expected = DVec3::new(0.09938079899999065, -0.04969039949999533, 0.9938079899999065);
        assert!((down - expected).length() < 1e-15);
    }
}
