//! Where the craters are: tiers of grids by powers of two of their size.

use crate::Craters;
use crate::fan::Fan;
use crate::tier::Tier;

/// Tiers, the smallest craters first. A crater of outer radius above `2^(k-1)` m and up to `2^k` m is in the tier of its k.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Index {
    tiers: Vec<Tier>,
}

impl Index {
    /// The index of `craters`, in O(n log n).
    pub fn new(craters: &Craters) -> Self {
        let mut by_size: Vec<(i32, u32)> =
            craters.iter().zip(0..).map(|(crater, index)| (size_class(crater.outer()), index)).collect();
        by_size.sort_unstable();
        let members = |class: &[(i32, u32)]| class.iter().map(|(_, index)| *index).collect::<Vec<_>>();
        let classes = by_size.chunk_by(|a, b| a.0 == b.0);
        Self { tiers: classes.map(|class| Tier::new(craters, &members(class))).collect() }
    }

    /// Indices of craters that may meet the box, in no useful order.
    pub fn near_box(&self, low: [f64; 2], high: [f64; 2]) -> impl Iterator<Item = u32> {
        self.tiers.iter().flat_map(move |tier| tier.near_box(low, high))
    }

    /// The same of craters whose outer radius may exceed `outer` (m); smaller ones may be among them.
    pub fn near_box_above(&self, outer: f64, low: [f64; 2], high: [f64; 2]) -> impl Iterator<Item = u32> {
        self.tiers
            .iter()
            .filter(move |tier| tier.outer() > outer)
            .flat_map(move |tier| tier.near_box(low, high))
    }

    /// Indices of craters that may meet the stretch of a length (m) from a point on along a unit vector, in no useful
    /// order.
    pub fn near_stretch(
        &self,
        from: [f64; 2],
        direction: [f64; 2],
        length: f64,
    ) -> impl Iterator<Item = u32> {
        self.tiers.iter().flat_map(move |tier| tier.near_stretch(from, direction, length))
    }

    /// Indices of craters that may meet a ray of the fan, in no useful order.
    pub fn near_fan(&self, fan: Fan) -> impl Iterator<Item = u32> {
        self.tiers.iter().flat_map(move |tier| tier.near_fan(fan))
    }

    /// Returns the tiers of the index.
    pub fn tiers(&self) -> &[Tier] {
        &self.tiers
    }
}

/// Least k with `outer <= 2^k`.
fn size_class(outer: f64) -> i32 {
    let (share, exponent) = libm::frexp(outer);
    if share == 0.5 { exponent - 1 } else { exponent }
}
