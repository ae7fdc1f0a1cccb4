//! What the generator runs on, as `hardware-models/programs/smooth-faces.toml` has it: real-time computer, transfer, geometry, slots, scan.

use diagnostics::{ProblemList, Reader, TomlFile};
use serde_json::{Value, json};

/// The file as the program carries it.
pub(crate) const SHIPPED: &str = include_str!("../../../../hardware-models/programs/smooth-faces.toml");

/// Name of the file that ships, for messages.
pub(crate) const FILE: &str = "built-in programs/smooth-faces.toml";

/// Tables of the file.
pub(crate) const TABLES: [&str; 5] = ["rt", "transfer", "geometry", "edges", "scan"];

/// Nanoseconds in a microsecond.
const MICROSECOND: f64 = 1e3;

/// Most slots of a memory (chosen).
const MOST_SLOTS: u32 = 1_000_000;

/// Times, slots and habits of the generator; times are whole nanoseconds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hardware {
    /// The real-time computer that all channels share.
    pub rt: RealTime,
    /// Words in a second that go from the active data base, 1 or more.
    pub transfer_words_s: u64,
    /// Time for a vertex that is transformed (ns).
    pub vertex_ns: u64,
    /// Time for a face that is tested, or for a triangle that a face is cut into (ns).
    pub face_ns: u64,
    /// Edges in view of a frame; `None` is without limit.
    pub edges_frame: Option<u32>,
    /// Pieces that a scan line holds; `None` is without limit.
    pub edges_line: Option<u32>,
    /// Time of a sample of a scan line (ns).
    pub sample_ns: u64,
    /// Whether a level of detail is added to what it is laid upon; else it replaces that.
    pub adds_levels: bool,
    /// Frames from a pose to its picture.
    pub delay_frames: u32,
}

/// The real-time computer; times are whole nanoseconds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RealTime {
    /// Time of each frame that it has for lists (ns).
    pub spare_ns: u64,
    /// Time of an instruction (ns).
    pub instruction_ns: u64,
    /// Time of a multiplication (ns).
    pub multiply_ns: u64,
    /// Time of a word that goes to the image processor (ns).
    pub word_ns: u64,
    /// Frames by which each step of a sequence comes too late.
    pub late_frames: u32,
    /// Number of the sun vector that never changes, from 1; 0 is none.
    pub dead_sun: u32,
}

/// Instructions of a look-up in a table (chosen).
const LOOK_UP: u64 = 3;
/// Instructions of a pointer: it counts, compares, goes on, stores (chosen).
const POINTER: u64 = 4;
/// Look-ups, multiplications and words of a sun vector (specification, section 11).
const SUN: [u64; 3] = [2, 4, 3];
/// The same of a body: sine and cosine of three angles, sixteen products of its turn (chosen); twelve words (specification, section 11).
const BODY: [u64; 3] = [6, 16, 12];
/// The same of a normal (specification, section 11).
const NORMAL: [u64; 3] = [1, 0, 3];
/// The same of a pointer, beside its instructions: the word that says which member shows (chosen).
const STEP: [u64; 3] = [0, 0, 1];

/// What the real-time computer does for a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// The pointer of a sequence goes on.
    Sequence,
    /// The sun vector of a list is turned.
    Sun,
    /// The frame of a body that moves is worked out.
    Body,
    /// A normal of a sea is looked up.
    Normal,
}

impl Kind {
    /// All kinds, in the order in which the computer takes them (specification, section 11).
    pub const ALL: [Self; 4] = [Self::Sequence, Self::Sun, Self::Body, Self::Normal];

    /// Its word in records.
    pub fn word(self) -> &'static str {
        ["sequence", "sun-vector", "body", "normals"][self as usize]
    }

    /// The task of a record that counts its pieces.
    pub fn task(self) -> &'static str {
        ["sequences", "sun-vectors", "bodies", "normals"][self as usize]
    }

    fn cost(self) -> [u64; 3] {
        [STEP, SUN, BODY, NORMAL][self as usize]
    }

    /// Words that go to the image processor of each channel for one piece.
    pub fn words(self) -> u64 {
        self.cost()[2]
    }
}

impl RealTime {
    /// Time for one piece of a kind for so many channels (ns): it is worked out once, and its words go to each.
    pub fn piece_ns(&self, kind: Kind, channels: u32) -> u64 {
        self.once_ns(kind) + u64::from(channels) * self.words_ns(kind)
    }

    /// Its part that is done once for all channels (ns).
    fn once_ns(&self, kind: Kind) -> u64 {
        let [look_ups, products, _] = kind.cost();
        let own = if kind == Kind::Sequence { POINTER } else { 0 };
        (own + look_ups * LOOK_UP) * self.instruction_ns + products * self.multiply_ns
    }

    /// Its part that is done for each channel (ns).
    pub fn words_ns(&self, kind: Kind) -> u64 {
        kind.words() * self.word_ns
    }
}

impl Hardware {
    /// The figures of the file that ships.
    ///
    /// # Errors
    /// Every fault of it: a program that carries a faulty one.
    pub fn shipped() -> Result<Self, ProblemList> {
        TomlFile::read_text(FILE, SHIPPED, Self::read)
    }

    /// What decides pictures, for the record of a run.
    pub(crate) fn record(&self) -> Value {
        let microseconds = |ns: u64| ns as f64 / MICROSECOND;
        json!({
            "spare_us": microseconds(self.rt.spare_ns),
            "instruction_us": microseconds(self.rt.instruction_ns),
            "multiply_us": microseconds(self.rt.multiply_ns),
            "word_us": microseconds(self.rt.word_ns),
            "late_frames": self.rt.late_frames,
            "dead_sun": self.rt.dead_sun,
            "edges_frame": self.edges_frame.unwrap_or(0),
            "edges_line": self.edges_line.unwrap_or(0),
            "adds_levels": self.adds_levels,
            "delay_frames": self.delay_frames,
        })
    }

    /// The figures of the five tables; every key is needed.
    pub(crate) fn read(root: &Reader) -> Option<Self> {
        let [rt, transfer, geometry, edges, scan] = TABLES.map(|name| root.table_or_empty(name));
        let rt = real_time(&rt);
        let words = transfer.f64("words_s").between(1.0, 1e12).unit("1/s").must("a whole number", is_whole);
        let words = words.required();
        let [vertex, face] = ["vertex_us", "face_us"].map(|key| time(&geometry, key, 0.0));
        let [frame, line] = ["edges_frame", "edges_line"].map(|key| slots(&edges, key));
        let sample = scan.f64("sample_ns").between(1.0, 1e6).unit("ns").must("a whole number", is_whole);
        let sample = sample.required();
        let adds_levels = scan.bool("adds_levels").required();
        let delay = scan.u32("delay_frames").at_most(1000).unit("frames").required();
        Some(Self {
            rt: rt?,
            transfer_words_s: words? as u64,
            vertex_ns: vertex?,
            face_ns: face?,
            edges_frame: frame?,
            edges_line: line?,
            sample_ns: sample? as u64,
            adds_levels: adds_levels?,
            delay_frames: delay?,
        })
    }
}

fn real_time(table: &Reader) -> Option<RealTime> {
    // A spare time of nothing would leave a record without a scale.
    let spare = time(table, "spare_us", 1.0);
    let [instruction, multiply, word] =
        ["instruction_us", "multiply_us", "word_us"].map(|key| time(table, key, 0.001));
    let late = table.u32("late_frames").at_most(1000).unit("frames").required();
    let dead = table.u32("dead_sun").help("0 is none").required();
    Some(RealTime {
        spare_ns: spare?,
        instruction_ns: instruction?,
        multiply_ns: multiply?,
        word_ns: word?,
        late_frames: late?,
        dead_sun: dead?,
    })
}

fn is_whole(number: &f64) -> bool {
    number.fract() == 0.0
}

/// A time in microseconds, from a least one to a second, as nanoseconds.
fn time(table: &Reader, key: &str, least: f64) -> Option<u64> {
    let time = table.f64(key).between(least, 1e6).unit("µs").required()?;
    Some((time * MICROSECOND).round() as u64)
}

/// Slots of a memory; 0 is without limit.
fn slots(table: &Reader, key: &str) -> Option<Option<u32>> {
    let slots = table.u32(key).at_most(MOST_SLOTS).help("0 is without limit").required()?;
    Some((slots > 0).then_some(slots))
}
