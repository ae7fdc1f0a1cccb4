//! STL as text: one statement a line.

use std::sync::Arc;

use diagnostics::{ProblemList, Source};

use super::add_facet;
use crate::shape_files::MAX_PARTS;
use crate::shape_files::faults::Faults;
use crate::shape_files::mesh::{At, Mesh, Part};
use crate::shape_files::text::{Word, extent, text_of, words};

/// Bytes that are looked at to tell text from a binary file that begins with the same word.
const LOOKED_AT: usize = 512;

/// Whether a file is text: it begins with `solid` and has no byte of 0 soon.
pub(super) fn is_text(bytes: &[u8]) -> bool {
    let begins = text::without_byte_order_mark(bytes)
        .trim_ascii_start()
        .get(..5)
        .is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    begins && !bytes.iter().take(LOOKED_AT).any(|&byte| byte == 0)
}

/// The mesh of a text, and the faults to add to.
///
/// # Errors
/// If it is no text behind its first bytes.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<(Mesh, Faults), ProblemList> {
    let source = Arc::new(Source { name: name.into(), text: text_of(name, bytes)? });
    let faults = Faults::of_text(Arc::clone(&source));
    let mut reading = Reading { mesh: Mesh::default(), faults, facet: None };
    let text = &source.text;
    for line in text.lines() {
        reading.statement(&words(text, line).collect::<Vec<_>>());
    }
    if let Some(facet) = reading.facet.take() {
        reading.faults.add(&facet.at, "the file ends in this facet".into(), "`endfacet`");
    }
    Ok((reading.mesh, reading.faults))
}

/// A facet that has begun.
struct Facet {
    corners: Vec<([f64; 3], At)>,
    at: At,
}

struct Reading {
    mesh: Mesh,
    faults: Faults,
    facet: Option<Facet>,
}

impl Reading {
    fn statement(&mut self, words: &[Word]) {
        let all = extent(words);
        let [(keyword, at), rest @ ..] = words else { return };
        match keyword.to_ascii_lowercase().as_str() {
            "solid" => self.begin_part(rest, at),
            "facet" => self.begin_facet(all),
            "vertex" => self.vertex(rest, &all),
            "endfacet" => self.end_facet(&all),
            "outer" | "endloop" | "endsolid" => {}
            other => {
                let title = format!("statement `{other}` is not read");
                self.faults.add(at, title, "solid, facet, outer loop, vertex, endloop, endfacet or endsolid");
            }
        }
    }

    fn begin_part(&mut self, name: &[Word], at: &At) {
        if self.mesh.parts.len() == MAX_PARTS {
            self.faults.add(at, format!("more than {MAX_PARTS} solids"), "fewer solids; use several files");
        }
        if self.mesh.parts.len() <= MAX_PARTS {
            let name = name.iter().map(|(word, _)| *word).collect::<Vec<_>>().join(" ");
            self.mesh.parts.push(Part { name, ..Part::default() });
        }
    }

    /// The normal is passed over: it says nothing that the order of the corners does not.
    fn begin_facet(&mut self, at: At) {
        if let Some(before) = self.facet.replace(Facet { corners: Vec::new(), at }) {
            self.faults.add(&before.at, "this facet does not end".into(), "`endfacet`");
        }
    }

    fn vertex(&mut self, words: &[Word], at: &At) {
        let mut place = [0.0; 3];
        if words.len() != 3 {
            self.faults.add(
                at,
                format!("a vertex of {} numbers", words.len()),
                "three coordinates in metres",
            );
        }
        for (length, (word, at)) in place.iter_mut().zip(words) {
            match word.parse().ok().filter(|length: &f64| length.is_finite()) {
                Some(read) => *length = read,
                None => {
                    self.faults.add(
                        at,
                        format!("a coordinate must be a finite number, not {word}"),
                        "metres",
                    );
                }
            }
        }
        match &mut self.facet {
            Some(facet) => facet.corners.push((place, at.clone())),
            None => {
                self.faults.add(at, "a vertex outside a facet".into(), "`facet` and `outer loop` before it")
            }
        }
    }

    fn end_facet(&mut self, at: &At) {
        let Some(Facet { corners, at }) = self.facet.take() else {
            self.faults.add(at, "no facet has begun".into(), "`facet` before it");
            return;
        };
        match <[_; 3]>::try_from(corners) {
            Ok(corners) => add_facet(&mut self.mesh, corners, at),
            Err(corners) => {
                self.faults.add(&at, format!("a facet of {} vertices", corners.len()), "three vertices");
            }
        }
    }
}
