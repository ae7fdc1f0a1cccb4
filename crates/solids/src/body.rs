//! A solid in its place.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::Solid;

/// What a body is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A rock.
    Rock,
    /// Man-made.
    Culture,
}

/// A convex solid on the ground, in terrain axes: x north, y east, h up (m).
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Names the object that it is a part of; stable over a mission.
    pub object: u32,
    /// What it is.
    pub kind: Kind,
    /// Foot point of its object: decides whether it is seen and shadowed.
    pub foot: DVec3,
    /// Its shape: corners and albedo of the faces; its own vertices and normals are in body axes.
    pub solid: Arc<Solid>,
    /// Vertices of the solid in terrain axes.
    pub vertices: Vec<DVec3>,
    /// Normal of each face of the solid in terrain axes.
    pub normals: Vec<DVec3>,
}

impl Body {
    /// Places `solid`, `scale` times as large, at `foot`; `to_ground` turns body axes (forward, starboard, up)
    /// into north, east, up (a rotation).
    pub fn place(
        object: u32,
        kind: Kind,
        solid: &Arc<Solid>,
        foot: DVec3,
        to_ground: &DMat3,
        scale: f64,
    ) -> Self {
        let vertices = solid.vertices().iter().map(|&vertex| foot + *to_ground * (vertex * scale)).collect();
        let normals = solid.faces().iter().map(|face| *to_ground * face.normal).collect();
        Self { object, kind, foot, solid: solid.clone(), vertices, normals }
    }
}
