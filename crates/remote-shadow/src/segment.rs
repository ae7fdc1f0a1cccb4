//! Boundary segments: what is stored of a shadow.

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

impl Segment {
    /// The closed outline through `corners` (north, east; m) in their order; nothing for fewer than three.
    pub fn outline(corners: &[[f64; 2]]) -> Vec<Self> {
        if corners.len() < 3 {
            return Vec::new();
        }
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(&from, &to)| Self { from, to }).collect()
    }
}
