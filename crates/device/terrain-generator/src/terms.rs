//! The terms of the three sums: which wires meet in each.

/// Terms of one sum.
pub(crate) const TERMS: usize = 36;
/// Terms of a row: those behind one function generator of X.
pub(crate) const ROW: usize = 6;
/// The same two by two ([`side_by_side`]).
pub(crate) const PAIRS: usize = ROW / 2;
/// Terms of all three: height, slope to the north, slope to the east.
pub(crate) const ALL: usize = 3 * TERMS;

/// The factors of term `term` (`6 ap + bq`) of sum `sum`: unit of each axis ([`crate::of_parts`]).
pub(crate) fn factors(sum: usize, term: usize) -> [usize; 2] {
    let (ap, bq) = (term / 6, term % 6);
    [ap + if sum == 1 { 6 } else { 0 }, bq + if sum == 2 { 6 } else { 0 }]
}

/// Ends of a ramp: near, far.
pub(crate) const ENDS: [usize; 2] = [0, 1];

/// Units of an axis, and terms, are side by side with those of the same order at the other end of their ramp (of Y, for
/// terms): number of the pair, and end.
#[inline(always)]
pub(crate) fn side_by_side(one: usize) -> [usize; 2] {
    [3 * (one / 6) + one % 3, one / 3 % 2]
}

/// The unit or term at one end of a pair.
#[inline(always)]
pub(crate) fn one_of(pair: usize, end: usize) -> usize {
    6 * (pair / 3) + 3 * end + pair % 3
}

/// Colour and word of a term.
pub(crate) fn word_of(term: usize) -> [usize; 2] {
    let (ap, bq) = (term / 6, term % 6);
    [ap / 3 + 2 * (bq / 3), 3 * (ap % 3) + bq % 3]
}

/// The term of a word of a colour.
pub(crate) fn term_of(colour: usize, word: usize) -> usize {
    6 * (3 * (colour % 2) + word / 3) + 3 * (colour / 2) + word % 3
}

/// The sign of function generator `unit` (section 6.4): odd orders of value and even ones of slope carry the
/// `polarity` (1 or -1) at the near end, and its opposite at the far one.
pub(crate) fn sign(unit: usize, polarity: f64) -> f64 {
    let (is_slope, is_far, order) = (unit / 6 == 1, unit / 3 % 2 == 1, unit % 3);
    match ((order == 1) == is_slope, is_far) {
        (true, _) => 1.0,
        (false, false) => polarity,
        (false, true) => -polarity,
    }
}

#[cfg(test)]
mod tests {
    use super::{ALL, TERMS, one_of, side_by_side, term_of, word_of};

    #[test]
    fn each_has_one_place_beside_another() {
        for one in 0..ALL {
            let [pair, end] = side_by_side(one);
            assert_eq!(one_of(pair, end), one);
            let [order, other] = [word_of(one % TERMS)[1], word_of(one_of(pair, 1 - end) % TERMS)[1]];
            assert_eq!(order, other, "both are of the same order");
        }
    }

    #[test]
    fn a_word_has_one_term() {
        for term in 0..TERMS {
            let [colour, word] = word_of(term);
            assert_eq!(term_of(colour, word), term);
        }
    }
}
