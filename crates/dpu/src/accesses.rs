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
    access: u64,
    /// One word edited.
    edit: u64,
    strobe: u64,
}

impl Accesses {
    pub fn of(loader: &Loader) -> Self {
        let Loader { words_per_access, access, strobe, .. } = *loader;
        Self { words_per_access, access, edit: loader.channel_programme().edit, strobe }
    }

    /// When the last word of a set whose first access begins at `begin` has been edited: the next set may begin.
    pub fn end(&self, begin: Tick) -> Tick {
        self.done(begin, self.count() - 1)
    }

    /// The words of a set and when they are in their register, access by access.
    pub fn arrivals(self, begin: Tick) -> impl Iterator<Item = (Tick, WordMask)> {
        (0..self.count()).map(move |number| {
            let words = WordMask::range(number * self.words_per_access, self.words_by(number));
            (Tick(self.done(begin, number).0 + self.strobe), words)
        })
    }

    fn count(&self) -> u32 {
        SET.div_ceil(self.words_per_access)
    }

    /// Words that have come with access `number`.
    fn words_by(&self, number: u32) -> u32 {
        ((number + 1) * self.words_per_access).min(SET)
    }

    fn done(&self, begin: Tick, number: u32) -> Tick {
        let (accesses, words) = (u64::from(number + 1), u64::from(self.words_by(number)));
        Tick(begin.0 + accesses * self.access + words * self.edit)
    }
}
