//! Words that are taken within a block, in lists by step.

use super::block::BLOCK;

/// Behind the last of a list.
const NONE: u32 = u32::MAX;

/// What lanes take together in one step: a link of the list of that step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link<T> {
    /// Lanes, bit by bit; the words of others mean nothing.
    pub(super) lanes: u64,
    pub(super) words: T,
    /// What comes after it in the same step.
    then: u32,
}

/// Links of a block, whosever they are: the first `count`. Room behind them is used again, with what it holds.
#[derive(Debug, Clone)]
pub(super) struct Links<T> {
    links: Vec<Link<T>>,
    count: usize,
}

/// The lists of whoever takes words: one a step of the block.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Lists {
    /// Bit n: words are taken in the step to sample n of the block.
    samples: u32,
    /// The first and the last of them, by sample.
    ends: [[u32; 2]; BLOCK],
}

impl<T> Default for Links<T> {
    fn default() -> Self {
        Self { links: Vec::new(), count: 0 }
    }
}

impl Lists {
    pub(super) fn clear(&mut self) {
        self.samples = 0;
    }

    /// Samples of the block within whose step words are taken, bit by bit.
    #[inline(always)]
    pub(super) fn samples(&self) -> u32 {
        self.samples
    }
}

impl<T: Default> Links<T> {
    pub(super) fn clear(&mut self) {
        self.count = 0;
    }

    /// Room for the words of a lane in the step to sample `n`: behind those that the lane takes in the same step.
    #[inline(always)]
    pub(super) fn room(&mut self, lists: &mut Lists, n: usize, lane: usize) -> &mut T {
        let place = self.place(lists, n, lane);
        let link = &mut self.links[place];
        link.lanes |= 1 << lane;
        &mut link.words
    }

    #[inline(always)]
    fn place(&mut self, lists: &mut Lists, n: usize, lane: usize) -> usize {
        let next = self.count as u32;
        let [first, last] = &mut lists.ends[n];
        if lists.samples >> n & 1 == 0 {
            lists.samples |= 1 << n;
            *first = next;
        } else {
            let before = &mut self.links[*last as usize];
            if before.lanes >> lane & 1 == 0 {
                return *last as usize;
            }
            before.then = next;
        }
        *last = next;
        if self.count == self.links.len() {
            self.grow();
        }
        let link = &mut self.links[self.count];
        (link.lanes, link.then) = (0, NONE);
        self.count += 1;
        next as usize
    }

    #[cold]
    fn grow(&mut self) {
        self.links.push(Link { lanes: 0, words: T::default(), then: NONE });
    }

    /// The list of the step to sample `n`, of whom words are taken there.
    #[inline(always)]
    pub(super) fn of(&self, lists: &Lists, n: usize) -> impl Iterator<Item = &Link<T>> {
        let first = self.links.get(lists.ends[n][0] as usize);
        std::iter::successors(first, |link| self.links.get(link.then as usize))
    }
}
