//! Faces, groups, suns and sequences that cannot be.

use quantities::Rate;

/// Why there is no such list of faces, sun or sequence.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FaceError {
    /// A figure is out of its range.
    #[error("{what} is {found}: expected {expected}")]
    Figure {
        /// Name of the figure with its unit.
        what: &'static str,
        /// The value that was found.
        found: f64,
        /// The range in words.
        expected: &'static str,
    },
    /// A vertex that is no place.
    #[error("list `{list}`, vertex {vertex}: a coordinate is not finite: expected three finite numbers (m)")]
    Place {
        /// Name of the list.
        list: String,
        /// Number of the vertex, from 0.
        vertex: usize,
    },
    /// A given normal without a direction.
    #[error(
        "list `{list}`, vertex {vertex}: the normal has no direction: expected three finite numbers, not all 0"
    )]
    Normal {
        /// Name of the list.
        list: String,
        /// Number of the vertex, from 0.
        vertex: usize,
    },
    /// A face of fewer than three corners.
    #[error("list `{list}`, face {face}: {found} corners: expected 3 or more")]
    Corners {
        /// Name of the list.
        list: String,
        /// Number of the face, from 0.
        face: usize,
        /// Number of its corners.
        found: usize,
    },
    /// A face names a vertex that the list lacks.
    #[error("list `{list}`, face {face}: there is no vertex {vertex}: expected a number below {vertices}")]
    NoVertex {
        /// Name of the list.
        list: String,
        /// Number of the face, from 0.
        face: usize,
        /// The number that was found.
        vertex: u32,
        /// Number of vertices in the list.
        vertices: usize,
    },
    /// A colour is out of range.
    #[error("list `{list}`, face {face}: a colour is {found}: expected linear red, green, blue from 0 to 1")]
    Colour {
        /// Name of the list.
        list: String,
        /// Number of the face, from 0.
        face: usize,
        /// The value that was found.
        found: f64,
    },
    /// A flat-shaded face is not plane.
    #[error(
        "list `{list}`, face {face}: vertex {vertex} lies {off:.3e} m off the face's plane: expected a plane face; cut it in triangles, or shade it `smooth`"
    )]
    NotPlane {
        /// Name of the list.
        list: String,
        /// Number of the face, from 0.
        face: usize,
        /// Number of the vertex farthest from the plane.
        vertex: u32,
        /// Its distance from the plane (m).
        off: f64,
    },
    /// A face turns back on itself at a corner.
    #[error(
        "list `{list}`, face {face}: not convex at vertex {vertex}: expected a convex face; cut it in convex parts"
    )]
    NotConvex {
        /// Name of the list.
        list: String,
        /// Number of the face, from 0.
        face: usize,
        /// Number of the vertex at which it turns back.
        vertex: u32,
    },
    /// A list has too many faces.
    #[error(
        "list `{list}` has {found} faces: expected {most} or fewer; raise `faces.limit`, or use a coarser model"
    )]
    TooMany {
        /// Name of the list.
        list: String,
        /// Number of its faces.
        found: usize,
        /// Largest number that is allowed.
        most: usize,
    },
    /// Two lists have the same priority.
    #[error("lists `{}` and `{}` both have priority {priority}: expected a number of its own for each list", .lists[0], .lists[1])]
    EqualPriority {
        /// The number that both have.
        priority: i32,
        /// Names of the two lists.
        lists: [String; 2],
    },
    /// The sun turns more than half a turn a frame, so it would seem to turn backwards.
    #[error(
        "the sun turns at {found} Hz, over half the frame rate, so it would seem to turn backwards: expected {} Hz or less", fraction(*.highest)
    )]
    Aliased {
        /// The rate that was found (Hz).
        found: f64,
        /// The highest rate that would do.
        highest: Rate,
    },
    /// A sequence lacks the face or object of one place.
    #[error("member {missing} of a sequence of {members} is missing: give a face or an object for it")]
    MissingMember {
        /// Number of the missing member, from 0.
        missing: usize,
        /// Number of places in the sequence.
        members: usize,
    },
    /// A sequence names a face that the list lacks.
    #[error(
        "list `{list}`: member {member} of a sequence shows face {face}: expected a number below {faces}"
    )]
    NoFace {
        /// Name of the list.
        list: String,
        /// Number of the member, from 0.
        member: usize,
        /// The number that was found.
        face: usize,
        /// Number of faces in the list.
        faces: usize,
    },
    /// Two sequences, or two members of one, show the same face.
    #[error(
        "list `{list}`: face {face} stands in more than one place of its sequences: expected one place for each face"
    )]
    SharedFace {
        /// Name of the list.
        list: String,
        /// Number of the face, from 0.
        face: usize,
    },
}

impl FaceError {
    /// Number of the face that is at fault, if one is.
    pub fn face(&self) -> Option<usize> {
        match self {
            Self::Corners { face, .. }
            | Self::NoVertex { face, .. }
            | Self::Colour { face, .. }
            | Self::NotPlane { face, .. }
            | Self::NotConvex { face, .. } => Some(*face),
            _ => None,
        }
    }
}

/// Hertz as a whole number or a fraction of whole numbers.
fn fraction(rate: Rate) -> String {
    match rate.fraction() {
        [whole, 1] => whole.to_string(),
        [above, below] => format!("{above}/{below}"),
    }
}

/// A finite number in a range that `expected` puts in words.
pub(crate) fn within(
    what: &'static str,
    found: f64,
    allowed: bool,
    expected: &'static str,
) -> Result<(), FaceError> {
    if found.is_finite() && allowed { Ok(()) } else { Err(FaceError::Figure { what, found, expected }) }
}
