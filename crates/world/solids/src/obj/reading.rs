//! Statements of a text, one a line.

use std::ops::Range;

use glam::DVec3;

use super::MAX_PARTS;
use super::faults::Faults;
use super::words::{Word, lines};
use super::written::{Corner, Face, Part, Vertex, Written};

/// Statements that say nothing about shape or light.
const PASSED_OVER: [&str; 4] = ["vt", "s", "usemtl", "mtllib"];

/// A text on its way to what it says.
pub(super) struct Reading<'f> {
    written: Written,
    faults: &'f mut Faults,
}

impl<'f> Reading<'f> {
    /// What `text` says; what cannot be read is added to `faults`.
    pub fn of(text: &str, faults: &'f mut Faults) -> Written {
        let mut reading = Self { written: Written::default(), faults };
        lines(text).for_each(|line| reading.statement(&line));
        reading.written
    }

    fn statement(&mut self, words: &[Word]) {
        let [(keyword, span), words @ ..] = words else { return };
        let all = span.start..words.last().map_or(span.end, |(_, last)| last.end);
        match *keyword {
            "v" => self.vertex(words, all),
            "vn" => self.normal(words, all),
            "f" => self.face(words, all),
            "o" | "g" => self.begin_part(span),
            passed if PASSED_OVER.contains(&passed) => {}
            other => {
                let title = format!("statement `{other}` is not read");
                self.faults.add(span, title, "v, vn, f, o or g (vt, s, usemtl, mtllib are passed over)");
            }
        }
    }

    fn begin_part(&mut self, span: &Range<usize>) {
        let parts = &mut self.written.parts;
        if parts.last().is_some_and(|part| part.faces.is_empty()) {
            return;
        }
        if parts.len() == MAX_PARTS {
            self.faults.add(span, format!("more than {MAX_PARTS} parts"), "fewer parts; use several files");
        }
        if parts.len() <= MAX_PARTS {
            parts.push(Part::default());
        }
    }

    fn vertex(&mut self, words: &[Word], span: Range<usize>) {
        if !matches!(words.len(), 3 | 4 | 6 | 7) {
            let title = format!("a vertex of {} numbers", words.len());
            self.faults.add(
                &span,
                title,
                "three coordinates in metres; behind them a weight, a colour or both",
            );
        }
        let place = self.coordinates(words);
        let colour = if words.len() >= 6 { self.colour(&words[words.len() - 3..]) } else { [1.0; 3] };
        self.written.vertices.push(Vertex { place, colour, span });
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

    fn normal(&mut self, words: &[Word], span: Range<usize>) {
        if words.len() != 3 {
            let title = format!("a normal of {} numbers", words.len());
            self.faults.add(&span, title, "three numbers, along the axes of the vertices");
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
        self.written.normals.push(normal);
    }

    /// Three numbers along the file's axes, in body axes; 0 for each that is none.
    fn triple(&mut self, words: &[Word], read: impl Fn(&Word, &mut Faults) -> Option<f64>) -> DVec3 {
        let mut triple = DVec3::ZERO;
        for (axis, word) in words.iter().take(3).enumerate() {
            triple[axis] = read(word, self.faults).unwrap_or_default();
        }
        DVec3::new(triple.x, -triple.y, triple.z)
    }

    fn colour(&mut self, words: &[Word]) -> [f64; 3] {
        let mut colour = [1.0; 3];
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

    fn face(&mut self, words: &[Word], span: Range<usize>) {
        let corners: Option<Vec<Corner>> = words.iter().map(|word| self.corner(word)).collect();
        let parts = &mut self.written.parts;
        if parts.is_empty() {
            parts.push(Part::default());
        }
        if let (Some(corners), Some(part)) = (corners, parts.last_mut()) {
            part.faces.push(Face { corners, span });
        }
    }

    fn corner(&mut self, (word, span): &Word) -> Option<Corner> {
        let mut parts = word.split('/');
        let (vertex, normal) =
            (parts.next().unwrap_or_default(), parts.nth(1).filter(|part| !part.is_empty()));
        let vertices = self.written.vertices.len();
        let vertex = index_of(vertex, vertices);
        if vertex.is_none() {
            let title = match word.split('/').next().unwrap_or_default().parse::<i64>() {
                Ok(_) => format!("corner {word} names no vertex: {vertices} stand above this line"),
                Err(_) => format!("corner {word} is no number of a vertex"),
            };
            let expected = "a vertex number from 1, or counted back from -1, before any `/`";
            self.faults.add(span, title, expected);
        }
        let normals = self.written.normals.len();
        let named = normal.map(|number| index_of(number, normals));
        if named == Some(None) {
            let title = format!("corner {word} names no normal: {normals} stand above this line");
            let expected = "the number of a `vn` from 1, or counted back from -1, behind the second `/`";
            self.faults.add(span, title, expected);
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
