//! The regions that a straight line over a grid passes, in order.

/// A part of the line inside one region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Region, north and east.
    pub region: [usize; 2],
    /// Ground range of its begin (m).
    pub from: f64,
    /// Ground range of its end (m), beyond `from`.
    pub to: f64,
}

/// How far outside the grid a place may lie by rounding (regions); as a share of how far the origin is from the grid.
const ROUNDING: f64 = 1e-9;
const FAR_ROUNDING: f64 = 1e-15;

/// Stretches of `origin + s * step` (in regions) for s from `from` up to `end`, or up to the edge of the area.
///
/// Crossings are computed from the origin each time: no error adds up. A line along a boundary stays on one side
/// of it; a line through a corner passes a region of no length, which is left out.
#[derive(Debug, Clone)]
pub struct Walk {
    origin: [f64; 2],
    step: [f64; 2],
    metres: [f64; 2],
    region: [i64; 2],
    regions: [i64; 2],
    from: f64,
    end: f64,
}

impl Walk {
    /// A walk over a grid of `regions` north by east; `None` if it begins outside.
    pub fn new(regions: [usize; 2], origin: [f64; 2], step: [f64; 2], from: f64, end: f64) -> Option<Self> {
        let regions = regions.map(|count| count as i64);
        let mut region = [0; 2];
        for axis in 0..2 {
            let at = origin[axis] + from * step[axis];
            // A line that comes in from outside begins on the edge, but for the rounding of its crossing.
            let rounding = ROUNDING.max(FAR_ROUNDING * origin[axis].abs());
            if !(at >= -rounding && at <= regions[axis] as f64 + rounding) {
                return None;
            }
            region[axis] = (at as i64).min(regions[axis] - 1);
        }
        let metres = step.map(|step| 1.0 / step);
        Some(Self { origin, step, metres, region, regions, from, end })
    }

    /// Ground range where the line leaves the present region across the boundary of an axis.
    fn crossing(&self, axis: usize) -> f64 {
        let step = self.step[axis];
        if step == 0.0 {
            return f64::INFINITY;
        }
        let boundary = self.region[axis] + i64::from(step > 0.0);
        (boundary as f64 - self.origin[axis]) * self.metres[axis]
    }

    /// Range at which the line leaves the square block of `size` regions in which it is; `None` once it is outside.
    pub fn block_end(&self, size: i64) -> Option<f64> {
        let crossings = [0, 1].map(|axis| self.block_crossing(axis, size));
        self.stored().then(|| crossings[0].min(crossings[1]).min(self.end))
    }

    /// Goes to where the line leaves that block.
    pub fn leave_block(&mut self, size: i64) {
        let crossings = [0, 1].map(|axis| self.block_crossing(axis, size));
        let axis = usize::from(crossings[1] < crossings[0]);
        let other = 1 - axis;
        let to = crossings[axis].min(self.end);
        let first = self.region.map(|index| index - index % size);
        self.region[axis] = if self.step[axis] > 0.0 { first[axis] + size } else { first[axis] - 1 };
        let at = (self.origin[other] + to * self.step[other]).floor() as i64;
        self.region[other] = at.clamp(first[other], (first[other] + size).min(self.regions[other]) - 1);
        self.from = to.max(self.from);
    }

    /// The region in which the line is.
    pub fn region(&self) -> [usize; 2] {
        self.region.map(|index| index as usize)
    }

    /// Returns the range that the walk has reached (m).
    pub fn from(&self) -> f64 {
        self.from
    }

    fn block_crossing(&self, axis: usize, size: i64) -> f64 {
        let step = self.step[axis];
        if step == 0.0 {
            return f64::INFINITY;
        }
        let first = self.region[axis] - self.region[axis] % size;
        let boundary = if step > 0.0 { (first + size).min(self.regions[axis]) } else { first };
        (boundary as f64 - self.origin[axis]) * self.metres[axis]
    }

    fn stored(&self) -> bool {
        (0..2).all(|axis| self.region[axis] >= 0 && self.region[axis] < self.regions[axis])
    }
}

impl Iterator for Walk {
    type Item = Stretch;

    fn next(&mut self) -> Option<Stretch> {
        while self.from < self.end && self.stored() {
            let crossings = [self.crossing(0), self.crossing(1)];
            let axis = usize::from(crossings[1] < crossings[0]);
            let to = crossings[axis].min(self.end);
            let stretch = Stretch { region: self.region.map(|index| index as usize), from: self.from, to };
            self.region[axis] += if self.step[axis] > 0.0 { 1 } else { -1 };
            if to > self.from {
                self.from = to;
                return Some(stretch);
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{Stretch, Walk};
    use proptest::prelude::*;

    fn walk(origin: [f64; 2], direction: [f64; 2], from: f64, end: f64) -> Vec<Stretch> {
        let [origin, step] = [origin, direction].map(|pair| pair.map(|value| value / 10.0));
        Walk::new([3, 3], origin, step, from, end).into_iter().flatten().collect()
    }

    fn regions(stretches: &[Stretch]) -> Vec<[usize; 2]> {
        stretches.iter().map(|stretch| stretch.region).collect()
    }

    #[test]
    fn along_a_boundary_and_along_both_edges() {
        assert_eq!(regions(&walk([0.0, 10.0], [1.0, 0.0], 1.0, 99.0)), [[0, 1], [1, 1], [2, 1]]);
        assert_eq!(regions(&walk([30.0, 30.0], [-1.0, 0.0], 0.0, 99.0)), [[2, 2], [1, 2], [0, 2]]);
        assert_eq!(regions(&walk([15.0, 0.0], [0.0, 1.0], 0.0, 12.0)), [[1, 0], [1, 1]]);
    }

    #[test]
    fn through_corners() {
        let half = 0.5_f64.sqrt();
        let stretches = walk([0.0, 0.0], [half, half], 1.0, 99.0);
        assert_eq!(stretches.first().unwrap().from, 1.0);
        assert!((stretches.last().unwrap().to - 30.0 * 2.0_f64.sqrt()).abs() < 1e-12);
        let long: Vec<_> = stretches.into_iter().filter(|stretch| stretch.to - stretch.from > 1e-9).collect();
        assert_eq!(regions(&long), [[0, 0], [1, 1], [2, 2]]);
        assert_eq!(regions(&walk([10.0, 10.0], [-half, half], 0.0, 5.0)), [[0, 1]]);
    }

    #[test]
    fn from_the_edge_outwards_there_is_nothing() {
        assert!(walk([0.0, 5.0], [-1.0, 0.0], 0.0, 99.0).is_empty());
        assert!(walk([30.0, 5.0], [1.0, 0.0], 0.0, 99.0).is_empty());
        assert!(walk([5.0, 5.0], [1.0, 0.0], 26.0, 99.0).is_empty());
        assert!(walk([5.0, 5.0], [f64::NAN, f64::NAN], 1.0, 99.0).is_empty());
    }

    /// From 10^9 regions away the crossing of the edge is good to 1e-7 of a region.
    #[test]
    fn lines_that_come_in_from_far_away() {
        for k in 1..200 {
            let (origin, across) = (-9.1e8 - f64::from(k), 1e-9 * f64::from(k));
            let length = (1.0 + across * across).sqrt();
            let step = [1.0 / length, across / length];
            let from = -origin / step[0];
            let walk = Walk::new([3, 3], [origin, 1.5 - from * step[1]], step, from, f64::INFINITY);
            assert_eq!(walk.into_iter().flatten().count(), 3, "{k}");
        }
    }

    proptest! {
        #[test]
        fn leaving_a_block_is_passing_its_regions(
            origin in proptest::array::uniform2(0.0..=12.0f64), azimuth in 0.0..7.0f64,
        ) {
            let direction = [libm::cos(azimuth), libm::sin(azimuth)];
            let walk = || Walk::new([12, 12], origin, direction, 0.0, 99.0).unwrap();
            let (block, mut left) = (walk().region().map(|index| index / 4), walk());
            let end = left.block_end(4);
            left.leave_block(4);
            let mut passed = walk();
            let outside = passed.find(|stretch| stretch.region.map(|index| index / 4) != block);
            prop_assert_eq!(outside, left.next());
            prop_assert!(outside.is_none_or(|stretch| Some(stretch.from) == end));
        }

        #[test]
        fn stretches_join_and_lie_in_their_regions(
            origin in proptest::array::uniform2(0.0..=30.0f64), azimuth in 0.0..7.0f64,
        ) {
            let direction = [libm::cos(azimuth), libm::sin(azimuth)];
            let stretches = walk(origin, direction, 0.0, 99.0);
            for pair in stretches.windows(2) {
                prop_assert_eq!(pair[0].to, pair[1].from);
            }
            for stretch in stretches {
                for s in [stretch.from, stretch.to] {
                    for axis in 0..2 {
                        let local = (origin[axis] + s * direction[axis]) / 10.0 - stretch.region[axis] as f64;
                        prop_assert!((-1e-13..=1.0 + 1e-13).contains(&local), "{}", local);
                    }
                }
            }
        }
    }
}
