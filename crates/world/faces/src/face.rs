//! A vertex and a face, as data.

use glam::DVec3;

/// A corner that faces of one list share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// Place in the group's axes: north, east, up (m).
    pub place: DVec3,
    /// Normal that is given, of length 1 once it is in a [`Mesh`](crate::Mesh); without it normals of faces are averaged.
    pub normal: Option<DVec3>,
}

impl Vertex {
    /// A vertex whose normal follows from its faces.
    pub fn at(place: DVec3) -> Self {
        Self { place, normal: None }
    }
}

/// How brightness runs over a face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shading {
    /// The face has the brightness of its own normal.
    Flat,
    /// Brightness runs linearly between that of the corners.
    Smooth,
    /// The face shines of itself: full brightness under any sun, from both sides (chosen).
    Glow,
}

/// Which sides of a face are seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sides {
    /// The side from which its corners run counter-clockwise.
    One,
    /// Both sides; seen from behind, its normals are reversed.
    Both,
}

/// A convex polygon of a list.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// Numbers of its vertices, counter-clockwise seen from the front; 3 or more.
    pub corners: Vec<u32>,
    /// Linear red, green, blue, 0 to 1 each.
    pub colour: [f64; 3],
    /// How brightness runs over it.
    pub shading: Shading,
    /// Which of its sides are seen.
    pub sides: Sides,
}

impl Face {
    /// A smooth one-sided face.
    pub fn smooth(corners: Vec<u32>, colour: [f64; 3]) -> Self {
        Self { corners, colour, shading: Shading::Smooth, sides: Sides::One }
    }

    /// A flat one-sided face.
    pub fn flat(corners: Vec<u32>, colour: [f64; 3]) -> Self {
        Self { corners, colour, shading: Shading::Flat, sides: Sides::One }
    }

    /// The same face, seen from both sides.
    pub fn both_sides(self) -> Self {
        Self { sides: Sides::Both, ..self }
    }
}
