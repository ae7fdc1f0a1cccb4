//! Words on their way to the D/As of a group, and what they do within a block of samples.
//!
//! A strobe gives a colour nine words, which go to nine D/As of each sum. Each of these has its own time. What two of them, side
//! by side, make of their words is worked out for all lanes at once.

use std::ops::Range;

use fearless_simd::Simd;
use parts::LagSteps;
use signal::{Both, Double, LANES, Real};

use super::cell::{CellStep, Wires};
use super::strobed::{NEVER, Strobed, Strobes, WORDS};
use crate::terms::{ALL, ENDS, PAIRS, one_of};

/// The bit of what is taken behind a block.
const BEYOND: f64 = 31.0;

/// Figures of two multiplying D/As side by side.
#[derive(Debug, Clone)]
pub(super) struct Converters {
    /// Gain, and the scale of the sum.
    pub(super) factor: [f64; 2],
    /// By how many samples each switches later than a nominal one.
    later: [f64; 2],
    /// Inverse time constants (1/s), infinite without a lag.
    rate: [f64; 2],
    /// What a pulse of area 1 begins with (1/s): nothing without a lag, as it is over at once.
    kick: [f64; 2],
}

impl Converters {
    /// Those of all pairs; by their numbers D/As have a factor, are later (samples) and have a time constant (s).
    pub(super) fn of_all(figures: impl Fn(usize) -> [f64; 3]) -> Vec<Self> {
        let of_pair = |pair: usize| {
            let figures = ENDS.map(|end| figures(one_of(pair, end)));
            let rate = figures.map(|[.., tau]| 1.0 / tau);
            Self {
                factor: figures.map(|[factor, ..]| factor),
                later: figures.map(|[_, later, _]| later),
                rate,
                kick: rate.map(|rate| if rate < f64::INFINITY { rate } else { 0.0 }),
            }
        };
        (0..ALL / 2).map(of_pair).collect()
    }
}

/// What two D/As take, side by side: each lane in a step of its own.
#[derive(Debug, Clone)]
pub(super) struct Taken<S> {
    /// In the steps to which samples of the block, bit by bit; [`BEYOND`] is one behind it.
    samples: u32,
    /// In the step to which sample, lane by lane: exact, as no sweep has more than 65 536.
    sample: Both<S>,
    /// When within the step, 0..=1.
    share: Both<S>,
    /// What they multiply by from then on.
    weight: Both<S>,
    /// What the signal at the word and at the end of the step leave at its end, for a weight of 1.
    from: Both<S>,
    to: Both<S>,
    /// What the pulse leaves, for a signal of 1 at the word.
    kick: Both<S>,
}

/// Words of all D/As.
#[derive(Debug, Clone)]
pub(super) struct Words<S> {
    /// First sample of the block.
    first: i64,
    strobed: Strobes,
    /// By pairs of D/As; in a lane ascending in time.
    taken: Vec<Vec<Taken<S>>>,
}

impl<S: Real> Default for Words<S> {
    fn default() -> Self {
        Self { first: 0, strobed: Strobes::default(), taken: vec![Vec::new(); ALL / 2] }
    }
}

impl<S: Real> Words<S> {
    /// Forgets all of them: a group begins.
    pub(super) fn clear(&mut self) {
        self.strobed.clear();
        self.taken.iter_mut().for_each(Vec::clear);
    }

    /// Puts words on their way, as [`Strobes::send`].
    pub(super) fn send(&mut self, at: f64, whose: (usize, usize), words: [&[f64; WORDS]; 2]) {
        self.strobed.send(at, whose, words);
    }

    /// Hands over the words that act by `sample`, before the first block: what D/A takes, lane, weight. They are over when a
    /// block begins behind it.
    pub(super) fn take(
        &self,
        sample: i64,
        converters: &[Converters],
        mut take: impl FnMut(usize, usize, f64),
    ) {
        for (pair, Converters { factor, later, .. }) in converters.iter().enumerate() {
            for strobed in self.strobed.of_pair(pair) {
                for (end, lane) in ENDS.into_iter().flat_map(|end| (0..LANES).map(move |lane| (end, lane))) {
                    let at = strobed.at[end][lane];
                    if at != NEVER && at + later[end] <= sample as f64 {
                        take(one_of(pair, end), lane, strobed.shares[pair % WORDS][end][lane] * factor[end]);
                    }
                }
            }
        }
    }

    /// Begins the block of `samples`, at most [`BLOCK`](super::block::BLOCK).
    pub(super) fn begin(&mut self, samples: &Range<i64>) {
        let passed = samples.start - self.first;
        self.first = samples.start;
        for taken in &mut self.taken {
            taken.retain(|taken| i64::from(taken.samples) >> passed.min(32) != 0);
            taken.iter_mut().for_each(|taken| taken.mark(samples.start));
        }
    }

    /// Works out what the D/As take that were given words since the last block, for steps of `h` seconds.
    #[inline(always)]
    pub(super) fn divide(&mut self, h: f64, converters: &[Converters]) {
        if self.strobed.are_none() {
            return;
        }
        let of_rows = converters.chunks_exact(PAIRS).zip(self.taken.chunks_exact_mut(PAIRS));
        for (row, (converters, taken)) in of_rows.enumerate() {
            for strobed in self.strobed.of_pair(PAIRS * row) {
                taken.iter_mut().for_each(|taken| taken.push(Taken::none()));
                for end in ENDS.into_iter().filter(|&end| strobed.has(end)) {
                    strobed.divide(PAIRS * row % WORDS, end, (self.first, h), converters, taken);
                }
                taken.iter_mut().flat_map(|taken| taken.last_mut()).for_each(|taken| taken.mark(self.first));
            }
        }
        self.strobed.clear();
    }

    /// Samples of the block within whose step a pair of D/As takes words, bit by bit.
    #[inline(always)]
    pub(super) fn samples(&self, pair: usize) -> u32 {
        self.taken[pair].iter().fold(0, |samples, taken| samples | taken.samples)
    }

    /// Gives a pair of D/As the words of the step to sample `n` of the block, whose signals are `begin` as it begins and that of
    /// the `wires` as it ends: what that adds to their outputs at its end, and to what is left for the next.
    #[inline(always)]
    pub(super) fn act<L: Simd>(
        &self,
        simd: L,
        (pair, n): (usize, usize),
        step: &CellStep<S::Double<L>>,
        (begin, wires): (S::Double<L>, &mut Wires<S::Double<L>>),
    ) -> [S::Double<L>; 2] {
        let mut more = [S::Double::<L>::splat(simd, S::ZERO); 2];
        for taken in &self.taken[pair] {
            taken.act(simd, self.first + n as i64, step, (begin, wires), &mut more);
        }
        more
    }
}

impl Strobed {
    /// What the D/As of a row make of their words from `word` on, at one end, from sample `first` on in steps of `h` seconds: all
    /// together, so that none waits for itself.
    #[inline(always)]
    fn divide<S: Real>(
        &self,
        word: usize,
        end: usize,
        (first, h): (i64, f64),
        converters: &[Converters],
        taken: &mut [Vec<Taken<S>>],
    ) {
        let (first, mut ratios) = (first as f64, [0.0; PAIRS * LANES]);
        for pair in 0..PAIRS {
            let ([.., taken], of) = (&mut taken[pair][..], &converters[pair]) else { return };
            let (later, rate, factor) = (of.later[end], of.rate[end], of.factor[end]);
            for lane in 0..LANES {
                let at = (self.at[end][lane] + later) - first;
                let sample = at.ceil();
                let share = at - (sample - 1.0);
                let left = h * (1.0 - share);
                ratios[LANES * pair + lane] = if left > 0.0 { left * rate } else { 0.0 };
                let place = LANES * end + lane;
                taken.sample.0[place] = S::from_f64(sample + first);
                taken.share.0[place] = S::from_f64(share);
                taken.weight.0[place] = S::from_f64(self.shares[word + pair][end][lane] * factor);
            }
        }
        let LagSteps { keep, from, to } = LagSteps::of(ratios);
        for pair in 0..PAIRS {
            let ([.., taken], kick) = (&mut taken[pair][..], converters[pair].kick[end]) else { return };
            for lane in 0..LANES {
                let (place, from_all) = (LANES * end + lane, LANES * pair + lane);
                let area = self.pulses[word + pair][end][lane];
                taken.from.0[place] = S::from_f64(from[from_all]);
                taken.to.0[place] = S::from_f64(to[from_all]);
                taken.kick.0[place] = S::from_f64(area * (keep[from_all] * kick));
            }
        }
    }
}

impl<S: Real> Taken<S> {
    /// Nothing, in any lane.
    #[inline(always)]
    fn none() -> Self {
        let (never, zero) = (Both([S::from_f64(NEVER); 2 * LANES]), Both::default());
        Self { samples: 0, sample: never, share: zero, weight: zero, from: zero, to: zero, kick: zero }
    }

    /// Tells in which steps of the block that begins at sample `first` it is taken.
    #[inline(always)]
    fn mark(&mut self, first: i64) {
        let first = S::from_f64(first as f64);
        let bit = |n: f64| if n >= 0.0 { 1 << n.min(BEYOND) as u32 } else { 0 };
        self.samples = self.sample.0.iter().fold(0, |all, &sample| all | bit((sample - first).to_f64()));
    }

    /// Gives the D/As the words of the step to `sample`, whose signals are `begin` as it begins and that of the `wires` as it
    /// ends: adds to `more` what that adds to their outputs at its end, and to what is left for the next.
    #[inline(always)]
    pub(super) fn act<L: Simd>(
        &self,
        simd: L,
        sample: i64,
        step: &CellStep<S::Double<L>>,
        (begin, wires): (S::Double<L>, &mut Wires<S::Double<L>>),
        more: &mut [S::Double<L>; 2],
    ) {
        let load = |both| S::Double::<L>::load(simd, both);
        let lanes = load(&self.sample).matches(S::Double::<L>::splat(simd, S::from_f64(sample as f64)));
        let choose = |these, others| S::Double::<L>::chosen(simd, lanes, these, others);
        let (end, weight) = (wires.product, load(&self.weight));
        let start = begin + load(&self.share) * (end - begin);
        let change = weight - wires.weight;
        let held = start * load(&self.from) + end * load(&self.to);
        let now = held * change + start * load(&self.kick);
        let rest = now * step.converter.keep + end * change * step.converter.from;
        more[0] = choose(more[0] + now, more[0]);
        more[1] = choose(more[1] + rest, more[1]);
        wires.weight = choose(weight, wires.weight);
    }
}
