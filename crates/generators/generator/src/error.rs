//! Why a generator cannot draw.

use landscape::Landscape;
use scenario::Pose;

/// Why a generator cannot draw a stage.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PrepareError {
    /// The generator lacks something that the stage asks for.
    #[error("{generator} cannot do {what}: {remedy}")]
    Unsupported {
        /// Name of the generator.
        generator: &'static str,
        /// What is asked for.
        what: String,
        /// What to do instead.
        remedy: String,
    },
}

/// Why a frame cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FrameError {
    /// The eye does not see the ground from above.
    #[error("frame {frame}: the eye is {below:.3} m under the ground; expected it above the ground")]
    EyeUnderGround {
        /// Number of the frame, from 0.
        frame: u64,
        /// How far below the ground (m).
        below: f64,
    },
    /// The eye is outside the problem area.
    #[error("frame {frame}: the eye at x = {x:.1} m, y = {y:.1} m is outside the problem area")]
    OutsideProblemArea {
        /// Number of the frame, from 0.
        frame: u64,
        /// Place of the eye, north (m).
        x: f64,
        /// Place of the eye, east (m).
        y: f64,
    },
    /// The generator cannot draw the frame for a reason of its own.
    #[error("frame {frame}: {reason}")]
    Refused {
        /// Number of the frame, from 0.
        frame: u64,
        /// The reason, and what to do instead; an error of the generator's crate as text.
        reason: String,
    },
}

/// Farther from the origin than this (m) along any axis no eye stands: distances keep their digits.
const FARTHEST: f64 = 1e9;

/// The eye stands anywhere but in the ground of `landscape`: for generators whose sight does not begin at the ground.
///
/// # Errors
/// If the eye is in the ground, or far beyond everything, or an angle is no number.
pub fn check_free_eye(landscape: &Landscape, frame: u64, pose: &Pose) -> Result<(), FrameError> {
    let attitude = pose.attitude;
    let angles = [attitude.roll, attitude.pitch, attitude.heading, pose.yoke];
    if !(pose.eye.iter().all(|at| at.abs() <= FARTHEST) && angles.iter().all(|angle| angle.is_finite())) {
        let reason = format!(
            "an eye at {:?} m with angles of {angles:?} rad: expected numbers, those of the eye within {FARTHEST:e} m",
            pose.eye
        );
        return Err(FrameError::Refused { frame, reason });
    }
    let [x, y, height] = pose.eye;
    match landscape.height(x, y) {
        Some(ground) if height <= ground => Err(FrameError::EyeUnderGround { frame, below: ground - height }),
        _ => Ok(()),
    }
}

/// The eye is over the finest level of `landscape` and above its ground: sight begins there.
///
/// # Errors
/// If it is not.
pub fn check_eye(landscape: &Landscape, frame: u64, pose: &Pose) -> Result<(), FrameError> {
    let [x, y, height] = pose.eye;
    let inside = landscape.level().locate(x, y).is_some();
    let ground = landscape.height(x, y).filter(|_| inside);
    let ground = ground.ok_or(FrameError::OutsideProblemArea { frame, x, y })?;
    match height > ground {
        true => Ok(()),
        false => Err(FrameError::EyeUnderGround { frame, below: ground - height }),
    }
}
