//! The faces of a file as they stand, for generators that draw faces and need no solids.

use std::path::{Path, PathBuf};

use diagnostics::{Place, Problem, ProblemList};
use glam::DVec3;
use limits::Limit;

use super::{Read, read_mesh};

/// Faces of a file in body axes (forward, starboard, up; m).
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Places of the vertices (m).
    pub places: Vec<DVec3>,
    /// Normals as written: of any length, even without a direction.
    pub normals: Vec<DVec3>,
    /// Faces in the order of the file.
    pub faces: Vec<SurfaceFace>,
    /// What the user should know of how the file was read, in words that name the file.
    pub notes: Vec<String>,
    /// Other files that it names and that were read: buffers of glTF.
    pub beside: Vec<PathBuf>,
}

/// A polygon as written, counter-clockwise seen from outside.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceFace {
    /// Numbers of vertex and, where it has one, normal of each corner, from 0.
    pub corners: Vec<(usize, Option<usize>)>,
    /// Linear red, green, blue, 0 to 1; white without a colour.
    pub colour: [f64; 3],
    /// Where the face stands, in a file of text.
    pub place: Option<Place>,
}

/// Reads the faces of the file at `path`.
///
/// # Errors
/// Every fault with its place: what cannot be read, numbers that are not finite, indices out of range.
pub fn read_surface(path: impl AsRef<Path>) -> Result<Surface, ProblemList> {
    let path = path.as_ref();
    let name = path.display().to_string();
    let bytes = files::read_all(path, Limit::ShapeBytes)
        .map_err(|error| Problem::of_file(&name, error.to_string()))?;
    parse_surface(path, &bytes)
}

/// The same of bytes in hand; `path` is as the user gave it, and its ending tells the format.
///
/// # Errors
/// As [`read_surface`].
pub fn parse_surface(path: impl AsRef<Path>, bytes: &[u8]) -> Result<Surface, ProblemList> {
    let path = path.as_ref();
    let name = path.display().to_string();
    let Read { mesh, mut faults, beside } = read_mesh(path, &name, bytes)?;
    let faces: Vec<SurfaceFace> = mesh
        .parts
        .iter()
        .flat_map(|part| &part.faces)
        .map(|face| SurfaceFace {
            corners: face.corners.iter().map(|corner| (corner.vertex, corner.normal)).collect(),
            colour: mesh.colour(face),
            place: faults.place(&face.at),
        })
        .collect();
    if faults.is_empty() && faces.is_empty() {
        faults.push(faults.of_file("no faces").expected("one face or more"));
    }
    let notes = mesh.notes.iter().map(|note| format!("{name}: {note}")).collect();
    let places = mesh.vertices.iter().map(|vertex| vertex.place).collect();
    faults.resolve(Surface { places, normals: mesh.normals, faces, notes, beside })
}
