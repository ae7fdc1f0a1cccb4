//! Convex pieces of a pixel, and how lines cut them.

use smallvec::SmallVec;

/// A convex polygon (pixels), counter-clockwise or clockwise as it was made.
#[derive(Debug, Clone)]
pub struct Piece(SmallVec<[[f64; 2]; 12]>);

/// A linear function of the place: `a x + b y + c`.
#[derive(Debug, Clone, Copy)]
pub struct Linear(pub [f64; 3]);

impl Linear {
    pub fn at(&self, [x, y]: [f64; 2]) -> f64 {
        self.0[0] * x + self.0[1] * y + self.0[2]
    }

    /// This function less another.
    pub fn less(&self, other: &Self) -> Self {
        Self([0, 1, 2].map(|k| self.0[k] - other.0[k]))
    }
}

impl Piece {
    /// The square of a pixel.
    pub fn pixel([column, line]: [usize; 2]) -> Self {
        let [left, top] = [column as f64, line as f64];
        let corners = [[left, top], [left + 1.0, top], [left + 1.0, top + 1.0], [left, top + 1.0]];
        Self(SmallVec::from_slice(&corners))
    }

    /// The part where `line` is at least 0, and the part where it is at most 0.
    pub fn cut(&self, line: &Linear) -> [Self; 2] {
        let heights: SmallVec<[f64; 12]> = self.0.iter().map(|corner| line.at(*corner)).collect();
        let (mut above, mut below) = (SmallVec::new(), SmallVec::new());
        for (i, &from) in self.0.iter().enumerate() {
            let next = (i + 1) % self.0.len();
            let (to, start, end) = (self.0[next], heights[i], heights[next]);
            if start >= 0.0 {
                above.push(from);
            }
            if start <= 0.0 {
                below.push(from);
            }
            if (start > 0.0 && end < 0.0) || (start < 0.0 && end > 0.0) {
                let share = start / (start - end);
                let met = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * share);
                above.push(met);
                below.push(met);
            }
        }
        [Self(above), Self(below)]
    }

    /// Area of the piece (pixels squared).
    pub fn area(&self) -> f64 {
        self.triangles().map(|(area, _)| area).sum()
    }

    /// Largest and least value of a linear function on it.
    pub fn range(&self, line: &Linear) -> [f64; 2] {
        let values = || self.0.iter().map(|corner| line.at(*corner));
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// Triangles that make it up: area, and the middles of the sides.
    pub fn triangles(&self) -> impl Iterator<Item = (f64, [[f64; 2]; 3])> + '_ {
        let first = self.0.first().copied().unwrap_or_default();
        self.0.windows(2).skip(1).map(move |pair| {
            let [q, r] = [pair[0], pair[1]];
            let doubled = (q[0] - first[0]) * (r[1] - first[1]) - (r[0] - first[0]) * (q[1] - first[1]);
            let middle = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|axis| (a[axis] + b[axis]) / 2.0);
            (doubled.abs() / 2.0, [middle(first, q), middle(q, r), middle(r, first)])
        })
    }
}

/// Functions that are at least 0 on the inner side of each edge of a convex polygon, whichever way round it is given.
pub fn edges(polygon: &[[f64; 2]]) -> impl Iterator<Item = Linear> + '_ {
    let turn = doubled_area(polygon).signum();
    (0..polygon.len()).map(move |i| {
        let ([x, y], [to_x, to_y]) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        let [along_x, along_y] = [turn * (to_x - x), turn * (to_y - y)];
        Linear([-along_y, along_x, along_y * x - along_x * y])
    })
}

/// Twice the signed area. Corners are taken from the first one, so that far polygons lose no digits.
pub fn doubled_area(polygon: &[[f64; 2]]) -> f64 {
    let Some((&[x, y], others)) = polygon.split_first() else { return 0.0 };
    let cross = |pair: &[[f64; 2]]| (pair[0][0] - x) * (pair[1][1] - y) - (pair[1][0] - x) * (pair[0][1] - y);
    others.windows(2).map(cross).sum()
}
