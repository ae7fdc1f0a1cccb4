//! Words on their way to the D/As of a group, and those that act within a block of samples.

use std::mem;
use std::ops::Range;

use signal::LANES;

use super::block::BLOCK;
use super::grid::Cell;
use super::terms::ALL;

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

/// What one D/A takes in one step, lane by lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Acting {
    index: usize,
    /// Lanes that have a new word, bit by bit; the rest counts there alone.
    pub(super) lanes: u64,
    /// When within the step, 0..=1.
    pub(super) share: [f64; LANES],
    pub(super) weight: [f64; LANES],
    pub(super) pulse: [f64; LANES],
    /// What the signal at the word and at the end of the step leave at its end, for a weight of 1, and the pulse of an
    /// area of 1 (1/s).
    pub(super) from: [f64; LANES],
    pub(super) to: [f64; LANES],
    pub(super) kick: [f64; LANES],
    /// What comes after it in the same step.
    then: Option<usize>,
}

/// Words of all D/As.
#[derive(Debug, Clone)]
pub(super) struct Words {
    /// First and last sample of the block; no word acts in none.
    first: i64,
    last: f64,
    /// Strobed and not acting by the end of the block; for a D/A of a lane ascending in time.
    waiting: Vec<Change>,
    /// Those that act in the block are the first `count`; room behind them is used again.
    acting: Vec<Acting>,
    count: usize,
    cells: Vec<CellWords>,
}

/// Words of one D/A in a block.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CellWords {
    /// Bit n: a word acts within the step to sample n of the block.
    samples: u32,
    /// The first of these words, by sample.
    first: [u32; BLOCK],
}

impl Default for Words {
    fn default() -> Self {
        let cells = vec![CellWords::default(); ALL];
        Self { first: 0, last: f64::NEG_INFINITY, waiting: Vec::new(), acting: Vec::new(), count: 0, cells }
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

    /// Begins the block of `samples`, at most [`BLOCK`].
    pub(super) fn begin(&mut self, samples: &Range<i64>) {
        (self.first, self.last) = (samples.start, (samples.end - 1) as f64);
        self.count = 0;
        self.cells.iter_mut().for_each(|cell| cell.samples = 0);
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

    /// Places a word that acts by the end of the block; one that should have acted before acts as its first step
    /// begins.
    #[inline(always)]
    fn place(&mut self, change: &Change) {
        let whole = change.at as i64;
        let sample = (whole + i64::from(change.at > whole as f64)).max(self.first);
        let share = (change.at - (sample - 1) as f64).clamp(0.0, 1.0);
        let mut place = self.first_at(change.index, (sample - self.first) as usize);
        // A lane that has two words in a step takes one after the other.
        while self.acting[place].lanes >> change.lane & 1 == 1 {
            place = self.behind(place);
        }
        self.acting[place].set(share, change);
    }

    /// Where the first words are that D/A `index` takes in the step to sample `n` of the block.
    #[inline(always)]
    fn first_at(&mut self, index: usize, n: usize) -> usize {
        if self.cells[index].samples >> n & 1 == 0 {
            let next = self.room(index);
            let cell = &mut self.cells[index];
            cell.samples |= 1 << n;
            cell.first[n] = next as u32;
        }
        self.cells[index].first[n] as usize
    }

    /// Where those behind them are.
    #[cold]
    fn behind(&mut self, place: usize) -> usize {
        let Acting { then, index, .. } = self.acting[place];
        then.unwrap_or_else(|| {
            let next = self.room(index);
            self.acting[place].then = Some(next);
            next
        })
    }

    /// Room for words of D/A `index`.
    #[inline(always)]
    fn room(&mut self, index: usize) -> usize {
        let next = self.count;
        if next == self.acting.len() {
            self.grow();
        }
        let acting = &mut self.acting[next];
        (acting.index, acting.lanes, acting.then) = (index, 0, None);
        self.count += 1;
        next
    }

    #[cold]
    fn grow(&mut self) {
        self.acting.push(Acting::NONE);
    }

    /// Works out what the words of the block leave of their steps of `h` seconds; `cells` have the D/As.
    #[inline(always)]
    pub(super) fn divide<S>(&mut self, h: f64, cells: &[Cell<S>]) {
        for acting in &mut self.acting[..self.count] {
            acting.divide(h, cells[acting.index].tau);
        }
    }

    /// Samples of the block within whose step a word acts on any of these D/As, ascending.
    #[inline(always)]
    pub(super) fn samples(&self, indices: Range<usize>) -> impl Iterator<Item = usize> + use<> {
        let mut all = 0;
        for cell in &self.cells[indices] {
            all |= cell.samples;
        }
        let left = |samples: u32| (samples != 0).then_some(samples);
        std::iter::successors(left(all), move |samples| left(samples & (samples - 1)))
            .map(|samples| samples.trailing_zeros() as usize)
    }

    /// The words of D/A `index` that act in the step to sample `n` of the block, one after the other.
    #[inline(always)]
    pub(super) fn acting(&self, index: usize, n: usize) -> impl Iterator<Item = &Acting> {
        let cell = &self.cells[index];
        let first = (cell.samples >> n & 1 == 1).then(|| &self.acting[cell.first[n] as usize]);
        std::iter::successors(first, |acting| Some(&self.acting[acting.then?]))
    }
}

impl Acting {
    const NONE: Self = Self {
        index: 0,
        lanes: 0,
        share: [0.0; LANES],
        weight: [0.0; LANES],
        pulse: [0.0; LANES],
        from: [0.0; LANES],
        to: [0.0; LANES],
        kick: [0.0; LANES],
        then: None,
    };

    #[inline(always)]
    fn set(&mut self, share: f64, change: &Change) {
        self.lanes |= 1 << change.lane;
        self.share[change.lane] = share;
        self.weight[change.lane] = change.weight;
        self.pulse[change.lane] = change.pulse;
    }
}
