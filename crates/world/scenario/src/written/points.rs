//! Points of a path, as a file has them.

use diagnostics::Placed;

use super::coordinates::Coordinates;
use crate::{HeightOver, Waypoint};

/// A waypoint and the place of its time, for what is wrong with its order.
pub(super) type PlacedWaypoint = Placed<Waypoint>;

/// The points of a path file, before they are in the axes of the bank.
#[derive(Debug, Clone)]
pub(super) struct Points {
    /// Waypoints whose places are in `coordinates`: metres north and east, or latitude and longitude (rad).
    pub waypoints: Vec<PlacedWaypoint>,
    pub coordinates: Coordinates,
    pub height_over: HeightOver,
}
