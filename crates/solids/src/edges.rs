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

#[cfg(test)]
mod tests {
    use crate::rocks;

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
