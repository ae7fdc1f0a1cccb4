//! Convex hull by wrapping planes around edges; points in one plane make one polygon.

use std::collections::{BTreeMap, VecDeque};

use glam::DVec3;

use crate::{Solid, SolidError};

/// Points within this share of the extent of a plane or line lie in it.
const FLAT: f64 = 1e-9;

impl Solid {
    /// The convex hull of at most [`Solid::MOST`] `points` (m); points inside are left out, triangles in one
    /// plane are one polygon. Every face has this `albedo`.
    ///
    /// # Errors If the points are too many, not finite, or lie in one plane.
    pub fn hull(points: &[DVec3], albedo: f64) -> Result<Self, SolidError> {
        crate::check::check_counts(points.len(), 4)?;
        crate::check::check_vertices(points)?;
        let points = &apart(points);
        let faces = Wrapping::new(points).faces()?;
        let mut number = BTreeMap::new();
        let mut vertices = Vec::new();
        let mut renumber = |corner: usize| {
            *number.entry(corner).or_insert_with(|| {
                vertices.push(points[corner]);
                vertices.len() as u32 - 1
            })
        };
        let mut painted = Vec::with_capacity(faces.len());
        for face in faces {
            painted.push((face.into_iter().map(&mut renumber).collect(), albedo));
        }
        Self::new(vertices, painted)
    }
}

fn slack(points: &[DVec3]) -> f64 {
    let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    FLAT * (high - low).max_element()
}

/// The points without repetitions.
fn apart(points: &[DVec3]) -> Vec<DVec3> {
    let slack = slack(points);
    let mut kept: Vec<DVec3> = Vec::with_capacity(points.len());
    for &point in points {
        if kept.iter().all(|other| other.distance(point) > slack) {
            kept.push(point);
        }
    }
    kept
}

/// A plane that all points lie behind.
#[derive(Debug, Clone, Copy)]
struct Plane {
    at: DVec3,
    normal: DVec3,
}

/// An edge of a face that was found.
#[derive(Debug, Clone, Copy)]
struct Edge {
    from: usize,
    to: usize,
    plane: Plane,
    /// Mean of the face's corners.
    middle: DVec3,
}

impl Edge {
    fn name(&self) -> (usize, usize) {
        (self.from.min(self.to), self.from.max(self.to))
    }
}

/// Faces found so far, how many of them each edge has, and edges to look beyond.
#[derive(Debug, Default)]
struct Wrapped {
    faces: Vec<Vec<usize>>,
    uses: BTreeMap<(usize, usize), usize>,
    open: VecDeque<Edge>,
}

impl Wrapped {
    fn add(&mut self, points: &[DVec3], plane: Plane, corners: Vec<usize>) -> Result<(), SolidError> {
        // A hull of n points has at most 2n - 4 faces: more would be a fault of rounding, without end.
        if corners.len() < 3 || self.faces.len() > 2 * points.len() {
            return Err(SolidError::Flat);
        }
        let middle = corners.iter().map(|&corner| points[corner]).sum::<DVec3>() / corners.len() as f64;
        for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let edge = Edge { from, to, plane, middle };
            *self.uses.entry(edge.name()).or_default() += 1;
            self.open.push_back(edge);
        }
        self.faces.push(corners);
        Ok(())
    }
}

struct Wrapping<'a> {
    points: &'a [DVec3],
    slack: f64,
}

impl<'a> Wrapping<'a> {
    fn new(points: &'a [DVec3]) -> Self {
        Self { points, slack: slack(points) }
    }

    /// Corners of all faces: from one face over every edge to the next.
    fn faces(&self) -> Result<Vec<Vec<usize>>, SolidError> {
        let mut wrapped = Wrapped::default();
        let (plane, corners) = self.first_face();
        wrapped.add(self.points, plane, corners)?;
        while let Some(edge) = wrapped.open.pop_front() {
            if wrapped.uses[&edge.name()] < 2 {
                let (plane, corners) = self.beyond(&edge).ok_or(SolidError::Flat)?;
                wrapped.add(self.points, plane, corners)?;
            }
        }
        Ok(wrapped.faces)
    }

    /// Any face: a plane that touches at the hindmost point, wrapped about two lines.
    fn first_face(&self) -> (Plane, Vec<usize>) {
        let by_place = |&a: &usize, &b: &usize| {
            let [a, b] = [self.points[a], self.points[b]];
            a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z))
        };
        let start = (0..self.points.len()).min_by(by_place).unwrap_or_default();
        let at = self.points[start];
        let touching = Plane { at, normal: DVec3::NEG_X };
        let leaning = self.wrap(touching, DVec3::Z, DVec3::Y).unwrap_or(touching);
        let corners = self.outline(leaning);
        match corners[..] {
            [from, to] => {
                let along = (self.points[to] - self.points[from]).normalize();
                let plane = self.wrap(leaning, along, leaning.normal.cross(along)).unwrap_or(leaning);
                (plane, self.outline(plane))
            }
            _ => (leaning, corners),
        }
    }

    /// The face on the other side of an edge.
    fn beyond(&self, edge: &Edge) -> Option<(Plane, Vec<usize>)> {
        let at = self.points[edge.from];
        let along = (self.points[edge.to] - at).normalize();
        let across = along.cross(edge.plane.normal);
        let ahead = if across.dot(edge.middle - at) > 0.0 { -across } else { across };
        let plane = self.wrap(Plane { at, ..edge.plane }, along, ahead)?;
        Some((plane, self.outline(plane)))
    }

    /// Turns `plane` about the line `along` through its point, its half `ahead` downwards, until it touches a
    /// point.
    fn wrap(&self, plane: Plane, along: DVec3, ahead: DVec3) -> Option<Plane> {
        let across_line = |point: &DVec3| {
            let from = *point - plane.at;
            [from.dot(ahead), (-from.dot(plane.normal)).max(0.0)]
        };
        let off_line = |[out, down]: &[f64; 2]| out.abs().max(*down) > self.slack;
        // All angles lie between 0 and 180 degrees, where the cross product orders them.
        let flatter = |a: [f64; 2], b: [f64; 2]| if b[1] * a[0] < a[1] * b[0] { b } else { a };
        let steps = self.points.iter().map(across_line).filter(off_line);
        let [out, down] = steps.filter(|step| step[0] > 0.0 || step[1] > self.slack).reduce(flatter)?;
        let turned = (ahead * down + plane.normal * out).normalize();
        let square = turned - along * along.dot(turned);
        Some(Plane { at: plane.at, normal: square.normalize() })
    }

    /// Corners of the polygon that the points in `plane` span, in order; two if they lie on a line. From the
    /// point farthest from the middle, a corner, always on to the rightmost; of several in one line to the
    /// farthest.
    fn outline(&self, plane: Plane) -> Vec<usize> {
        let is_in = |&index: &usize| plane.normal.dot(self.points[index] - plane.at) >= -self.slack;
        let flat: Vec<usize> = (0..self.points.len()).filter(is_in).collect();
        let middle = flat.iter().map(|&index| self.points[index]).sum::<DVec3>() / flat.len() as f64;
        let farness = |&&index: &&usize| self.points[index].distance_squared(middle);
        let Some(&start) = flat.iter().max_by(|a, b| farness(a).total_cmp(&farness(b))) else { return flat };
        let mut outline = vec![start];
        let mut at = start;
        while let Some(next) = self.rightmost(at, &flat, plane.normal) {
            if next == start || outline.len() == flat.len() {
                break;
            }
            outline.push(next);
            at = next;
        }
        outline
    }

    /// The point of `flat` that has none to its right, seen from point `at`.
    fn rightmost(&self, at: usize, flat: &[usize], normal: DVec3) -> Option<usize> {
        let from = self.points[at];
        let more_right = |best: usize, other: usize| {
            let (line, step) = (self.points[best] - from, self.points[other] - from);
            let right = step.cross(line).dot(normal) / line.length();
            let farther = step.length_squared() > line.length_squared();
            if right > self.slack || (right >= -self.slack && farther) { other } else { best }
        };
        flat.iter().copied().filter(|&other| other != at).reduce(more_right)
    }
}
