//! Maximum viewing distance (section 12).

use glam::DVec3;
use solids::Body;

/// What a maximum viewing distance leaves out, and what that changes at most.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LeftOut {
    /// Bodies beyond their distance.
    pub bodies: u64,
    /// Resolution cells that their bounding spheres would cover together: the sum over the picture of what
    /// changes, in pixels of full scale, is at most this.
    pub cells: f64,
}

/// The report's maximal distance, body by body (our choice: a boulder is no reason to draw pebbles as far as itself).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// Angle of a resolution cell (rad).
    cell: f64,
}

impl Sight {
    /// For a picture of `lines` lines over a vertical `field` (rad). The report's figures are 1000 lines over 30 degrees.
    pub fn new(lines: f64, field: f64) -> Self {
        Self { cell: field / lines }
    }

    /// Whether `body` is as large as a resolution cell, that is, within `r_max = size lines / field`; if not, it is added
    /// to `left_out`.
    pub fn resolves(&self, eye: DVec3, body: &Body, left_out: &mut LeftOut) -> bool {
        let range = body.centre.distance(eye) - body.radius;
        let cells = 2.0 * body.radius / (range * self.cell);
        if range <= 0.0 || cells >= 1.0 {
            return true;
        }
        left_out.bodies += 1;
        left_out.cells += cells * cells;
        false
    }
}
