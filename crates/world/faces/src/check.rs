//! Whether faces can be drawn: numbers, corners, plane, convex.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::error::FaceError;
use crate::face::{Face, Shading, Vertex};
use crate::mesh::Mesh;
use crate::warning::Degenerate;

/// Part of a face's size below which two corners lie at one place, and of its squared size below which it has no area (chosen).
const NOTHING: f64 = 1e-12;

/// The vertex with a unit normal.
pub(crate) fn checked_vertex(list: &str, number: usize, vertex: Vertex) -> Result<Vertex, FaceError> {
    if !vertex.place.is_finite() {
        return Err(FaceError::Place { list: list.into(), vertex: number });
    }
    let unit = |normal: DVec3| {
        normal.try_normalize().ok_or_else(|| FaceError::Normal { list: list.into(), vertex: number })
    };
    Ok(Vertex { normal: vertex.normal.map(unit).transpose()?, ..vertex })
}

/// Refuses corners that are too few or missing, and colours out of range.
pub(crate) fn check_corners(list: &str, face: usize, of: &Face, vertices: usize) -> Result<(), FaceError> {
    let list = || list.to_owned();
    if of.corners.len() < 3 {
        return Err(FaceError::Corners { list: list(), face, found: of.corners.len() });
    }
    if let Some(&vertex) = of.corners.iter().find(|&&corner| corner as usize >= vertices) {
        return Err(FaceError::NoVertex { list: list(), face, vertex, vertices });
    }
    match of.colour.into_iter().find(|channel| !(0.0..=1.0).contains(channel)) {
        Some(found) => Err(FaceError::Colour { list: list(), face, found }),
        None => Ok(()),
    }
}

/// The corners of one face with their places.
pub(crate) struct Outline<'a> {
    pub list: &'a str,
    pub face: usize,
    pub corners: &'a [u32],
    pub places: &'a [DVec3],
}

impl Outline<'_> {
    /// Largest distance of a corner from the first one (m).
    fn size(&self) -> f64 {
        self.places.iter().map(|place| place.distance(self.places[0])).fold(0.0, f64::max)
    }

    /// Corner `k`, and the corners after the last one from the first.
    fn place(&self, k: usize) -> DVec3 {
        self.places[k % self.places.len()]
    }

    /// Why there is nothing to show, if so.
    pub fn degenerate(&self) -> Option<Degenerate> {
        let size = self.size();
        let count = self.places.len();
        let meets =
            |k: usize| (k + 1..count).any(|l| self.place(k).distance(self.place(l)) <= NOTHING * size);
        if (0..count).any(meets) {
            return Some(Degenerate::RepeatedVertex);
        }
        (self.area().length() <= NOTHING * size * size).then_some(Degenerate::NoArea)
    }

    /// Twice the area as a vector towards the front: counter-clockwise corners, left-handed axes, so the cross product of the
    /// components is reversed.
    fn area(&self) -> DVec3 {
        let from = self.places[0];
        let part = |k: usize| (self.place(k + 1) - from).cross(self.place(k) - from);
        (1..self.places.len() - 1).map(part).sum()
    }

    /// Unit normal towards the front of a face that has an area.
    pub fn normal(&self) -> DVec3 {
        self.area().normalize()
    }

    /// Unit normal of the face, and whether it is plane.
    pub fn checked(&self, shading: Shading) -> Result<(DVec3, bool), FaceError> {
        let normal = self.normal();
        if self.places.len() == 3 {
            return Ok((normal, true));
        }
        let is_plane = self.check_plane(normal);
        if shading == Shading::Flat {
            is_plane.clone()?;
        }
        self.check_convex(normal)?;
        Ok((normal, is_plane.is_ok()))
    }

    fn check_plane(&self, normal: DVec3) -> Result<(), FaceError> {
        let middle = self.places.iter().sum::<DVec3>() / self.places.len() as f64;
        let off = |k: usize| normal.dot(self.places[k] - middle).abs();
        let worst = (0..self.places.len()).max_by(|&a, &b| off(a).total_cmp(&off(b)));
        match worst.filter(|&k| off(k) > Mesh::PLANE * self.size()) {
            Some(k) => {
                let (list, vertex) = (self.list.to_owned(), self.corners[k]);
                Err(FaceError::NotPlane { list, face: self.face, vertex, off: off(k) })
            }
            None => Ok(()),
        }
    }

    /// Every corner turns to the left seen from the front, and all turns together make one full turn.
    fn check_convex(&self, normal: DVec3) -> Result<(), FaceError> {
        let refused = |k: usize| {
            let (list, vertex) = (self.list.to_owned(), self.corners[k % self.corners.len()]);
            Err(FaceError::NotConvex { list, face: self.face, vertex })
        };
        let mut turned = 0.0;
        for k in 1..=self.places.len() {
            let (before, after) = (self.place(k) - self.place(k - 1), self.place(k + 1) - self.place(k));
            let left = normal.dot(after.cross(before));
            // Three corners on one line are allowed; rounding may bend them a little.
            if left < -NOTHING * self.size() * self.size() {
                return refused(k);
            }
            turned += libm::atan2(left, before.dot(after));
            if turned > 1.25 * TAU {
                return refused(k);
            }
        }
        Ok(())
    }
}
