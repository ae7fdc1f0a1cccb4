//! Binary STL: a head of 80 bytes, a count, and 50 bytes for each facet.

use diagnostics::Problem;

use super::add_facet;
use crate::shape_files::faults::Faults;
use crate::shape_files::mesh::{At, Mesh};

/// Bytes before the count.
const HEAD: usize = 80;
/// Bytes of a facet: a normal, three corners, a word of attributes.
const FACET: usize = 50;

/// The facets of a file whose size fits its count; whatever its first word is, such a file is binary.
pub(super) fn facets(bytes: &[u8]) -> Option<&[u8]> {
    let (count, facets) = counted(bytes)?;
    (facets.len() as u64 == FACET as u64 * u64::from(count)).then_some(facets)
}

fn counted(bytes: &[u8]) -> Option<(u32, &[u8])> {
    let (count, facets) = bytes.get(HEAD..)?.split_first_chunk()?;
    Some((u32::from_le_bytes(*count), facets))
}

/// Why a file is no binary STL file.
pub(super) fn wrong_size(name: &str, bytes: &[u8]) -> Problem {
    let title = match counted(bytes) {
        Some((count, facets)) => format!(
            "binary STL with {count} facets has {} bytes behind its head, not {}",
            FACET as u64 * u64::from(count),
            facets.len()
        ),
        None => format!("{} bytes: binary STL has a head of {} bytes", bytes.len(), HEAD + 4),
    };
    Problem::of_file(name, title).help("export the file again: it is cut off, or no STL file")
}

/// The mesh of facets.
pub(super) fn read(name: &str, facets: &[u8]) -> (Mesh, Faults) {
    let (mut mesh, mut faults) = (Mesh::default(), Faults::of_numbers(name, "facet"));
    let mut coloured = 0_usize;
    let (facets, _) = facets.as_chunks::<FACET>();
    for (number, facet) in (1..).zip(facets) {
        let at: At = number..number;
        // The normal says nothing that the order of the corners does not.
        let (words, attributes) = facet.split_at(FACET - 2);
        coloured += usize::from(attributes != [0, 0]);
        let mut word = words.as_chunks().0.iter().skip(3).map(|word| f64::from(f32::from_le_bytes(*word)));
        let corners: [[f64; 3]; 3] =
            std::array::from_fn(|_| std::array::from_fn(|_| word.next().unwrap_or(f64::NAN)));
        match corners.iter().flatten().find(|length| !length.is_finite()) {
            Some(length) => {
                faults.add(&at, format!("a coordinate must be a finite number, not {length}"), "metres");
            }
            None => add_facet(&mut mesh, corners.map(|place| (place, at.clone())), at),
        }
    }
    if coloured > 0 {
        mesh.notes.push(format!(
            "{coloured} facets have a word of attributes: programs disagree on its colours, so none are read"
        ));
    }
    (mesh, faults)
}
