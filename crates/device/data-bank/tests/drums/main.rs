//! Drums and buffer against closed forms, against a drum that turns tick by tick, and against their own books.

mod books;
mod closed_forms;
mod second_opinion;
mod together;
mod turning;

use data_bank::{Contents, DataBank, Demand, FrameSupply, Piece, StoreDesign};
use hardware_model::{Channels, Drum, DrumQueue};
use quantities::Tick;

/// One drum with records of one corner.
fn single(rotation: u64, word: f64, queue: DrumQueue) -> Drum {
    Drum { rotation, word, record_words: 9, queue, count: 1 }
}

fn demand(frame: u64, start: u64, end: u64, corners: impl IntoIterator<Item = u32>) -> Demand {
    Demand {
        frame,
        start: Tick(start),
        end: Tick(end),
        wants: vec![corners.into_iter().map(Piece::one).collect()],
    }
}

/// A bank of one level, whose records need no editing.
fn bank_of(drum: Drum, channels: Channels, buffer: Option<u32>, corners: [usize; 2], seed: u64) -> DataBank {
    let contents = Contents::Corners(corners);
    let store = StoreDesign { contents, record_words: drum.record_words, buffer_words: buffer, edit: 0.0 };
    DataBank::new(drum, channels, &[store], seed)
}

/// Banks that have one store.
trait OneStore {
    /// What its store gets in a frame.
    fn one(&mut self, demand: &Demand) -> FrameSupply;
}

impl OneStore for DataBank {
    fn one(&mut self, demand: &Demand) -> FrameSupply {
        self.frame(demand).remove(0)
    }
}

/// A bank behind an unlimited buffer that begins the mission with nothing in it.
fn empty_bank(drum: Drum, corners: [usize; 2]) -> DataBank {
    let mut bank = bank_of(drum, Channels::default(), None, corners, 1);
    bank.one(&demand(0, 0, 0, []));
    bank
}
