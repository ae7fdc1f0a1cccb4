//! Drums and buffer against closed forms, against a drum that turns tick by tick, and against their own books.

mod books;
mod closed_forms;
mod second_opinion;
mod turning;

use data_bank::{DataBank, Demand};
use hardware_model::{Channels, Drum, DrumQueue};
use quantities::Tick;

/// One drum with records of one corner.
fn single(rotation: u64, word: f64, queue: DrumQueue) -> Drum {
    Drum { rotation, word, record_words: 9, queue, count: 1 }
}

fn demand(frame: u64, start: u64, end: u64, corners: impl IntoIterator<Item = u32>) -> Demand {
    Demand { frame, start: Tick(start), end: Tick(end), corners: corners.into_iter().collect() }
}

/// A bank behind an unlimited buffer that begins the mission with nothing in it.
fn empty_bank(drum: Drum, corners: [usize; 2]) -> DataBank {
    let mut bank = DataBank::new(drum, Channels::default(), None, corners, 1);
    bank.frame(&demand(0, 0, 0, []));
    bank
}
