//! Why tiles or levels cannot be.

/// A terrain or a table of levels that is none.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TileError {
    /// Tiles of this order are too small or too large.
    #[error("tile order n = {0}: expected 1 to 12, so that a side has 2^n + 1 posts")]
    Order(u32),
    /// The posts do not make whole tiles.
    #[error(
        "{posts} posts along {axis}: expected a multiple of {side} and one more, for tiles of {side} cells; refine the last tile or cut the ground"
    )]
    Posts {
        /// Axis at fault: x or y.
        axis: char,
        /// Number of posts that was found.
        posts: usize,
        /// Cells of a tile.
        side: usize,
    },
    /// Places of posts do not rise.
    #[error("post {index} along {axis} does not lie beyond the one before it")]
    Places {
        /// Axis at fault: x or y.
        axis: char,
        /// Index of the post.
        index: usize,
    },
    /// There are not as many heights as posts.
    #[error("{found} heights for {expected} posts")]
    Heights {
        /// Number of heights that was found.
        found: usize,
        /// How many posts there are.
        expected: usize,
    },
    /// A height is no number.
    #[error("height of post {0} is not finite: fill voids before the ground is cut into tiles")]
    Void(usize),
    /// There is no level, or there are more than the tiles have.
    #[error("{found} levels: expected 1 to {most}, as tiles of order n have n + 1")]
    Count {
        /// Number of levels that was found.
        found: usize,
        /// Levels that the tiles have.
        most: usize,
    },
    /// A range ends before it begins.
    #[error(
        "level {level}: its range ends at {end} m, and begins at {begin} m; ranges join, so each ends beyond the one before it"
    )]
    Range {
        /// The level at fault.
        level: usize,
        /// Where its range begins (m).
        begin: f64,
        /// Where its range ends (m).
        end: f64,
    },
    /// A morph share is no share.
    #[error("level {level}: {share} of its range morphs; expected 0 to 1")]
    Share {
        /// The level at fault.
        level: usize,
        /// Share that was found.
        share: f64,
    },
}
