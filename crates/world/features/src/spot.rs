//! What the index keeps of a crater.

use crate::fan::Fan;

/// Slack of lengths (m and share): places are up to 1e9 m, so a difference of two is good to 1e-7 m.
const SLACK: f64 = 1e-6;

/// A length that rounding cannot have made too short (m).
pub(crate) fn with_slack(length: f64) -> f64 {
    length * (1.0 + SLACK) + SLACK
}

/// Bits of an index; the others of its word number the radius.
const INDEX_BITS: u32 = 28;

/// Most craters that an index tells apart.
pub const MOST_CRATERS: usize = 1 << INDEX_BITS;

/// Radii that a spot can tell.
const RADII: usize = 1 << (u32::BITS - INDEX_BITS);

/// A crater in short: enough to pass over most of those that are near but do not meet the query, without a look at
/// the crater itself, which is far away in memory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Spot {
    /// Centre from the corner of the grid: north, east (steps).
    centre: [u16; 2],
    /// Index of the crater; above it the number of the radius.
    index: u32,
}

/// What the numbers in the spots of a tier mean.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scale {
    /// Step of a place (m).
    step: f64,
    /// Radii (steps), ascending, with what the centre lost in rounding; infinite for a crater whose centre is not told.
    radii: [f64; RADII],
}

impl Scale {
    /// For places up to `span` (m) from the corner of the grid and radii up to `reach` (m), of which few are less than half
    /// of that.
    pub fn new(span: f64, reach: f64) -> Self {
        // Craters about one spot need no finer places than a crater does.
        let step = (span / f64::from(u16::MAX)).max(reach / 256.0);
        let radius = |number| 0.5 * reach / step * (1.0 + (number + 1) as f64 / (RADII - 1) as f64) + 1.0;
        let mut radii = std::array::from_fn(radius);
        radii[RADII - 1] = f64::INFINITY;
        Self { step, radii }
    }

    /// Crater `index`, whose centre is at `offset` (m) from the corner of the grid and whose radius is `outer` (m).
    ///
    /// # Panics
    /// If the index is not below [`MOST_CRATERS`].
    pub fn spot(&self, offset: [f64; 2], outer: f64, index: u32) -> Spot {
        assert!((index as usize) < MOST_CRATERS, "an index of fewer than 2^28 craters");
        let centre = offset.map(|way| self.steps(way).round());
        let is_told = centre.iter().all(|place| (0.0..=f64::from(u16::MAX)).contains(place));
        let needed = if is_told { self.steps(with_slack(outer)) + 1.0 } else { f64::INFINITY };
        let number = self.radii.partition_point(|&radius| radius < needed).min(RADII - 1) as u32;
        Spot { centre: centre.map(|place| place as u16), index: number << INDEX_BITS | index }
    }

    /// Steps in a length (m).
    pub fn steps(&self, length: f64) -> f64 {
        length / self.step
    }

    /// A radius that a crater does not exceed about the centre of its spot (steps).
    #[inline]
    fn outer(&self, spot: Spot) -> f64 {
        self.radii[(spot.index >> INDEX_BITS) as usize]
    }

    /// Whether its bounding square may meet a box of the grid (steps).
    #[inline]
    pub fn meets_box(&self, spot: Spot, low: [f64; 2], high: [f64; 2]) -> bool {
        let (centre, outer) = (spot.centre(), self.outer(spot));
        (0..2).all(|axis| centre[axis] + outer >= low[axis] && centre[axis] - outer <= high[axis])
    }

    /// Whether its circle may meet the stretch from a point on along a unit vector (steps).
    #[inline]
    pub fn meets_stretch(&self, spot: Spot, from: [f64; 2], direction: [f64; 2], length: f64) -> bool {
        let (centre, outer) = (spot.centre(), self.outer(spot));
        let [dx, dy] = [0, 1].map(|axis| centre[axis] - from[axis]);
        let nearest = (dx * direction[0] + dy * direction[1]).max(0.0).min(length);
        let [dx, dy] = [dx - nearest * direction[0], dy - nearest * direction[1]];
        dx * dx + dy * dy <= outer * outer
    }

    /// Whether its circle may meet a ray of a fan of the grid (steps).
    #[inline]
    pub fn meets_fan(&self, spot: Spot, fan: &Fan) -> bool {
        fan.may_reach(spot.centre(), self.outer(spot))
    }
}

impl Spot {
    /// Index of the crater.
    #[inline]
    pub fn index(self) -> u32 {
        self.index & ((1 << INDEX_BITS) - 1)
    }

    /// Centre from the corner of the grid: north, east (steps).
    #[inline]
    fn centre(self) -> [f64; 2] {
        self.centre.map(f64::from)
    }
}

#[cfg(test)]
mod tests {
    use super::{INDEX_BITS, Scale, with_slack};
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

    proptest! {
        /// Craters of a tier, of any size beside its largest, on its grid or beyond: the circle that a spot tells holds theirs.
        #[test]
        fn a_spot_holds_its_crater(
            span in 0.0..1e5f64,
            reach in 0.01..2e3f64,
            places in proptest::array::uniform2(-0.1..1.1f64),
            share in 0.0..=1.0f64,
            index in 0..1u32 << INDEX_BITS,
        ) {
            let scale = Scale::new(span, with_slack(reach));
            let (offset, outer) = (places.map(|place| place * span), share * reach);
            let spot = scale.spot(offset, outer, index);
            prop_assert_eq!(spot.index(), index);
            let (centre, told) = (spot.centre().map(|place| place * scale.step), scale.outer(spot) * scale.step);
            let [dx, dy] = [0, 1].map(|axis| centre[axis] - offset[axis]);
            prop_assert!((dx * dx + dy * dy).sqrt() + outer <= told, "{:?} {}", centre, told);
            let lies_within = places.iter().all(|place| (0.0..=1.0).contains(place));
            if lies_within && share > 0.5 {
                prop_assert!(told <= outer + reach / 20.0 + 3.0 * scale.step, "{}", told);
            }
        }
    }
}
