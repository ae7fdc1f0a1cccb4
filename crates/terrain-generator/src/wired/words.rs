//! Words on their way to the D/As of a group, and those that act within a block of samples.

use std::mem;
use std::ops::Range;

use parts::LagSteps;
use signal::{Both, LANES, Real};

use super::block::BLOCK;
use super::cell::Cell;
use super::terms::{ALL, ENDS, one_of};

/// A multiplying D/A takes a new word.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    /// When (samples).
    pub(super) at: f64,
    /// Which D/A, of which lane.
    pub(super) index: usize,
    pub(super) lane: usize,
    /// What it multiplies by from then on.
    pub(super) weight: f64,
    /// Area of the pulse for a product of full scale (full scale times seconds).
    pub(super) pulse: f64,
}

/// A word that a D/A of a lane takes within the block.
#[derive(Debug, Clone, Copy)]
struct Acting {
    weight: f64,
    pulse: f64,
    /// Which of the divided steps its own is.
    divided: u32,
    lane: u32,
    /// What the D/A takes after it in the same step, in any lane.
    then: u32,
}

/// Words of all D/As.
#[derive(Debug, Clone)]
pub(super) struct Words {
    /// First and last sample of the block; no word acts in none.
    first: i64,
    last: f64,
    /// Strobed and not acting by the end of the block; for a D/A of a lane ascending in time.
    waiting: Vec<Change>,
    /// Those that act in the block.
    acting: Vec<Acting>,
    divided: Divided,
    cells: Vec<CellWords>,
}

/// Steps that words divide, each once for all words that act together on D/As that are alike.
#[derive(Debug, Clone, Default)]
struct Divided {
    /// When within the step, 0..=1.
    share: Vec<f64>,
    /// Time constants of the D/As (s).
    tau: Vec<f64>,
    /// What the signal at the word and at the end of the step leave at its end, for a weight of 1, and the pulse of an
    /// area of 1 (1/s).
    from: Vec<f64>,
    to: Vec<f64>,
    kick: Vec<f64>,
}

/// Words of one D/A in a block.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CellWords {
    /// Bit n: a word acts within the step to sample n of the block.
    samples: u32,
    /// The first and the last of these words, by sample.
    ends: [[u32; 2]; BLOCK],
}

/// Behind the last word of a step.
const NONE: u32 = u32::MAX;

impl Default for Words {
    fn default() -> Self {
        let cells = vec![CellWords::default(); ALL];
        Self {
            first: 0,
            last: f64::NEG_INFINITY,
            waiting: Vec::new(),
            acting: Vec::new(),
            divided: Divided::default(),
            cells,
        }
    }
}

impl Words {
    /// Forgets all of them: a group begins, and no block yet.
    pub(super) fn clear(&mut self) {
        self.last = f64::NEG_INFINITY;
        self.waiting.clear();
    }

    /// Puts a word on its way: into the block if it acts there.
    #[inline(always)]
    pub(super) fn send(&mut self, change: Change, tau: f64) {
        if change.at <= self.last {
            self.place(&change, tau);
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

    /// Begins the block of `samples`, at most [`BLOCK`]; `cells` have the D/As.
    pub(super) fn begin<S>(&mut self, samples: &Range<i64>, cells: &[Cell<S>]) {
        (self.first, self.last) = (samples.start, (samples.end - 1) as f64);
        self.acting.clear();
        self.divided.clear();
        self.cells.iter_mut().for_each(|cell| cell.samples = 0);
        let mut waiting = mem::take(&mut self.waiting);
        let last = self.last;
        waiting.retain(|change| {
            let acts = change.at <= last;
            if acts {
                self.place(change, cells[change.index].tau);
            }
            !acts
        });
        self.waiting = waiting;
    }

    /// Places a word that acts by the end of the block, of a D/A of time constant `tau` (s); one that should have acted
    /// before acts as its first step begins.
    #[inline(always)]
    fn place(&mut self, change: &Change, tau: f64) {
        let whole = change.at as i64;
        let sample = (whole + i64::from(change.at > whole as f64)).max(self.first);
        let share = (change.at - (sample - 1) as f64).clamp(0.0, 1.0);
        let (next, n) = (self.acting.len() as u32, (sample - self.first) as usize);
        let cell = &mut self.cells[change.index];
        let [first, last] = &mut cell.ends[n];
        if cell.samples >> n & 1 == 0 {
            cell.samples |= 1 << n;
            *first = next;
        } else {
            self.acting[*last as usize].then = next;
        }
        *last = next;
        let Change { lane, weight, pulse, .. } = *change;
        let divided = self.divided.find(share, tau);
        self.acting.push(Acting { weight, pulse, divided, lane: lane as u32, then: NONE });
    }

    /// Works out what the words of the block leave of their steps of `h` seconds.
    #[inline(always)]
    pub(super) fn divide(&mut self, h: f64) {
        self.divided.work_out(h);
    }

    /// Samples of the block within whose step a word acts on a D/A of this pair, bit by bit.
    #[inline(always)]
    pub(super) fn samples(&self, pair: usize) -> u32 {
        let [near, far] = ENDS.map(|end| self.cells[one_of(pair, end)].samples);
        near | far
    }

    /// What a word adds to the term at the end of its step, which the D/A has taken with the weight `held`; its signal is
    /// `from` as the step begins and `end` as it ends.
    #[inline(always)]
    fn more(&self, word: &Acting, [from, end]: [f64; 2], held: f64) -> f64 {
        let (divided, n) = (&self.divided, word.divided as usize);
        let start = from + divided.share[n] * (end - from);
        let kick = word.pulse * start * divided.kick[n];
        (start * divided.from[n] + end * divided.to[n]) * (word.weight - held) + kick
    }

    /// The words of D/A `index` that act in the step to sample `n` of the block, one after the other.
    #[inline(always)]
    fn acting(&self, index: usize, n: usize) -> impl Iterator<Item = &Acting> {
        let cell = &self.cells[index];
        let first = if cell.samples >> n & 1 == 1 { cell.ends[n][0] } else { NONE };
        std::iter::successors(self.acting.get(first as usize), |word| self.acting.get(word.then as usize))
    }
}

impl Divided {
    fn clear(&mut self) {
        self.share.clear();
        self.tau.clear();
    }

    /// The number of a step that is divided at `share` behind a D/A of time constant `tau` (s): of the last, if it is that.
    #[inline(always)]
    fn find(&mut self, share: f64, tau: f64) -> u32 {
        if self.share.last() != Some(&share) || self.tau.last() != Some(&tau) {
            self.share.push(share);
            self.tau.push(tau);
        }
        (self.share.len() - 1) as u32
    }

    /// Eight at a time; the last are filled up.
    #[inline(always)]
    fn work_out(&mut self, h: f64) {
        let count = self.share.len().next_multiple_of(LANES);
        for values in [&mut self.share, &mut self.tau, &mut self.from, &mut self.to, &mut self.kick] {
            values.resize(count, 0.0);
        }
        for first in (0..count).step_by(LANES) {
            let (mut left, mut tau) = ([0.0; LANES], [0.0; LANES]);
            tau.copy_from_slice(&self.tau[first..first + LANES]);
            for (left, share) in left.iter_mut().zip(&self.share[first..]) {
                *left = h * (1.0 - share);
            }
            let LagSteps { keep, from, to } = LagSteps::new(left, tau);
            self.from[first..first + LANES].copy_from_slice(&from);
            self.to[first..first + LANES].copy_from_slice(&to);
            for (kick, (keep, tau)) in self.kick[first..].iter_mut().zip(keep.iter().zip(&tau)) {
                *kick = if *tau > 0.0 { keep / tau } else { 0.0 };
            }
        }
    }
}

/// Two D/As that take words within a step, each with its lanes.
#[derive(Debug)]
pub(super) struct Taking<S> {
    /// Their signals as the step begins and as it ends.
    pub(super) begin: Both<S>,
    pub(super) end: Both<S>,
    /// What they multiply by.
    pub(super) weight: Both<S>,
    /// What comes out at the end.
    pub(super) term: Both<S>,
}

impl<S: Real> Default for Taking<S> {
    #[inline(always)]
    fn default() -> Self {
        let none = Both::default();
        Self { begin: none, end: none, weight: none, term: none }
    }
}

impl<S: Real> Taking<S> {
    /// Gives the D/As of a pair the words of the step to sample `n` of the block.
    #[inline(always)]
    pub(super) fn act(&mut self, words: &Words, pair: usize, n: usize) {
        for end in ENDS {
            for word in words.acting(one_of(pair, end), n) {
                let lane = LANES * end + word.lane as usize;
                let ends = [self.begin.0[lane], self.end.0[lane]].map(S::to_f64);
                let (held, term) = (&mut self.weight.0[lane], &mut self.term.0[lane]);
                *term = S::from_f64(term.to_f64() + words.more(word, ends, held.to_f64()));
                *held = S::from_f64(word.weight);
            }
        }
    }
}
