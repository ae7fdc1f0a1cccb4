//! Poses in headers, the request `ahead`, and the frame that a request looks at.

use drive::{Drive, DriveError, EyePose, Viewpoint};
use serde_json::{Value, json};

use crate::keys::Keys;
use crate::session::{Held, Reply};
use crate::{Home, Session};

impl<H: Home> Session<H> {
    pub(crate) fn ahead(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let (pose, metres, turn) = (keys.pose("pose"), keys.number("metres"), keys.number("turn_deg"));
        keys.finish()?;
        let held = self.held()?;
        let pose = pose.map(|pose| pose.eye);
        let from = match pose.or(held.driven.poses().last().copied()) {
            Some(pose) => pose,
            None => held.drive.pose(0)?,
        };
        let there = held.driven.turned(&from, turn, metres)?;
        Ok(json!({ "pose": pose_json(&there) }).into())
    }
}

/// A pose in a header.
pub(crate) fn pose_json(pose: &EyePose) -> Value {
    let EyePose { time_s, eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, yoke_deg } = pose;
    json!({ "time_s": time_s, "x_m": x, "y_m": y, "z_m": z, "heading_deg": heading_deg, "pitch_deg": pitch_deg,
            "roll_deg": roll_deg, "yoke_deg": yoke_deg })
}

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

/// Which frame a request looks at: one of the path, one from a pose, or the last of the loop.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Which {
    frame: Option<u64>,
    pose: Option<AskedPose>,
}

impl Which {
    /// The keys `frame` and `pose`.
    pub fn of(keys: &Keys) -> Self {
        Self { frame: keys.whole("frame"), pose: keys.pose("pose") }
    }

    /// The frame of `held`.
    pub fn at(self, held: &mut Held) -> Result<Viewpoint<'_>, DriveError> {
        match (self.pose, self.frame) {
            (Some(pose), frame) => pose.at(&held.drive, frame),
            (None, Some(frame)) => held.drive.at(frame),
            (None, None) => held.driven.viewpoint(),
        }
    }
}
