//! Solids from Wavefront OBJ files.
//!
//! ```text
//!  text --> words --> reading --> written: vertices, normals, parts --> parts --> solids
//!                        |                                                |
//!                        +-----------------> faults <------ blame <-------+
//! ```
//!
//! **Axes.** Metres; x forward, y to port (left), z up, the foot point at the origin: right-handed, as
//! modelling programs keep them. A solid's starboard is `-y`.
//!
//! **Read.**
//!
//! - `v`: three coordinates. A fourth number is a weight, which says nothing about plane faces. Three numbers more are the
//!   colour of the vertex: linear red, green and blue of 0 to 1. A face has the mean of its corners' colours.
//! - `vn`: a normal of any length, for smooth light. A corner whose normal has no direction (zero, or no finite number), or lies
//!   in its face or behind it, has the normal of the face: exporters write such normals at creases and where faces have no area.
//! - `f`: corners `a`, `a/b`, `a//c`, `a/b/c`, counted from 1 or, if negative, back from the last above. `a` is a vertex and `c`
//!   a normal; `b` is passed over. A corner without `c` has the normal of its face.
//! - `o` and `g` each begin a new part. Every part with faces must be one closed convex solid; [`read_open`] takes any
//!   other for an open shape. Vertices of a part at the same place are one.
//!
//! Albedo is [`ALBEDO`] times the colour: the format's materials have none that would suit.
//!
//! **Passed over.** `vt`, `s`, `usemtl`, `mtllib`, comments. A material's file is not opened. Any other statement is a fault: it
//! would be missed in the picture.
//!
//! **Limits.** [`Limit::ShapeBytes`], [`MAX_PARTS`]; [`Solid::MOST`] vertices and faces a part.

mod blame;
mod faults;
mod parts;
mod reading;
mod words;
mod written;

use std::path::Path;
use std::sync::Arc;

use diagnostics::{Problem, ProblemList, Source};
use glam::DVec3;
use limits::Limit;

use crate::{Solid, SolidError};
use faults::Faults;
use reading::Reading;

/// Largest number of parts.
pub const MAX_PARTS: usize = 4096;
/// Albedo of every face.
pub const ALBEDO: f64 = 0.8;

/// Reads the parts of the file at `path`.
///
/// # Errors
/// Every fault with its line: what cannot be read, indices out of range, degenerate faces, parts that are not convex or not closed.
pub fn read(path: impl AsRef<Path>) -> Result<Vec<Solid>, ProblemList> {
    let (name, text) = text_of(path.as_ref())?;
    parse(&name, text)
}

/// The same of a file whose parts may be open: one that is no closed convex solid is a surface that is seen from both sides.
///
/// # Errors
/// As [`read`], but for parts that are not convex or not closed.
pub fn read_open(path: impl AsRef<Path>) -> Result<Vec<Solid>, ProblemList> {
    let (name, text) = text_of(path.as_ref())?;
    parse_open(&name, text)
}

fn text_of(path: &Path) -> Result<(String, String), ProblemList> {
    let name = path.display().to_string();
    let bytes = files::read_all(path, Limit::ShapeBytes)
        .map_err(|error| Problem::of_file(&name, error.to_string()))?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let title = format!("not text: byte {} is not UTF-8", error.utf8_error().valid_up_to());
        Problem::of_file(&name, title).help("save the file as UTF-8")
    })?;
    Ok((name, text))
}

/// The same from a text; `name` is the path as the user gave it.
///
/// # Errors
/// As [`read`].
pub fn parse(name: &str, text: String) -> Result<Vec<Solid>, ProblemList> {
    solids_of(name, text, Solid::new)
}

/// The same of a text whose parts may be open.
///
/// # Errors
/// As [`read_open`].
pub fn parse_open(name: &str, text: String) -> Result<Vec<Solid>, ProblemList> {
    solids_of(name, text, closed_or_open)
}

/// What makes a part of vertices and faces.
type Make = fn(Vec<DVec3>, Vec<(Vec<u32>, f64)>) -> Result<Solid, SolidError>;

fn closed_or_open(vertices: Vec<DVec3>, faces: Vec<(Vec<u32>, f64)>) -> Result<Solid, SolidError> {
    Solid::new(vertices.clone(), faces.clone()).or_else(|_| Solid::open(vertices, faces))
}

/// Every part of a text, or every fault.
fn solids_of(name: &str, text: String, make: Make) -> Result<Vec<Solid>, ProblemList> {
    let source = Arc::new(Source { name: name.into(), text });
    let mut faults = Faults::new(Arc::clone(&source));
    let written = Reading::of(&source.text, &mut faults);
    let solids = if faults.is_empty() { parts::solids(&written, make, &mut faults) } else { Vec::new() };
    if faults.is_empty() && solids.is_empty() {
        let problem = Problem::of_file(name, "no faces, so no solid");
        faults.push(problem.expected("`v` and `f` statements of at least one closed convex part"));
    }
    faults.resolve(solids)
}
