//! The data banks of a mission: which kinds share drums, and what each frame gets (report, figure 15).

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use data_bank::{BankState, Contents, DataBank, DrumUnit, FrameSupply, Piece, StoreDesign};
use hardware_model::{BankPlace, Drum};

use crate::blocks::Blocks;
use crate::data_kind::DataKind;
use crate::demand::{Asking, Layouts, has_bank, place};
use crate::stage::MachineStage;

/// Drums that hold the data of some kinds.
#[derive(Debug)]
pub(crate) struct Bank {
    /// Kinds whose records lie on the drums, in the order of their stores; the first gives the drums their name.
    pub kinds: Vec<DataKind>,
    /// As a mission finds it.
    fresh: DataBank,
    history: Mutex<History>,
}

/// A data bank from the start of the mission on, worked out once, in order of frames.
#[derive(Debug)]
struct History {
    bank: DataBank,
    frames: Vec<Arc<[FrameSupply]>>,
}

/// What the bank of one kind did in one frame.
#[derive(Debug, Clone)]
pub struct Supplied {
    /// Kind of the data.
    pub kind: DataKind,
    /// Kind after which its drums are called.
    pub drums: DataKind,
    /// Those drums, with the transfer of a record of the kind.
    pub units: Vec<DrumUnit>,
    /// What all kinds on the drums got.
    frame: Arc<[FrameSupply]>,
    /// Number of its store among them.
    store: usize,
}

impl Supplied {
    /// What the kind got.
    pub fn supply(&self) -> &FrameSupply {
        &self.frame[self.store]
    }

    /// Whether the drums are called after the kind.
    pub fn names_drums(&self) -> bool {
        self.kind == self.drums
    }
}

/// What a kind of data asks of its drums, from the first frame of a mission on.
#[derive(Debug, Clone, PartialEq)]
pub struct BankDemand {
    /// Kind of the data.
    pub kind: DataKind,
    /// The drums, with the transfer of a record of the kind.
    pub drums: Vec<DrumUnit>,
    /// Pieces that each frame asks for, most urgent first.
    pub asked: Vec<Vec<Piece>>,
}

/// The banks of a stage; none where all data are at hand.
pub(crate) fn banks(stage: &MachineStage, blocks: &Blocks, layouts: &Layouts) -> Vec<Bank> {
    let Some(drum) = stage.settings.data_banks.drum else { return Vec::new() };
    let groups = kinds_by_drums(stage, blocks).into_iter();
    groups.map(|kinds| Bank::new(stage, layouts, drum, kinds)).collect()
}

/// Drums of all banks of a machine.
pub(crate) fn drum_count(stage: &MachineStage, blocks: &Blocks) -> usize {
    let of_bank = stage.settings.data_banks.drum.map_or(0, |drum| drum.count as usize);
    of_bank * kinds_by_drums(stage, blocks).len()
}

/// Channels of all banks of a machine.
pub(crate) fn channel_count(stage: &MachineStage, blocks: &Blocks) -> usize {
    let banks = &stage.settings.data_banks;
    let of_bank = banks.drum.map_or(0, |drum| {
        let drums = drum.count.max(1);
        banks.channels.count.unwrap_or(drums).clamp(1, drums) as usize
    });
    of_bank * kinds_by_drums(stage, blocks).len()
}

/// Kinds of data by the drums that they share.
fn kinds_by_drums(stage: &MachineStage, blocks: &Blocks) -> Vec<Vec<DataKind>> {
    let kinds = DataKind::ALL.into_iter().filter(|&kind| has_bank(stage, blocks, kind));
    let (together, apart): (Vec<DataKind>, Vec<DataKind>) =
        kinds.partition(|&kind| kind == DataKind::Fine || place(stage, kind) == BankPlace::Together);
    [together].into_iter().chain(apart.into_iter().map(|kind| vec![kind])).collect()
}

impl Bank {
    fn new(stage: &MachineStage, layouts: &Layouts, drum: Drum, kinds: Vec<DataKind>) -> Self {
        let settings = &stage.settings;
        let designs: Vec<StoreDesign> =
            kinds.iter().map(|&kind| design(stage, layouts, &drum, kind)).collect();
        let seed = settings.seed ^ kinds[0] as u64;
        let fresh = DataBank::new(drum, settings.data_banks.channels, &designs, seed);
        Self { kinds, history: Mutex::new(History { bank: fresh.clone(), frames: Vec::new() }), fresh }
    }

    /// The drums as the seed drew them, with the transfer of a record of store `store`.
    pub fn units(&self, store: usize) -> Vec<DrumUnit> {
        self.fresh.drums(store).collect()
    }

    /// What each kind got in frame `frame`, worked out from the first frame on.
    pub fn frame(&self, asking: &Asking<'_>, frame: u64) -> impl Iterator<Item = Supplied> {
        let frame = self.supplies(asking, frame);
        let supplied = move |(store, &kind): (usize, &DataKind)| Supplied {
            kind,
            drums: self.kinds[0],
            units: self.units(store),
            frame: Arc::clone(&frame),
            store,
        };
        self.kinds.iter().enumerate().map(supplied)
    }

    /// Demands are worked out without the lock: they take threads, which may come to wait for it.
    fn supplies(&self, asking: &Asking<'_>, frame: u64) -> Arc<[FrameSupply]> {
        loop {
            let known = self.lock().frames.len() as u64;
            if frame < known {
                return Arc::clone(&self.lock().frames[frame as usize]);
            }
            let demand = asking.demand(&self.kinds, known);
            let mut history = self.lock();
            if history.frames.len() as u64 == known {
                let supplies = history.bank.frame(&demand).into();
                history.frames.push(supplies);
            }
        }
    }

    fn lock(&self) -> MutexGuard<'_, History> {
        self.history.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What it takes to fill the buffers before the mission, by store.
    pub fn first_load(&self, asking: &Asking<'_>) -> Vec<FrameSupply> {
        self.fresh.first_load(&asking.demand(&self.kinds, 0))
    }

    /// What frames 0 to `last` ask of the drums, kind by kind.
    pub fn demands(&self, asking: &Asking<'_>, last: u64) -> Vec<BankDemand> {
        let of_kind = |(store, &kind): (usize, &DataKind)| BankDemand {
            kind,
            drums: self.units(store),
            asked: (0..=last).map(|frame| asking.demand(&[kind], frame).wants.remove(0)).collect(),
        };
        self.kinds.iter().enumerate().map(of_kind).collect()
    }

    /// What the bank remembers as frame `frame` begins, before its demand is read.
    pub fn before(&self, asking: &Asking<'_>, frame: u64) -> BankState {
        let mut bank = self.fresh.clone();
        for earlier in 0..frame {
            bank.frame(&asking.demand(&self.kinds, earlier));
        }
        bank.state()
    }
}

/// Records, buffer and I/O processor of a kind.
fn design(stage: &MachineStage, layouts: &Layouts, drum: &Drum, kind: DataKind) -> StoreDesign {
    let settings = &stage.settings;
    match layouts.of(kind) {
        Some(layout) => StoreDesign {
            contents: Contents::Chains(layout.grid.count()),
            record_words: layout.bank.record_words,
            buffer_words: layout.bank.buffer_words,
            edit: layout.bank.edit,
        },
        None => StoreDesign {
            contents: Contents::Corners(stage.landscape.bank().levels()[kind.level().unwrap_or(0)].corners()),
            record_words: drum.record_words,
            buffer_words: settings.data_banks.buffer_words,
            edit: settings.kind_banks.terrain_edit,
        },
    }
}
