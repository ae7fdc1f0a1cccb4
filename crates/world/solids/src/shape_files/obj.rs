//! Wavefront OBJ: statements of a text, one a line.

mod words;

use std::collections::BTreeSet;
use std::sync::Arc;

use diagnostics::{ProblemList, Source};
use glam::DVec3;

use super::faults::Faults;
use super::mesh::{At, Corner, Face, Mesh, Part, Vertex, WHITE, from_port};
use super::text::{Word, extent, text_of};
use super::{MAX_PARTS, Read};
use words::statements;

/// Statements that say nothing about shape or light.
const HARMLESS: [&str; 11] =
    ["vt", "vp", "s", "lod", "maplib", "usemap", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"];
/// Statements that name materials.
const MATERIALS: [&str; 2] = ["usemtl", "mtllib"];
/// Statements that would be missed in the picture, and what to do about them.
const REFUSED: [(&[&str], &str); 4] = [
    (&["l", "p"], "delete loose edges and points before the export: only faces are drawn"),
    (
        &[
            "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp",
            "end", "con", "ctech", "stech", "mg",
        ],
        "export polygons: curves and free surfaces are not drawn",
    ),
    (&["bzp", "bsp", "cdc", "cdp", "res"], "export polygons: patches of old files are not drawn"),
    (&["call", "csh"], "put everything into one file: other files and commands are never followed"),
];

/// What an OBJ file says.
///
/// # Errors
/// If it is no text.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Read, ProblemList> {
    let source = Arc::new(Source { name: name.into(), text: text_of(name, bytes)? });
    let mut reading = Reading {
        mesh: Mesh::default(),
        materials: BTreeSet::new(),
        faults: Faults::of_text(Arc::clone(&source)),
    };
    statements(&source.text).for_each(|words| reading.statement(&words));
    if !reading.materials.is_empty() {
        let named: Vec<&str> = reading.materials.iter().map(String::as_str).collect();
        reading.mesh.notes.push(format!(
            "materials are not read, their colours are lost ({}): give `colour`, or colours of vertices",
            named.join(", ")
        ));
    }
    Ok(Read::alone(reading.mesh, reading.faults))
}

/// A text on its way to what it says.
struct Reading {
    mesh: Mesh,
    /// The statements of materials that the file has.
    materials: BTreeSet<String>,
    faults: Faults,
}

impl Reading {
    fn statement(&mut self, words: &[Word]) {
        let all = extent(words);
        let [(keyword, at), words @ ..] = words else { return };
        match *keyword {
            "v" => self.vertex(words, all),
            "vn" => self.normal(words, all),
            "f" => self.face(words, all),
            "o" | "g" => self.begin_part(words, at),
            material if MATERIALS.contains(&material) => {
                self.materials.insert(material.to_owned());
            }
            harmless if HARMLESS.contains(&harmless) => {}
            other => self.refuse(other, at),
        }
    }

    fn refuse(&mut self, statement: &str, at: &At) {
        let title = format!("statement `{statement}` is not read");
        let expected = "v, vn, f, o or g (vt, s, usemtl, mtllib and others of no effect are passed over)";
        let problem = self.faults.problem(at, title, expected);
        let why = REFUSED.iter().find(|(statements, _)| statements.contains(&statement));
        self.faults.push(match why {
            Some((_, why)) => problem.help(*why),
            None => problem,
        });
    }

    fn begin_part(&mut self, words: &[Word], at: &At) {
        let parts = &mut self.mesh.parts;
        if parts.len() == MAX_PARTS && parts.last().is_some_and(|part| !part.faces.is_empty()) {
            self.faults.add(at, format!("more than {MAX_PARTS} parts"), "fewer parts; use several files");
        }
        if parts.last().is_none_or(|part| !part.faces.is_empty()) && parts.len() <= MAX_PARTS {
            parts.push(Part::default());
        }
        if let Some(part) = parts.last_mut() {
            part.name = words.iter().map(|(word, _)| *word).collect::<Vec<_>>().join(" ");
        }
    }

    fn vertex(&mut self, words: &[Word], at: At) {
        if !matches!(words.len(), 3 | 4 | 6 | 7) {
            let title = format!("a vertex of {} numbers", words.len());
            self.faults.add(
                &at,
                title,
                "three coordinates in metres; behind them a weight, a colour or both",
            );
        }
        let place = self.coordinates(words);
        let colour = if words.len() >= 6 { self.colour(&words[words.len() - 3..]) } else { WHITE };
        self.mesh.vertices.push(Vertex { place, colour, at });
    }

    fn coordinates(&mut self, words: &[Word]) -> DVec3 {
        self.triple(words, |word, faults| {
            let length = number(word).filter(|length| length.is_finite());
            if length.is_none() {
                let title = format!("a coordinate must be a finite number, not {}", word.0);
                faults.add(&word.1, title, "metres");
            }
            length
        })
    }

    fn normal(&mut self, words: &[Word], at: At) {
        if words.len() != 3 {
            let title = format!("a normal of {} numbers", words.len());
            self.faults.add(&at, title, "three numbers, along the axes of the vertices");
        }
        let normal = self.triple(words, |word, faults| {
            let part = number(word);
            if part.is_none() {
                faults.add(
                    &word.1,
                    format!("a part of a normal must be a number, not {}", word.0),
                    "a number",
                );
            }
            part
        });
        self.mesh.normals.push(normal);
    }

    /// Three numbers along the file's axes, in body axes; 0 for each that is none.
    fn triple(&mut self, words: &[Word], read: impl Fn(&Word, &mut Faults) -> Option<f64>) -> DVec3 {
        let mut triple = [0.0; 3];
        for (axis, word) in words.iter().take(3).enumerate() {
            triple[axis] = read(word, &mut self.faults).unwrap_or_default();
        }
        from_port(triple)
    }

    fn colour(&mut self, words: &[Word]) -> [f64; 3] {
        let mut colour = WHITE;
        for (channel, word) in colour.iter_mut().zip(words) {
            match number(word).filter(|light| (0.0..=1.0).contains(light)) {
                Some(light) => *channel = light,
                None => {
                    let title = format!("a channel of a colour must be 0 to 1, not {}", word.0);
                    self.faults.add(&word.1, title, "linear red, green and blue behind the coordinates");
                }
            }
        }
        colour
    }

    fn face(&mut self, words: &[Word], at: At) {
        let corners: Option<Vec<Corner>> = words.iter().map(|word| self.corner(word)).collect();
        if let Some(corners) = corners {
            self.mesh.last_part().faces.push(Face { corners, colour: None, at });
        }
    }

    fn corner(&mut self, (word, at): &Word) -> Option<Corner> {
        let mut parts = word.split('/');
        let (vertex, normal) =
            (parts.next().unwrap_or_default(), parts.nth(1).filter(|part| !part.is_empty()));
        let vertices = self.mesh.vertices.len();
        let vertex = index_of(vertex, vertices);
        if vertex.is_none() {
            let title = match word.split('/').next().unwrap_or_default().parse::<i64>() {
                Ok(_) => format!("corner {word} names no vertex: {vertices} stand above this line"),
                Err(_) => format!("corner {word} is no number of a vertex"),
            };
            let expected = "a vertex number from 1, or counted back from -1, before any `/`";
            self.faults.add(at, title, expected);
        }
        let normals = self.mesh.normals.len();
        let named = normal.map(|number| index_of(number, normals));
        if named == Some(None) {
            let title = format!("corner {word} names no normal: {normals} stand above this line");
            let expected = "the number of a `vn` from 1, or counted back from -1, behind the second `/`";
            self.faults.add(at, title, expected);
        }
        Some(Corner { vertex: vertex?, normal: named.flatten() })
    }
}

fn number((word, _): &Word) -> Option<f64> {
    word.parse().ok()
}

/// The index, from 0, that a number from 1 or back from -1 has among `count`.
fn index_of(number: &str, count: usize) -> Option<usize> {
    let index = match number.parse::<i64>().ok()? {
        number if number > 0 => usize::try_from(number - 1).ok(),
        number if number < 0 => (count as i64).checked_add(number).and_then(|index| index.try_into().ok()),
        _ => None,
    };
    index.filter(|&index| index < count)
}
