//! Where the camera stands, and how it looks.

use glam::DVec3;
use landscape::{Attitude, Landscape};
use photo_camera::{Affine, Camera, Orientation};
use quantities::sin_cos;
use scenario::{FieldOfView, Pose};

use crate::{MakeError, Reach, Wishes};

/// Micrometres in a metre.
const MICROMETRES: f64 = 1e6;

/// A camera and the pose by which `exact` draws what it sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stand {
    /// The camera in the axes of the landscape: x east, y north, z up (m).
    pub camera: Camera,
    /// The pose: eye north, east, up (m).
    pub pose: Pose,
    /// Field of view of the picture.
    pub field: FieldOfView,
    /// Distance from the camera to the ground in the picture's middle (m).
    pub distance: f64,
}

impl Stand {
    /// The stand that `wishes` ask for on `landscape`.
    ///
    /// # Errors
    /// If a figure is out of its range, the centre lies beside the ground, or the camera stands in the ground.
    pub fn new(landscape: &Landscape, wishes: &Wishes) -> Result<Self, MakeError> {
        wishes.check()?;
        let [north, east] = wishes.centre;
        let ground = landscape.height(north, east).ok_or_else(|| beside(landscape, wishes.centre))?;
        let axes = axes(wishes);
        let forward = -axes[2];
        let distance = distance(wishes, -forward.z);
        let eye = DVec3::new(east, north, ground) - forward * distance;
        expect_above(landscape, eye)?;
        let half = wishes.size.map(|count| 0.5 * f64::from(count) * wishes.ground_sample / distance);
        let attitude = Attitude { roll: 0.0, pitch: wishes.pitch, heading: wishes.heading };
        Ok(Self {
            camera: camera(wishes, axes, eye, distance)?,
            pose: Pose { time: wishes.time, eye: [eye.y, eye.x, eye.z], attitude, yoke: wishes.roll },
            field: FieldOfView { tan_half_width: half[0], tan_half_height: half[1] },
            distance,
        })
    }
}

/// Image axes right, up and against the line of sight, in east, north, up.
fn axes(wishes: &Wishes) -> [DVec3; 3] {
    let [(sin_h, cos_h), (sin_p, cos_p), (sin_r, cos_r)] =
        [wishes.heading, wishes.pitch, wishes.roll].map(sin_cos);
    let forward = DVec3::new(sin_h * cos_p, cos_h * cos_p, sin_p);
    let level = DVec3::new(cos_h, -sin_h, 0.0);
    let right = level * cos_r - level.cross(forward) * sin_r;
    [right, right.cross(forward), -forward]
}

/// Distance along the optical axis (m); `fall` is the sine of its angle below the horizontal.
fn distance(wishes: &Wishes, fall: f64) -> f64 {
    match wishes.reach {
        Reach::Height(height) => height / fall,
        Reach::Field(field) => {
            let (sin, cos) = sin_cos(0.5 * field);
            0.5 * f64::from(wishes.size[0]) * wishes.ground_sample * cos / sin
        }
    }
}

fn camera(wishes: &Wishes, axes: [DVec3; 3], eye: DVec3, distance: f64) -> Result<Camera, MakeError> {
    let pixel = MICROMETRES * wishes.focal_length * wishes.ground_sample / distance;
    let [across, down] = wishes.size.map(|count| 0.5 * pixel * f64::from(count));
    let affine = Affine::new([pixel, 0.0, -across], [0.0, -pixel, down])?;
    let orientation = Orientation::from_axes(axes)?;
    Ok(Camera::new(wishes.focal_length, [0.0; 2], eye, orientation, affine)?)
}

fn expect_above(landscape: &Landscape, eye: DVec3) -> Result<(), MakeError> {
    match landscape.height(eye.y, eye.x) {
        Some(ground) if eye.z <= ground => {
            Err(MakeError::UnderGround { below: ground - eye.z, height: eye.z })
        }
        _ => Ok(()),
    }
}

fn beside(landscape: &Landscape, [north, east]: [f64; 2]) -> MakeError {
    let [south_edge, west_edge, north_edge, east_edge] = landscape.level().extent();
    MakeError::Centre { north, east, south_edge, north_edge, west_edge, east_edge }
}
