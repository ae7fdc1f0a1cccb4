//! The accesses that bring one set, and when the words of each are in their register.

use hardware_model::Loader;
use quantities::Tick;
use sweep_program::WordMask;

/// Words of a set.
const SET: u32 = 9;

/// How a set comes from the storage buffer: access by access, each behind the editing of the words of the one before.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Accesses {
    words_per_access: u32,
    /// Accesses of a set.
    count: u32,
    access: u64,
    /// Time to edit one word (ticks).
    edit: u64,
    strobe: u64,
    /// From the first access of a set until its last word has been edited.
    whole: u64,
}

impl Accesses {
    pub fn of(loader: &Loader) -> Self {
        let Loader { words_per_access, access, strobe, .. } = *loader;
        let (count, edit) = (SET.div_ceil(words_per_access), loader.channel_programme().edit);
        let whole = u64::from(count) * access + u64::from(SET) * edit;
        Self { words_per_access, count, access, edit, strobe, whole }
    }

    /// When the last word of a set whose first access begins at `begin` has been edited: the next set may begin.
    pub fn end(&self, begin: Tick) -> Tick {
        Tick(begin.0 + self.whole)
    }

    /// When the last word of such a set is in its register.
    pub fn last(&self, begin: Tick) -> Tick {
        Tick(begin.0 + self.whole + self.strobe)
    }

    /// The words of a set and when they are in their register, access by access.
    pub fn arrivals(self, begin: Tick) -> impl Iterator<Item = (Tick, WordMask)> {
        (0..self.count).map(move |number| {
            let until = ((number + 1) * self.words_per_access).min(SET);
            let words = WordMask::range(number * self.words_per_access, until);
            let after = u64::from(number + 1) * self.access + u64::from(until) * self.edit;
            (Tick(begin.0 + after + self.strobe), words)
        })
    }
}
