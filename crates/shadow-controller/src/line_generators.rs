//! A limited number of line generators.

use std::collections::BinaryHeap;

use crate::crossings::Line;

/// One true boundary of a sweep, and how long it needs a line generator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Boundary {
    /// Ground range of the crossing (m).
    pub(crate) range: f64,
    /// Ground ranges between which the sweep is within the segment's extent (m).
    pub(crate) held: [f64; 2],
}

impl Boundary {
    /// The crossing of `line` (from the eye) at `range` (m) by a sweep of unit vector `direction`.
    pub(crate) fn new(line: &Line, direction: [f64; 2], range: f64) -> Self {
        let extent = [0, 1].map(|axis| (line.to[axis] - line.from[axis]).abs());
        // Nearly parallel to y: swapped form.
        let axis = usize::from(extent[1] > extent[0]);
        let ends = [line.from, line.to].map(|end| end[axis] / direction[axis]);
        let held = if direction[axis] == 0.0 {
            [0.0, f64::INFINITY]
        } else {
            [ends[0].min(ends[1]).max(0.0), ends[0].max(ends[1])]
        };
        Self { range, held }
    }
}

/// What became of the boundaries of one sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Service {
    pub(crate) dropped: u32,
    pub(crate) most_in_use: u32,
}

/// Gives line generators to `boundaries` in the order in which the sweep comes to need them, and removes those that
/// find none of `limit` free.
pub(crate) fn serve(boundaries: &mut Vec<Boundary>, limit: Option<u32>) -> Service {
    let limit = limit.map_or(usize::MAX, |limit| limit as usize);
    boundaries.sort_by(|a, b| a.held[0].total_cmp(&b.held[0]).then(a.range.total_cmp(&b.range)));
    // Ranges are not negative, so their bits are in their order; the heap gives the largest, hence the complement.
    let mut free_at: BinaryHeap<u64> = BinaryHeap::new();
    let (mut dropped, mut most) = (0, 0);
    boundaries.retain(|boundary| {
        while free_at.peek().is_some_and(|&end| f64::from_bits(!end) <= boundary.held[0]) {
            free_at.pop();
        }
        let served = free_at.len() < limit;
        if served {
            free_at.push(!boundary.held[1].max(0.0).to_bits());
            most = most.max(free_at.len());
        } else {
            dropped += 1;
        }
        served
    });
    boundaries.sort_by(|a, b| a.range.total_cmp(&b.range));
    Service { dropped, most_in_use: most as u32 }
}

#[cfg(test)]
mod tests {
    use super::{Boundary, Service, serve};
    use remote_shadow::Segment;

    fn boundary(range: f64, from: f64, to: f64) -> Boundary {
        Boundary { range, held: [from, to] }
    }

    #[test]
    fn nested_extents_need_one_each() {
        let mut all = vec![boundary(5.0, 0.0, 10.0), boundary(6.0, 1.0, 9.0), boundary(7.0, 2.0, 8.0)];
        assert_eq!(serve(&mut all.clone(), None), Service { dropped: 0, most_in_use: 3 });
        assert_eq!(serve(&mut all, Some(2)), Service { dropped: 1, most_in_use: 2 });
        assert_eq!(all.iter().map(|b| b.range).collect::<Vec<_>>(), [5.0, 6.0]);
    }

    #[test]
    fn one_after_the_other_needs_one() {
        let mut all: Vec<_> =
            (0..2000).map(|n| boundary(f64::from(n) + 0.5, f64::from(n), f64::from(n + 1))).collect();
        assert_eq!(serve(&mut all, Some(1)), Service { dropped: 0, most_in_use: 1 });
        assert_eq!(all.len(), 2000);
    }

    #[test]
    fn the_one_needed_first_is_served_first() {
        let mut all = vec![boundary(3.0, 2.5, 3.5), boundary(9.0, 1.0, 9.5)];
        assert_eq!(serve(&mut all, Some(1)), Service { dropped: 1, most_in_use: 1 });
        assert_eq!(all[0].range, 9.0);
    }

    #[test]
    fn the_extent_is_that_of_the_longer_side() {
        let flat = Segment { from: [10.0, -1.0], to: [14.0, 1.0] };
        assert_eq!(Boundary::new(&flat, [1.0, 0.0], 12.0).held, [10.0, 14.0]);
        let steep = Segment { from: [10.0, -5.0], to: [11.0, 5.0] };
        assert_eq!(Boundary::new(&steep, [1.0, 0.0], 10.5).held, [0.0, f64::INFINITY], "y never changes");
        assert_eq!(Boundary::new(&steep, [0.8, 0.6], 10.5).held, [0.0, 5.0 / 0.6]);
    }
}
