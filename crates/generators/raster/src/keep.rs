//! Clipping of a convex polygon by one linear function (Sutherland and Hodgman, one edge).

use smallvec::{Array, SmallVec};

/// The part of a convex `polygon` where `height` is at least 0. `between` tells the point that lies at a share (0 to 1) of the way from
/// one point to another.
///
/// The way always leads from inside to outside: both polygons at an edge find the same point.
pub fn keep<A: Array<Item: Copy>>(
    polygon: &[A::Item],
    height: impl Fn(A::Item) -> f64,
    between: impl Fn(A::Item, A::Item, f64) -> A::Item,
) -> SmallVec<A> {
    let mut kept = SmallVec::new();
    for (i, &from) in polygon.iter().enumerate() {
        let to = polygon[(i + 1) % polygon.len()];
        let (start, end) = (height(from), height(to));
        if start >= 0.0 {
            kept.push(from);
        }
        match (start >= 0.0, end >= 0.0) {
            (true, false) => kept.push(between(from, to, start / (start - end))),
            (false, true) => kept.push(between(to, from, end / (end - start))),
            _ => {}
        }
    }
    kept
}
