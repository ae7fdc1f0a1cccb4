//! Boulders as shape files, and as objects of a scenario.

use std::fmt::Write;

use rayon::prelude::*;
use terrain_builder::{Ground, PlacedBoulder};

use crate::error::ExportError;

/// A boulder for a scenario.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Object {
    /// Name of its shape file in the folder of the export.
    pub file: String,
    /// Wavefront OBJ: x north, y west, z up (m), its foot on the ground at the origin.
    pub shape: String,
    /// Its foot in the axes of the bank: north, east (m).
    pub at: [f64; 2],
}

/// All boulders of a landscape, in their order. `corner` is the south-west corner of the posts: north, east (m).
pub(crate) fn objects(ground: &Ground, corner: [f64; 2]) -> Result<Vec<Object>, ExportError> {
    let boulders = ground.boulders().par_iter().enumerate();
    boulders.map(|(number, boulder)| object(number, boulder, corner)).collect()
}

fn object(number: usize, placed: &PlacedBoulder, corner: [f64; 2]) -> Result<Object, ExportError> {
    let body = placed.body(number as u32).map_err(|source| ExportError::Boulder { number, source })?;
    let at = placed.boulder.at();
    let mut shape = format!("# Boulder {number}: x forward (north), y to port (west), z up, metres\n");
    for corner in body.vertices() {
        let [north, east, up] = [corner.x - at[0], corner.y - at[1], corner.z - placed.ground];
        // Writing to a text does not fail. A port of -0 would read badly.
        let _ = writeln!(shape, "v {north} {} {up}", 0.0 - east);
    }
    for face in body.solid.faces() {
        let corners: Vec<String> = face.corners.iter().map(|corner| (corner + 1).to_string()).collect();
        let _ = writeln!(shape, "f {}", corners.join(" "));
    }
    Ok(Object {
        file: format!("boulders/{number}.obj"),
        shape,
        at: [0, 1].map(|axis| at[axis] - corner[axis]),
    })
}
