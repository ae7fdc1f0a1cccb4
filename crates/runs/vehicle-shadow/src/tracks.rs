//! Tracks along the way that a picture sequence was taken on.

use landscape::Landscape;
use scenario::{Path, TrackPatch, Tracks, Vehicle, Waypoint};

use crate::{AugmentError, Sequence};

/// Patches of a wheel's width where a scenario does not say (our choice; those of `scenarios/tracks.toml`).
pub const USUAL_TRACKS: Tracks = Tracks { length: 0.12, width: 0.22, spacing: 0.24 };

/// The patches that `vehicle` leaves from the first pose of `sequence` to the last, ascending in time: none where its
/// eye is too high for it to stand.
///
/// # Errors
/// If the poses are no path, or there would be too many patches.
pub fn tracks_along(
    sequence: &Sequence,
    tracks: &Tracks,
    vehicle: &Vehicle,
    landscape: &Landscape,
) -> Result<Vec<TrackPatch>, AugmentError> {
    let waypoints = sequence.frames().iter().map(|frame| {
        let [x, y, z] = frame.pose.eye;
        let heading = Some(frame.pose.attitude.heading);
        Waypoint { time: frame.pose.time, at: [x, y], heading, eye_height: Some(z), pitch: None, roll: None }
    });
    let refused = |error: &dyn std::fmt::Display| AugmentError::Tracks(error.to_string());
    let path = Path::new(waypoints.collect()).map_err(|error| refused(&error))?;
    tracks.lay(&path, vehicle, landscape).map_err(|error| refused(&error))
}
