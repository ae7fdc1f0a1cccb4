//! Faces whose vertices at one place are one, and which of them hang together.

use std::collections::BTreeMap;

use glam::DVec3;

use super::mesh::{Face, Mesh};
use super::outline::ears;

/// Faces with common vertices.
pub(super) struct Joined<'m> {
    pub places: Vec<DVec3>,
    /// The file's index of each.
    pub named: Vec<usize>,
    pub faces: Vec<JoinedFace<'m>>,
    /// Faces that were left out because they have no area.
    pub left_out: usize,
}

/// A face by numbers of common vertices; an outline with dents is several.
#[derive(Clone)]
pub(super) struct JoinedFace<'m> {
    pub corners: Vec<u32>,
    /// The face of the file.
    pub of: &'m Face,
    /// Number of its part.
    pub part: usize,
}

/// The two ends of an edge, ascending, and the faces that have it, each with whether its outline ascends there.
pub(super) type Edges = BTreeMap<[u32; 2], Vec<(usize, bool)>>;

impl<'m> Joined<'m> {
    /// Joins the vertices of faces of `mesh`, each with the number of its part. A corner that repeats the one before it is left out, and with it faces that had
    /// three corners and keep two: they have no area.
    pub fn new(mesh: &Mesh, faces: impl Iterator<Item = (usize, &'m Face)>) -> Self {
        let mut numbers = BTreeMap::new();
        let mut joined = Self { places: Vec::new(), named: Vec::new(), faces: Vec::new(), left_out: 0 };
        for (part, of) in faces {
            let mut corners: Vec<u32> = Vec::with_capacity(of.corners.len());
            for corner in &of.corners {
                let place = mesh.vertices[corner.vertex].place;
                // Adding 0 makes -0 the same place as 0.
                let number = numbers.entry(place.to_array().map(|length| (length + 0.0).to_bits()));
                corners.push(*number.or_insert_with(|| {
                    joined.places.push(place);
                    joined.named.push(corner.vertex);
                    joined.places.len() as u32 - 1
                }));
            }
            let written = corners.len();
            corners.dedup();
            if corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            if corners.len() > 2 || written < 3 {
                joined.add(JoinedFace { corners, of, part });
            } else {
                joined.left_out += 1;
            }
        }
        joined.used_only()
    }

    fn add(&mut self, face: JoinedFace<'m>) {
        let places: Vec<DVec3> = face.corners.iter().map(|&corner| self.places[corner as usize]).collect();
        match ears(&places) {
            Some(triangles) => self.faces.extend(triangles.into_iter().map(|triangle| {
                let corners = triangle.map(|corner| face.corners[corner]).to_vec();
                JoinedFace { corners, ..face }
            })),
            None => self.faces.push(face),
        }
    }

    /// The same without vertices that no face has.
    fn used_only(self) -> Self {
        let all: Vec<usize> = (0..self.faces.len()).collect();
        Self { left_out: self.left_out, ..self.only(&all) }
    }

    /// Some of the faces, by number, with their vertices in order of use.
    pub fn only(&self, faces: &[usize]) -> Self {
        let mut numbers = vec![u32::MAX; self.places.len()];
        let (places, named) = (Vec::new(), Vec::new());
        let mut some = Self { places, named, faces: Vec::with_capacity(faces.len()), left_out: 0 };
        for &face in faces {
            let JoinedFace { corners, of, part } = &self.faces[face];
            let renumbered = corners.iter().map(|&corner| {
                let number = &mut numbers[corner as usize];
                if *number == u32::MAX {
                    *number = some.places.len() as u32;
                    some.places.push(self.places[corner as usize]);
                    some.named.push(self.named[corner as usize]);
                }
                *number
            });
            let corners = renumbered.collect();
            some.faces.push(JoinedFace { corners, of, part: *part });
        }
        some
    }

    /// All edges of the faces.
    pub fn edges(&self) -> Edges {
        let mut edges = Edges::new();
        for (number, face) in self.faces.iter().enumerate() {
            let next = face.corners.iter().cycle().skip(1);
            for (&from, &to) in face.corners.iter().zip(next) {
                edges.entry([from.min(to), from.max(to)]).or_default().push((number, from < to));
            }
        }
        edges
    }

    /// The shells: sets of faces, by number, that hang together by edges. Of each, whether it closes: every edge has two faces.
    pub fn shells(&self) -> Vec<(Vec<usize>, bool)> {
        let edges = self.edges();
        let mut beside = vec![Vec::new(); self.faces.len()];
        let mut is_rim = vec![false; self.faces.len()];
        for faces in edges.values() {
            for (&(face, _), &(other, _)) in faces.iter().zip(faces.iter().cycle().skip(1)) {
                beside[face].push(other);
                beside[other].push(face);
                is_rim[face] |= faces.len() != 2;
            }
        }
        let mut is_met = vec![false; self.faces.len()];
        let mut shells = Vec::new();
        for first in 0..self.faces.len() {
            let (mut shell, mut open) = (Vec::new(), vec![first]);
            while let Some(face) = open.pop() {
                if !std::mem::replace(&mut is_met[face], true) {
                    shell.push(face);
                    open.extend(&beside[face]);
                }
            }
            shell.sort_unstable();
            let closes = !shell.iter().any(|&face| is_rim[face]);
            if !shell.is_empty() {
                shells.push((shell, closes));
            }
        }
        shells
    }

    /// Corners and albedo of all faces, as solids are made of.
    pub fn outlines(&self, albedo: f64) -> Vec<(Vec<u32>, f64)> {
        self.faces.iter().map(|face| (face.corners.clone(), albedo)).collect()
    }
}
