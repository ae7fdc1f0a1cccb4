//! From parts as written to solids.

use std::collections::BTreeMap;

use glam::DVec3;

use super::blame::Blame;
use super::faults::Faults;
use super::written::{Part, Vertex, Written};
use super::{ALBEDO, Make};
use crate::{Solid, SolidError};

/// The solids of all parts that have faces; what is wrong with a part is added to `faults`.
pub(super) fn solids(written: &Written, make: Make, faults: &mut Faults) -> Vec<Solid> {
    let mut solids = Vec::new();
    for part in written.parts.iter().filter(|part| !part.faces.is_empty()) {
        let Gathered { places, named, faces } = Gathered::new(&written.vertices, part);
        match make(places, faces).and_then(|solid| dressed(solid, written, part, &named)) {
            Ok(solid) => solids.push(solid),
            Err(error) => {
                let problem = Blame { written, part, named: &named, faults }.problem(&error);
                faults.push(problem);
            }
        }
    }
    solids
}

/// A part with the colours and normals of its corners; `named` gives the file's index of each of its vertices.
fn dressed(solid: Solid, written: &Written, part: &Part, named: &[usize]) -> Result<Solid, SolidError> {
    let mean = |face: usize| {
        let corners = &part.faces[face].corners;
        let sum = |channel: usize| -> f64 {
            corners.iter().map(|corner| written.vertices[corner.vertex].colour[channel]).sum()
        };
        std::array::from_fn(|channel| (sum(channel) / corners.len() as f64).min(1.0))
    };
    let normal = |face: usize, corner: u32| {
        let place = written.vertices[named[corner as usize]].place;
        let mut corners = part.faces[face].corners.iter();
        let corner = corners.find(|corner| written.vertices[corner.vertex].place == place)?;
        Some(written.normals[corner.normal?])
    };
    Ok(solid.with_colours(mean)?.with_normals(normal))
}

/// Vertices and faces of one part, vertices at the same place joined.
struct Gathered {
    places: Vec<DVec3>,
    /// The file's index of each.
    named: Vec<usize>,
    faces: Vec<(Vec<u32>, f64)>,
}

impl Gathered {
    fn new(vertices: &[Vertex], part: &Part) -> Self {
        let mut numbers = BTreeMap::new();
        let mut gathered = Self { places: Vec::new(), named: Vec::new(), faces: Vec::new() };
        for face in &part.faces {
            let mut corners = Vec::with_capacity(face.corners.len());
            for corner in &face.corners {
                let place = vertices[corner.vertex].place;
                // Adding 0 makes -0 the same place as 0.
                let number = numbers
                    .entry(place.to_array().map(|length| (length + 0.0).to_bits()))
                    .or_insert_with(|| {
                        gathered.places.push(place);
                        gathered.named.push(corner.vertex);
                        gathered.places.len() as u32 - 1
                    });
                corners.push(*number);
            }
            gathered.faces.push((corners, ALBEDO));
        }
        gathered
    }
}
