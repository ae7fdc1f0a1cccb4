//! The digital side: processor, loader, data banks (hardware sections 2 and 4). Times are whole master ticks.

use serde::Serialize;
use sweep_program::{Colour, PreloadRegister};

/// Central processor (hardware section 2.1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Cpu {
    /// Time of one memory cycle (ticks).
    pub memory_cycle: u64,
    /// Banks of its memory that work side by side, words dealt out to them in turn: at least 1.
    pub memory_banks: u32,
    /// Time of one multiplication (ticks).
    pub multiply: u64,
    /// Recognition of an interrupt, saving and restoring the state.
    pub interrupt: u64,
    /// Longest instruction that no interrupt breaks.
    pub longest_instruction: u64,
    /// Instructions by which an interrupt moves the pointers of a crossing and returns.
    pub crossing_instructions: u32,
    /// Memory cycles of one of them: fetch and operand.
    pub instruction_cycles: u32,
    /// Multiplications among what an interrupt does for a crossing.
    pub crossing_multiplications: u32,
    /// Memory cycles that each word of a crossing takes of one bank where others bring it; 0 if the storage buffer is a
    /// memory of its own.
    pub dma_cycles_per_word: u32,
    /// Setting up one sweep.
    pub sweep_setup: u64,
    /// Visibility and tables of one frame.
    pub frame_tables: u64,
    /// Transformation and projection of one vertex of a polyhedron.
    pub vertex: u64,
    /// Priority levels of interrupts; any number if `None`. With one level a crossing waits until the set-up that runs is
    /// done, with more it interrupts it.
    pub priority_levels: Option<u32>,
}

/// Instructions and multiplications of one entry of the table of the sweeps' azimuths: sine and cosine by rotation of the
/// entry before, 16 moves and two additions (hardware section 4.6).
const ENTRY_INSTRUCTIONS: u32 = 18;
const ENTRY_MULTIPLICATIONS: u32 = 4;

/// The same of the reflectivity of one face of a polyhedron: two edges, their cross product (6 multiplications, 9 subtractions), its
/// product with the sun and with itself (6, 4 additions), root and division (4), albedo (1), and two moves a multiplication.
const FACE_INSTRUCTIONS: u32 = 47;
const FACE_MULTIPLICATIONS: u32 = 17;

/// The same of one place on a profile of remote shadow: 36 products of the polynomial and 12 of its functions with 36 additions,
/// the line of the sun (1, 1), the comparison, and two moves a multiplication.
const SHADOW_INSTRUCTIONS: u32 = 136;
const SHADOW_MULTIPLICATIONS: u32 = 49;

/// A processor that takes no time.
impl Default for Cpu {
    fn default() -> Self {
        Self {
            memory_cycle: 0,
            memory_banks: 1,
            multiply: 0,
            interrupt: 0,
            longest_instruction: 0,
            crossing_instructions: 0,
            instruction_cycles: 0,
            crossing_multiplications: 0,
            dma_cycles_per_word: 0,
            sweep_setup: 0,
            frame_tables: 0,
            vertex: 0,
            priority_levels: None,
        }
    }
}

impl Cpu {
    /// One crossing by interrupt, without its words: recognition, save and restore, and the instructions that move the
    /// pointers (hardware section 4.6).
    pub fn crossing(&self) -> u64 {
        self.interrupt + self.program(self.crossing_instructions, self.crossing_multiplications)
    }

    /// A table of sine and cosine with `entries` entries, made before the mission.
    pub fn sine_table(&self, entries: u32) -> u64 {
        u64::from(entries) * self.program(ENTRY_INSTRUCTIONS, ENTRY_MULTIPLICATIONS)
    }

    /// The reflectivity of one face of a polyhedron, made before the mission (inferred).
    pub fn face(&self) -> u64 {
        self.program(FACE_INSTRUCTIONS, FACE_MULTIPLICATIONS)
    }

    /// One place on a profile of remote shadow, made before the mission (inferred).
    pub fn shadow_place(&self) -> u64 {
        self.program(SHADOW_INSTRUCTIONS, SHADOW_MULTIPLICATIONS)
    }

    fn program(&self, instructions: u32, multiplications: u32) -> u64 {
        u64::from(instructions) * u64::from(self.instruction_cycles) * self.memory_cycle
            + u64::from(multiplications) * self.multiply
    }

    /// What `words` that others bring through its memory take from the processor. Of interleaved banks it meets that of
    /// the word in one cycle out of as many as there are banks: the mean, and what is left of a tick is a whole one (our
    /// choice).
    pub fn stolen(&self, words: u64) -> u64 {
        let cycles = words * u64::from(self.dma_cycles_per_word);
        (cycles * self.memory_cycle).div_ceil(u64::from(self.memory_banks))
    }

    /// Whether no interrupt breaks a set-up.
    pub fn has_one_level(&self) -> bool {
        self.priority_levels == Some(1)
    }

    /// Whether any task takes it time.
    pub fn is_timed(&self) -> bool {
        self.sweep_setup + self.frame_tables + self.vertex + self.stolen(1) > 0
    }
}

/// Who answers a fold with coefficient words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CrossingServer {
    /// Pointers in hardware, one buffer bank a colour.
    WiredPointers,
    /// An I/O processor, one request after another.
    IoProcessor,
    /// The central processor, by interrupt, one request after another.
    CpuInterrupt,
}

/// The path of coefficient words from storage buffer to register (section 6.3; hardware section 4.4).
#[derive(Debug, Clone, PartialEq)]
pub struct Loader {
    /// Unit that answers the crossings.
    pub served_by: CrossingServer,
    /// Words of a set that one access of the storage buffer brings, 1 to 9.
    pub words_per_access: u32,
    /// Time of one access of the storage buffer (ticks).
    pub access: u64,
    /// Pointer arithmetic of one set.
    pub pointer: u64,
    /// Channel programme of an I/O processor.
    pub io_processor: IoProcessor,
    /// Strobe of the words into their register.
    pub strobe: u64,
    /// Whether the set that the next stop of the other axis may need goes first.
    pub urgent_first: bool,
    /// Whether a third preload register holds the corner beyond both stops.
    pub diagonal_register: bool,
    /// Crossings of a sweep after which nothing is transferred any more; never if `None`. A fault, not a part.
    pub stop_after_crossings: Option<u32>,
    /// What happens to words that come after the transfer they were meant for.
    pub late_policy: LatePolicy,
    /// Single words held back on purpose, to see what a fault does.
    pub delays: Vec<LoadDelay>,
}

/// What an I/O processor does for a crossing beside pointers and accesses: a chain of commands, one a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct IoProcessor {
    /// The order that starts the chain, once a crossing.
    pub order: u64,
    /// Fetch of the next command of the chain, once a set.
    pub chain: u64,
    /// Rearranging one word on its way: half of a core word, sign.
    pub edit: u64,
}

impl Loader {
    /// The channel programme, if an I/O processor serves the crossings; otherwise it takes no time.
    pub fn channel_programme(&self) -> IoProcessor {
        match self.served_by {
            CrossingServer::IoProcessor => self.io_processor,
            CrossingServer::WiredPointers | CrossingServer::CpuInterrupt => IoProcessor::default(),
        }
    }

    /// Whether words are in their registers with the fold that asks for them.
    pub fn is_wired_through(&self) -> bool {
        self.served_by == CrossingServer::WiredPointers && self.access + self.pointer + self.strobe == 0
    }
}

/// What happens to words that miss their fold (hardware section 4.5).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LatePolicy {
    /// They go to the hold register as they arrive, word by word.
    StrobeThrough,
    /// The hold register keeps the stale words until the colour is transferred again.
    Latched,
}

/// One word held back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LoadDelay {
    /// Frame, or every frame.
    pub frame: Option<u64>,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// The fold that asks for the word, counted from 0 in the sweep; folds of both axes count.
    pub crossing: u32,
    /// Colour register that waits for the word.
    pub colour: Colour,
    /// Preload register of that colour.
    pub register: PreloadRegister,
    /// Word, `3 p + q`, 0..=8.
    pub word: usize,
    /// Master ticks it comes later.
    pub ticks: u64,
}

/// Data banks of one level: drums behind the storage buffer (hardware section 2.3).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Drum {
    /// Time of one revolution (ticks).
    pub rotation: u64,
    /// Master ticks to transfer one 16-bit word.
    pub word: f64,
    /// Words of one record: 9 are one corner, 9 n² a square of n x n corners.
    pub record_words: u32,
    /// Which request is served next.
    pub queue: DrumQueue,
    /// Drums that share the requests.
    pub count: u32,
}

/// Channels between the drums of one level and its storage buffer (hardware section 2.2). Drum `k` is on channel `k` mod
/// the number of channels, and a channel carries one record at a time. The default is no limit.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Channels {
    /// How many; every drum has its own if `None`.
    pub count: Option<u32>,
    /// Master ticks that one 16-bit word takes, at least.
    pub word: f64,
}

/// Queue discipline of a drum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DrumQueue {
    /// First come, first served.
    Fifo,
    /// The record that comes under the heads first.
    ShortestLatency,
}

/// What stands between the data banks and the registers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DataBanks {
    /// The drums of each level; all words are at hand if `None`.
    pub drum: Option<Drum>,
    /// The channels of each level's drums.
    pub channels: Channels,
    /// Words of the storage buffer of each level; any number if `None`.
    pub buffer_words: Option<u32>,
}

/// Where the data of one kind lie beside the terrain's finest level (report, figures 14 and 15; hardware section 4.7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BankPlace {
    /// All of them in a memory of their generator, loaded before the mission.
    #[default]
    Local,
    /// On drums of their own, of the design that terrain has.
    Apart,
    /// On the drums of the finest level, with its channels.
    Together,
}

/// The bank of one kind of data beside terrain: records, storage buffer, I/O processor. All that lies in a square of regions is
/// one chain of records.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct KindBank {
    /// Where the records lie.
    pub place: BankPlace,
    /// Words of one record.
    pub record_words: u32,
    /// Regions of the finest level along the side of a square.
    pub record_regions: u32,
    /// Words of the storage buffer; any number if `None`.
    pub buffer_words: Option<u32>,
    /// Master ticks that the I/O processor takes to edit one word.
    pub edit: f64,
}

/// Banks of all kinds of data beside the terrain's finest level.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct KindBanks {
    /// Whether the coarse level has drums of its own: [`BankPlace::Apart`] or [`BankPlace::Together`].
    pub coarse: BankPlace,
    /// Master ticks that the I/O processor of each level of terrain takes to edit one word.
    pub terrain_edit: f64,
    /// The bank of the craters' parameters.
    pub features: KindBank,
    /// The bank of the boundaries of shadow.
    pub shadows: KindBank,
    /// The bank of polyhedra: vertices and reflectivities of faces.
    pub polyhedra: KindBank,
}

impl KindBanks {
    /// Banks of features, of shadow boundaries, of polyhedra, with the tables of their keys.
    pub fn kinds(&self) -> [(&'static str, &KindBank); 3] {
        [
            ("feature_bank", &self.features),
            ("shadow_bank", &self.shadows),
            ("polyhedron_bank", &self.polyhedra),
        ]
    }

    /// Whether terrain alone has drums, each level its own, and nothing is edited.
    pub fn is_plain(&self) -> bool {
        self.coarse == BankPlace::Apart
            && self.terrain_edit == 0.0
            && self.kinds().iter().all(|(_, bank)| bank.place == BankPlace::Local)
    }
}
