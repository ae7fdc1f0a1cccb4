//! Why the machine cannot draw a frame that others may draw.

use generator::FrameError;

/// What the machine refuses.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum Refusal {
    /// The fan of sweeps cannot cover the view.
    #[error(
        "pitch {pitch_deg:.1} deg brings the nadir or the zenith near the picture; \
         expected |pitch| + half the vertical field of view below {limit_deg:.0} deg"
    )]
    Pitch {
        /// Pitch of the frame (deg).
        pitch_deg: f64,
        /// Limit for |pitch| + half the vertical field of view (deg).
        limit_deg: f64,
    },
    /// Shadow boundaries cannot be kept.
    #[error(
        "shadow boundaries cannot be kept: {reason}; name a folder that can be written by --shadow-cache, or leave it out"
    )]
    ShadowCache {
        /// What the system says.
        reason: String,
    },
}

impl Refusal {
    /// The refusal of frame `frame`.
    pub fn of(self, frame: u64) -> FrameError {
        FrameError::Refused { frame, reason: self.to_string() }
    }
}
