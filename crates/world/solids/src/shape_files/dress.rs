//! Colours and normals of a mesh on the solids made of it.

use glam::DVec3;

use super::joined::Joined;
use super::mesh::{Face, Mesh, WHITE};
use super::oriented::Oriented;
use crate::{Solid, SolidError};

/// A solid of all faces of a shell, with the colours and normals of their corners.
pub(super) fn dressed(solid: Solid, mesh: &Mesh, shell: &Joined) -> Result<Solid, SolidError> {
    let of = |face: usize| shell.faces[face].of;
    let normal = |face: usize, corner: u32| {
        normal_at(mesh, of(face), mesh.vertices[shell.named[corner as usize]].place)
    };
    Ok(solid.with_colours(|face| mesh.colour(of(face)))?.with_normals(normal))
}

/// The normal that a face has at one of its corners, of any length.
fn normal_at(mesh: &Mesh, face: &Face, place: DVec3) -> Option<DVec3> {
    let corner = face.corners.iter().find(|corner| mesh.vertices[corner.vertex].place == place)?;
    Some(mesh.normals[corner.normal?])
}

/// A triangle of a shell, as faces of parts look for it.
struct Cloth<'m> {
    corners: [DVec3; 3],
    /// Unit normal of the triangle, outwards.
    normal: DVec3,
    of: &'m Face,
}

/// The looks of a shell, for parts that it was split into.
pub(super) struct Wardrobe<'m> {
    mesh: &'m Mesh,
    cloths: Vec<Cloth<'m>>,
    /// Distance within which a triangle lies in a face (m).
    slack: f64,
}

impl<'m> Wardrobe<'m> {
    /// The triangles of a shell. There are none if it has neither colours nor normals.
    pub fn new(mesh: &'m Mesh, shell: &Joined<'m>, oriented: &Oriented) -> Self {
        let faces = || shell.faces.iter().map(|face| face.of);
        let has_normals = faces().any(|face| face.corners.iter().any(|corner| corner.normal.is_some()));
        let has_looks = has_normals || faces().any(|face| mesh.colour(face) != WHITE);
        let size = shell.places.iter().map(|place| place.distance(shell.places[0])).fold(0.0, f64::max);
        let cloth = |(&[a, b, c], &face): (&[DVec3; 3], &usize)| {
            let normal = (b - a).cross(c - a).try_normalize()?;
            Some(Cloth { corners: [a, b, c], normal, of: shell.faces[face].of })
        };
        let all = oriented.triangles.iter().zip(&oriented.faces);
        let cloths = if has_looks { all.filter_map(cloth).collect() } else { Vec::new() };
        Self { mesh, cloths, slack: Solid::TOLERANCE * size }
    }

    /// A part with the looks of the triangles that lie in its faces. A face with several colours has their mean by area. A face
    /// between two parts is never seen; it is white.
    pub fn dressed(&self, part: Solid) -> Result<Solid, SolidError> {
        if self.cloths.is_empty() {
            return Ok(part);
        }
        let worn: Vec<Vec<(&Cloth, f64)>> =
            (0..part.faces().len()).map(|face| self.worn(&part, face)).collect();
        let places = part.vertices().to_vec();
        let colour = |face: usize| self.colour(&worn[face]);
        let normal = |face: usize, corner: u32| self.normal(&worn[face], places[corner as usize]);
        Ok(part.with_colours(colour)?.with_normals(normal))
    }

    /// The triangles that lie in a face of a part, each with the area that they share (m2).
    fn worn(&self, part: &Solid, face: usize) -> Vec<(&Cloth<'m>, f64)> {
        let face = &part.faces()[face];
        let outline: Vec<DVec3> =
            face.corners.iter().map(|&corner| part.vertices()[corner as usize]).collect();
        let lies = |cloth: &&Cloth| {
            let is_near = |at: &DVec3| face.normal.dot(*at - outline[0]).abs() <= self.slack;
            face.normal.dot(cloth.normal) > 0.9 && cloth.corners.iter().all(is_near)
        };
        let shared = |cloth| Some((cloth, common_area(cloth, &outline)));
        let worn = self.cloths.iter().filter(lies).filter_map(shared);
        worn.filter(|(_, area)| *area > 0.0).collect()
    }

    fn colour(&self, worn: &[(&Cloth, f64)]) -> [f64; 3] {
        let whole: f64 = worn.iter().map(|(_, area)| area).sum();
        if whole == 0.0 {
            return WHITE;
        }
        std::array::from_fn(|channel| {
            let light = |(cloth, area): &(&Cloth, f64)| self.mesh.colour(cloth.of)[channel] * area;
            (worn.iter().map(light).sum::<f64>() / whole).min(1.0)
        })
    }

    /// The normal at a place: mixed from the corners of the triangle that holds the place best.
    fn normal(&self, worn: &[(&Cloth, f64)], place: DVec3) -> Option<DVec3> {
        let shared = worn.iter().map(|(cloth, _)| (*cloth, shares(cloth, place)));
        let least = |shares: &[f64; 3]| shares.iter().copied().fold(f64::INFINITY, f64::min);
        let (cloth, shares) = shared.max_by(|(_, a), (_, b)| least(a).total_cmp(&least(b)))?;
        let normal = |corner: DVec3| normal_at(self.mesh, cloth.of, corner)?.try_normalize();
        let [a, b, c] = cloth.corners.map(normal);
        let [x, y, z] = shares.map(|share| share.max(0.0));
        Some(a? * x + b? * y + c? * z)
    }
}

/// Shares of a triangle's corners at a place; one is negative outside.
fn shares(cloth: &Cloth, place: DVec3) -> [f64; 3] {
    let [a, b, c] = cloth.corners;
    let area = |a: DVec3, b: DVec3, c: DVec3| cloth.normal.dot((b - a).cross(c - a));
    let whole = area(a, b, c);
    [area(place, b, c), area(a, place, c), area(a, b, place)].map(|part| part / whole)
}

/// Area that a triangle has in common with a convex outline in its plane (m2).
fn common_area(cloth: &Cloth, outline: &[DVec3]) -> f64 {
    let mut common = cloth.corners.to_vec();
    let next = outline.iter().cycle().skip(1);
    for (&from, &to) in outline.iter().zip(next) {
        // Outlines of solids run clockwise seen from outside by right-handed axes.
        let inwards = (to - from).cross(cloth.normal);
        common = kept(&common, |place| inwards.dot(place - from));
    }
    let [first, ..] = common[..] else { return 0.0 };
    let area = common.windows(2).map(|edge| (edge[0] - first).cross(edge[1] - first)).sum::<DVec3>();
    0.5 * area.length()
}

/// The part of a convex outline where `height` is not negative.
fn kept(outline: &[DVec3], height: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(outline.len() + 1);
    let next = outline.iter().cycle().skip(1);
    for (&from, &to) in outline.iter().zip(next) {
        let [here, there] = [height(from), height(to)];
        if here >= 0.0 {
            kept.push(from);
        }
        if here * there < 0.0 {
            kept.push(from + (to - from) * (here / (here - there)));
        }
    }
    kept
}
