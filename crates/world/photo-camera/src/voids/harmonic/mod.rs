//! The harmonic fill: Laplace's equation on the posts of each hole.
//!
//! ```text
//!  hole --> few posts:  elimination -------------------------------> heights
//!       \-> many posts: equations --> conjugate gradients ---------> heights
//!                          \--> grids, finer to coarser: cycle --^
//! ```
//!
//! The matrix is that of a graph: the number of neighbours on the diagonal, -1 for each neighbour that is a void too. It is positive
//! definite, because every hole has a rim. Heights are taken from the mean of the rim, so a plane far above the datum loses no digits.
//! Holes are solved beside one another; the bits do not depend on the number of threads.

mod cycle;
mod elimination;
mod equations;

use rayon::prelude::*;

use super::VoidError;
use super::holes::Hole;
use elimination::Elimination;
use equations::Equations;

/// Largest imbalance of a post that is left, by the range of the rim's heights (chosen).
const BALANCE: f64 = 1e-13;

/// Known posts around a hole.
struct Rim {
    low: f64,
    high: f64,
    mean: f64,
}

impl Rim {
    fn of(heights: &[f64], hole: Hole) -> Self {
        let rim = || hole.rim.iter().map(|&post| heights[post]);
        Self {
            low: rim().fold(f64::INFINITY, f64::min),
            high: rim().fold(f64::NEG_INFINITY, f64::max),
            mean: rim().sum::<f64>() / hole.rim.len() as f64,
        }
    }

    /// Imbalance (m) up to which a post counts as balanced. A flat rim leaves the rounding of its mean: the bound is never below that.
    fn bound(&self) -> f64 {
        BALANCE * (self.high - self.low).max(self.low.abs()).max(self.high.abs()).max(f64::MIN_POSITIVE)
    }
}

/// Fills holes harmonically, each by itself.
pub(super) fn fill(shape: [usize; 2], heights: &mut [f64], holes: &[Hole]) -> Result<(), VoidError> {
    let mut values = vec![0.0; holes.iter().map(|hole| hole.posts.len()).sum()];
    let mut rest = &mut values[..];
    let parts = holes.iter().map(|hole| {
        let (part, behind) = std::mem::take(&mut rest).split_at_mut(hole.posts.len());
        rest = behind;
        (*hole, part)
    });
    let known = &*heights;
    parts
        .collect::<Vec<_>>()
        .into_par_iter()
        .try_for_each_init(Elimination::default, |elimination, (hole, values)| {
            solve(shape, known, hole, elimination, values)
        })?;
    let posts = holes.iter().flat_map(|hole| hole.posts);
    posts.zip(values).for_each(|(&post, value)| heights[post] = value);
    Ok(())
}

/// Heights (m) of the posts of one hole.
fn solve(
    shape: [usize; 2],
    heights: &[f64],
    hole: Hole,
    elimination: &mut Elimination,
    values: &mut [f64],
) -> Result<(), VoidError> {
    let rim = Rim::of(heights, hole);
    if hole.posts.len() <= elimination::MOST_POSTS {
        elimination.solve(shape, heights, hole, rim.mean, values);
    } else {
        values.copy_from_slice(&Equations::of(shape, heights, hole, rim.mean).solve(rim.bound())?);
    }
    for value in values {
        // Rounding may leave the range by a unit in the last place; the law says never.
        *value = (rim.mean + *value).clamp(rim.low, rim.high);
    }
    Ok(())
}
