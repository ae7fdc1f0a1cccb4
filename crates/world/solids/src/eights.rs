//! Vertices and faces of a solid, eight side by side: for whoever works on them in vectors.

use glam::DVec3;

use crate::Face;

/// How many stand side by side.
const TOGETHER: usize = 8;

/// x, y and z of eight points or directions in body axes.
type Eight = [[f64; TOGETHER]; 3];

/// All vertices and faces of a solid in groups of eight.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Eights {
    /// Vertices; the last one stands in for those that are not there.
    pub vertices: Box<[Eight]>,
    /// Faces, in groups of eight.
    pub faces: Box<[EightFaces]>,
}

/// Eight faces; those that are not there look nowhere.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EightFaces {
    /// Unit normals of the faces, outwards.
    pub normals: Eight,
    /// How far from the foot point, along its normal, the plane of each lies: a face looks at what lies farther.
    pub distances: [f64; TOGETHER],
    /// Share of the light that is returned, 0..=1.
    pub albedos: [f64; TOGETHER],
}

impl Eights {
    pub(crate) fn new(vertices: &[DVec3], faces: &[Face]) -> Self {
        let eight_vertices =
            |some: &[DVec3]| [0, 1, 2].map(|axis| std::array::from_fn(|n| some[n.min(some.len() - 1)][axis]));
        let eight_faces = |some: &[Face]| {
            let mut eight = EightFaces::default();
            for (n, face) in some.iter().enumerate() {
                (0..3).for_each(|axis| eight.normals[axis][n] = face.normal[axis]);
                eight.distances[n] = face.normal.dot(vertices[face.corners[0] as usize]);
                eight.albedos[n] = face.albedo;
            }
            eight
        };
        Self {
            vertices: vertices.chunks(TOGETHER).map(eight_vertices).collect(),
            faces: faces.chunks(TOGETHER).map(eight_faces).collect(),
        }
    }
}
