//! Words of D/As that are alike: all of a strobe act in the same instant, and the lag of a row takes what they change.
//!
//! **Law.** That of `converters`, summed over a row: words that change from w to v at a share p of the step add to the row
//! at its end `sum (v - w) (from u(p) + to u(1))`, `from` and `to` what a lag at rest makes of a straight line over what is
//! left of the step.

use std::ops::Range;

use fearless_simd::Simd;
use fearless_simd::prelude::SimdBase;
use parts::LagStep;
use signal::{Both, Double, LANES, Lanes, Real};

use super::grid::GridWires;
use super::state::Coded;
use super::taken::{Link, Links, Lists};
use super::terms::{ALL, PAIRS, ROW, TERMS, side_by_side, term_of};

/// Rows of an array.
const ROWS: usize = ALL / ROW;

/// Words that the D/As of a row take in one step, pair by pair.
#[derive(Debug, Clone, Copy)]
struct Taken<S> {
    /// What they multiply by from then on.
    weight: [Both<S>; PAIRS],
    /// When within the step, 0..=1.
    share: Lanes<S>,
    /// What the signal at the word and at the end of the step leave at its end, for a weight of 1.
    from: Lanes<S>,
    to: Lanes<S>,
}

impl<S: Real> Default for Taken<S> {
    #[inline(always)]
    fn default() -> Self {
        let none = Lanes::default();
        Self { weight: [Both::default(); PAIRS], share: none, from: none, to: none }
    }
}

/// What a lane has strobed in one instant (samples).
#[derive(Debug, Clone, Copy)]
struct Strobed {
    at: f64,
    lane: usize,
    /// Rows that it changes, bit by bit.
    rows: u32,
}

/// Words of all rows of a group.
#[derive(Debug, Clone)]
pub(super) struct RowWords<S> {
    /// First sample of the block.
    first: i64,
    /// What each D/A was given last, pair by pair.
    given: Vec<Both<S>>,
    strobed: Option<Strobed>,
    /// Words that act in the block, and whose they are, row by row.
    taken: Links<Taken<S>>,
    rows: [Lists; ROWS],
}

impl<S: Real> Default for RowWords<S> {
    fn default() -> Self {
        let rows = [Lists::default(); ROWS];
        Self { first: 0, given: Vec::new(), strobed: None, taken: Links::default(), rows }
    }
}

impl<S: Real> RowWords<S> {
    /// Begins a sweep with the words that D/As have.
    pub(super) fn start(&mut self, wires: &GridWires<S>) {
        self.given.clear();
        self.given.extend(wires.pairs.iter().map(|pair| pair.weight));
    }

    /// Begins the block of `samples`, at most [`BLOCK`](super::block::BLOCK).
    pub(super) fn begin(&mut self, samples: &Range<i64>) {
        self.first = samples.start;
        self.taken.clear();
        self.rows.iter_mut().for_each(Lists::clear);
    }

    /// The D/As of a colour have `coded` words in a lane from `at` on (samples); `factors` are those of all D/As, and their
    /// time constant is `tau`, of steps of `h` seconds.
    pub(super) fn send(
        &mut self,
        (at, lane): (f64, usize),
        (colour, coded): (usize, &Coded),
        factors: &[f64],
        [h, tau]: [f64; 2],
    ) {
        if self.strobed.is_some_and(|strobed| (strobed.at, strobed.lane) != (at, lane)) {
            self.flush([h, tau]);
        }
        let strobed = self.strobed.get_or_insert(Strobed { at, lane, rows: 0 });
        for (word, share) in coded.shares.iter().enumerate() {
            let term = term_of(colour, word);
            let [pair, end] = side_by_side(term);
            for sum in 0..3 {
                let weight = S::from_f64(share * factors[TERMS * sum + term]);
                self.given[TERMS / 2 * sum + pair].0[LANES * end + lane] = weight;
                strobed.rows |= 1 << (TERMS / ROW * sum + term / ROW);
            }
        }
    }

    /// Places what was strobed last.
    pub(super) fn flush(&mut self, [h, tau]: [f64; 2]) {
        let Some(Strobed { at, lane, rows }) = self.strobed.take() else { return };
        let whole = at as i64;
        // What should have acted before acts as its first step begins.
        let sample = (whole + i64::from(at > whole as f64)).max(self.first);
        let share = (at - (sample - 1) as f64).clamp(0.0, 1.0);
        let LagStep { from, to, .. } = LagStep::part(h * (1.0 - share), tau);
        let [share, from, to] = [share, from, to].map(S::from_f64);
        for row in (0..ROWS).filter(|row| rows >> row & 1 == 1) {
            let taken = self.taken.room(&mut self.rows[row], (sample - self.first) as usize, lane);
            (taken.share[lane], taken.from[lane], taken.to[lane]) = (share, from, to);
            for (weight, given) in taken.weight.iter_mut().zip(&self.given[PAIRS * row..]) {
                weight.0[lane] = given.0[lane];
                weight.0[LANES + lane] = given.0[LANES + lane];
            }
        }
    }

    /// Samples of the block within whose step a row takes words, bit by bit.
    #[inline(always)]
    pub(super) fn samples(&self, row: usize) -> u32 {
        self.rows[row].samples()
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
        let both = |lanes: &Lanes<S>| {
            let half = S::Vector::<L>::from_slice(simd, &lanes.0);
            S::Double::<L>::of(half, half)
        };
        let mut more = S::Double::<L>::splat(simd, S::ZERO);
        for Link { lanes, words, .. } in self.taken.of(&self.rows[row], n) {
            let [share, from, to] = [both(&words.share), both(&words.from), both(&words.to)];
            let lanes = lanes | lanes << LANES;
            for pair in 0..PAIRS {
                let start = begin[pair] + share * (end[pair] - begin[pair]);
                let new = S::Double::<L>::load(simd, &words.weight[pair]);
                let new = S::Double::<L>::chosen(simd, lanes, new, weight[pair]);
                let held = (start * from + end[pair] * to) * (new - weight[pair]);
                more = S::Double::<L>::chosen(simd, lanes, more + held, more);
                weight[pair] = new;
            }
        }
        more
    }
}
