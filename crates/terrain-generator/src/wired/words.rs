//! Words on their way to the D/As of a group, and what they do within a block of samples.
//!
//! A strobe gives a colour nine words, which go to nine D/As of each sum. Each of these has its own time, but what they make of
//! the words is worked out side by side; D/As, two by two, find theirs among it.

use std::ops::Range;

use parts::{LagStep, LagSteps};
use signal::{Both, LANES, Real};

use super::block::{BLOCK, BothRow};
use super::cell::CellStep;
use super::terms::{TERMS, term_of};

/// D/As of a colour, `9 sum + word`, with those behind them that nobody has: whole vectors.
const PLACES: usize = 32;

/// Sides of X: colours of a side stand at both ends of Y of the same rows.
const SIDES: usize = 2;

/// What the multiplying D/As of a colour make of their words.
#[derive(Debug, Clone)]
pub(super) struct Converters {
    /// Gain, and the scale of the sum.
    factor: [f64; PLACES],
    /// By how many samples each switches later than a nominal one.
    later: [f64; PLACES],
    /// Inverse time constants (1/s), infinite without a lag.
    rate: [f64; PLACES],
}

impl Converters {
    /// Those of `colour`; by their numbers D/As have a factor, are later (samples) and have a time constant (s).
    pub(super) fn of_colour(colour: usize, figures: impl Fn(usize) -> [f64; 3]) -> Self {
        let mut all = Self { factor: [0.0; PLACES], later: [0.0; PLACES], rate: [0.0; PLACES] };
        for place in 0..3 * 9 {
            let [factor, later, tau] = figures(TERMS * (place / 9) + term_of(colour, place % 9));
            (all.factor[place], all.later[place], all.rate[place]) = (factor, later, 1.0 / tau);
        }
        all
    }
}

/// A colour is given other words in a lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strobed {
    /// When a nominal D/A has them (samples).
    pub(super) at: f64,
    pub(super) colour: usize,
    pub(super) lane: usize,
    /// Shares of full scale.
    pub(super) shares: [f64; 9],
    /// Areas of their pulses for a product of full scale (full scale times seconds).
    pub(super) pulses: [f64; 9],
}

/// What the D/As of a colour take, each in a step of its own.
#[derive(Debug, Clone, Copy)]
struct Taken<S> {
    /// The lane of both D/As of a pair, side by side.
    lane: usize,
    /// In the step to which sample of the block; before the block, it is over.
    sample: [i32; PLACES],
    /// When within the step, 0..=1.
    share: [S; PLACES],
    /// What they multiply by from then on.
    weight: [S; PLACES],
    /// What the signal at the word and at the end of the step leave at its end, for a weight of 1.
    from: [S; PLACES],
    to: [S; PLACES],
    /// What the pulse leaves, for a signal of 1 at the word.
    kick: [S; PLACES],
}

/// Words of all D/As.
#[derive(Debug, Clone)]
pub(super) struct Words<S> {
    /// First sample of the block.
    first: i64,
    /// Strobed since the block began; in a lane ascending in time, as are those taken.
    strobed: Vec<Strobed>,
    taken: [Vec<Taken<S>>; SIDES],
    changes: Box<Changes<S>>,
}

impl<S: Real> Default for Words<S> {
    fn default() -> Self {
        Self { first: 0, strobed: Vec::new(), taken: Default::default(), changes: Box::default() }
    }
}

impl<S: Real> Words<S> {
    /// Forgets all of them: a group begins.
    pub(super) fn clear(&mut self) {
        self.strobed.clear();
        self.taken.iter_mut().for_each(Vec::clear);
    }

    /// Puts words on their way.
    pub(super) fn send(&mut self, strobed: Strobed) {
        self.strobed.push(strobed);
    }

    /// Hands over the words that act by `sample`, before the first block: what D/A takes, lane, weight. They are over when a
    /// block begins behind it.
    pub(super) fn take(
        &self,
        sample: i64,
        converters: &[Converters; 4],
        mut take: impl FnMut(usize, usize, f64),
    ) {
        for &Strobed { at, colour, lane, shares, .. } in &self.strobed {
            let Converters { factor, later, .. } = &converters[colour];
            for place in (0..3 * 9).filter(|&place| at + later[place] <= sample as f64) {
                let index = TERMS * (place / 9) + term_of(colour, place % 9);
                take(index, lane, shares[place % 9] * factor[place]);
            }
        }
    }

    /// Begins the block of `samples`, at most [`BLOCK`].
    pub(super) fn begin(&mut self, samples: &Range<i64>) {
        let later = (samples.start - self.first) as i32;
        self.first = samples.start;
        for side in &mut self.taken {
            side.retain_mut(|taken| {
                taken.sample.iter_mut().for_each(|sample| *sample -= later);
                taken.sample.iter().any(|&sample| sample >= 0)
            });
        }
    }

    /// Works out what the D/As take that were given words since the last block, for steps of `h` seconds.
    #[inline(always)]
    pub(super) fn divide(&mut self, h: f64, converters: &[Converters; 4]) {
        for strobed in &self.strobed {
            let taken = strobed.taken(self.first, h, &converters[strobed.colour]);
            self.taken[strobed.colour % 2].push(taken);
        }
        self.strobed.clear();
    }

    /// Whether the D/As of a pair may take words in the block.
    #[inline(always)]
    pub(super) fn reach(&self, pair: usize) -> bool {
        !self.taken[side_of(pair)].is_empty()
    }

    /// What words do to a pair of D/As in the first `count` samples of the block: these multiply `products`, the first of which
    /// is that of the sample before, by `weight` as the block begins.
    #[inline(always)]
    pub(super) fn of_pair(
        &mut self,
        pair: usize,
        count: usize,
        step: &CellStep<Both<S>>,
        products: &[Both<S>; BLOCK + 1],
        mut weight: Both<S>,
    ) -> &Changes<S> {
        let changes = &mut *self.changes;
        changes.lanes = [0; BLOCK];
        for taken in &self.taken[side_of(pair)] {
            let (place, lane) = (place_of(pair), taken.lane);
            let n = taken.sample[place] as usize;
            if n >= count.min(BLOCK) {
                continue;
            }
            let [begin, end] = [products[n].0[lane], products[n + 1].0[lane]];
            let start = begin + taken.share[place] * (end - begin);
            let change = taken.weight[place] - weight.0[lane];
            let held = start * taken.from[place] + end * taken.to[place];
            let now = held * change + start * taken.kick[place];
            let LagStep { keep, from, .. } = &step.converter;
            let rest = now * keep.0[lane] + end * change * from.0[lane];
            let is_second = changes.lanes[n] >> lane & 1 == 1;
            let before =
                if is_second { [changes.now[n].0[lane], changes.rest[n].0[lane]] } else { [S::ZERO; 2] };
            changes.now[n].0[lane] = before[0] + now;
            changes.rest[n].0[lane] = before[1] + rest;
            (changes.weight[n].0[lane], weight.0[lane]) = (taken.weight[place], taken.weight[place]);
            changes.lanes[n] |= 1 << lane;
        }
        changes
    }
}

impl Strobed {
    /// What D/As make of it from sample `first` on, in steps of `h` seconds.
    #[inline(always)]
    fn taken<S: Real>(&self, first: i64, h: f64, converters: &Converters) -> Taken<S> {
        let Self { at, colour, lane, shares, pulses } = self;
        let none = [S::ZERO; PLACES];
        let mut taken = Taken {
            lane: LANES * (colour / 2) + lane,
            sample: [-1; PLACES],
            share: none,
            weight: none,
            from: none,
            to: none,
            kick: none,
        };
        let [mut values, mut areas, mut ratios] = [[0.0; PLACES]; 3];
        for sum in 0..3 {
            values[9 * sum..][..9].copy_from_slice(shares);
            areas[9 * sum..][..9].copy_from_slice(pulses);
        }
        for place in 0..PLACES {
            let at = (at + converters.later[place]) - first as f64;
            let sample = at.ceil();
            let share = at - (sample - 1.0);
            let left = h * (1.0 - share);
            ratios[place] = if left > 0.0 { left * converters.rate[place] } else { 0.0 };
            taken.sample[place] = sample as i32;
            taken.share[place] = S::from_f64(share);
            taken.weight[place] = S::from_f64(values[place] * converters.factor[place]);
        }
        let LagSteps { keep, from, to } = LagSteps::of(ratios);
        for place in 0..PLACES {
            let rate = converters.rate[place];
            let kick = if rate < f64::INFINITY { areas[place] * (keep[place] * rate) } else { 0.0 };
            taken.from[place] = S::from_f64(from[place]);
            taken.to[place] = S::from_f64(to[place]);
            taken.kick[place] = S::from_f64(kick);
        }
        taken.sample[3 * 9..].fill(-1);
        taken
    }
}

/// What words do to a pair of D/As in a block, sample by sample; for lanes that take none it means nothing.
#[derive(Debug, Clone)]
pub(super) struct Changes<S> {
    /// Lanes that take a word in the step to a sample, bit by bit.
    pub(super) lanes: [u64; BLOCK],
    /// What they multiply by from then on.
    pub(super) weight: BothRow<S>,
    /// What that adds to their outputs at the end of the step, and to what is left for the next.
    pub(super) now: BothRow<S>,
    pub(super) rest: BothRow<S>,
}

impl<S: Real> Default for Changes<S> {
    fn default() -> Self {
        let none = [Both::default(); BLOCK];
        Self { lanes: [0; BLOCK], weight: none, now: none, rest: none }
    }
}

/// The side of X whose colours a pair multiplies by.
fn side_of(pair: usize) -> usize {
    pair / 9 % SIDES
}

/// Place of the D/As of a pair among those of their colours.
fn place_of(pair: usize) -> usize {
    9 * (pair / (9 * SIDES)) + pair % 9
}
