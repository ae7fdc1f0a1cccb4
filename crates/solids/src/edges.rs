//! Edges of a solid: each once, though two faces share it.

use std::collections::BTreeMap;

use crate::Face;

/// An edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edge {
    /// Its two corners.
    pub corners: [u32; 2],
    /// The face along whose outline it runs from the first corner to the second, and the one along whose outline it runs back.
    pub faces: [u32; 2],
}

/// Edges of `faces`, which close: every edge runs along one outline and back along another.
pub(crate) fn edges_of(faces: &[Face]) -> Box<[Edge]> {
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
    edges.into()
}

/// Sixteen edges side by side, corners and faces told by bits: two bits each; those that are not there have none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EdgeBits {
    /// Its corners.
    pub corners: [u32; EdgeBits::TOGETHER],
    /// Its faces: the first 32, and the others.
    pub faces: [[u32; EdgeBits::TOGETHER]; 2],
}

impl EdgeBits {
    /// How many edges stand side by side.
    pub const TOGETHER: usize = 16;
    /// Most corners and faces of a solid that can be told by bits: all rocks, and whatever else is shipped.
    const MOST: [usize; 2] = [u32::BITS as usize, u64::BITS as usize];

    /// Those of a solid with so many corners and faces; none if there are too many.
    pub(crate) fn all(edges: &[Edge], [corners, faces]: [usize; 2]) -> Box<[Self]> {
        let is_told = corners <= Self::MOST[0] && faces <= Self::MOST[1];
        let told = if is_told { edges } else { &[] };
        told.chunks(Self::TOGETHER).map(Self::new).collect()
    }

    fn new(edges: &[Edge]) -> Self {
        let mut bits = Self::default();
        for (place, edge) in edges.iter().enumerate() {
            edge.corners.iter().for_each(|corner| bits.corners[place] |= 1 << corner);
            let faces = edge.faces.iter().fold(0u64, |faces, face| faces | 1 << face);
            (bits.faces[0][place], bits.faces[1][place]) = (faces as u32, (faces >> u32::BITS) as u32);
        }
        bits
    }
}

#[cfg(test)]
mod tests {
    use super::EdgeBits;
    use crate::{Solid, rocks};
    use glam::DVec3;

    #[test]
    fn bits_tell_what_the_lists_tell() {
        for solid in rocks::shapes(5).unwrap() {
            let told = solid.edge_bits().iter().flat_map(|sixteen| {
                (0..EdgeBits::TOGETHER).map(|n| (sixteen.corners[n], sixteen.faces.map(|faces| faces[n])))
            });
            let mut told: Vec<_> = told.collect();
            let edges = solid.edges();
            assert!(told.drain(edges.len()..).all(|none| none == (0, [0; 2])));
            for (edge, (corners, [first, others])) in edges.iter().zip(told) {
                assert_eq!(edge.corners.map(|corner| 1 << corner).into_iter().sum::<u32>(), corners);
                let faces = u64::from(others) << 32 | u64::from(first);
                assert_eq!(edge.faces.map(|face| 1 << face).into_iter().sum::<u64>(), faces);
            }
        }
    }

    #[test]
    fn a_solid_of_too_many_corners_is_not_told_by_bits() {
        let drum = |sides| Solid::prism([DVec3::ZERO, DVec3::Z], [1.0; 2], DVec3::X, sides, 0.5).unwrap();
        assert_eq!(drum(16).edge_bits().len(), 3);
        assert!(drum(17).edge_bits().is_empty());
    }

    #[test]
    fn every_edge_runs_along_its_two_faces_and_each_face_has_all_of_its_own() {
        for solid in rocks::shapes(3).unwrap() {
            let (faces, edges) = (solid.faces(), solid.edges());
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
