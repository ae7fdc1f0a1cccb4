//! Normals at the corners of faces: given, or averaged over the faces that meet at a vertex.

use glam::DVec3;

use crate::face::{Face, Shading};
use crate::mesh::Mesh;

/// How much each face counts in the average at a vertex.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weights {
    /// All faces count the same (reported).
    Equal,
    /// A face counts by its angle at the vertex (chosen).
    Angle,
}

/// Length of a sum of unit normals, for each of them, below which they cancel (chosen).
const CANCELS: f64 = 1e-9;

/// Unit normals at the corners of all faces of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct CornerNormals {
    starts: Vec<usize>,
    normals: Vec<DVec3>,
    knife_edges: u64,
}

impl CornerNormals {
    /// Normals of `mesh`; a flat face has its own normal at all corners.
    ///
    /// A vertex whose normals cancel is a knife edge: each of its faces has its own normal there.
    pub fn new(mesh: &Mesh, weights: Weights) -> Self {
        let sums = sums(mesh, weights);
        let units: Vec<Option<DVec3>> = mesh
            .vertices()
            .iter()
            .zip(&sums)
            .map(|(vertex, sum)| {
                vertex.normal.or_else(|| (sum.0.length() > CANCELS * sum.1).then(|| sum.0.normalize()))
            })
            .collect();
        let is_knife = |(unit, sum): &(&Option<DVec3>, &(DVec3, f64))| unit.is_none() && sum.1 > 0.0;
        let knife_edges = units.iter().zip(&sums).filter(is_knife).count() as u64;
        let (mut starts, mut normals) = (vec![0], Vec::new());
        for (face, own) in mesh.faces().iter().zip(mesh.normals()) {
            let unit = |&corner: &u32| match face.shading {
                Shading::Flat | Shading::Glow => *own,
                Shading::Smooth => units[corner as usize].unwrap_or(*own),
            };
            normals.extend(face.corners.iter().map(unit));
            starts.push(normals.len());
        }
        Self { starts, normals, knife_edges }
    }

    /// Unit normals at the corners of face `face`, in the order of its corners.
    pub fn of_face(&self, face: usize) -> &[DVec3] {
        &self.normals[self.starts[face]..self.starts[face + 1]]
    }

    /// Vertices at which the normals of the faces cancel.
    pub fn knife_edges(&self) -> u64 {
        self.knife_edges
    }
}

/// Weighted sum of the normals of the faces at each vertex, and the sum of the weights.
fn sums(mesh: &Mesh, weights: Weights) -> Vec<(DVec3, f64)> {
    let mut sums = vec![(DVec3::ZERO, 0.0); mesh.vertices().len()];
    for (face, normal) in mesh.faces().iter().zip(mesh.normals()) {
        for k in 0..face.corners.len() {
            let weight = match weights {
                Weights::Equal => 1.0,
                Weights::Angle => angle_at(mesh, face, k),
            };
            let sum = &mut sums[face.corners[k] as usize];
            *sum = (sum.0 + *normal * weight, sum.1 + weight);
        }
    }
    sums
}

/// Angle of a face at its corner `k` (radians).
fn angle_at(mesh: &Mesh, face: &Face, k: usize) -> f64 {
    let count = face.corners.len();
    let place = |k: usize| mesh.vertices()[face.corners[k % count] as usize].place;
    let (after, before) = (place(k + 1) - place(k), place(k + count - 1) - place(k));
    libm::atan2(after.cross(before).length(), after.dot(before))
}
