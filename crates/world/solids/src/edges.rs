//! Edges of a solid: each once, though two faces share it.

use std::collections::BTreeMap;

use crate::Face;

/// An edge of a solid, between two faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Edge {
    /// Indices of its two corners among the vertices.
    corners: [u32; 2],
    /// The face along whose outline it runs from the first corner to the second, and the one along whose outline it runs back.
    faces: [u32; 2],
}

/// Edges of `faces`, which close: every edge runs along one outline and back along another.
pub(crate) fn edges_of(faces: &[Face]) -> Vec<Edge> {
    let mut met = BTreeMap::new();
    let mut edges = Vec::new();
    for (number, face) in (0..).zip(faces) {
        let next = face.corners.iter().cycle().skip(1);
        for (&from, &to) in face.corners.iter().zip(next) {
            match met.get(&[to, from]) {
                Some(&other) => edges.push(Edge { corners: [to, from], faces: [other, number] }),
                None => {
                    met.insert([from, to], number);
                }
            }
        }
    }
    edges
}

/// Sixteen edges side by side, each told by the bytes of a word, from the lowest: two corners, the face along whose outline it runs
/// from the first to the second, and the one along whose outline it runs back. Those that are not there have one corner twice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EdgeWords(pub [u32; EdgeWords::TOGETHER]);

impl EdgeWords {
    /// How many edges stand side by side.
    pub const TOGETHER: usize = 16;
    /// Most corners and faces of a solid that is told by words, so that a bit each tells any of them: all rocks, and whatever else
    /// is shipped.
    const MOST: [usize; 2] = [u32::BITS as usize, u64::BITS as usize];

    /// Those of a solid with so many corners and faces; none if there are too many.
    pub(crate) fn all(edges: &[Edge], [corners, faces]: [usize; 2]) -> Box<[Self]> {
        let is_told = corners <= Self::MOST[0] && faces <= Self::MOST[1];
        let told = if is_told { edges } else { &[] };
        told.chunks(Self::TOGETHER).map(Self::new).collect()
    }

    fn new(edges: &[Edge]) -> Self {
        let mut words = Self::default();
        for (word, Edge { corners, faces }) in words.0.iter_mut().zip(edges) {
            let [from, to, along, back] =
                [corners[0], corners[1], faces[0], faces[1]].map(|number| number as u8);
            *word = u32::from_le_bytes([from, to, along, back]);
        }
        words
    }
}

#[cfg(test)]
mod tests {
    use super::{EdgeWords, edges_of};
    use crate::{Solid, rocks};
    use glam::DVec3;

    #[test]
    fn words_tell_what_the_lists_tell() {
        for solid in rocks::shapes(5).unwrap() {
            let mut told: Vec<u32> = solid.edge_words().iter().flat_map(|sixteen| sixteen.0).collect();
            let edges = edges_of(solid.faces());
            assert_eq!(told.len(), edges.len().next_multiple_of(EdgeWords::TOGETHER));
            assert!(told.drain(edges.len()..).all(|none| none == 0));
            for (edge, word) in edges.iter().zip(told) {
                let [from, to, along, back] = word.to_le_bytes().map(u32::from);
                assert_eq!(([from, to], [along, back]), (edge.corners, edge.faces));
            }
        }
    }

    #[test]
    fn a_solid_of_too_many_corners_is_not_told_by_words() {
        let drum = |sides| Solid::prism([DVec3::ZERO, DVec3::Z], [1.0; 2], DVec3::X, sides, 0.5).unwrap();
        assert_eq!(drum(16).edge_words().len(), 3);
        assert!(drum(17).edge_words().is_empty());
    }

    #[test]
    fn every_edge_runs_along_its_two_faces_and_each_face_has_all_of_its_own() {
        for solid in rocks::shapes(3).unwrap() {
            let (faces, edges) = (solid.faces(), edges_of(solid.faces()));
            assert_eq!(solid.vertices().len() + faces.len(), edges.len() + 2, "Euler");
            let runs = |face: usize, from: u32, to: u32| {
                let corners = &faces[face].corners;
                let at = corners.iter().position(|&corner| corner == from);
                at.is_some_and(|at| corners[(at + 1) % corners.len()] == to)
            };
            for edge in edges {
                let ([a, b], [along, back]) = (edge.corners, edge.faces.map(|face| face as usize));
                assert!(runs(along, a, b) && runs(back, b, a), "{edge:?}");
            }
        }
    }
}
