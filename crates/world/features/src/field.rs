//! All craters of a problem area.

use std::sync::Arc;

use crate::Crater;
use crate::Craters;
use crate::fade::{gone_to, kept_share};
use crate::fan::Fan;
use crate::index::Index;
use crate::tier::Tier;

/// What features add to the ground at a point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rise {
    /// Height above the terrain (m); negative inside a bowl.
    pub height: f64,
    /// Slopes to the north and to the east.
    pub slopes: [f64; 2],
    /// Whether the point is inside the footprint of a feature.
    pub present: bool,
}

/// All craters of a problem area, and where they are.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Features {
    craters: Arc<Craters>,
    index: Index,
}

impl Features {
    /// An index over `craters`; their order is kept and names them.
    ///
    /// # Panics
    /// If there are more than [`MOST_CRATERS`](crate::MOST_CRATERS).
    pub fn new(craters: Vec<Crater>) -> Self {
        Self::of(Arc::new(craters.into_iter().collect()))
    }

    /// The same.
    ///
    /// # Panics
    /// As there.
    pub fn of(craters: Arc<Craters>) -> Self {
        Self { index: Index::new(&craters), craters }
    }

    /// Returns all craters of the problem area.
    pub fn craters(&self) -> &Craters {
        &self.craters
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.craters.is_empty()
    }

    /// Indices of the craters whose footprints meet the box from `low` to `high` (north, east; m), a footprint taken
    /// by its bounding square; ascending.
    pub fn in_box(&self, low: [f64; 2], high: [f64; 2], found: &mut Vec<u32>) {
        found.clear();
        let meets = |crater: &Crater| {
            let (centre, outer) = (crater.centre(), crater.outer());
            (0..2).all(|axis| centre[axis] + outer >= low[axis] && centre[axis] - outer <= high[axis])
        };
        found.extend(self.index.near_box(low, high).filter(|&index| meets(&self.crater(index))));
        found.sort_unstable();
    }

    /// Indices of the craters whose outer circles the ray from `origin` (north, east; m) along the unit vector
    /// `direction` meets between the ranges `from` and `to` (m); ascending. A ray that only touches a circle does not
    /// meet it.
    pub fn along(&self, origin: [f64; 2], direction: [f64; 2], from: f64, to: f64, found: &mut Vec<u32>) {
        let start = [0, 1].map(|axis| origin[axis] + from * direction[axis]);
        let near = self.index.near_stretch(start, direction, to - from);
        self.keep_met(near, origin, direction, [from, to], found);
        found.sort_unstable();
    }

    /// The same if only those of `among` can be met, ascending indices such as [`between`](Self::between) finds.
    pub fn along_among(
        &self,
        among: &[u32],
        origin: [f64; 2],
        direction: [f64; 2],
        from: f64,
        to: f64,
        found: &mut Vec<u32>,
    ) {
        self.keep_met(among.iter().copied(), origin, direction, [from, to], found);
    }

    /// Indices of all craters that rays from `origin` (north, east; m) can meet up to range `to` (m) whose directions lie
    /// between two unit vectors, the left and the right one, less than half a turn apart; ascending. A few that none
    /// of them meets may be among them.
    pub fn between(&self, origin: [f64; 2], edges: [[f64; 2]; 2], to: f64, found: &mut Vec<u32>) {
        found.clear();
        found.extend(self.index.near_fan(Fan::new(origin, edges, to)));
        found.sort_unstable();
    }

    fn keep_met(
        &self,
        near: impl Iterator<Item = u32>,
        origin: [f64; 2],
        direction: [f64; 2],
        [from, to]: [f64; 2],
        found: &mut Vec<u32>,
    ) {
        let meets = |&index: &u32| {
            let (centre, outer) = self.craters.circle(index);
            let [dx, dy] = [0, 1].map(|axis| centre[axis] - origin[axis]);
            let nearest = (dx * direction[0] + dy * direction[1]).max(from).min(to);
            let [dx, dy] = [dx - nearest * direction[0], dy - nearest * direction[1]];
            dx * dx + dy * dy < outer * outer
        };
        found.clear();
        found.extend(near.filter(meets));
    }

    /// What the features add at (x, y) (m): heights and slopes summed in ascending order of index.
    pub fn at(&self, x: f64, y: f64) -> Rise {
        self.sum(self.index.near_box([x, y], [x, y]), [x, y], |_| 1.0)
    }

    /// The same as samples of the ground `spacing` (m) apart can show it: each crater times [`kept_share`](crate::kept_share). At a
    /// spacing of 0 nothing is lost.
    pub fn at_spacing(&self, x: f64, y: f64, spacing: f64) -> Rise {
        let near = self.index.near_box_above(gone_to(spacing), [x, y], [x, y]);
        self.sum(near, [x, y], |outer| kept_share(outer / spacing))
    }

    /// Sum over the craters that hold (x, y) (m), each the `weight` of its type (1 to 3) times `1 - rho^2 / R^2`: how near the place
    /// is to the centre, 1 there and 0 on the edge of the footprint. In ascending order of index.
    pub fn nearness(&self, x: f64, y: f64, weight: impl Fn(u32) -> f64) -> f64 {
        let near = |index: u32| {
            let (centre, outer) = self.craters.circle(index);
            let [dx, dy] = [x - centre[0], y - centre[1]];
            (1.0 - (dx * dx + dy * dy) / (outer * outer)).max(0.0)
        };
        let mut around = Around::default();
        self.index
            .near_box([x, y], [x, y])
            .filter(|&index| near(index) > 0.0)
            .for_each(|index| around.push(index));
        around.ascending().iter().map(|&index| weight(self.crater(index).type_number()) * near(index)).sum()
    }

    /// Sum of what craters add at a point, each times the share that its outer radius (m) has. `near` has all whose circles hold the
    /// point, and others.
    #[inline]
    fn sum(&self, near: impl Iterator<Item = u32>, [x, y]: [f64; 2], share: impl Fn(f64) -> f64) -> Rise {
        let mut rise = Rise::default();
        let mut around = Around::default();
        for index in near {
            let crater = self.crater(index);
            let [dx, dy] = [x - crater.centre()[0], y - crater.centre()[1]];
            // Not yet the decision: a comfortable margin over the rounding of the root below.
            if dx * dx + dy * dy < 1.000_001 * crater.outer() * crater.outer() {
                around.push(index);
            }
        }
        for &index in around.ascending() {
            let crater = self.crater(index);
            add(&crater, [x, y], share(crater.outer()), &mut rise);
        }
        rise
    }

    pub(crate) fn tiers(&self) -> &[Tier] {
        self.index.tiers()
    }

    /// Returns crater number `index`, counted from 0.
    #[inline]
    pub fn crater(&self, index: u32) -> Crater {
        self.craters.get(index)
    }
}

/// Adds a share of what one crater does at a point.
#[inline]
fn add(crater: &Crater, [x, y]: [f64; 2], share: f64, rise: &mut Rise) {
    let [dx, dy] = [x - crater.centre()[0], y - crater.centre()[1]];
    let rho = (dx * dx + dy * dy).sqrt();
    if rho < crater.outer() {
        let [height, slope] = crater.profile(rho).map(|value| share * value);
        rise.height += height;
        rise.present = true;
        if rho > 0.0 {
            rise.slopes[0] += slope * dx / rho;
            rise.slopes[1] += slope * dy / rho;
        }
    }
}

/// Indices around a point: a few without allocation, any number with.
#[derive(Default)]
struct Around {
    few: [u32; 16],
    count: usize,
    many: Vec<u32>,
}

impl Around {
    fn push(&mut self, index: u32) {
        if self.count < self.few.len() {
            self.few[self.count] = index;
        } else {
            if self.count == self.few.len() {
                self.many.extend(self.few);
            }
            self.many.push(index);
        }
        self.count += 1;
    }

    fn ascending(&mut self) -> &[u32] {
        let all = if self.many.is_empty() { &mut self.few[..self.count] } else { &mut self.many[..] };
        all.sort_unstable();
        all
    }
}

#[cfg(test)]
mod tests {
    use super::{Features, Rise, add};
    use crate::{Crater, Shape, kept_share};
    use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, proptest};

    /// Without an index: every crater is asked.
    fn at_by_force(craters: &[Crater], at: [f64; 2]) -> Rise {
        let mut rise = Rise::default();
        craters.iter().for_each(|crater| add(crater, at, 1.0, &mut rise));
        rise
    }

    /// The same at a spacing: each crater is asked alone, and its whole rise is scaled.
    fn at_spacing_by_force(craters: &[Crater], at: [f64; 2], spacing: f64) -> [f64; 3] {
        craters.iter().fold([0.0; 3], |sum, crater| {
            let share = kept_share(crater.outer() / spacing);
            let Rise { height, slopes: [north, east], .. } = at_by_force(&[*crater], at);
            [sum[0] + share * height, sum[1] + share * north, sum[2] + share * east]
        })
    }

    fn in_box_by_force(craters: &[Crater], low: [f64; 2], high: [f64; 2]) -> Vec<u32> {
        let meets = |crater: &Crater| {
            let (centre, outer) = (crater.centre(), crater.outer());
            (0..2).all(|axis| centre[axis] + outer >= low[axis] && centre[axis] - outer <= high[axis])
        };
        (0..craters.len() as u32).filter(|&index| meets(&craters[index as usize])).collect()
    }

    /// By the chord: it is there, and meets the ranges.
    fn along_by_force(
        craters: &[Crater],
        origin: [f64; 2],
        [cos, sin]: [f64; 2],
        from: f64,
        to: f64,
    ) -> Vec<u32> {
        let meets = |crater: &Crater| {
            let [dx, dy] = [crater.centre()[0] - origin[0], crater.centre()[1] - origin[1]];
            let (middle, side) = (dx * cos + dy * sin, dy * cos - dx * sin);
            let square = crater.outer() * crater.outer() - side * side;
            square > 0.0 && middle + square.sqrt() > from && middle - square.sqrt() < to
        };
        (0..craters.len() as u32).filter(|&index| meets(&craters[index as usize])).collect()
    }

    /// Sizes over ten octaves, some at one spot, one far away.
    fn craters() -> impl Strategy<Value = Vec<Crater>> {
        let place = proptest::array::uniform2(-300.0..300.0f64);
        let one = (place, -2.0..8.0f64, 0..20u32).prop_map(|([x, y], size, spot)| {
            let centre = match spot {
                0 => [1e6 * x, y],
                1..4 => [10.0, -20.0],
                _ => [x, y],
            };
            let r1 = libm::exp2(size);
            Crater::new(centre, Shape::RimmedBowl { r1, r2: 1.4 * r1 }, 0.3 * r1, 0.1 * r1).unwrap()
        });
        proptest::collection::vec(one, 0..300)
    }

    proptest! {
        /// The index changes no bit and misses nothing.
        #[test]
        fn queries_equal_brute_force(
            craters in craters(),
            at in proptest::array::uniform2(-400.0..400.0f64),
            size in proptest::array::uniform2(0.0..500.0f64),
            angle in 0.0..7.0f64,
        ) {
            let features = Features::new(craters.clone());
            let mut found = Vec::new();
            for point in [at, [10.0, -20.0], [10.0, at[1]]] {
                prop_assert_eq!(features.at(point[0], point[1]), at_by_force(&craters, point));
            }
            for spacing in [0.01, 0.1, 0.4].map(|share| share * size[0] + 1e-9) {
                let Rise { height, slopes: [north, east], .. } = features.at_spacing(at[0], at[1], spacing);
                let expected = at_spacing_by_force(&craters, at, spacing);
                let off = |found: f64, expected: f64| (found - expected).abs();
                let off = off(height, expected[0]).max(off(north, expected[1])).max(off(east, expected[2]));
                prop_assert!(off < 1e-10, "{:?}", expected);
            }
            prop_assert_eq!(features.at_spacing(at[0], at[1], 0.0), features.at(at[0], at[1]));
            let high = [at[0] + size[0], at[1] + size[1]];
            features.in_box(at, high, &mut found);
            prop_assert_eq!(&found, &in_box_by_force(&craters, at, high));
            let quarter = std::f64::consts::FRAC_PI_2;
            for angle in [angle, 0.0, quarter, quarter + 1e-11, 3.0 * quarter - 1e-7] {
                let (sin, cos) = quantities::sin_cos(angle);
                for (from, to) in [(0.0, 2.0 * size[0]), (0.3 * size[1], 1.5 * size[1])] {
                    features.along(at, [cos, sin], from, to, &mut found);
                    prop_assert_eq!(&found, &along_by_force(&craters, at, [cos, sin], from, to));
                    let edges = [-1.5, 1.2].map(|turn| {
                        let (sin, cos) = quantities::sin_cos(angle + turn * size[1] / 500.0);
                        [cos, sin]
                    });
                    let (mut among, mut met) = (Vec::new(), Vec::new());
                    features.between(at, edges, to, &mut among);
                    features.along_among(&among, at, [cos, sin], from, to, &mut met);
                    prop_assert_eq!(&met, &found);
                }
            }
        }
    }

    #[test]
    fn a_hundred_nested_craters_add_up() {
        let nested = |k: u32| Crater::new([5.0, 5.0], Shape::Bowl { r1: f64::from(k) }, 1.0, 0.0).unwrap();
        let features = Features::new((1..=100).map(nested).collect());
        assert_eq!(features.at(5.0, 5.0).height, -100.0);
        let mut found = Vec::new();
        features.along([0.0, 5.0], [1.0, 0.0], 0.0, 2.0, &mut found);
        assert_eq!(found, (3..100).collect::<Vec<_>>());
    }

    #[test]
    fn nothing_is_found_where_nothing_is() {
        let features = Features::default();
        let mut found = vec![7];
        features.in_box([-1e9; 2], [1e9; 2], &mut found);
        assert!(features.is_empty() && found.is_empty());
        assert_eq!(features.at(0.0, 0.0), Rise::default());
        assert_eq!(Features::new(Vec::new()), features);
    }
}
