//! Words on their way to the D/As of a group, and those that act within a block of samples.

use std::mem;
use std::ops::Range;

use fearless_simd::Simd;
use parts::LagSteps;
use signal::{Both, Double, LANES, Real};

use super::taken::{Link, Links, Lists};
use super::terms::ALL;

/// A multiplying D/A takes a new word.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    /// When (samples).
    pub(super) at: f64,
    /// Which D/A, by its pair, and lane of both.
    pub(super) pair: u32,
    pub(super) lane: u32,
    /// What it multiplies by from then on.
    pub(super) weight: f64,
    /// Area of the pulse for a product of full scale (full scale times seconds).
    pub(super) pulse: f64,
    /// Time constant of the D/A (s).
    pub(super) tau: f64,
}

/// Words that two D/As, side by side with their lanes, take in one step.
#[derive(Debug, Clone, Copy)]
struct Taken<S> {
    /// What they multiply by from then on.
    weight: Both<S>,
    /// When within the step, 0..=1.
    share: Both<S>,
    /// What the signal at the word and at the end of the step leave at its end, for a weight of 1.
    from: Both<S>,
    to: Both<S>,
    /// What the pulse leaves, for a signal of 1 at the word.
    kick: Both<S>,
}

impl<S: Real> Default for Taken<S> {
    #[inline(always)]
    fn default() -> Self {
        let none = Both::default();
        Self { weight: none, share: none, from: none, to: none, kick: none }
    }
}

/// Words of all D/As.
#[derive(Debug, Clone)]
pub(super) struct Words<S> {
    /// First and last sample of the block; no word acts in none.
    first: i64,
    last: f64,
    /// Strobed and not acting by the end of the block; for a D/A of a lane ascending in time.
    waiting: Vec<Change>,
    /// Those that act in the block, and whose they are, pair by pair.
    taken: Links<Taken<S>>,
    pairs: Vec<Lists>,
    divided: Vec<Divided>,
}

/// A step that a word divides.
#[derive(Debug, Clone, Copy)]
struct Divided {
    /// When within the step, 0..=1.
    share: f64,
    /// Time constant of the D/A (s).
    tau: f64,
    pulse: f64,
    /// Whose it is: place among those taken, lane.
    place: u32,
    lane: u32,
}

impl<S: Real> Default for Words<S> {
    fn default() -> Self {
        let pairs = vec![Lists::default(); ALL / 2];
        let (waiting, divided) = (Vec::new(), Vec::new());
        Self { first: 0, last: f64::NEG_INFINITY, waiting, taken: Links::default(), pairs, divided }
    }
}

impl<S: Real> Words<S> {
    /// Forgets all of them: a group begins, and no block yet.
    pub(super) fn clear(&mut self) {
        self.last = f64::NEG_INFINITY;
        self.waiting.clear();
    }

    /// Puts a word on its way: into the block if it acts there.
    #[inline(always)]
    pub(super) fn send(&mut self, change: Change) {
        if change.at <= self.last {
            self.place(&change);
        } else {
            self.waiting.push(change);
        }
    }

    /// Hands over the words that act by `sample`.
    pub(super) fn take(&mut self, sample: i64, mut take: impl FnMut(&Change)) {
        self.waiting.retain(|change| {
            let acts = change.at <= sample as f64;
            if acts {
                take(change);
            }
            !acts
        });
    }

    /// Begins the block of `samples`, at most [`BLOCK`](super::block::BLOCK).
    pub(super) fn begin(&mut self, samples: &Range<i64>) {
        (self.first, self.last) = (samples.start, (samples.end - 1) as f64);
        self.taken.clear();
        self.divided.clear();
        self.pairs.iter_mut().for_each(Lists::clear);
        let mut waiting = mem::take(&mut self.waiting);
        let last = self.last;
        waiting.retain(|change| {
            let acts = change.at <= last;
            if acts {
                self.place(change);
            }
            !acts
        });
        self.waiting = waiting;
    }

    /// Places a word that acts by the end of the block; one that should have acted before acts as its first step begins.
    #[inline(always)]
    fn place(&mut self, change: &Change) {
        let whole = change.at as i64;
        let sample = (whole + i64::from(change.at > whole as f64)).max(self.first);
        let share = (change.at - (sample - 1) as f64).clamp(0.0, 1.0);
        let Change { pair, lane, tau, pulse, .. } = *change;
        let n = (sample - self.first) as usize;
        let (place, taken) = self.taken.room(&mut self.pairs[pair as usize], n, lane as usize);
        let (place, at) = (place as u32, lane as usize);
        (taken.weight.0[at], taken.share.0[at]) = (S::from_f64(change.weight), S::from_f64(share));
        self.divided.push(Divided { share, tau, pulse, place, lane });
    }

    /// Works out what the words of the block leave of their steps of `h` seconds, eight at a time whosever they are.
    #[inline(always)]
    pub(super) fn divide(&mut self, h: f64) {
        for words in self.divided.chunks(LANES) {
            let [mut left, mut tau] = [[0.0; LANES]; 2];
            for (n, word) in words.iter().enumerate() {
                (left[n], tau[n]) = (h * (1.0 - word.share), word.tau);
            }
            let LagSteps { keep, from, to } = LagSteps::new(left, tau);
            for (n, word) in words.iter().enumerate() {
                let (taken, lane) = (self.taken.at(word.place as usize), word.lane as usize);
                (taken.from.0[lane], taken.to.0[lane]) = (S::from_f64(from[n]), S::from_f64(to[n]));
                let kick = if word.tau > 0.0 { word.pulse * (keep[n] / word.tau) } else { 0.0 };
                taken.kick.0[lane] = S::from_f64(kick);
            }
        }
    }

    /// Samples of the block within whose step a word acts on a D/A of this pair, bit by bit.
    #[inline(always)]
    pub(super) fn samples(&self, pair: usize) -> u32 {
        self.pairs[pair].samples()
    }

    /// Gives the D/As of a pair the words of the step to sample `n` of the block, which they have taken with those before to
    /// `term`; their signals are `begin` as it begins and `end` as it ends.
    #[inline(always)]
    pub(super) fn act<L: Simd>(
        &self,
        simd: L,
        (pair, n): (usize, usize),
        [begin, end]: [S::Double<L>; 2],
        (weight, term): (&mut S::Double<L>, &mut S::Double<L>),
    ) {
        let load = |both: &Both<S>| S::Double::<L>::load(simd, both);
        for Link { lanes, words, .. } in self.taken.of(&self.pairs[pair], n) {
            let start = begin + load(&words.share) * (end - begin);
            let new = S::Double::<L>::chosen(simd, *lanes, load(&words.weight), *weight);
            let held = start * load(&words.from) + end * load(&words.to);
            let more = *term + (held * (new - *weight) + start * load(&words.kick));
            *term = S::Double::<L>::chosen(simd, *lanes, more, *term);
            *weight = new;
        }
    }
}
