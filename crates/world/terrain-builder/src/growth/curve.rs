//! Curves of control points: picks, and every post between them.

use super::ControlPoint;
use crate::height_grid::Posts;

/// A picked point of a curve; initial heights are 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pick {
    /// Place: north, east (m).
    pub at: [f64; 2],
    /// Height that the ground grows to (m).
    pub height: f64,
    /// Weight against other points.
    pub weight: f64,
}

/// Numbers that run from one to another over `between` posts between them, both ends included. The document divides by `between`,
/// so its run passes the end; that is selectable.
pub fn runs(from: f64, to: f64, between: usize, divides_by_between: bool) -> impl Iterator<Item = f64> {
    let parts = if divides_by_between && between > 0 { between } else { between + 1 };
    (0..between + 2).map(
        move |post| {
            if post == parts { to } else { from + (to - from) * post as f64 / parts as f64 }
        },
    )
}

/// Control points of a curve, on the posts that are nearest to its straight pieces.
pub(super) fn points(posts: &Posts, picks: &[Pick], divides_by_between: bool) -> Vec<ControlPoint> {
    let single = picks.first().filter(|_| picks.len() == 1);
    let pieces = picks.windows(2).enumerate().flat_map(|(number, pair)| {
        // A piece begins at the post at which the one before ended.
        piece(posts, [&pair[0], &pair[1]], divides_by_between).into_iter().skip(usize::from(number > 0))
    });
    pieces.chain(single.map(|pick| point(pick.at, pick.height, pick.weight))).collect()
}

fn piece(posts: &Posts, [from, to]: [&Pick; 2], divides_by_between: bool) -> Vec<ControlPoint> {
    let [first, last] = [from, to].map(|pick| posts.nearest(pick.at).map(|post| post as f64));
    let steps = (first[0] - last[0]).abs().max((first[1] - last[1]).abs());
    let between = (steps as usize).saturating_sub(1);
    let run = |from, to| runs(from, to, between, divides_by_between);
    let heights = run(from.height, to.height).zip(run(from.weight, to.weight));
    let at = |post: usize| {
        let share = if steps > 0.0 { post as f64 / steps } else { 0.0 };
        let post = [0, 1].map(|axis| (first[axis] + share * (last[axis] - first[axis])).round() as usize);
        posts.place(post)
    };
    heights.enumerate().map(|(post, (height, weight))| point(at(post), height, weight)).collect()
}

fn point(at: [f64; 2], height: f64, weight: f64) -> ControlPoint {
    ControlPoint { at, height, weight, initial: 0.0 }
}
