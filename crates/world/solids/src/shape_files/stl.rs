//! STL: triangles without a unit, binary or as text.

mod binary;
mod text;

use diagnostics::ProblemList;
use glam::DVec3;

use super::Read;
use super::mesh::{At, Corner, Face, Mesh, Vertex, WHITE, from_port};

/// What an STL file says.
///
/// # Errors
/// If its size contradicts its head.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Read, ProblemList> {
    let (mut mesh, faults) = match binary::facets(bytes) {
        Some(facets) => binary::read(name, facets),
        None if text::is_text(bytes) => text::read(name, bytes)?,
        None => return Err(binary::wrong_size(name, bytes).into()),
    };
    let places = || mesh.vertices.iter().map(|vertex| vertex.place);
    let (low, high) =
        (places().fold(DVec3::INFINITY, DVec3::min), places().fold(DVec3::NEG_INFINITY, DVec3::max));
    if low.x <= high.x {
        let [x, y, z] = (high - low).to_array();
        mesh.notes.push(format!(
            "STL has no unit: read as metres, {x:.4} x {y:.4} x {z:.4} m large (`scale = 0.001` for millimetres)"
        ));
    }
    Ok(Read::alone(mesh, faults))
}

/// Adds a triangle of three new vertices.
fn add_facet(mesh: &mut Mesh, corners: [([f64; 3], At); 3], at: At) {
    let first = mesh.vertices.len();
    let vertices = corners.map(|(place, at)| Vertex { place: from_port(place), colour: WHITE, at });
    mesh.vertices.extend(vertices);
    let corners = (first..first + 3).map(|vertex| Corner { vertex, normal: None }).collect();
    mesh.last_part().faces.push(Face { corners, colour: None, at });
}
