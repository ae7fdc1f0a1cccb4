//! Which craters can be told from where the eye is (economy; performance-insights, section 6).

use std::array;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

use crate::fan::Fan;
use crate::tier::Tier;
use crate::{Crater, Features};

/// Craters that are looked at together.
const TOGETHER: usize = 16;

/// An eye over level ground, and how little it tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outlook {
    /// Height of the eye above the ground around (m), at least 0.
    pub eye: f64,
    /// What is less high on the picture cannot be told (tangent of the angle), above 0.
    pub least: f64,
    /// Side of a resolution cell (tangent of the angle), above 0.
    pub cell: f64,
}

/// What an [`Outlook`] leaves out, and what that changes at most.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LeftOut {
    /// Craters that cannot be told.
    pub craters: u64,
    /// Resolution cells that they would cover together over level ground.
    pub cells: f64,
}

impl Outlook {
    /// Ground range from which on a crater cannot be told (m): there its `relief` and its floor plan of radius `outer`, seen
    /// from the height of the eye, are together as high on the picture as can just be told, `relief / r + 2 outer eye / r^2`.
    pub fn reach(&self, relief: f64, outer: f64) -> f64 {
        (relief + (relief * relief + 8.0 * outer * self.eye * self.least).sqrt()) / (2.0 * self.least)
    }

    fn tells(&self, crater: &Crater, range: f64) -> bool {
        range <= self.reach(crater.relief(), crater.outer())
    }

    /// Cells that a crater of radius `outer` (m) covers at most if it cannot be told at `range` (m).
    fn cells(&self, outer: f64, range: f64) -> f64 {
        self.least * 2.0 * outer / (range * self.cell * self.cell)
    }
}

impl Features {
    /// As [`between`](Self::between), without craters that cannot be told.
    pub fn in_sight(
        &self,
        origin: [f64; 2],
        edges: [[f64; 2]; 2],
        to: f64,
        outlook: &Outlook,
        found: &mut Vec<u32>,
    ) -> LeftOut {
        let seen = |tier: &Tier| self.seen_of(tier, origin, edges, to, outlook);
        let tiers: Vec<(Vec<u32>, LeftOut)> = self.tiers().par_iter().map(seen).collect();
        found.clear();
        let mut left_out = LeftOut::default();
        for (some, without) in tiers {
            found.extend(some);
            left_out.craters += without.craters;
            left_out.cells += without.cells;
        }
        found.par_sort_unstable();
        left_out
    }

    fn seen_of(
        &self,
        tier: &Tier,
        origin: [f64; 2],
        edges: [[f64; 2]; 2],
        to: f64,
        outlook: &Outlook,
    ) -> (Vec<u32>, LeftOut) {
        let told = tier.told_to(outlook).min(to);
        let mut found: Vec<u32> = tier.near_fan(Fan::new(origin, edges, told)).collect();
        let (near, mut kept, mut left_out) = (found.len(), 0, LeftOut::default());
        let mut leave_out = |craters: u64, outer: f64, range: f64| {
            left_out.craters += craters;
            left_out.cells += craters as f64 * outlook.cells(outer, range);
        };
        for first in (0..near).step_by(TOGETHER) {
            let some: [u32; TOGETHER] = array::from_fn(|n| found[(first + n).min(near - 1)]);
            // Which of them are told nobody can guess: first all, far apart in memory, none of which waits for another.
            let craters = some.map(|index| self.crater(index));
            for (index, crater) in some.iter().zip(&craters).take(near - first) {
                let [north, east] = [0, 1].map(|axis| crater.centre()[axis] - origin[axis]);
                let range = (north * north + east * east).sqrt();
                if outlook.tells(crater, range) {
                    found[kept] = *index;
                    kept += 1;
                } else {
                    leave_out(1, crater.outer(), range);
                }
            }
        }
        found.truncate(kept);
        if told < to {
            let beyond = tier.count(Fan::new(origin, edges, to)).saturating_sub(near as u64);
            leave_out(beyond, tier.outer(), told);
        }
        (found, left_out)
    }
}

#[cfg(test)]
mod tests {
    use super::Outlook;
    use crate::{Crater, Features, Shape};
    use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, proptest};

    const EYE: Outlook = Outlook { eye: 1.6, least: 0.0005, cell: 0.001 };

    #[test]
    fn a_crater_is_told_as_far_as_it_looks_high_enough() {
        // 0.2 m of relief and 4 m of floor plan: 0.2 / r + 6.4 / r^2 = 0.0005 at 429.8 m.
        let reach = EYE.reach(0.2, 2.0);
        assert!((0.2 / reach + 6.4 / (reach * reach) - 0.0005).abs() < 1e-15);
        assert!((reach - 429.78).abs() < 0.01, "{reach}");
        assert_eq!(EYE.reach(0.0, 0.0), 0.0);
    }

    fn craters() -> impl Strategy<Value = Vec<Crater>> {
        let place = proptest::array::uniform2(-900.0..900.0f64);
        let one = (place, -2.0..5.0f64, 0.0..0.3f64).prop_map(|(centre, size, depth)| {
            let r1 = libm::exp2(size);
            Crater::new(centre, Shape::RimmedBowl { r1, r2: 1.4 * r1 }, depth * r1, 0.1 * depth * r1).unwrap()
        });
        proptest::collection::vec(one, 0..300)
    }

    proptest! {
        /// Those that `between` finds fall into two: what is told is found, the rest is counted.
        #[test]
        fn what_is_told_is_found_and_the_rest_is_counted(
            craters in craters(),
            origin in proptest::array::uniform2(-500.0..500.0f64),
            angle in 0.0..7.0f64,
            to in 10.0..1500.0f64,
        ) {
            let features = Features::new(craters);
            let edges = [angle - 0.4, angle + 0.4].map(|angle| {
                let (sin, cos) = quantities::sin_cos(angle);
                [cos, sin]
            });
            let (mut all, mut found) = (Vec::new(), Vec::new());
            features.between(origin, edges, to, &mut all);
            let left_out = features.in_sight(origin, edges, to, &EYE, &mut found);
            let range = |index: &u32| {
                let [x, y] = features.crater(*index).centre();
                ((x - origin[0]) * (x - origin[0]) + (y - origin[1]) * (y - origin[1])).sqrt()
            };
            let (told, untold): (Vec<u32>, Vec<u32>) =
                all.into_iter().partition(|index| EYE.tells(&features.crater(*index), range(index)));
            // `between` may name a few more beyond the ends of the rays, as may the other.
            prop_assert!(told.iter().filter(|&index| range(index) <= to).all(|index| found.contains(index)));
            prop_assert_eq!(found.iter().filter(|index| !told.contains(index)).count(), 0);
            prop_assert!(left_out.craters >= untold.len() as u64, "{} of {}", left_out.craters, untold.len());
            let cells: f64 = untold.iter().map(|index| {
                let crater = features.crater(*index);
                let (range, outer) = (range(index), crater.outer());
                let height = crater.relief() / range + 2.0 * outer * EYE.eye / (range * range);
                height * 2.0 * outer / (range * EYE.cell * EYE.cell)
            }).sum();
            prop_assert!(left_out.cells >= cells * 0.999_999, "{} {}", left_out.cells, cells);
        }
    }
}
