//! Planes that faces lie in, and the two sides of one.

use glam::DVec3;

/// Faces whose normals differ by more than this (cosine) never share a plane, however small they are.
const ALIKE: f64 = 0.999;

/// A plane: all places whose product with `normal` is `offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plane {
    /// Unit vector square to it, outwards.
    pub normal: DVec3,
    /// Distance from the origin along the normal (m).
    pub offset: f64,
}

/// Two polygons, or nothing, on the two sides of a plane.
pub(super) struct Halves {
    pub front: Vec<DVec3>,
    pub back: Vec<DVec3>,
}

impl Plane {
    /// The plane of a triangle; nothing if the triangle is thinner than `slack` (m).
    pub fn of([a, b, c]: [DVec3; 3], slack: f64) -> Option<Self> {
        let area = (b - a).cross(c - a);
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        (area.length() > slack * longest).then(|| {
            let normal = area.normalize();
            Self { normal, offset: normal.dot((a + b + c) / 3.0) }
        })
    }

    /// How far a place lies in front (m); negative behind.
    pub fn height(&self, place: DVec3) -> f64 {
        self.normal.dot(place) - self.offset
    }

    /// Whether a triangle with this plane of its own lies in `self`, within `slack` (m).
    pub fn holds(&self, own: &Self, corners: &[DVec3], slack: f64) -> bool {
        self.normal.dot(own.normal) > ALIKE && corners.iter().all(|&at| self.height(at).abs() <= slack)
    }

    /// Where the edge between two places on different sides meets the plane. The result has the same bits whichever way the
    /// edge runs: polygons on both sides of it keep common corners.
    fn crossing(&self, a: DVec3, b: DVec3) -> DVec3 {
        let (a, b) = if a.to_array() < b.to_array() { (a, b) } else { (b, a) };
        let [from, to] = [a, b].map(|place| self.height(place));
        a + (b - a) * (from / (from - to))
    }

    /// Cuts a convex polygon. Corners nearer than `slack` (m) count as on the plane and belong to both halves.
    pub fn cut(&self, corners: &[DVec3], slack: f64) -> Halves {
        let mut halves = Halves { front: Vec::new(), back: Vec::new() };
        let next = corners.iter().cycle().skip(1);
        for (&from, &to) in corners.iter().zip(next) {
            let [here, there] = [from, to].map(|place| side(self.height(place), slack));
            if here >= 0 {
                halves.front.push(from);
            }
            if here <= 0 {
                halves.back.push(from);
            }
            if here * there < 0 {
                let at = self.crossing(from, to);
                halves.front.push(at);
                halves.back.push(at);
            }
        }
        halves
    }

    /// Which sides a polygon reaches: in front, behind.
    pub fn reaches(&self, corners: &[DVec3], slack: f64) -> [bool; 2] {
        let sides = || corners.iter().map(|&place| side(self.height(place), slack));
        [sides().any(|side| side > 0), sides().any(|side| side < 0)]
    }
}

/// 1 in front, -1 behind, 0 on the plane.
fn side(height: f64, slack: f64) -> i8 {
    i8::from(height > slack) - i8::from(height < -slack)
}

/// The plane of each triangle: large triangles choose first, and smaller ones that lie in a plane share it. Triangles thinner
/// than `slack` (m) bound nothing and have no plane.
pub(super) fn planes_of(triangles: &[[DVec3; 3]], slack: f64) -> (Vec<Plane>, Vec<Option<usize>>) {
    let area = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a).length_squared();
    let mut order: Vec<usize> = (0..triangles.len()).collect();
    order.sort_by(|&a, &b| area(triangles[b]).total_cmp(&area(triangles[a])).then(a.cmp(&b)));
    let (mut planes, mut of_triangle) = (Vec::<Plane>::new(), vec![None; triangles.len()]);
    for triangle in order {
        let corners = triangles[triangle];
        let Some(own) = Plane::of(corners, slack) else { continue };
        let known = planes.iter().position(|plane| plane.holds(&own, &corners, slack));
        of_triangle[triangle] = Some(known.unwrap_or_else(|| {
            planes.push(own);
            planes.len() - 1
        }));
    }
    (planes, of_triangle)
}
