//! Poses of the program in the axes of robotics: right-handed, with quaternions.
//!
//! The program counts north, east and height. That is left-handed, so no rotation leads from it to other axes: places and rotations
//! are turned here, once, into the site's axes east, north, up.

use glam::{DMat3, DQuat, DVec3};
use landscape::Attitude;
use scenario::Pose;

/// Where axes stand in others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Origin in the other axes (m).
    pub origin: DVec3,
    /// Unit quaternion from these axes to the others; its w is not negative.
    pub rotation: DQuat,
}

impl Placement {
    fn new(origin: DVec3, rotation: &DMat3) -> Self {
        let rotation = DQuat::from_mat3(rotation).normalize();
        // A quaternion and its negative turn alike: one of them is chosen.
        let rotation = if rotation.w < 0.0 { -rotation } else { rotation };
        Self { origin, rotation }
    }

    /// The quaternion in the order in which messages have it: x, y, z, w.
    pub fn xyzw(&self) -> [f64; 4] {
        self.rotation.to_array()
    }
}

/// From north, east, down to east, north, up.
const SITE_OF_TERRAIN: DMat3 = DMat3::from_cols(DVec3::Y, DVec3::X, DVec3::NEG_Z);
/// From forward, port, up to forward, starboard, down.
const BODY_OF_VEHICLE: DMat3 = DMat3::from_cols(DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z);
/// From right, down, ahead to forward, starboard, down.
const BODY_OF_CAMERA: DMat3 = DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X);

/// The vehicle in the site. Its origin is the eye, and its roll is that of the vehicle, drawn or not.
pub fn vehicle_in_site(pose: &Pose) -> Placement {
    let [north, east, up] = pose.eye;
    let rotation = SITE_OF_TERRAIN * pose.attitude.to_terrain() * BODY_OF_VEHICLE;
    Placement::new(DVec3::new(east, north, up), &rotation)
}

/// The camera in the vehicle. The picture turns with the yoke, and not with the vehicle's roll.
pub fn camera_in_vehicle(pose: &Pose) -> Placement {
    let drawn = Attitude { roll: pose.yoke, ..pose.attitude };
    let body = pose.attitude.to_terrain().transpose() * drawn.to_terrain();
    Placement::new(DVec3::ZERO, &(BODY_OF_VEHICLE.transpose() * body * BODY_OF_CAMERA))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

    use glam::DVec3;
    use landscape::Attitude;
    use quantities::sin_cos;
    use scenario::Pose;

    use super::{camera_in_vehicle, vehicle_in_site};

    fn pose(roll: f64, pitch: f64, heading: f64, yoke: f64) -> Pose {
        Pose { time: 0.0, eye: [200.0, 100.0, 2.5], attitude: Attitude { roll, pitch, heading }, yoke }
    }

    fn close(found: DVec3, expected: [f64; 3]) {
        assert!(found.distance(DVec3::from(expected)) < 1e-12, "{found}, expected {expected:?}");
    }

    /// Heading east on level ground the vehicle's axes are the site's: the identity. Heading north it is turned by a right angle to
    /// port, about z.
    #[test]
    fn headings_in_closed_form() {
        let east = vehicle_in_site(&pose(0.0, 0.0, FRAC_PI_2, 0.0));
        assert_eq!(east.origin, DVec3::new(100.0, 200.0, 2.5));
        for (found, expected) in east.xyzw().into_iter().zip([0.0, 0.0, 0.0, 1.0]) {
            assert!((found - expected).abs() < 1e-12, "{:?}", east.xyzw());
        }
        let north = vehicle_in_site(&pose(0.0, 0.0, 0.0, 0.0));
        for (found, expected) in north.xyzw().into_iter().zip([0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2]) {
            assert!((found - expected).abs() < 1e-12, "{:?}", north.xyzw());
        }
    }

    #[test]
    fn nose_up_looks_up_and_starboard_down_lowers_the_starboard_side() {
        let up = vehicle_in_site(&pose(0.0, 0.3, 0.7, 0.0)).rotation * DVec3::X;
        let ((sin_h, cos_h), (sin_p, cos_p)) = (sin_cos(0.7), sin_cos(0.3));
        close(up, [sin_h * cos_p, cos_h * cos_p, sin_p]);
        let starboard = vehicle_in_site(&pose(0.2, 0.0, 0.0, 0.0)).rotation * DVec3::NEG_Y;
        let (sin_r, cos_r) = sin_cos(0.2);
        close(starboard, [cos_r, 0.0, -sin_r]);
    }

    /// Without a yoke the picture stays upright while the vehicle rolls; with a settled yoke it rolls with the vehicle.
    #[test]
    fn the_camera_follows_the_yoke() {
        for yoke in [0.0, 0.2, -0.1] {
            let pose = pose(0.2, 0.1, 0.7, yoke);
            let (vehicle, camera) = (vehicle_in_site(&pose), camera_in_vehicle(&pose));
            let right = vehicle.rotation * (camera.rotation * DVec3::X);
            assert!((right.z + sin_cos(yoke).0 * sin_cos(0.1).1).abs() < 1e-12, "{right}");
            let ahead = vehicle.rotation * (camera.rotation * DVec3::Z);
            close(ahead, (vehicle.rotation * DVec3::X).to_array());
            let down = vehicle.rotation * (camera.rotation * DVec3::Y);
            close(ahead.cross(right), down.to_array());
            assert_eq!(camera.origin, DVec3::ZERO);
        }
        // Upright: right of the picture is to starboard, its bottom below, its depth ahead.
        let camera = camera_in_vehicle(&pose(0.0, 0.3, 1.0, 0.0)).rotation;
        close(camera * DVec3::X, [0.0, -1.0, 0.0]);
        close(camera * DVec3::Y, [0.0, 0.0, -1.0]);
        close(camera * DVec3::Z, [1.0, 0.0, 0.0]);
    }

    /// All turns, past the half circle too: the same rotation as the program's own matrix, and a w that is not negative.
    #[test]
    fn quaternions_are_the_programs_rotation() {
        for step in 0..200 {
            let angle = |part: u32| f64::from(step * part % 628) / 100.0 - PI;
            let pose = pose(angle(7), 0.4 * angle(13), angle(31), angle(11));
            let vehicle = vehicle_in_site(&pose);
            let [x, y, z, w] = vehicle.xyzw();
            assert!(w >= 0.0 && (x * x + y * y + z * z + w * w - 1.0).abs() < 1e-12);
            let forward = pose.attitude.to_terrain().x_axis;
            close(vehicle.rotation * DVec3::X, [forward.y, forward.x, -forward.z]);
            let starboard = pose.attitude.to_terrain().y_axis;
            close(vehicle.rotation * DVec3::NEG_Y, [starboard.y, starboard.x, -starboard.z]);
        }
    }
}
