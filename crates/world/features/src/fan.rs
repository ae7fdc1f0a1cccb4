//! Rays from one place, between a left and a right one.

/// All rays from a place up to a range whose directions lie between two.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fan {
    origin: [f64; 2],
    /// Unit vectors (north, east) of the left and of the right edge.
    edges: [[f64; 2]; 2],
    /// Range at which the chord between the edges lies beyond the ends of all rays (m).
    to: f64,
}

impl Fan {
    /// `edges` are less than half a turn apart.
    pub fn new(origin: [f64; 2], edges: [[f64; 2]; 2], to: f64) -> Self {
        let [left, right] = edges;
        // Cosine of half the angle, squared.
        let half = 0.5 + 0.5 * (left[0] * right[0] + left[1] * right[1]);
        Self { origin, edges, to: to / half.sqrt() }
    }

    /// The same rays from `origin` in another unit, of which there are `units` in a metre.
    pub fn in_units(&self, origin: [f64; 2], units: f64) -> Self {
        Self { origin, to: self.to * units, ..*self }
    }

    /// Where the rays begin (m).
    pub fn origin(&self) -> [f64; 2] {
        self.origin
    }

    /// Sides of the triangle that holds all rays (m): both edges and the chord between their ends.
    pub fn sides(&self) -> [[[f64; 2]; 2]; 3] {
        let [left, right] =
            self.edges.map(|edge| [0, 1].map(|axis| self.origin[axis] + self.to * edge[axis]));
        [[self.origin, left], [self.origin, right], [left, right]]
    }

    /// Between which northings the rays are (m).
    pub fn northings(&self) -> (f64, f64) {
        let ends = self.sides().map(|[begin, _]| begin[0]);
        let right = self.sides()[1][1][0];
        (ends.into_iter().fold(right, f64::min), ends.into_iter().fold(right, f64::max))
    }

    /// Whether a circle of radius `outer` (m) about `centre` may meet a ray: it reaches over both edges, and not only behind
    /// the origin or beyond the end.
    #[inline]
    pub fn may_reach(&self, centre: [f64; 2], outer: f64) -> bool {
        let [left, right] = self.edges;
        let offset = [0, 1].map(|axis| centre[axis] - self.origin[axis]);
        let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
        let farthest = self.to + outer;
        let ahead = offset[0] * (left[0] + right[0]) + offset[1] * (left[1] + right[1]);
        cross(left, offset) >= -outer
            && cross(offset, right) >= -outer
            && ahead >= -2.0 * outer
            && offset[0] * offset[0] + offset[1] * offset[1] <= farthest * farthest
    }
}
