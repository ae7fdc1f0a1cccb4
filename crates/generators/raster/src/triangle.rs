//! Triangles as edge functions in whole numbers.

use crate::fixed::Point;

/// Twice the signed area of a triangle (1/256 pixel squared): above 0 if its corners go clockwise as the screen shows them
/// (y down). A generator that draws one side alone drops the others.
pub fn doubled_area([p, q, r]: [Point; 3]) -> i64 {
    let [a, b, c, d] = [q.x - p.x, r.y - p.y, q.y - p.y, r.x - p.x].map(i64::from);
    a * b - c * d
}

/// `e(x, y) = a x + b y + c` with x and y in 1/256 pixel: at least 0 at points that belong to the inside.
///
/// The top-left rule is in `c`. An edge whose inside lies to its right (`a > 0`), or below it (`a = 0`, `b > 0`), keeps
/// the points that lie on it. Any other edge has `c` less 1, so that points on it are outside.
///
/// Bound: coordinates span at most 8208 pixels, so `|a|, |b| < 2^21.01` and all three terms together stay below 2^45.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    pub a: i32,
    pub b: i32,
    pub c: i64,
}

impl Edge {
    /// The edge from `p` to `q`, with its inside to the right of who walks there (y down).
    fn new(p: Point, q: Point) -> Self {
        let [a, b] = [p.y - q.y, q.x - p.x];
        let on_edge = i64::from(a) * i64::from(p.x) + i64::from(b) * i64::from(p.y);
        let edge = Self { a, b, c: -on_edge };
        Self { c: edge.c - i64::from(!edge.keeps_its_points()), ..edge }
    }

    /// Whether points that lie on the edge belong to the inside.
    fn keeps_its_points(&self) -> bool {
        self.a > 0 || (self.a == 0 && self.b > 0)
    }

    /// The largest value over a rectangle from `low` to `high` (1/256 pixel).
    pub fn most(&self, low: [i32; 2], high: [i32; 2]) -> i64 {
        let x = if self.a > 0 { high[0] } else { low[0] };
        let y = if self.b > 0 { high[1] } else { low[1] };
        i64::from(self.a) * i64::from(x) + i64::from(self.b) * i64::from(y) + self.c
    }
}

/// A triangle on the screen that has an area.
#[derive(Debug, Clone, Copy)]
pub struct Triangle {
    pub(crate) edges: [Edge; 3],
    /// Corner of its box nearest to the top left of the screen.
    pub(crate) low: Point,
    /// Corner of its box farthest from the top left of the screen.
    pub(crate) high: Point,
}

impl Triangle {
    /// The triangle of three corners in any order; `None` if its area is 0, so that it covers nothing.
    pub fn new([p, q, r]: [Point; 3]) -> Option<Self> {
        let [p, q, r] = match doubled_area([p, q, r]) {
            0 => return None,
            1.. => [p, q, r],
            _ => [p, r, q],
        };
        Some(Self {
            edges: [Edge::new(p, q), Edge::new(q, r), Edge::new(r, p)],
            low: Point { x: p.x.min(q.x).min(r.x), y: p.y.min(q.y).min(r.y) },
            high: Point { x: p.x.max(q.x).max(r.x), y: p.y.max(q.y).max(r.y) },
        })
    }

    /// Its corners (pixels, exact multiples of 1/256), clockwise as the screen shows them.
    pub fn corners(&self) -> [[f64; 2]; 3] {
        let doubled = i128::from(self.doubled_area());
        let line = |k: usize| {
            let edge = &self.edges[k];
            [i128::from(edge.a), i128::from(edge.b), i128::from(edge.c + i64::from(!edge.keeps_its_points()))]
        };
        // Two edges meet in a corner; the determinant of their slopes is twice the area.
        [(2, 0), (0, 1), (1, 2)].map(|(before, after)| {
            let ([a, b, c], [d, e, f]) = (line(before), line(after));
            [(b * f - e * c) / doubled, (c * d - f * a) / doubled].map(|at| at as f64 / 256.0)
        })
    }

    /// Twice its area (1/256 pixel squared), above 0.
    pub fn doubled_area(&self) -> i64 {
        // It is the sum of the three edge functions at any point, here at the origin, without the top-left rule.
        self.edges.iter().map(|edge| edge.c + i64::from(!edge.keeps_its_points())).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screen::{LARGEST_RASTER, LARGEST_SIDE};

    fn triangle(corners: [[f64; 2]; 3]) -> Triangle {
        Triangle::new(corners.map(|corner| Point::snap(corner).unwrap())).unwrap()
    }

    #[test]
    fn edge_functions_of_the_check_triangle() {
        let edges = triangle([[10.0, 10.0], [50.0, 20.0], [20.0, 60.0]]).edges;
        let in_pixels = edges
            .map(|edge| [i64::from(edge.a) / 256, i64::from(edge.b) / 256, edge.c.div_euclid(256) / 256]);
        // The second and third edge keep no points: `c` is less by 1 step squared, and rounds down to a pixel less.
        let rounded = in_pixels.map(|[a, b, _]| [a, b]);
        assert_eq!(rounded, [[-10, 40], [-40, -30], [50, -10]]);
        let keeps = edges.map(|edge| edge.c.rem_euclid(256 * 256) == 0);
        assert_eq!(keeps, [false, false, true], "only the left edge keeps its points");
        let constants = edges.map(|edge| (edge.c + 1).div_euclid(256 * 256));
        assert_eq!(constants, [-300, 2600, -400]);
    }

    #[test]
    fn corners_come_back_exactly() {
        let corners = [[10.25, 10.0], [50.0, 20.5], [20.0, 60.00390625]];
        assert_eq!(triangle(corners).corners(), corners);
        let [p, q, r] = corners;
        assert_eq!(triangle([p, r, q]).corners(), corners, "clockwise, whichever way it was made");
    }

    #[test]
    fn a_level_edge_above_keeps_its_points_and_one_below_does_not() {
        let [above, ..] = triangle([[1.0, 1.0], [3.0, 1.0], [2.0, 2.0]]).edges;
        assert_eq!((above.a, above.c), (0, -512 * 256));
        let below = triangle([[1.0, 2.0], [2.0, 1.0], [3.0, 2.0]]).edges[2];
        assert_eq!((below.a, below.c), (0, 512 * 512 - 1));
    }

    #[test]
    fn orientation_does_not_matter_and_flat_ones_are_none() {
        let corners = [[1.0, 1.0], [5.0, 2.0], [2.0, 7.0]].map(|corner| Point::snap(corner).unwrap());
        let [p, q, r] = corners;
        assert_eq!(doubled_area([p, q, r]), -doubled_area([p, r, q]));
        assert_eq!(Triangle::new(corners).unwrap().doubled_area(), doubled_area(corners).abs());
        for order in [[p, r, q], [q, r, p]] {
            let inside =
                Triangle::new(order).unwrap().edges.map(|edge| edge.most([600, 700], [600, 700]) >= 0);
            assert_eq!(inside, [true; 3]);
        }
        assert!(Triangle::new([p, q, q]).is_none() && Triangle::new([p; 3]).is_none());
    }

    #[test]
    fn the_bound_holds_on_the_largest_raster() {
        let (low, high) = (-f64::from(LARGEST_SIDE), f64::from(LARGEST_RASTER + LARGEST_SIDE));
        let edges = triangle([[low, low], [high, low], [low, high]]).edges;
        for edge in edges {
            let [a, b] = [edge.a, edge.b].map(|part| part.unsigned_abs());
            assert!(a < 1 << 22 && b < 1 << 22, "{edge:?}");
            let corner = i64::from(LARGEST_RASTER + LARGEST_SIDE) * 256;
            assert!((i64::from(a) + i64::from(b)) * corner + edge.c.abs() < 1 << 45, "{edge:?}");
        }
    }
}
