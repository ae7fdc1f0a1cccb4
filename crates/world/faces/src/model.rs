//! Face models from files of shapes.

use std::collections::BTreeMap;
use std::path::Path;

use diagnostics::{Problem, ProblemList};
use solids::shape_files::{ALBEDO, Surface, read_surface};

use crate::face::{Face, Shading, Sides, Vertex};
use crate::mesh::{Loaded, Mesh};

/// How the faces of a model are shaded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModelShading {
    /// Smooth where corners have normals, flat elsewhere.
    AsWritten,
    /// All faces smooth; where a corner has no normal, it is averaged.
    Smooth,
    /// All faces are flat.
    Flat,
}

/// A face model of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Its faces in body axes (forward, starboard, up; m), and what was left out.
    pub loaded: Loaded,
    /// Sentences on how the file was read.
    pub notes: Vec<String>,
}

impl Model {
    /// Reads the list `list` of a file of shapes (OBJ, PLY, STL, glTF) with its normals and colours, of at most `most` faces.
    ///
    /// The colour of a face is [`ALBEDO`] times that of the file. A normal without a direction counts as none.
    ///
    /// # Errors
    /// Every fault of the file with its place; of faces the first one.
    pub fn read(path: &Path, list: &str, shading: ModelShading, most: usize) -> Result<Self, ProblemList> {
        let surface = read_surface(path)?;
        let (vertices, faces) = vertices_and_faces(&surface, shading);
        match Mesh::limited(list, vertices, faces, most) {
            Ok(loaded) => Ok(Self { loaded, notes: surface.notes }),
            Err(error) => {
                let place = error.face().and_then(|face| surface.faces[face].place.as_ref());
                let title = error.to_string();
                let of_file = || Problem::of_file(path.display().to_string(), title.clone());
                Err(place.map_or_else(of_file, |place| Problem::at(place, title.clone())).into())
            }
        }
    }
}

/// One vertex for each pair of place and normal.
fn vertices_and_faces(surface: &Surface, shading: ModelShading) -> (Vec<Vertex>, Vec<Face>) {
    let mut numbers = BTreeMap::new();
    let mut vertices = Vec::new();
    let directed = |number: &usize| surface.normals[*number].try_normalize().is_some();
    let faces = surface.faces.iter().map(|face| {
        let mut is_smooth = shading == ModelShading::Smooth;
        let corners = face.corners.iter().map(|&(place, normal)| {
            let normal = normal.filter(directed);
            is_smooth |= normal.is_some() && shading == ModelShading::AsWritten;
            *numbers.entry((place, normal)).or_insert_with(|| {
                let normal = normal.map(|number| surface.normals[number]);
                vertices.push(Vertex { place: surface.places[place], normal });
                vertices.len() as u32 - 1
            })
        });
        let (corners, colour) = (corners.collect(), face.colour.map(|channel| channel * ALBEDO));
        let shading = if is_smooth { Shading::Smooth } else { Shading::Flat };
        Face { corners, colour, shading, sides: Sides::One }
    });
    let faces = faces.collect();
    (vertices, faces)
}
