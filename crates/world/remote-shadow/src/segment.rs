//! Boundary segments: what shadow is made of.

/// A directed piece of the boundary of remote shadow on the ground: a point and the next one (11.2).
///
/// The shadow lies to the right of the way from `from` to `to`, seen from above with north up: outlines that
/// run clockwise enclose shadow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// First end: north, east (m).
    pub from: [f64; 2],
    /// Second end: north, east (m).
    pub to: [f64; 2],
}
