//! Words on their way to the D/As of a group, and those that act within a block of samples.

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
    /// What the signal at the word and at the end of the step leave at its end, for a weight of 1, and the pulse of an area
    /// of 1 (1/s).
    pub(super) from: [f64; LANES],
    pub(super) to: [f64; LANES],
    pub(super) kick: [f64; LANES],
    /// What comes after it in the same step.
    then: Option<usize>,
}

/// Words of all D/As.
#[derive(Debug, Clone)]
pub(super) struct Words {
    /// Strobed and not yet acting; for a D/A of a lane ascending in time.
    waiting: Vec<Change>,
    /// Those that act in the block.
    acting: Vec<Acting>,
    cells: Vec<CellWords>,
}

/// Words of one D/A in a block.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CellWords {
    /// Bit n: a word acts within the step to sample n of the block.
    samples: u32,
    /// The first of these words, by sample.
    first: [usize; BLOCK],
}

impl Default for Words {
    fn default() -> Self {
        Self { waiting: Vec::new(), acting: Vec::new(), cells: vec![CellWords::default(); ALL] }
    }
}

impl Words {
    /// Forgets all of them: a group begins.
    pub(super) fn clear(&mut self) {
        self.waiting.clear();
    }

    /// Puts a word on its way.
    #[inline]
    pub(super) fn send(&mut self, change: Change) {
        self.waiting.push(change);
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

    /// Places the words that act within the steps to these `samples`, at most [`BLOCK`]; those that should have acted before
    /// act as the first step begins.
    pub(super) fn place(&mut self, samples: &Range<i64>) {
        let Self { waiting, acting, cells } = self;
        acting.clear();
        cells.iter_mut().for_each(|cell| cell.samples = 0);
        let (first, last) = (samples.start, (samples.end - 1) as f64);
        waiting.retain(|change| {
            let acts = change.at <= last;
            if acts {
                let sample = (change.at.ceil() as i64).max(first);
                let share = (change.at - (sample - 1) as f64).clamp(0.0, 1.0);
                cells[change.index].place((sample - first) as usize, share, change, acting);
            }
            !acts
        });
    }

    /// Works out what the words of the block leave of their steps of `h` seconds; `cells` have the D/As.
    #[inline(always)]
    pub(super) fn divide<S>(&mut self, h: f64, cells: &[Cell<S>]) {
        for acting in &mut self.acting {
            acting.divide(h, cells[acting.index].tau);
        }
    }

    /// The words of D/A `index` in the block.
    #[inline(always)]
    pub(super) fn of(&self, index: usize) -> &CellWords {
        &self.cells[index]
    }

    /// The words of a D/A that act in the step to sample `n` of the block, one after the other.
    #[inline(always)]
    pub(super) fn acting(&self, cell: &CellWords, n: usize) -> impl Iterator<Item = &Acting> {
        std::iter::successors(Some(&self.acting[cell.first[n]]), |acting| Some(&self.acting[acting.then?]))
    }
}

impl CellWords {
    /// Samples of the block by the end of whose step a word acts, ascending.
    #[inline(always)]
    pub(super) fn samples(&self) -> impl Iterator<Item = usize> + use<> {
        let left = |samples: u32| (samples != 0).then_some(samples);
        std::iter::successors(left(self.samples), move |samples| left(samples & (samples - 1)))
            .map(|samples| samples.trailing_zeros() as usize)
    }

    fn place(&mut self, n: usize, share: f64, change: &Change, acting: &mut Vec<Acting>) {
        let next = acting.len();
        if self.samples >> n & 1 == 0 {
            self.samples |= 1 << n;
            self.first[n] = next;
            acting.push(Acting::of(change.index));
        }
        let mut place = self.first[n];
        // A lane that has two words in a step takes one after the other.
        while acting[place].lanes >> change.lane & 1 == 1 {
            place = *acting[place].then.get_or_insert(next);
            if place == next {
                acting.push(Acting::of(change.index));
            }
        }
        acting[place].set(share, change);
    }
}

impl Acting {
    fn of(index: usize) -> Self {
        let none = [0.0; LANES];
        Self {
            index,
            lanes: 0,
            share: none,
            weight: none,
            pulse: none,
            from: none,
            to: none,
            kick: none,
            then: None,
        }
    }

    fn set(&mut self, share: f64, change: &Change) {
        self.lanes |= 1 << change.lane;
        self.share[change.lane] = share;
        self.weight[change.lane] = change.weight;
        self.pulse[change.lane] = change.pulse;
    }
}
