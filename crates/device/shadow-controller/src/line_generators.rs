//! A limited number of line generators.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use quantities::SweepTime;
use sweep_program::{LoadTiming, MissCause, TimedLoad};

use crate::crossings::ROOM;
use crate::fan::Line;
use crate::nearly::sort_nearly;

/// Words of a boundary: place, length, direction (hardware section 3.7).
pub const SEGMENT_WORDS: u32 = 4;

/// A boundary whose words were not there when the sweep crossed it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SegmentMiss {
    /// Line generator that waited for them; none if all were taken.
    pub line_generator: Option<u32>,
    /// Ground range of the crossing (m).
    pub range: f64,
    /// When that was; none if all line generators were taken.
    pub due: Option<SweepTime>,
    /// When the words came; none if never.
    pub arrival: Option<SweepTime>,
    /// Why; none if all line generators were taken.
    pub cause: Option<MissCause>,
}

/// A boundary whose words took time to come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SegmentLoad {
    /// Line generator that waited for them.
    pub line_generator: u32,
    /// Ground range of the crossing (m).
    pub range: f64,
    /// When they came; a slack below 0 is late.
    pub load: TimedLoad,
}

impl SegmentMiss {
    /// A boundary that found no free line generator.
    fn occupied(boundary: &Boundary) -> Self {
        Self { line_generator: None, range: boundary.range, due: None, arrival: None, cause: None }
    }
}

/// Least rate at which a sweep and a line part (metres a metre of range): a flatter one counts as this.
pub(crate) const FLATTEST: f64 = 0.1;

/// One true boundary of a sweep, and how long it needs a line generator.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Boundary {
    /// Ground range of the crossing (m).
    pub(crate) range: f64,
    /// Ground ranges between which the sweep is within the segment's extent (m).
    pub(crate) held: [f64; 2],
    /// By how much the crossing moves along the sweep for an error of the line of its full scale, which is its length (m).
    pub(crate) swing: f64,
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
            // `max` may take either of two zeros; added to 0, each is 0.
            [ends[0].min(ends[1]).max(0.0) + 0.0, ends[0].max(ends[1])]
        };
        let slope = (line.to[1 - axis] - line.from[1 - axis]) / (line.to[axis] - line.from[axis]);
        let rate = direction[1 - axis] - slope * direction[axis];
        let length = (extent[0] * extent[0] + extent[1] * extent[1]).sqrt();
        Self { range, held, swing: length * rate.signum() / rate.abs().max(FLATTEST) }
    }
}

/// What became of the boundaries of one sweep.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Service {
    pub(crate) dropped: u32,
    pub(crate) most_in_use: u32,
    pub(crate) misses: Vec<SegmentMiss>,
    /// Loads that took time.
    pub(crate) loads: Vec<SegmentLoad>,
}

/// Boundaries in the order in which the sweep comes to need them.
fn order(boundaries: &mut [Boundary]) {
    boundaries.sort_unstable_by(|a, b| a.held[0].total_cmp(&b.held[0]).then_with(|| by_range(a, b)));
}

/// As the sweep crosses them: no two are at one place.
fn by_range(a: &Boundary, b: &Boundary) -> Ordering {
    a.range.total_cmp(&b.range)
}

/// What [`serve`] uses again from sweep to sweep.
#[derive(Debug)]
pub(crate) struct ServiceWork {
    /// Where line generators come free again.
    free_at: BinaryHeap<u64>,
    /// Where each boundary takes one and gives it back, each in order.
    taken: Vec<u64>,
    given_back: Vec<u64>,
    apart: Vec<u64>,
}

impl ServiceWork {
    /// Room for the boundaries of a sweep.
    pub(crate) fn new() -> Self {
        let room = || Vec::with_capacity(ROOM);
        Self { free_at: BinaryHeap::new(), taken: room(), given_back: room(), apart: room() }
    }
}

/// Gives line generators to `boundaries` in the order in which the sweep comes to need them, and removes those that
/// find none of `limit` free.
pub(crate) fn serve(boundaries: &mut Vec<Boundary>, limit: Option<u32>, work: &mut ServiceWork) -> Service {
    let most_in_use = if limit.is_none() { most_at_one_time(boundaries, work) } else { None };
    match most_in_use {
        Some(most_in_use) => Service { most_in_use, ..Service::default() },
        None => serve_in_turn(boundaries, limit, &mut work.free_at),
    }
}

/// Most line generators in use at one time if there is one for each boundary; `None` if some boundary needs one for no
/// time at all.
fn most_at_one_time(boundaries: &[Boundary], work: &mut ServiceWork) -> Option<u32> {
    if !boundaries.iter().all(|boundary| boundary.held[0] < boundary.held[1]) {
        return None;
    }
    let ServiceWork { taken, given_back, apart, .. } = work;
    // Boundaries come by range, so these are nearly in order.
    for (ranges, end) in [(&mut *taken, 0), (&mut *given_back, 1)] {
        // They are not negative, so their bits are in their order.
        let held = boundaries.iter().map(|boundary| (boundary.held[end] + 0.0).to_bits());
        sort_nearly(held, ranges, apart);
    }
    let (mut free_again, mut most) = (0, 0);
    for (before, at) in taken.iter().enumerate() {
        // What is given back at a range comes before what is taken.
        while given_back[free_again] <= *at {
            free_again += 1;
        }
        most = most.max(before + 1 - free_again);
    }
    Some(most as u32)
}

/// As [`serve`], boundary by boundary.
fn serve_in_turn(
    boundaries: &mut Vec<Boundary>,
    limit: Option<u32>,
    free_at: &mut BinaryHeap<u64>,
) -> Service {
    let limit = limit.map_or(usize::MAX, |limit| limit as usize);
    order(boundaries);
    // Ranges are not negative, so their bits are in their order; the heap gives the largest, hence the complement.
    free_at.clear();
    let (mut service, mut most) = (Service::default(), 0);
    boundaries.retain(|boundary| {
        while free_at.peek().is_some_and(|&end| f64::from_bits(!end) <= boundary.held[0]) {
            free_at.pop();
        }
        let served = free_at.len() < limit;
        if served {
            free_at.push(!(boundary.held[1].max(0.0) + 0.0).to_bits());
            most = most.max(free_at.len());
        } else {
            service.dropped += 1;
            service.misses.push(SegmentMiss::occupied(boundary));
        }
        served
    });
    boundaries.sort_unstable_by(by_range);
    Service { most_in_use: most as u32, ..service }
}

/// The same where words take time: of the free line generators that is taken which has been free for longest. A boundary
/// whose words are late acts from where they come, if that is not beyond `reach` (m), or not at all.
pub(crate) fn serve_in_time(
    boundaries: &mut Vec<Boundary>,
    limit: Option<u32>,
    reach: f64,
    timing: &mut LoadTiming<impl Fn(f64) -> SweepTime, impl Fn(SweepTime) -> f64>,
) -> Service {
    order(boundaries);
    let (mut busy, mut service) = (Vec::new(), Service::default());
    boundaries.retain_mut(|boundary| {
        let Some((line_generator, free)) = longest_free(&mut busy, boundary, limit) else {
            service.dropped += 1;
            service.misses.push(SegmentMiss::occupied(boundary));
            return false;
        };
        busy[line_generator as usize] = boundary.held[1];
        let in_use = busy.iter().filter(|&&freed| freed > boundary.held[0]).count() as u32;
        service.most_in_use = service.most_in_use.max(in_use);
        let number = service.loads.len() as u32;
        let load = timing.load(number, [free, boundary.range, boundary.held[1].min(reach)]);
        service.loads.push(SegmentLoad { line_generator, range: boundary.range, load });
        let TimedLoad { due, arrival, range, slack, cause } = load;
        if slack >= 0 {
            return true;
        }
        let line_generator = Some(line_generator);
        let (due, cause) = (Some(due), Some(cause));
        service.misses.push(SegmentMiss { line_generator, range: boundary.range, due, arrival, cause });
        boundary.range = range;
        timing.strobes_through && range <= reach
    });
    boundaries.sort_unstable_by(by_range);
    service
}

/// The line generator that has been free for longest, and the ground range since when (m); one that was not used yet has
/// been free always. `None` if all are taken.
fn longest_free(busy: &mut Vec<f64>, boundary: &Boundary, limit: Option<u32>) -> Option<(u32, f64)> {
    let next = busy.len() as u32;
    if limit.is_none_or(|limit| next < limit) {
        busy.push(f64::NEG_INFINITY);
        return Some((next, f64::NEG_INFINITY));
    }
    let free = busy.iter().copied().enumerate().filter(|&(_, freed)| freed <= boundary.held[0]);
    free.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, freed)| (index as u32, freed))
}

#[cfg(test)]
mod tests {
    use std::collections::BinaryHeap;

    use super::{Boundary, ServiceWork, serve, serve_in_turn};
    use proptest::prelude::{any, prop_assert_eq, proptest};
    use remote_shadow::Segment;

    fn boundary(range: f64, from: f64, to: f64) -> Boundary {
        Boundary { range, held: [from, to], swing: 1.0 }
    }

    /// Boundaries dropped, and most in use.
    fn served(all: &mut Vec<Boundary>, limit: Option<u32>) -> (u32, u32) {
        let service = serve(all, limit, &mut ServiceWork::new());
        assert_eq!(service.misses.len() as u32, service.dropped);
        (service.dropped, service.most_in_use)
    }

    #[test]
    fn nested_extents_need_one_each() {
        let mut all = vec![boundary(5.0, 0.0, 10.0), boundary(6.0, 1.0, 9.0), boundary(7.0, 2.0, 8.0)];
        assert_eq!(served(&mut all.clone(), None), (0, 3));
        assert_eq!(served(&mut all, Some(2)), (1, 2));
        assert_eq!(all.iter().map(|b| b.range).collect::<Vec<_>>(), [5.0, 6.0]);
    }

    #[test]
    fn one_after_the_other_needs_one() {
        let mut all: Vec<_> =
            (0..2000).map(|n| boundary(f64::from(n) + 0.5, f64::from(n), f64::from(n + 1))).collect();
        assert_eq!(served(&mut all, Some(1)), (0, 1));
        assert_eq!(all.len(), 2000);
    }

    #[test]
    fn the_one_needed_first_is_served_first() {
        let mut all = vec![boundary(3.0, 2.5, 3.5), boundary(9.0, 1.0, 9.5)];
        assert_eq!(served(&mut all, Some(1)), (1, 1));
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

    proptest! {
        /// Extents that touch, nest and coincide, some of them of no length.
        #[test]
        fn one_for_each_is_counted_as_if_they_were_served_in_turn(
            extents in proptest::collection::vec((0..12u8, 0..6u8, any::<bool>()), 0..40),
        ) {
            let mut all: Vec<Boundary> = Vec::new();
            for (n, &(from, length, point)) in extents.iter().enumerate() {
                let from = f64::from(from);
                let length = if point { f64::from(length) } else { f64::from(length) + 0.5 };
                all.push(boundary(n as f64, from, from + length));
            }
            let mut in_turn = all.clone();
            let expected = serve_in_turn(&mut in_turn, None, &mut BinaryHeap::new());
            let mut work = ServiceWork { taken: vec![3], given_back: vec![4], ..ServiceWork::new() };
            prop_assert_eq!(serve(&mut all, None, &mut work), expected);
            prop_assert_eq!(all, in_turn);
        }
    }
}
