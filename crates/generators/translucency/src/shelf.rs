//! Slots of translucent features, near to far, for each sampling point.

use crate::entry::Entry;
use crate::feature::Feature;

/// Slots that unlimited shelves begin with at each sampling point.
const FIRST_SLOTS: usize = 4;

/// The nearest features of each sampling point, up to a capacity.
#[derive(Debug, Clone)]
pub(crate) struct Shelf {
    capacity: usize,
    /// Slots that every sampling point has by now, at most the capacity.
    stride: usize,
    counts: Vec<u32>,
    farthest: Vec<f64>,
    entries: Vec<Entry>,
}

impl Shelf {
    /// An empty shelf of a capacity (`None`: without limit) for so many sampling points.
    pub fn new(capacity: Option<u32>, samples: usize) -> Self {
        let capacity = capacity.map_or(usize::MAX, |slots| slots as usize);
        let stride = capacity.min(FIRST_SLOTS);
        Self {
            capacity,
            stride,
            counts: vec![0; samples],
            farthest: vec![farthest_of_none(capacity); samples],
            entries: vec![Entry::NONE; stride * samples],
        }
    }

    /// Forgets what sampling points have.
    pub fn clear(&mut self, samples: std::ops::Range<usize>) {
        self.farthest[samples.clone()].fill(farthest_of_none(self.capacity));
        self.counts[samples].fill(0);
    }

    /// What a sampling point has, near to far.
    pub fn of(&self, sample: usize) -> &[Entry] {
        &self.entries[sample * self.stride..][..self.counts[sample] as usize]
    }

    /// How near (q, 1/m) the farthest is that a full sampling point has; nothing is as far where there is a slot.
    pub fn farthest(&self) -> &[f64] {
        &self.farthest
    }

    /// Puts an entry in its place by distance and key; what then has no slot is given back, the farthest.
    pub fn insert(&mut self, sample: usize, entry: Entry, features: &[Feature]) -> Option<Entry> {
        let held = self.of(sample);
        let nearer = held.iter().rposition(|&other| !entry.is_nearer(other, features));
        let (place, count) = (nearer.map_or(0, |last| last + 1), held.len());
        if place == self.capacity {
            return Some(entry);
        }
        let lost = (count == self.capacity).then(|| held[count - 1]);
        if lost.is_none() {
            if count == self.stride {
                self.grow();
            }
            self.counts[sample] += 1;
        }
        let slots = &mut self.entries[sample * self.stride..][..self.counts[sample] as usize];
        slots[place..].rotate_right(1);
        slots[place] = entry;
        if slots.len() == self.capacity {
            self.farthest[sample] = slots[self.capacity - 1].q;
        }
        lost
    }

    /// Twice as many slots for every sampling point.
    fn grow(&mut self) {
        let stride = (2 * self.stride).min(self.capacity);
        let mut entries = vec![Entry::NONE; stride * self.counts.len()];
        for (sample, slots) in entries.chunks_exact_mut(stride).enumerate() {
            let held = self.of(sample);
            slots[..held.len()].copy_from_slice(held);
        }
        (self.stride, self.entries) = (stride, entries);
    }
}

/// [`Shelf::farthest`] of a sampling point that has nothing: without a slot everything is too far.
fn farthest_of_none(capacity: usize) -> f64 {
    if capacity == 0 { f64::INFINITY } else { f64::NEG_INFINITY }
}
