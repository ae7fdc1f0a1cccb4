//! Wishes for a line of sight that cannot be met.

/// Why there is no line of sight.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SightError {
    /// The mesh has too few posts, or another number of heights than posts.
    #[error(
        "{heights} heights for {rows} rows of {columns} posts: expected one each, and 2 rows and columns or more"
    )]
    Shape {
        /// Number of rows that was given.
        rows: usize,
        /// Number of columns that was given.
        columns: usize,
        /// Number of heights that was given.
        heights: usize,
    },
    /// A height (m) is infinite; NaN marks a void and is allowed.
    #[error(
        "height of post (row {row}, column {column}) is {found} m: expected a finite number, or NaN for a void"
    )]
    Infinite {
        /// Row of the post, from the north.
        row: usize,
        /// Column of the post, from the west.
        column: usize,
        /// The value that was found (m).
        found: f64,
    },
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
    /// A level does not divide the rows and columns of the mesh.
    #[error(
        "level {level} takes every {stride}th of {rows} x {columns} posts: expected a stride that divides {rows} - 1 and {columns} - 1"
    )]
    Level {
        /// The level that was asked for.
        level: u32,
        /// Posts from one post of the level to the next.
        stride: usize,
        /// Rows of the mesh.
        rows: usize,
        /// Columns of the mesh.
        columns: usize,
    },
    /// A height above ground was given where there is no ground.
    #[error("no ground at ({}, {}) m: expected a place on the mesh and off its voids, or a height above the datum", place[0], place[1])]
    NoGround {
        /// The place: north, east (m).
        place: [f64; 2],
    },
    /// A point lies below the ground.
    #[error("point at ({}, {}) m lies {depth} m below the ground: expected a height on it or above it", place[0], place[1])]
    Below {
        /// The place: north, east (m).
        place: [f64; 2],
        /// Depth below the ground (m).
        depth: f64,
    },
}

/// A finite number in a range that `expected` puts in words.
pub(crate) fn within(
    what: &'static str,
    found: f64,
    allowed: bool,
    expected: &'static str,
) -> Result<(), SightError> {
    if found.is_finite() && allowed { Ok(()) } else { Err(SightError::Figure { what, found, expected }) }
}
