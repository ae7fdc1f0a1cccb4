//! Faces of more than three corners, cut in triangles.

/// Whether faces are cut in triangles before they are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cut {
    /// Triangles from the first corner (chosen); the squares of a pattern begin at alternate corners, so their diagonals alternate.
    Fan,
    /// Whole faces, to show why cutting is needed: brightness then depends on the direction of the scan.
    Uncut,
}

impl Cut {
    /// The pieces of a face of `corners` corners, by numbers of its corners.
    pub fn pieces(self, corners: usize) -> Vec<Vec<usize>> {
        match self {
            Self::Fan => (2..corners).map(|last| vec![0, last - 1, last]).collect(),
            Self::Uncut => vec![(0..corners).collect()],
        }
    }
}
