//! Words that were strobed, before D/As take them.
//!
//! Neighbouring sweeps meet the same corners at nearly the same instants: words of a block are laid side by side, one of each
//! lane of the two colours of a side, so that what D/As make of them is worked out for all lanes at once.

use signal::LANES;

/// Words of a colour.
pub(super) const WORDS: usize = 9;

/// Sides of X: colours of a side stand at both ends of Y of the same rows.
pub(super) const SIDES: usize = 2;

/// When what was never strobed acts (samples).
pub(super) const NEVER: f64 = f64::NEG_INFINITY;

/// Words of a side that were strobed, by end of Y: at most one of each lane of either colour.
#[derive(Debug, Clone)]
pub(super) struct Strobed {
    /// When a nominal D/A has them (samples).
    pub(super) at: [[f64; LANES]; 2],
    /// Shares of full scale.
    pub(super) shares: [[[f64; LANES]; 2]; WORDS],
    /// Areas of their pulses for a product of full scale (full scale times seconds).
    pub(super) pulses: [[[f64; LANES]; 2]; WORDS],
}

impl Strobed {
    /// No words strobed in any lane.
    const NONE: Self = Self {
        at: [[NEVER; LANES]; 2],
        shares: [[[0.0; LANES]; 2]; WORDS],
        pulses: [[[0.0; LANES]; 2]; WORDS],
    };

    /// Whether any lane has words at an end.
    pub(super) fn has(&self, end: usize) -> bool {
        self.at[end] != [NEVER; LANES]
    }
}

/// Words of both sides that were strobed since a block began; in a lane ascending in time.
#[derive(Debug, Clone, Default)]
pub(super) struct Strobes([Vec<Strobed>; SIDES]);

impl Strobes {
    /// Forgets all of them.
    pub(super) fn clear(&mut self) {
        self.0.iter_mut().for_each(Vec::clear);
    }

    /// Whether there are none.
    pub(super) fn are_none(&self) -> bool {
        self.0.iter().all(Vec::is_empty)
    }

    /// Those of the side whose colours a pair of D/As multiplies by.
    pub(super) fn of_pair(&self, pair: usize) -> &[Strobed] {
        &self.0[side_of(pair)]
    }

    /// Adds the words of a colour, which a nominal D/A has at `at` (samples) in `lane`: shares of full scale, and areas of their
    /// pulses.
    pub(super) fn send(
        &mut self,
        at: f64,
        (colour, lane): (usize, usize),
        [shares, pulses]: [&[f64; WORDS]; 2],
    ) {
        let (strobed, end) = (&mut self.0[colour % SIDES], colour / SIDES);
        let place =
            strobed.iter().position(|strobed| strobed.at[end][lane] == NEVER).unwrap_or(strobed.len());
        if place == strobed.len() {
            strobed.push(Strobed::NONE);
        }
        let strobed = &mut strobed[place];
        strobed.at[end][lane] = at;
        for word in 0..WORDS {
            strobed.shares[word][end][lane] = shares[word];
            strobed.pulses[word][end][lane] = pulses[word];
        }
    }
}

/// The side of X whose colours a pair of D/As multiplies by: pairs are `WORDS (SIDES sum + side) + word`.
pub(super) fn side_of(pair: usize) -> usize {
    pair / WORDS % SIDES
}

#[cfg(test)]
mod tests {
    use super::{NEVER, Strobes, WORDS};

    #[test]
    fn words_of_a_lane_stay_in_order() {
        let mut strobes = Strobes::default();
        let words = |value: f64| [value; WORDS];
        for (at, lane, colour) in
            [(1.0, 3, 0), (2.0, 5, 0), (3.0, 3, 0), (3.0, 3, 2), (4.0, 3, 0), (5.0, 1, 3)]
        {
            strobes.send(at, (colour, lane), [&words(10.0 * at), &words(-at)]);
        }
        let [first, second, third] = strobes.of_pair(18) else { panic!() };
        assert_eq!([first.at[0][3], second.at[0][3], third.at[0][3]], [1.0, 3.0, 4.0]);
        assert_eq!([first.at[0][5], second.at[0][5], first.at[1][3]], [2.0, NEVER, 3.0]);
        assert_eq!((third.shares[8][0][3], third.pulses[0][0][3]), (40.0, -4.0));
        assert!(first.has(0) && first.has(1) && !second.has(1));
        let [other] = strobes.of_pair(27) else { panic!() };
        assert_eq!(other.at[1][1], 5.0);
    }
}
