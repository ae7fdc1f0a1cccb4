//! Solids from Wavefront OBJ files.
//!
//! **Axes.** Metres; x forward, y to port (left), z up, the foot point at the origin: right-handed, as
//! modelling programs keep them. A solid's starboard is `-y`.
//!
//! **Read.** `v`; `f` with corners `a`, `a/b`, `a//c`, `a/b/c`, counted from 1 or, if negative, back from the
//! last vertex; `o` and `g` each begin a new part, and every part with faces must be one closed convex solid; [`read_open`]
//! takes any other for an open shape. Vertices of a part at the same place are one. `vn` with `c`: normals at corners, for
//! smooth light. Three numbers behind the coordinates of a vertex (and a weight) are its colour, linear red, green and blue
//! of 0 to 1; a face has the mean of its corners' colours. Albedo is [`ALBEDO`] times that: the format's materials have none
//! that would suit.
//!
//! **Skipped.** `vt`, `s`, `usemtl`, `mtllib`, comments. Anything else is a fault: it would be missed in
//! the picture.
//!
//! **Limits.** [`Limit::ShapeBytes`], [`MAX_PARTS`]; [`Solid::MOST`] vertices and faces a part.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use diagnostics::{LongList, Place, Problem, ProblemList, Problems, Source};
use glam::DVec3;
use limits::Limit;

use crate::{Solid, SolidError};

/// Largest number of parts.
pub const MAX_PARTS: usize = 4096;
/// Albedo of every face.
pub const ALBEDO: f64 = 0.8;

/// Statements that say nothing about shape.
const SKIPPED: [&str; 4] = ["vt", "s", "usemtl", "mtllib"];

/// Reads the parts of the file at `path`.
///
/// # Errors Every fault with its line: what cannot be read, indices out of range, degenerate faces, parts that
/// are not convex or not closed.
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
    Reading::new(name, text, Solid::new).parts_of(name)
}

/// The same of a text whose parts may be open.
///
/// # Errors
/// As [`read_open`].
pub fn parse_open(name: &str, text: String) -> Result<Vec<Solid>, ProblemList> {
    Reading::new(name, text, closed_or_open).parts_of(name)
}

/// What makes a part of vertices and faces.
type Make = fn(Vec<DVec3>, Vec<(Vec<u32>, f64)>) -> Result<Solid, SolidError>;

fn closed_or_open(vertices: Vec<DVec3>, faces: Vec<(Vec<u32>, f64)>) -> Result<Solid, SolidError> {
    Solid::new(vertices.clone(), faces.clone()).or_else(|_| Solid::open(vertices, faces))
}
/// A word and the bytes it takes.
type Word<'t> = (&'t str, Range<usize>);

/// Lines as words, without comments; empty ones left out.
fn lines(text: &str) -> impl Iterator<Item = Vec<Word<'_>>> {
    let start_of = |part: &str| part.as_ptr() as usize - text.as_ptr() as usize;
    let words = move |line: &'_ str| -> Vec<(usize, usize)> {
        let said = line.split('#').next().unwrap_or_default();
        said.split_whitespace().map(|word| (start_of(word), word.len())).collect()
    };
    let found = text.lines().map(words).filter(|words| !words.is_empty());
    found.map(|words| words.into_iter().map(|(at, len)| (&text[at..at + len], at..at + len)).collect())
}

/// A part as written.
struct Part {
    faces: Vec<WrittenFace>,
}

struct WrittenFace {
    /// Indices of the file's vertices, from 0.
    corners: Vec<usize>,
    /// Indices of the file's normals, from 0.
    normals: Vec<Option<usize>>,
    span: Range<usize>,
}

struct Reading {
    source: Arc<Source>,
    faults: LongList,
    make: Make,
    vertices: Vec<(DVec3, Range<usize>)>,
    /// Colour of each vertex.
    colours: Vec<[f64; 3]>,
    normals: Vec<DVec3>,
    parts: Vec<Part>,
}

impl Reading {
    fn new(name: &str, text: String, make: Make) -> Self {
        let (source, faults) = (Arc::new(Source { name: name.into(), text }), LongList::new(name));
        let (vertices, colours, normals, parts) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { source, faults, make, vertices, colours, normals, parts }
    }

    /// Every part of the text, or every fault.
    fn parts_of(mut self, name: &str) -> Result<Vec<Solid>, ProblemList> {
        let source = self.source.clone();
        for line in lines(&source.text) {
            self.statement(line);
        }
        let solids = if self.faults.is_empty() { self.solids() } else { Vec::new() };
        if self.faults.is_empty() && solids.is_empty() {
            let problem = Problem::of_file(name, "no faces, so no solid");
            self.faults.push(problem.expected("`v` and `f` statements of at least one closed convex part"));
        }
        let problems = Problems::new();
        let solids = self.faults.finish(solids, &problems);
        problems.resolve(solids)
    }

    fn fault(&mut self, span: &Range<usize>, title: String, expected: &str) {
        let problem = self.problem(span, title, expected);
        self.faults.push(problem);
    }

    fn problem(&self, span: &Range<usize>, title: String, expected: &str) -> Problem {
        let place = Place { source: self.source.clone(), span: span.clone() };
        let found = self.source.text[span.clone()].to_owned();
        Problem::at(&place, title).found(found).expected(expected)
    }

    fn statement(&mut self, words: Vec<Word>) {
        let (keyword, span) = &words[0];
        let all = span.start..words[words.len() - 1].1.end;
        match *keyword {
            "v" => self.vertex(&words[1..], all),
            "vn" => self.normal(&words[1..], all),
            "f" => self.face(&words[1..], all),
            "o" | "g" => self.begin_part(span),
            skipped if SKIPPED.contains(&skipped) => {}
            other => {
                let title = format!("statement `{other}` is not read");
                self.fault(span, title, "v, vn, f, o or g (vt, s, usemtl, mtllib are skipped)");
            }
        }
    }

    fn begin_part(&mut self, span: &Range<usize>) {
        if self.parts.last().is_some_and(|part| part.faces.is_empty()) {
            return;
        }
        if self.parts.len() == MAX_PARTS {
            self.fault(span, format!("more than {MAX_PARTS} parts"), "fewer parts; use several files");
        }
        if self.parts.len() <= MAX_PARTS {
            self.parts.push(Part { faces: Vec::new() });
        }
    }

    fn vertex(&mut self, words: &[Word], all: Range<usize>) {
        // Behind the three coordinates a weight or a colour may stand.
        if !(3..=7).contains(&words.len()) {
            let title = format!("a vertex of {} numbers", words.len());
            self.fault(&all, title, "three coordinates in metres");
        }
        let place = self.triple(words, "metres");
        let colour = if words.len() >= 6 { self.colour(&words[words.len() - 3..]) } else { [1.0; 3] };
        self.vertices.push((place, all));
        self.colours.push(colour);
    }

    fn normal(&mut self, words: &[Word], all: Range<usize>) {
        if words.len() != 3 {
            let title = format!("a normal of {} numbers", words.len());
            self.fault(&all, title, "three numbers, along the axes of the vertices");
        }
        let normal = self.triple(words, "a number");
        self.normals.push(normal);
    }

    /// Three numbers along the file's axes, in body axes.
    fn triple(&mut self, words: &[Word], expected: &str) -> DVec3 {
        let mut place = DVec3::ZERO;
        for (axis, (word, span)) in words.iter().take(3).enumerate() {
            match word.parse().ok().filter(|length: &f64| length.is_finite()) {
                Some(length) => place[axis] = length,
                None => {
                    self.fault(span, format!("a coordinate must be a finite number, not {word}"), expected)
                }
            }
        }
        DVec3::new(place.x, -place.y, place.z)
    }

    fn colour(&mut self, words: &[Word]) -> [f64; 3] {
        let mut colour = [1.0; 3];
        for (channel, (word, span)) in colour.iter_mut().zip(words) {
            match word.parse().ok().filter(|light: &f64| (0.0..=1.0).contains(light)) {
                Some(light) => *channel = light,
                None => {
                    let title = format!("a channel of a colour must be 0 to 1, not {word}");
                    self.fault(span, title, "linear red, green and blue behind the coordinates");
                }
            }
        }
        colour
    }

    fn face(&mut self, words: &[Word], span: Range<usize>) {
        let corners: Option<Vec<usize>> = words.iter().map(|word| self.corner(word)).collect();
        if self.parts.is_empty() {
            self.parts.push(Part { faces: Vec::new() });
        }
        let normals = words.iter().map(|word| self.normal_of(word)).collect();
        if let (Some(corners), Some(part)) = (corners, self.parts.last_mut()) {
            part.faces.push(WrittenFace { corners, normals, span });
        }
    }

    fn corner(&mut self, (word, span): &Word) -> Option<usize> {
        let count = self.vertices.len();
        let found = word.split('/').next().and_then(|number| index_of(number, count));
        if found.is_none() {
            let title = format!("corner {word} names no vertex: {count} stand above this line");
            self.fault(span, title, "a vertex number from 1, or counted back from -1, before any `/`");
        }
        found
    }

    /// The normal of a corner, if it names one.
    fn normal_of(&mut self, (word, span): &Word) -> Option<usize> {
        let (count, number) = (self.normals.len(), word.split('/').nth(2)?);
        let found = index_of(number, count);
        if found.is_none() {
            let title = format!("corner {word} names no normal: {count} stand above this line");
            self.fault(
                span,
                title,
                "the number of a `vn` from 1, or counted back from -1, behind the second `/`",
            );
        }
        found
    }

    fn solids(&mut self) -> Vec<Solid> {
        let parts = std::mem::take(&mut self.parts);
        let mut solids = Vec::new();
        for part in parts.iter().filter(|part| !part.faces.is_empty()) {
            let gathered = Gathered::new(&self.vertices, part);
            let made = (self.make)(gathered.places, gathered.faces);
            match made.and_then(|solid| self.dressed(solid, part, &gathered.named)) {
                Ok(solid) => solids.push(solid),
                Err(error) => self.refuse(&error, part, &gathered.named),
            }
        }
        solids
    }

    /// A part with the colours and normals of its corners; `named` gives the file's index of each of its vertices.
    fn dressed(&self, solid: Solid, part: &Part, named: &[usize]) -> Result<Solid, SolidError> {
        let mean = |face: usize| {
            let corners = &part.faces[face].corners;
            let sum =
                |channel: usize| corners.iter().map(|&corner| self.colours[corner][channel]).sum::<f64>();
            std::array::from_fn(|channel| (sum(channel) / corners.len() as f64).min(1.0))
        };
        let normal = |face: usize, corner: u32| {
            let WrittenFace { corners, normals, .. } = &part.faces[face];
            let place = self.vertices[named[corner as usize]].0;
            let at = corners.iter().position(|&corner| self.vertices[corner].0 == place)?;
            normals[at].map(|normal| self.normals[normal])
        };
        solid.with_colours(mean)?.with_normals(normal)
    }

    /// Says what is wrong with a part, at the line of the face where one is to blame; `named` gives the file's index
    /// of each of the part's vertices.
    fn refuse(&mut self, error: &SolidError, part: &Part, named: &[usize]) {
        let (face, title) = match error {
            SolidError::NotConvex { vertex, face, outside } => {
                let vertex = self.vertex_named(named[*vertex]);
                (*face, format!("not convex: {vertex} lies {outside:.6} m outside this face"))
            }
            SolidError::BadFace { face, what } => (*face, format!("degenerate face: {what}")),
            SolidError::Open(from, to) => self.open_edge(part, [from, to].map(|&end| named[end as usize])),
            SolidError::BadVertex { vertex } => {
                (0, format!("{}: farther than 1e5 m", self.vertex_named(named[*vertex])))
            }
            SolidError::BadNormal { face } => {
                (*face, "a normal at a corner points inwards or nowhere".to_owned())
            }
            other => (0, format!("this part is no solid: {other}")),
        };
        let problem = self.problem(&part.faces[face].span, title, "a closed convex solid");
        let help = "each `o` or `g` must hold one closed convex part: split the object";
        self.faults.push(problem.help(help));
    }

    /// A face at an open edge, and the words for it.
    fn open_edge(&self, part: &Part, ends: [usize; 2]) -> (usize, String) {
        let holds = |face: &WrittenFace, end: usize| {
            face.corners.iter().any(|&corner| self.vertices[corner].0 == self.vertices[end].0)
        };
        let face = part.faces.iter().position(|face| ends.iter().all(|&end| holds(face, end)));
        let [from, to] = ends.map(|end| self.vertex_named(end));
        let title = format!("not closed: the edge between {from} and {to} does not part exactly two faces");
        (face.unwrap_or_default(), title)
    }

    /// The file's name of a vertex, by its index.
    fn vertex_named(&self, vertex: usize) -> String {
        let place = Place { source: self.source.clone(), span: self.vertices[vertex].1.clone() };
        format!("vertex {} (line {})", vertex + 1, place.line())
    }
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

/// Vertices and faces of one part, vertices at the same place joined.
struct Gathered {
    places: Vec<DVec3>,
    /// The file's index of each.
    named: Vec<usize>,
    faces: Vec<(Vec<u32>, f64)>,
}

impl Gathered {
    fn new(vertices: &[(DVec3, Range<usize>)], part: &Part) -> Self {
        let mut numbers = BTreeMap::new();
        let mut gathered = Self { places: Vec::new(), named: Vec::new(), faces: Vec::new() };
        for face in &part.faces {
            let mut corners = Vec::with_capacity(face.corners.len());
            for &corner in &face.corners {
                let place = vertices[corner].0;
                // Adding 0 makes -0 the same place as 0.
                let number = numbers
                    .entry(place.to_array().map(|length| (length + 0.0).to_bits()))
                    .or_insert_with(|| {
                        gathered.places.push(place);
                        gathered.named.push(corner);
                        gathered.places.len() as u32 - 1
                    });
                corners.push(*number);
            }
            gathered.faces.push((corners, ALBEDO));
        }
        gathered
    }
}
