//! One crossing of a sweep and a line, in forms that are sorted as they are met.

/// A segment: its list and its number there, less than 2^31 lists.
pub(crate) type Place = [u32; 2];

/// One sweep crosses one line. In this form crossings are sorted as they are met: by range, beginnings of shadow before
/// endings at the same range.
pub(crate) trait Crossing: Copy + Ord + Default + Send + Sync {
    /// `range` (m) must not be negative: only then its bits are in its order.
    fn new(range: f64, ends: bool, place: Place) -> Self;

    /// Returns the ground range of the crossing (m).
    fn range(self) -> f64;
}

/// A crossing of which only that is known: bits of the range without its sign, then whether a shadow ends there.
pub(crate) type Bare = u64;

impl Crossing for Bare {
    fn new(range: f64, ends: bool, _: Place) -> Self {
        range.to_bits() << 1 | u64::from(ends)
    }

    fn range(self) -> f64 {
        f64::from_bits(self >> 1)
    }
}

/// A crossing of a line that is known: the same, then list and number of the line.
pub(crate) type Known = u128;

impl Crossing for Known {
    fn new(range: f64, ends: bool, place: Place) -> Self {
        let [list, number] = place.map(u128::from);
        u128::from(Bare::new(range, ends, place)) << 64 | list << 32 | number
    }

    fn range(self) -> f64 {
        ((self >> 64) as Bare).range()
    }
}

/// Shadows begun (1) or ended (-1) at a crossing.
pub(crate) fn step(crossing: Known) -> i32 {
    1 - 2 * (crossing >> 64 & 1) as i32
}

/// The line that is crossed.
pub(crate) fn place(crossing: Known) -> Place {
    [(crossing >> 32) as u32, crossing as u32]
}
