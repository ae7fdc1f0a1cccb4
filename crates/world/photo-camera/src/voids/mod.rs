//! Voids of an elevation grid, filled.
//!
//! A *hole* is a set of voids joined by rows and columns. The *rim* of a hole is the known posts beside its voids. Nothing beyond
//! the rim changes what fills a hole, except in the way of the thesis ([`Fill::WrittenMean`]), whose fill moves with the crop.

mod harmonic;
mod holes;

use holes::{Hole, Holes};

/// Largest part of the grid that one hole may take (chosen).
const LARGEST_PART: f64 = 0.25;

/// Least and greatest height (m) that a post may have.
const HEIGHTS: [f64; 2] = [-32_767.0, 9_000.0];

/// Why a grid with voids cannot be filled.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum VoidError {
    /// The grid is too small, or has another number of heights than posts.
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
    /// A height is out of range.
    #[error(
        "height of post (row {row}, column {column}) is {found} m: expected -32767 to 9000 m, or NaN for a void"
    )]
    Height {
        /// Row of the post, from 0.
        row: usize,
        /// Column of the post, from 0.
        column: usize,
        /// The value that was found (m).
        found: f64,
    },
    /// No post is known.
    #[error("all {posts} posts are void: give a crop with at least one known post")]
    AllVoid {
        /// Number of posts in the grid.
        posts: usize,
    },
    /// One hole takes more than a quarter of the grid.
    #[error(
        "the hole at row {row}, column {column} has {size} of {posts} posts, more than a quarter: \
         take a larger crop, or allow large holes"
    )]
    LargeHole {
        /// Row of the first post of the hole.
        row: usize,
        /// Column of the first post of the hole.
        column: usize,
        /// Number of posts in the hole.
        size: usize,
        /// Number of posts in the grid.
        posts: usize,
    },
    /// The harmonic solution did not arrive.
    #[error(
        "the harmonic fill stopped {residual:e} m from balance after {steps} steps: report this grid as a fault"
    )]
    NotConverged {
        /// Largest imbalance of a post that is left (m).
        residual: f64,
        /// Number of steps that were made.
        steps: usize,
    },
}

/// How voids are filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fill {
    /// Each void is the mean of its neighbours, at equilibrium: exact on planes, never beyond the rim.
    Harmonic,
    /// Mean of the rim, weighted by the inverse of the squared distance in posts.
    InverseDistance,
    /// Height of the nearest post of the rim; of equals the first by row, then column.
    Nearest,
    /// Mean of all known posts, cut to a whole metre towards 0, as the thesis's program does. It makes cliffs.
    WrittenMean,
    /// Voids stay void and are only counted.
    Leave,
}

/// What is done with a hole that touches the edge of the grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Border {
    /// The hole stays void: it was never surveyed, and nothing encloses it.
    StaysVoid,
    /// The hole is filled; the edge of the grid reflects.
    Filled,
}

/// What a filled grid is to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wishes {
    /// The way in which voids are filled.
    pub fill: Fill,
    /// Treatment of holes at the edge.
    pub border: Border,
    /// Whether a hole may take more than a quarter of the grid.
    pub allow_large_holes: bool,
}

impl Default for Wishes {
    fn default() -> Self {
        Self { fill: Fill::Harmonic, border: Border::StaysVoid, allow_large_holes: false }
    }
}

/// A grid after the fill, with the mask of what was void.
#[derive(Debug, Clone, PartialEq)]
pub struct Filled {
    /// Heights (m), row by row; NaN where a void stays.
    pub heights: Vec<f64>,
    /// Whether the post was void before the fill.
    pub was_void: Vec<bool>,
    /// Number of holes of the grid, also of those that stay.
    pub holes: usize,
    /// Number of posts in the largest hole.
    pub largest_hole: usize,
    /// Number of posts that stay void.
    pub still_void: usize,
}

/// Fills the voids (NaN) of `heights` (m), given row by row.
///
/// # Errors
///
/// If the shape or a height is unusable, all posts are void, a hole that is to be filled takes more than a quarter of the grid and
/// large holes are not allowed, or the harmonic solution does not arrive.
pub fn fill([rows, columns]: [usize; 2], heights: &[f64], wishes: Wishes) -> Result<Filled, VoidError> {
    refuse_grid([rows, columns], heights)?;
    let holes = Holes::find([rows, columns], heights);
    let chosen: Vec<Hole> = holes.iter().filter(|hole| is_filled(*hole, wishes)).collect();
    if !wishes.allow_large_holes {
        refuse_large(&chosen, heights.len(), columns)?;
    }
    let mut filled = heights.to_vec();
    let written_mean = written_mean(heights);
    let mut by =
        |value: &Value| chosen.iter().for_each(|hole| each(*hole, columns, heights, &mut filled, value));
    match wishes.fill {
        Fill::Harmonic => harmonic::fill([rows, columns], &mut filled, &chosen)?,
        Fill::InverseDistance => by(&inverse_distance),
        Fill::Nearest => by(&nearest),
        Fill::WrittenMean => by(&|_| written_mean),
        Fill::Leave => {}
    }
    Ok(Filled {
        still_void: filled.iter().filter(|height| height.is_nan()).count(),
        heights: filled,
        was_void: heights.iter().map(|height| height.is_nan()).collect(),
        holes: holes.iter().len(),
        largest_hole: holes.iter().map(|hole| hole.posts.len()).max().unwrap_or(0),
    })
}

fn is_filled(hole: Hole, wishes: Wishes) -> bool {
    wishes.fill != Fill::Leave && (hole.is_enclosed || wishes.border == Border::Filled)
}

fn refuse_grid([rows, columns]: [usize; 2], heights: &[f64]) -> Result<(), VoidError> {
    if rows < 2 || columns < 2 || rows.checked_mul(columns) != Some(heights.len()) {
        return Err(VoidError::Shape { rows, columns, heights: heights.len() });
    }
    let [low, high] = HEIGHTS;
    if let Some(post) = heights.iter().position(|&height| height < low || height > high) {
        let (row, column) = (post / columns, post % columns);
        return Err(VoidError::Height { row, column, found: heights[post] });
    }
    match heights.iter().all(|height| height.is_nan()) {
        true => Err(VoidError::AllVoid { posts: heights.len() }),
        false => Ok(()),
    }
}

fn refuse_large(holes: &[Hole], posts: usize, columns: usize) -> Result<(), VoidError> {
    match holes.iter().find(|hole| hole.posts.len() as f64 > LARGEST_PART * posts as f64) {
        Some(hole) => {
            let (row, column) = (hole.posts[0] / columns, hole.posts[0] % columns);
            Err(VoidError::LargeHole { row, column, size: hole.posts.len(), posts })
        }
        None => Ok(()),
    }
}

fn written_mean(heights: &[f64]) -> f64 {
    let known = || heights.iter().filter(|height| !height.is_nan());
    (known().sum::<f64>() / known().count() as f64).trunc()
}

/// What a void is given by the rim: squared distance (posts) and height (m) of each of its posts.
type Value<'a> = dyn Fn(&mut dyn Iterator<Item = [f64; 2]>) -> f64 + 'a;

/// Gives each void of a hole what `value` makes of the rim.
fn each(hole: Hole, columns: usize, known: &[f64], filled: &mut [f64], value: &Value) {
    for &post in hole.posts {
        let mut rim = hole.rim.iter().map(|&at| {
            let across = (at / columns).abs_diff(post / columns) as f64;
            let along = (at % columns).abs_diff(post % columns) as f64;
            [across * across + along * along, known[at]]
        });
        filled[post] = value(&mut rim);
    }
}

fn inverse_distance(rim: &mut dyn Iterator<Item = [f64; 2]>) -> f64 {
    let [sum, weights] = rim.fold([0.0; 2], |[sum, weights], [squared, height]| {
        [sum + height / squared, weights + 1.0 / squared]
    });
    sum / weights
}

fn nearest(rim: &mut dyn Iterator<Item = [f64; 2]>) -> f64 {
    rim.fold([f64::INFINITY; 2], |best, post| if post[0] < best[0] { post } else { best })[1]
}
