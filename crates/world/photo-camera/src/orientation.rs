//! Which way the photograph's axes stand: from three angles, or from axes.
//!
//! Rows of the matrix are the image axes x, y, z in georectangular components. z points from the scene to the camera.

use glam::{DMat3, DVec3};
use quantities::sin_cos;

use crate::CameraError;

/// Largest deviation from a rotation that is allowed for given axes, without unit (chosen).
const ALLOWED: f64 = 1e-9;

/// The rotation from georectangular axes to image axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orientation(DMat3);

impl Orientation {
    /// The orientation of the angles omega, phi, kappa (rad): about x first, then y, then z.
    ///
    /// # Errors
    ///
    /// If an angle is not finite.
    pub fn from_angles(angles: [f64; 3]) -> Result<Self, CameraError> {
        for (what, angle) in ["omega (rad)", "phi (rad)", "kappa (rad)"].into_iter().zip(angles) {
            CameraError::figure(what, angle, "a finite number", |_| true)?;
        }
        let [(sw, cw), (sp, cp), (sk, ck)] = angles.map(sin_cos);
        let x = DVec3::new(cp * ck, cw * sk + sw * sp * ck, sw * sk - cw * sp * ck);
        let y = DVec3::new(-cp * sk, cw * ck - sw * sp * sk, sw * ck + cw * sp * sk);
        let z = DVec3::new(sp, -sw * cp, cw * cp);
        Ok(Self(DMat3::from_cols(x, y, z).transpose()))
    }

    /// The orientation whose rows are the image axes x, y, z in georectangular components.
    ///
    /// # Errors
    ///
    /// If an axis is not of length 1, two are not at right angles, or the three are left-handed, beyond 1e-9.
    pub fn from_axes(axes: [DVec3; 3]) -> Result<Self, CameraError> {
        let [x, y, z] = axes;
        for (what, off) in [
            ("length of the x axis", x.length() - 1.0),
            ("length of the y axis", y.length() - 1.0),
            ("length of the z axis", z.length() - 1.0),
            ("right angle of x and y", x.dot(y)),
            ("right angle of y and z", y.dot(z)),
            ("right angle of z and x", z.dot(x)),
            ("handedness", x.cross(y).dot(z) - 1.0),
        ] {
            // A deviation that is no number fails this comparison too.
            let holds = off.abs() <= ALLOWED;
            if !holds {
                return Err(CameraError::NoRotation { what, off, allowed: ALLOWED });
            }
        }
        Ok(Self(DMat3::from_cols(x, y, z).transpose()))
    }

    /// The orientation of axes of any length, as the thesis takes them from three known directions.
    ///
    /// # Errors
    ///
    /// If the axes are not at right angles or left-handed beyond 1e-9, or one has no length.
    pub fn from_directions(axes: [DVec3; 3]) -> Result<Self, CameraError> {
        Self::from_axes(axes.map(|axis| axis / axis.length()))
    }

    /// The image axes x, y, z, unit vectors in georectangular components.
    pub fn axes(&self) -> [DVec3; 3] {
        [self.0.row(0), self.0.row(1), self.0.row(2)]
    }

    /// Image components of a georectangular vector.
    pub fn image(&self, vector: DVec3) -> DVec3 {
        self.0 * vector
    }

    /// Georectangular components of an image vector.
    pub fn ground(&self, vector: DVec3) -> DVec3 {
        self.0.transpose() * vector
    }

    /// The angles omega, phi, kappa (rad); phi lies in -pi/2 to pi/2. At its ends omega and kappa turn alike, and omega is 0.
    pub fn angles(&self) -> [f64; 3] {
        let [x, y, z] = self.axes();
        let cos_phi = libm::hypot(z.y, z.z);
        let phi = libm::atan2(z.x, cos_phi);
        match cos_phi < 1e-12 {
            true => [0.0, phi, libm::atan2(x.y, y.y)],
            false => [libm::atan2(-z.y, z.z), phi, libm::atan2(-y.x, x.x)],
        }
    }
}
