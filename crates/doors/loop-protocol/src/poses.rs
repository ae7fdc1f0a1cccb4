//! Poses in headers, the request `ahead`, and the frame that a request looks at.

use drive::{DriveError, EyePose, Viewpoint};
use serde_json::{Value, json};

use crate::asked_pose::AskedPose;
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
