//! Words of D/As that are alike: all of a strobe act in the same instant, and the lag of a row takes what they change.
//!
//! **Law.** That of `converters`, summed over a row: words that change from w to v at a share p of the step add to the row
//! at its end `sum (v - w) (from u(p) + to u(1))`, `from` and `to` what a lag at rest makes of a straight line over what is
//! left of the step.

use std::ops::Range;

use fearless_simd::Simd;
use parts::LagSteps;
use signal::{Both, Double, LANES, Real};

use super::block::BLOCK;
use super::strobed::{NEVER, SIDES, Strobed, Strobes, WORDS, side_of};
use super::words::Converters;
use crate::terms::{ENDS, PAIRS};

/// Pairs of D/As that take words of a side, `WORDS sum + word`.
const PLACES: usize = 3 * WORDS;

/// What the D/As of a side take, pair by pair: each lane in a step of its own.
#[derive(Debug, Clone)]
struct Taken<S> {
    /// In the steps to which samples of the block, bit by bit.
    samples: u32,
    /// In the step to which sample of the block, lane by lane.
    sample: Both<S>,
    /// When within the step, 0..=1.
    share: Both<S>,
    /// What the signal at the word and at the end of the step leave at its end, for a weight of 1.
    from: Both<S>,
    to: Both<S>,
    /// What they multiply by from then on.
    weight: [Both<S>; PLACES],
}

/// Words of all rows of a group.
#[derive(Debug, Clone)]
pub(super) struct RowWords<S> {
    /// First sample of the block.
    first: i64,
    strobed: Strobes,
    /// Those that act in the block, side by side of X; in a lane ascending in time.
    taken: [Vec<Taken<S>>; SIDES],
}

impl<S> Default for RowWords<S> {
    fn default() -> Self {
        Self { first: 0, strobed: Strobes::default(), taken: [Vec::new(), Vec::new()] }
    }
}

impl<S: Real> RowWords<S> {
    /// Begins the block of `samples`, at most [`BLOCK`].
    pub(super) fn begin(&mut self, samples: &Range<i64>) {
        self.first = samples.start;
        self.taken.iter_mut().for_each(Vec::clear);
    }

    /// The D/As of a colour have words of these shares of full scale in a lane from `at` on (samples).
    pub(super) fn send(&mut self, at: f64, whose: (usize, usize), shares: &[f64; WORDS]) {
        self.strobed.send(at, whose, [shares, &[0.0; WORDS]]);
    }

    /// Works out what D/As of time constant `tau` make of what was sent since the block began, for steps of `h` seconds.
    #[inline(always)]
    pub(super) fn divide(&mut self, [h, tau]: [f64; 2], converters: &[Converters]) {
        for side in 0..SIDES {
            for strobed in self.strobed.of_pair(WORDS * side) {
                let mut taken = Taken::none();
                for end in ENDS.into_iter().filter(|&end| strobed.has(end)) {
                    taken.divide(strobed, end, self.first as f64, [h, tau]);
                    taken.weigh(strobed, end, &converters[WORDS * side..]);
                }
                self.taken[side].push(taken);
            }
        }
        self.strobed.clear();
    }

    /// Samples of the block within whose step a row takes words, bit by bit.
    #[inline(always)]
    pub(super) fn samples(&self, row: usize) -> u32 {
        self.taken[side_of(PAIRS * row)].iter().fold(0, |samples, taken| samples | taken.samples)
    }

    /// Gives the D/As of a row the words of the step to sample `n`; their signals are `begin` as it begins and `end` as it
    /// ends. What that adds to the row at the end of the step, at both ends of Y.
    #[inline(always)]
    pub(super) fn act<L: Simd>(
        &self,
        simd: L,
        (row, n): (usize, usize),
        [begin, end]: [[S::Double<L>; PAIRS]; 2],
        weight: &mut [S::Double<L>; PAIRS],
    ) -> S::Double<L> {
        let load = |both| S::Double::<L>::load(simd, both);
        let n = S::Double::<L>::splat(simd, S::from_f64(n as f64));
        let first = WORDS * (PAIRS * row / (SIDES * WORDS)) + PAIRS * row % WORDS;
        let mut more = S::Double::<L>::splat(simd, S::ZERO);
        for taken in &self.taken[side_of(PAIRS * row)] {
            let lanes = load(&taken.sample).matches(n);
            let [share, from, to] = [load(&taken.share), load(&taken.from), load(&taken.to)];
            for pair in 0..PAIRS {
                let start = begin[pair] + share * (end[pair] - begin[pair]);
                let new =
                    S::Double::<L>::chosen(simd, lanes, load(&taken.weight[first + pair]), weight[pair]);
                let held = (start * from + end[pair] * to) * (new - weight[pair]);
                more = S::Double::<L>::chosen(simd, lanes, more + held, more);
                weight[pair] = new;
            }
        }
        more
    }
}

impl<S: Real> Taken<S> {
    /// Nothing, in any lane.
    #[inline(always)]
    fn none() -> Self {
        let (never, zero) = (Both([S::from_f64(NEVER); 2 * LANES]), Both::default());
        Self { samples: 0, sample: never, share: zero, from: zero, to: zero, weight: [zero; PLACES] }
    }

    /// Places what was strobed at one end in the steps of the block that begins at sample `first`: of `h` seconds, for D/As of
    /// time constant `tau`.
    #[inline(always)]
    fn divide(&mut self, strobed: &Strobed, end: usize, first: f64, [h, tau]: [f64; 2]) {
        let mut left = [0.0; LANES];
        for lane in 0..LANES {
            let (at, place) = (strobed.at[end][lane], LANES * end + lane);
            if at == NEVER {
                continue;
            }
            // What should have acted before acts as its first step begins.
            let sample = at.ceil().max(first);
            let share = (at - (sample - 1.0)).clamp(0.0, 1.0);
            left[lane] = h * (1.0 - share);
            self.samples |= 1 << ((sample - first) as usize).min(BLOCK);
            self.sample.0[place] = S::from_f64(sample - first);
            self.share.0[place] = S::from_f64(share);
        }
        let LagSteps { from, to, .. } = LagSteps::new(left, [tau; LANES]);
        for lane in 0..LANES {
            let place = LANES * end + lane;
            (self.from.0[place], self.to.0[place]) = (S::from_f64(from[lane]), S::from_f64(to[lane]));
        }
    }

    /// What the D/As of a side multiply by from then on at one end; `converters` are those from the first of the side on.
    #[inline(always)]
    fn weigh(&mut self, strobed: &Strobed, end: usize, converters: &[Converters]) {
        for sum in 0..3 {
            for word in 0..WORDS {
                let factor = converters[SIDES * WORDS * sum + word].factor[end];
                let weight = &mut self.weight[WORDS * sum + word];
                for lane in 0..LANES {
                    weight.0[LANES * end + lane] = S::from_f64(strobed.shares[word][end][lane] * factor);
                }
            }
        }
    }
}
