//! The channel that a run looks through.

use quantities::degrees;
use scenario::Channel;
use serde::{Deserialize, Serialize};

/// One of several views from the vehicle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ChannelRecord {
    /// Name of the channel.
    pub name: String,
    /// Turn against the vehicle's camera (deg), clockwise from above.
    pub heading_deg: f64,
    /// The same upwards (deg).
    pub pitch_deg: f64,
    /// The same about the line of sight (deg), positive for starboard down.
    pub roll_deg: f64,
}

impl From<&Channel> for ChannelRecord {
    fn from(channel: &Channel) -> Self {
        let [heading_deg, pitch_deg, roll_deg] =
            [channel.mount.heading, channel.mount.pitch, channel.mount.roll].map(degrees);
        Self { name: channel.name.clone(), heading_deg, pitch_deg, roll_deg }
    }
}
