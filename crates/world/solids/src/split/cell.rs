//! A convex room of space, cut smaller plane by plane.

use std::collections::BTreeMap;

use glam::DVec3;

use super::plane::Plane;
use crate::{Face, Solid, SolidError};

/// A convex polyhedron by its sides.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    sides: Vec<Side>,
}

/// A side: a convex polygon in a plane.
#[derive(Debug, Clone)]
struct Side {
    /// Unit normal of its plane, outwards.
    normal: DVec3,
    /// Counter-clockwise seen from outside, by right-handed axes. Sides that meet have corners of the same bits.
    corners: Vec<DVec3>,
}

impl Side {
    /// Twice the area, along the normal (m2).
    fn area(&self) -> DVec3 {
        let first = self.corners[0];
        self.corners.windows(2).map(|edge| (edge[0] - first).cross(edge[1] - first)).sum()
    }
}

impl Cell {
    /// A box between two corners (m).
    pub fn boxed(low: DVec3, high: DVec3) -> Self {
        let ends = [low, high];
        let corner = |bits: [usize; 3]| DVec3::new(ends[bits[0]].x, ends[bits[1]].y, ends[bits[2]].z);
        let side = |number: usize| {
            let (axis, end) = (number / 2, number % 2);
            let mut corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[a, b]| {
                let mut bits = [0; 3];
                (bits[axis], bits[(axis + 1) % 3], bits[(axis + 2) % 3]) = (end, a, b);
                corner(bits)
            });
            if end == 0 {
                corners.reverse();
            }
            let mut normal = DVec3::ZERO;
            normal[axis] = if end == 0 { -1.0 } else { 1.0 };
            Side { normal, corners: corners.to_vec() }
        };
        Self { sides: (0..6).map(side).collect() }
    }

    /// The parts in front of and behind a plane; `None` for a part without a volume.
    pub fn cut(&self, plane: &Plane, slack: f64) -> [Option<Self>; 2] {
        let reached = self.sides.iter().fold([false; 2], |[front, back], side| {
            let [in_front, behind] = plane.reaches(&side.corners, slack);
            [front | in_front, back | behind]
        });
        if reached != [true, true] {
            return reached.map(|whole| whole.then(|| self.clone()));
        }
        let (mut front, mut back) = (Vec::new(), Vec::new());
        for side in &self.sides {
            let halves = plane.cut(&side.corners, slack);
            let [in_front, behind] = plane.reaches(&side.corners, slack);
            front.extend(in_front.then_some(Side { corners: halves.front, ..*side }));
            back.extend(behind.then_some(Side { corners: halves.back, ..*side }));
        }
        let closed = |mut sides: Vec<Side>, normal: DVec3| {
            let corners = lid(&sides)?;
            sides.push(Side { normal, corners });
            Some(Self { sides })
        };
        [closed(front, -plane.normal), closed(back, plane.normal)]
    }

    /// What lies behind a plane.
    pub fn behind(&self, plane: &Plane, slack: f64) -> Option<Self> {
        let [_, back] = self.cut(plane, slack);
        back
    }

    /// A place inside: the mean of all corners of sides.
    pub fn middle(&self) -> DVec3 {
        let corners = || self.sides.iter().flat_map(|side| &side.corners);
        corners().sum::<DVec3>() / corners().count() as f64
    }

    /// Volume of the polyhedron (m3).
    pub fn volume(&self) -> f64 {
        let middle = self.middle();
        self.sides.iter().map(|side| side.area().dot(side.corners[0] - middle) / 6.0).sum()
    }

    /// Whether it is thinner than `slack` (m): its volume over its largest side.
    pub fn is_thin(&self, slack: f64) -> bool {
        let largest = self.sides.iter().map(|side| 0.5 * side.area().length()).fold(0.0, f64::max);
        self.volume() <= slack * largest
    }

    /// The same as a solid.
    ///
    /// # Errors
    /// If it has too many corners, or does not close.
    pub fn solid(&self, albedo: f64) -> Result<Solid, SolidError> {
        let (mut numbers, mut vertices) = (BTreeMap::new(), Vec::new());
        let mut number = |place: &DVec3| {
            *numbers.entry(bits(*place)).or_insert_with(|| {
                vertices.push(*place);
                vertices.len() as u32 - 1
            })
        };
        let mut faces = Vec::with_capacity(self.sides.len());
        for Side { normal, corners } in &self.sides {
            // Body axes are left-handed.
            let corners = corners.iter().rev().map(&mut number).collect();
            faces.push(Face { corners, normal: *normal, albedo });
        }
        Solid::of_faces(vertices, faces)
    }
}

/// A place as a key.
fn bits(place: DVec3) -> [u64; 3] {
    place.to_array().map(f64::to_bits)
}

/// The side that closes all others: it runs back along every edge that only one of them has. `None` if they leave no such side.
fn lid(sides: &[Side]) -> Option<Vec<DVec3>> {
    let mut open = BTreeMap::new();
    for Side { corners, .. } in sides {
        let next = corners.iter().cycle().skip(1);
        for (from, to) in corners.iter().zip(next) {
            let is_closed = open.remove(&[bits(*to), bits(*from)]).is_some();
            if !is_closed {
                open.insert([bits(*from), bits(*to)], *to);
            }
        }
    }
    let next: BTreeMap<[u64; 3], DVec3> = open.iter().map(|([from, _], to)| (*from, *to)).collect();
    let mut lid: Vec<DVec3> = next.values().next().copied().into_iter().collect();
    while let Some(&to) = next.get(&bits(*lid.last()?)).filter(|to| bits(**to) != bits(lid[0])) {
        lid.push(to);
        if lid.len() > open.len() {
            return None;
        }
    }
    lid.reverse();
    (lid.len() > 2 && lid.len() == open.len()).then_some(lid)
}
