//! Edges of a triangle, and where they cross rows of pixel centres. All in whole steps of 1/256 pixel, so nothing is rounded.

use raster::Point;

/// Steps in a pixel.
const STEPS: i64 = 256;
/// Steps from the border of a pixel to its centre.
const CENTRE: i64 = 128;

/// An edge that crosses rows, from its upper to its lower end (y runs downward).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    upper: [i64; 2],
    lower: [i64; 2],
}

impl Edge {
    /// The three edges of a triangle.
    pub fn of(corners: [Point; 3]) -> [Self; 3] {
        let steps = corners.map(|corner| corner.position().map(|at| (at * STEPS as f64) as i64));
        [0, 1, 2].map(|k| {
            let ends = [steps[k], steps[(k + 1) % 3]];
            let [upper, lower] = if ends[0][1] <= ends[1][1] { ends } else { [ends[1], ends[0]] };
            Self { upper, lower }
        })
    }

    /// Rows whose centres it crosses; its upper end belongs to it, its lower end does not.
    pub fn rows(&self) -> std::ops::Range<i64> {
        let first = |y: i64| ceil_div(y - CENTRE, STEPS);
        first(self.upper[1])..first(self.lower[1])
    }

    /// The first column of a row whose centre does not lie to the left of the edge. The row is one of [`Edge::rows`].
    pub fn crossing(&self, row: i64) -> i64 {
        let [dx, dy] = [0, 1].map(|axis| self.lower[axis] - self.upper[axis]);
        let down = STEPS * row + CENTRE - self.upper[1];
        ceil_div(dx * down + (self.upper[0] - CENTRE) * dy, STEPS * dy)
    }
}

/// The least whole number that is not below a fraction with a denominator above 0.
fn ceil_div(over: i64, under: i64) -> i64 {
    -(-over).div_euclid(under)
}
