//! The terms of the three sums: which wires meet in each.

use signal::{Lanes, Real};

use super::basis::UNITS;

/// Terms of one sum.
pub(super) const TERMS: usize = 36;
/// Terms of all three: height, slope to the north, slope to the east.
pub(super) const ALL: usize = 3 * TERMS;

/// The factors of term `term` (`6 ap + bq`) of sum `sum`: unit of each axis ([`super::basis::AxisGenerators`]).
pub(super) fn factors(sum: usize, term: usize) -> [usize; 2] {
    let (ap, bq) = (term / 6, term % 6);
    [ap + if sum == 1 { 6 } else { 0 }, bq + if sum == 2 { 6 } else { 0 }]
}

/// Colour and word of a term.
pub(super) fn word_of(term: usize) -> [usize; 2] {
    let (ap, bq) = (term / 6, term % 6);
    [ap / 3 + 2 * (bq / 3), 3 * (ap % 3) + bq % 3]
}

/// Function generators with their signs (section 6.4): odd orders of value and even ones of slope carry the polarity
/// at the near end, and its opposite at the far one.
#[inline(always)]
pub(super) fn signed<S: Real>(out: &[Lanes<S>; UNITS], sign: Lanes<S>) -> [Lanes<S>; UNITS] {
    std::array::from_fn(|unit| {
        let (is_slope, is_far, order) = (unit / 6 == 1, unit / 3 % 2 == 1, unit % 3);
        if (order == 1) == is_slope {
            return out[unit];
        }
        let signed = out[unit] * sign;
        if is_far { Lanes::default() - signed } else { signed }
    })
}
