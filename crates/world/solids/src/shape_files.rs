//! Solids from files of shapes that people and programs write.
//!
//! ```text
//!  bytes --> format --> obj, stl, ply, gltf --> mesh --> shells --> solids
//!                              |                           |          |
//!                              +--------> faults <--- blame +<- split <+
//! ```
//!
//! Every format gives a mesh (`mesh::Mesh`): vertices, faces, colours, normals. Vertices of a part at the same place are one. A part
//! whose faces close is a shape by itself; parts that do not close are joined, since many programs write a group for each face or
//! material. A closed shape that is not convex is split into convex solids that fill it, and a note says so.
//!
//! **Axes.** Metres; x forward, y to port (left), z up, the foot point at the origin: right-handed, as modelling programs keep
//! them. A solid's starboard is `-y`. glTF has y up: its front, z, is forward, and its x is port.
//!
//! **Light.** The albedo is [`ALBEDO`] times the colour. A corner whose normal has no direction (zero, or no finite number), or
//! lies in its face or behind it, has the normal of the face: exporters write such normals at creases and where faces have no
//! area.
//!
//! **Limits.** [`Limit::ShapeBytes`], [`Limit::ShapeParts`], [`MAX_PARTS`]; [`Solid::MOST`] vertices and faces of a convex part.

mod blame;
mod dress;
mod faults;
mod format;
mod gltf;
mod joined;
mod mesh;
mod obj;
mod oriented;
mod outline;
mod ply;
mod shells;
mod solids;
mod stl;
mod surface;
mod text;
mod told;

use std::path::{Path, PathBuf};

use diagnostics::{Problem, ProblemList};
use limits::Limit;

pub use surface::{Surface, SurfaceFace, parse_surface, read_surface};

use crate::Solid;
use faults::Faults;
use format::Format;
use mesh::Mesh;
use told::Told;

/// Largest number of parts that a file names.
pub const MAX_PARTS: usize = 4096;
/// Albedo of every face, before its colour.
pub const ALBEDO: f64 = 0.8;

/// Whether shapes of a file may be open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Openness {
    /// Every shape must close. One that is not convex is split.
    Closed,
    /// A shape that is no closed convex solid is a surface, seen from both sides.
    Any,
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Its convex solids and open surfaces.
    pub solids: Vec<Solid>,
    /// What the user should know of how the file was read, in words that name the file.
    pub notes: Vec<String>,
    /// Other files that it names and that were read: buffers of glTF.
    pub beside: Vec<PathBuf>,
}

/// Reads the file at `path`.
///
/// # Errors
/// Every fault with its place: what cannot be read, indices out of range, degenerate faces, shapes that do not close or cross
/// themselves.
pub fn read(path: impl AsRef<Path>, openness: Openness) -> Result<Shape, ProblemList> {
    let path = path.as_ref();
    let name = path.display().to_string();
    let bytes = files::read_all(path, Limit::ShapeBytes)
        .map_err(|error| Problem::of_file(&name, error.to_string()))?;
    parse(path, &bytes, openness)
}

/// The same of bytes in hand; `path` is as the user gave it, and its ending tells the format.
///
/// # Errors
/// As [`read`].
pub fn parse(path: impl AsRef<Path>, bytes: &[u8], openness: Openness) -> Result<Shape, ProblemList> {
    let path = path.as_ref();
    let name = path.display().to_string();
    let Read { mesh, mut faults, beside } = read_mesh(path, &name, bytes)?;
    let mut told = Told::default();
    let solids = match faults.is_empty() {
        true => solids::solids(&mesh, openness, &mut told, &mut faults),
        false => Vec::new(),
    };
    if faults.is_empty() && solids.is_empty() {
        faults.push(faults.of_file("no faces, so no solid").expected("faces of at least one closed shape"));
    }
    let notes = mesh.notes.into_iter().chain(told.notes()).map(|note| format!("{name}: {note}")).collect();
    faults.resolve(Shape { solids, notes, beside })
}

/// What a format's reader gives.
struct Read {
    mesh: Mesh,
    /// What is wrong so far, and how further faults tell their place.
    faults: Faults,
    beside: Vec<PathBuf>,
}

impl Read {
    /// What a file says that names no others.
    fn alone(mesh: Mesh, faults: Faults) -> Self {
        Self { mesh, faults, beside: Vec::new() }
    }
}

fn read_mesh(path: &Path, name: &str, bytes: &[u8]) -> Result<Read, ProblemList> {
    match Format::of(path, name, bytes)? {
        Format::Obj => obj::read(name, bytes),
        Format::Stl => stl::read(name, bytes),
        Format::Ply => ply::read(name, bytes),
        Format::Gltf => gltf::read(path, bytes),
        Format::Glb => gltf::read_binary(path, bytes),
    }
}
