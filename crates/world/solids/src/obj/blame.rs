//! What is wrong with a part that is no solid, and at which line.

use diagnostics::Problem;

use super::faults::Faults;
use super::written::{Face, Part, Written};
use crate::SolidError;

/// A part that is no solid.
pub(super) struct Blame<'a> {
    pub written: &'a Written,
    pub part: &'a Part,
    /// The file's index of each of the part's vertices.
    pub named: &'a [usize],
    pub faults: &'a Faults,
}

impl Blame<'_> {
    /// Says why, at the line of the face where one is to blame.
    pub fn problem(&self, error: &SolidError) -> Problem {
        let (face, title) = match error {
            SolidError::NotConvex { vertex, face, outside } => {
                let vertex = self.vertex_named(self.named[*vertex]);
                (*face, format!("not convex: {vertex} lies {outside:.6} m outside this face"))
            }
            SolidError::BadFace { face, what } => (*face, format!("degenerate face: {what}")),
            SolidError::Open(from, to) => self.open_edge([from, to].map(|&end| self.named[end as usize])),
            SolidError::BadVertex { vertex } => {
                (0, format!("{}: farther than 1e5 m", self.vertex_named(self.named[*vertex])))
            }
            other => (0, format!("this part is no solid: {other}")),
        };
        let problem = self.faults.problem(&self.part.faces[face].span, title, "a closed convex solid");
        problem.help("each `o` or `g` must hold one closed convex part: split the object")
    }

    /// A face at an open edge, and the words for it.
    fn open_edge(&self, ends: [usize; 2]) -> (usize, String) {
        let place = |vertex: usize| self.written.vertices[vertex].place;
        let holds =
            |face: &Face, end: usize| face.corners.iter().any(|corner| place(corner.vertex) == place(end));
        let face = self.part.faces.iter().position(|face| ends.iter().all(|&end| holds(face, end)));
        let [from, to] = ends.map(|end| self.vertex_named(end));
        let title = format!("not closed: the edge between {from} and {to} does not part exactly two faces");
        (face.unwrap_or_default(), title)
    }

    /// The file's name of a vertex, by its index.
    fn vertex_named(&self, vertex: usize) -> String {
        format!("vertex {} (line {})", vertex + 1, self.faults.line(&self.written.vertices[vertex].span))
    }
}
