//! PLY: elements with properties that a header names, as text or binary.

mod body;
mod columns;
mod header;

use diagnostics::ProblemList;

use super::Read;
use super::faults::Faults;
use super::mesh::Mesh;
use body::Body;
use columns::Columns;
use header::Header;

/// What a PLY file says.
///
/// # Errors
/// If its header or an element cannot be read, with its line or number.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Read, ProblemList> {
    let (header, behind) = Header::read(name, bytes)?;
    let columns = Columns::of(name, &header)?;
    let mut body = Body::new(name, &header, bytes, behind);
    let mut mesh = Mesh::default();
    for (element, use_) in header.elements.iter().zip(&columns.of_elements) {
        for number in 1..=element.count {
            let row = body.row(element, number)?;
            use_.add(&mut mesh, &row, number).map_err(|fault| body.problem(element, number, fault))?;
        }
    }
    body.finish()?;
    Ok(Read::alone(mesh, Faults::of_numbers(name, "face")))
}
