//! A pose in a request, and the time that belongs to it.

use drive::{Drive, DriveError, EyePose, Viewpoint};

/// A pose as a request has it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AskedPose {
    /// The pose; its time is 0 where the request leaves it out.
    pub eye: EyePose,
    /// Whether the request has `time_s`.
    pub has_time: bool,
}

impl AskedPose {
    /// What `drive` shows from the pose. Time and frame belong together: either left out is that of the other, and frame 0 if both are.
    pub fn at(self, drive: &Drive, frame: Option<u64>) -> Result<Viewpoint<'_>, DriveError> {
        let (Self { eye, has_time }, update) = (self, drive.raster().update_hz);
        let frame = frame.unwrap_or((eye.time_s * update).round() as u64);
        let time_s = if has_time { eye.time_s } else { frame as f64 / update };
        drive.from_pose(frame, &EyePose { time_s, ..eye })
    }
}
