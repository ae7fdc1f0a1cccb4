//! All craters of a problem area, in as few numbers as each takes: there may be a million.

use crate::{Crater, Shape};

/// Outer foot over inner foot of a rim (our choice): sharp ones, and those worn down.
pub(crate) const SHARP: f64 = 1.4;
pub(crate) const BROAD: f64 = 1.8;

/// Outer foot over inner foot by the signs of a [`Short`]; a bowl has none.
const OUTER: [f64; 3] = [SHARP, BROAD, 0.0];

/// The same of the circle around it all.
const REACH: [f64; 3] = [SHARP, BROAD, 1.0];

/// Craters in their order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Craters {
    short: Vec<Short>,
    /// Those that are not [`SHARP`], not [`BROAD`] and no bowl: few.
    others: Vec<Crater>,
}

/// Centre (north, east; m), inner foot, depth and rim (m). The first two of the last three are not negative, so their signs
/// are free to say what the outer foot is: none of a bowl (depth below 0), [`BROAD`] (foot below 0) or [`SHARP`] times the
/// inner one. If both are below 0, the foot is the place of the crater among the others.
type Short = [f64; 5];

impl Craters {
    /// None yet, and room for so many.
    pub(crate) fn with_room(count: usize) -> Self {
        Self { short: Vec::with_capacity(count), others: Vec::new() }
    }

    /// Returns the number of craters.
    pub fn len(&self) -> usize {
        self.short.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.short.is_empty()
    }

    /// Returns crater number `index`, counted from 0.
    #[inline]
    pub fn get(&self, index: u32) -> Crater {
        let [north, east, foot, depth, rim] = self.short[index as usize];
        let Some(broad) = OUTER.get(code(foot, depth)) else { return self.others[-foot as usize] };
        Crater::of_radii([north, east], [foot.abs(), broad * foot.abs(), 0.0], depth.abs(), rim)
    }

    /// Centre (north, east; m) and outer radius (m) of crater number `index`: all that most searches ask for.
    #[inline]
    pub fn circle(&self, index: u32) -> ([f64; 2], f64) {
        let [north, east, foot, depth, _] = self.short[index as usize];
        let outer = match REACH.get(code(foot, depth)) {
            Some(broad) => broad * foot.abs(),
            None => self.others[-foot as usize].outer(),
        };
        ([north, east], outer)
    }

    /// Goes through all craters, in the order of their numbers.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Crater> {
        (0..self.short.len() as u32).map(|index| self.get(index))
    }

    pub(crate) fn push(&mut self, crater: Crater) {
        let (foot, depth) = (crater.foot(), crater.depth());
        let signs = match crater.shape() {
            Shape::Bowl { .. } => [1.0, -1.0],
            Shape::RimmedBowl { r1, r2 } if r2 == SHARP * r1 => [1.0, 1.0],
            Shape::RimmedBowl { r1, r2 } if r2 == BROAD * r1 => [-1.0, 1.0],
            _ => [-1.0, -1.0],
        };
        let foot = if signs == [-1.0; 2] { self.others.len() as f64 } else { foot };
        let [north, east] = crater.centre();
        self.short.push([north, east, foot.copysign(signs[0]), depth.copysign(signs[1]), crater.rim()]);
        if signs == [-1.0; 2] {
            self.others.push(crater);
        }
    }
}

/// Place of a form in [`OUTER`] and [`REACH`], beyond them that of a crater among the others.
#[inline]
fn code(foot: f64, depth: f64) -> usize {
    usize::from(foot.is_sign_negative()) | usize::from(depth.is_sign_negative()) << 1
}

impl Extend<Crater> for Craters {
    fn extend<I: IntoIterator<Item = Crater>>(&mut self, craters: I) {
        let craters = craters.into_iter();
        // No room for twice as many.
        self.short.reserve_exact(craters.size_hint().0);
        craters.for_each(|crater| self.push(crater));
    }
}

impl FromIterator<Crater> for Craters {
    fn from_iter<I: IntoIterator<Item = Crater>>(craters: I) -> Self {
        let mut all = Self::default();
        all.extend(craters);
        all
    }
}

#[cfg(test)]
mod tests {
    use super::{BROAD, Craters, SHARP};
    use crate::{Crater, Shape};
    use proptest::prelude::{Strategy, prop_assert_eq, proptest};
    use proptest::sample::select;

    /// Bowls, rims of either breadth and of others, flat floors; some without depth or rim.
    fn crater() -> impl Strategy<Value = Crater> {
        let place = proptest::array::uniform2(-9e3..9e3f64);
        (place, 0..5u8, 0.01..100.0f64, select(vec![0.0, 0.3, 7.0]), select(vec![0.0, 0.2])).prop_map(
            |(centre, form, r1, depth, rim)| {
                let (shape, rim) = match form {
                    0 => (Shape::Bowl { r1 }, 0.0),
                    1 => (Shape::RimmedBowl { r1, r2: SHARP * r1 }, rim),
                    2 => (Shape::RimmedBowl { r1, r2: BROAD * r1 }, rim),
                    3 => (Shape::RimmedBowl { r1, r2: (BROAD * r1).next_up() }, rim),
                    _ => (Shape::FlatFloor { r1, r2: 2.0 * r1, r3: SHARP * 2.0 * r1 }, rim),
                };
                Crater::new(centre, shape, depth, rim).unwrap()
            },
        )
    }

    proptest! {
        #[test]
        fn craters_come_out_as_they_went_in(all in proptest::collection::vec(crater(), 0..60)) {
            let craters: Craters = all.iter().copied().collect();
            prop_assert_eq!(craters.iter().collect::<Vec<_>>(), &*all);
            for (index, crater) in (0..).zip(&all) {
                prop_assert_eq!(craters.circle(index), (crater.centre(), crater.outer()));
            }
        }
    }
}
