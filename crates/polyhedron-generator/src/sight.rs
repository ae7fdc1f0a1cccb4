//! Maximum viewing distance (section 12).

use glam::DVec3;
use solids::Body;

/// What a maximum viewing distance leaves out, and what that changes at most.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LeftOut {
    /// Bodies beyond the distance.
    pub bodies: u64,
    /// Resolution cells that their bounding spheres would cover together: the sum over the picture of what
    /// changes, in pixels of full scale, is at most this.
    pub cells: f64,
}

/// The distance from which on even the largest body is smaller than a resolution cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// That distance (m).
    pub distance: f64,
    /// Angle of a resolution cell (rad).
    cell: f64,
}

impl Sight {
    /// For bodies up to `largest` (m) on a picture of `lines` lines over a vertical `field` (rad): `r_max =
    /// largest lines / field`. The report's figures are 1000 lines over 30 degrees.
    pub fn new(largest: f64, lines: f64, field: f64) -> Self {
        let cell = field / lines;
        Self { distance: largest / cell, cell }
    }

    /// Whether `body` lies within the distance; if not, it is added to `left_out`. As reported: one distance
    /// for all.
    pub fn reaches(&self, eye: DVec3, body: &Body, left_out: &mut LeftOut) -> bool {
        self.keep(eye, body, self.distance, left_out)
    }

    /// Whether `body` itself is as large as a resolution cell; if not, it is added to `left_out`. The same rule
    /// body by body, for fields of small rocks.
    pub fn resolves(&self, eye: DVec3, body: &Body, left_out: &mut LeftOut) -> bool {
        self.keep(eye, body, 2.0 * body.radius / self.cell, left_out)
    }

    fn keep(&self, eye: DVec3, body: &Body, distance: f64, left_out: &mut LeftOut) -> bool {
        let range = body.centre.distance(eye) - body.radius;
        if range <= distance {
            return true;
        }
        let cells = 2.0 * body.radius / (range * self.cell);
        left_out.bodies += 1;
        left_out.cells += cells * cells;
        false
    }
}
