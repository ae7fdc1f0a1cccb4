//! Where an eye may stand and how it may look; and which poses a machine with sweeps could draw too.

use generator::{FrameError, Stage, check_eye, check_free_eye};
use landscape::Landscape;
use quantities::{degrees, sin_cos};
use scenario::{FieldOfView, Pose, Projection};

/// |pitch| + half the vertical field of view stays below this (deg) where sweeps are drawn: nadir and zenith lie outside
/// the picture.
const SWEPT_DEG: f64 = 80.0;

/// The same where the law `as-reported` has rays.
const POLE_DEG: f64 = 90.0;

/// Whether a machine with sweeps could draw `pose`: the eye stands over the finest level of `landscape`, above its
/// ground, and nadir and zenith lie outside the picture. Then ground is seen from the first sample of the sweeps on.
pub fn is_swept(landscape: &Landscape, field: FieldOfView, pose: &Pose) -> bool {
    check_eye(landscape, 0, pose).is_ok() && steepest_deg(field, pose) < SWEPT_DEG
}

/// Whether `pose` can be drawn.
///
/// # Errors
/// If it is no pose, if the eye is in the ground, or if the projection law has no rays for it.
pub fn check(stage: &Stage, frame: u64, pose: &Pose) -> Result<(), FrameError> {
    let Stage { landscape, view, .. } = stage;
    check_free_eye(landscape, frame, pose)?;
    check_law(view.laws.projection, view.field, frame, pose)
}

/// `as-reported` turns elevations into lines by a tangent, which has a pole; `corrected` leaves pitch out, and `exact` has
/// a ray for every place of every screen.
fn check_law(projection: Projection, field: FieldOfView, frame: u64, pose: &Pose) -> Result<(), FrameError> {
    let steepest = steepest_deg(field, pose);
    match projection {
        Projection::AsReported if steepest >= POLE_DEG => Err(unsupported(
            frame,
            format!(
                "a view {steepest:.1} deg above or below the horizontal under the projection law as-reported, which has no \
                 ray at {POLE_DEG:.0} deg or beyond: look less steeply, or set dpp.projection to exact"
            ),
        )),
        Projection::AsReported | Projection::Corrected | Projection::Exact => Ok(()),
    }
}

fn unsupported(frame: u64, what: String) -> FrameError {
    FrameError::Refused { frame, reason: format!("exact cannot draw {what}") }
}

/// |pitch| and half the vertical field of view together (deg). The corners of a turned screen look farther up and down
/// than its edges.
fn steepest_deg(field: FieldOfView, pose: &Pose) -> f64 {
    let (sin, cos) = sin_cos(pose.yoke);
    let highest = field.tan_half_height * cos.abs() + field.tan_half_width * sin.abs();
    degrees(pose.attitude.pitch).abs() + degrees(libm::atan(highest))
}
