//! A list of faces in a frame.

use faces::Detail;
use generator::Label;

/// A list of faces as a frame shows it.
#[derive(Debug, Clone, PartialEq)]
pub struct List {
    /// What it is called.
    pub name: String,
    /// What its faces are in the plane of labels.
    pub label: Label,
    /// Its priority: the lower number wins.
    pub priority: i64,
    /// How it is laid upon what is behind it; `None` where it stands for itself.
    pub level: Option<Detail>,
    /// Unit vector to its sun: north, east, up.
    pub sun: [f64; 3],
    /// Whether it has a sun of its own.
    pub has_own_sun: bool,
    /// Frames whose sequence, sun vector, body and normals it shows.
    pub shown: [u64; 4],
    /// Whether it is a level of detail that fell for want of edge slots.
    pub has_fallen: bool,
}
