//! What the vehicle looks like to the sun: the parts that cast its own shadow (section 19, on true ground).

use std::sync::Arc;

use glam::{DMat3, DVec3};
use landscape::Attitude;
use solids::{Body, Kind, Solid};

/// Convex parts in common body axes (forward, starboard, up; m), the foot point at the origin. The driver's eye stands
/// straight above it and never sees them.
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleShape {
    /// Convex parts that together make the shape.
    pub parts: Vec<Arc<Solid>>,
    /// Of the eye above the foot point (m).
    pub eye_height: f64,
}

impl VehicleShape {
    /// The parts in terrain axes, the eye at `eye` (north, east, up; m): the vehicle turns about its eye.
    pub fn bodies(&self, eye: [f64; 3], attitude: Attitude) -> impl Iterator<Item = Body> {
        let flip = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
        let to_ground = flip * attitude.to_terrain() * flip;
        let foot = DVec3::from_array(eye) - to_ground * (DVec3::Z * self.eye_height);
        self.parts.iter().map(move |part| Body::place(0, Kind::Culture, part, foot, &to_ground, 1.0))
    }
}
