//! What is wrong with a shell that is no solid, and at which face.

use diagnostics::Problem;

use super::faults::Faults;
use super::mesh::Mesh;
use super::shells::Shell;
use crate::SolidError;
use crate::split::{MOST_TRIANGLES, SplitError};
use limits::Limit;

/// What to do about a shell that does not close.
const CLOSE: &str =
    "fill its holes and join vertices at one place; an object may be a surface: `open = true`";
/// What to do about a shell that cannot be split.
const SIMPLER: &str =
    "simplify the shape, give convex parts as objects of the file, or draw it as a surface: `open = true`";

/// Why a shell gives no solids.
pub(super) enum Refusal {
    /// It is refused as it is.
    Solid(SolidError),
    /// An edge has not two faces.
    NotClosed,
    /// No way round suits all faces.
    NotOrientable,
    /// It is not convex, and not split either.
    NotSplit(SplitError),
}

impl From<SolidError> for Refusal {
    fn from(error: SolidError) -> Self {
        Self::Solid(error)
    }
}

/// A shell that is no solid.
pub(super) struct Blame<'a> {
    pub mesh: &'a Mesh,
    pub shell: &'a Shell<'a>,
    pub faults: &'a Faults,
}

impl Blame<'_> {
    /// Says why, at the face that is to blame.
    pub fn problem(&self, refusal: &Refusal) -> Problem {
        match refusal {
            Refusal::Solid(error) => self.not_solid(error),
            Refusal::NotClosed => self.not_closed(),
            Refusal::NotOrientable => self.not_orientable(),
            Refusal::NotSplit(error) => self.not_split(error),
        }
    }

    fn not_solid(&self, error: &SolidError) -> Problem {
        let (face, title) = match error {
            SolidError::BadFace { face, what } => (*face, format!("degenerate face: {what}")),
            SolidError::BadVertex { vertex } => (0, format!("{}: farther than 1e5 m", self.vertex(*vertex))),
            other => (0, format!("{} is no solid: {other}", self.name())),
        };
        self.at(face, title)
    }

    /// Says where it does not close.
    fn not_closed(&self) -> Problem {
        let edges = self.shell.joined.edges();
        let rim = edges.iter().find(|(_, faces)| faces.len() != 2);
        let (face, title) = match rim {
            Some((ends, faces)) => {
                let [from, to] = ends.map(|end| self.vertex(end as usize));
                let (what, count) = match faces.len() {
                    1 => ("not closed", "1 face".into()),
                    count => ("branching", format!("{count} faces")),
                };
                let title = format!(
                    "{what}: the edge between {from} and {to} has {count}, so {} is no solid",
                    self.name()
                );
                (faces[0].0, title)
            }
            None => (0, format!("{} is no solid: it closes only together with another part", self.name())),
        };
        self.at(face, title).help(CLOSE)
    }

    fn not_orientable(&self) -> Problem {
        let title = format!("{} has one side only: its faces cannot all be turned outwards", self.name());
        self.at(0, title).help(SIMPLER)
    }

    fn not_split(&self, error: &SplitError) -> Problem {
        let name = self.name();
        let problem = |title| self.at(0, title).help(SIMPLER);
        match error {
            SplitError::TooManyParts => {
                let most = Limit::ShapeParts.value();
                let title =
                    format!("{name} is not convex and would split into more than {most} convex parts");
                self.at(0, title).help(format!("{SIMPLER}; {}", Limit::ShapeParts))
            }
            SplitError::TooManyTriangles(count) => problem(format!(
                "{name} is not convex and has {count} triangles: at most {MOST_TRIANGLES} are split"
            )),
            SplitError::Crosses { at, around } => problem(format!(
                "{name} crosses itself: its surface runs {around} times around x {:.3}, y {:.3}, z {:.3} m",
                at.x, -at.y, at.z
            )),
            SplitError::Lost(share) => problem(format!(
                "{name} is not convex, crosses itself or is too thin: convex parts would differ by {:.2} % of its volume",
                share.abs() * 100.0
            )),
            SplitError::Part(error) => {
                problem(format!("{name} is not convex, and a part of it is no solid: {error}"))
            }
        }
    }

    fn at(&self, face: usize, title: String) -> Problem {
        let at = &self.shell.joined.faces[face].of.at;
        self.faults.problem(at, title, "a closed solid")
    }

    fn name(&self) -> String {
        match &self.mesh.parts[self.shell.part].name {
            name if name.is_empty() => "this part".into(),
            name => format!("part `{name}`"),
        }
    }

    /// The file's name of a vertex of the shell.
    fn vertex(&self, number: usize) -> String {
        let index = self.shell.joined.named[number];
        self.faults.vertex(index, &self.mesh.vertices[index].at)
    }
}
