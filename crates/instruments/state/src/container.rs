//! The file of a state: its parts, and how they are written. The page is docs/state-format.md.

use std::fmt;
use std::path::Path;
use std::sync::Arc;

use machine::{Memory, Sizes};
use serde::{Deserialize, Serialize};

use crate::decode::decode;
use crate::error::BlockName;
use crate::{Fault, Identity, Place, StateError};

/// What a file of a state begins with.
pub const MAGIC: &[u8; 8] = b"LUNOSTAT";
/// Format of the container.
pub const FORMAT: u32 = 1;
/// Schema of the header.
pub const SCHEMA: &str = "lunoid.state/1";
/// Bytes before the header, and what blocks are aligned to.
pub(crate) const LEAD: usize = 64;
/// Where the checksum stands.
pub(crate) const CHECKSUM: usize = 32;
/// Largest file that is read (bytes): the largest raster with the longest memory takes half of it.
const MOST_BYTES: u64 = 1 << 34;

/// The machine at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// What is said of it in words.
    pub head: Head,
    /// Registers, processor and data banks at the start of the sweep: lines of JSON.
    pub digital: String,
    /// What tubes and sweep memory hold: the rows, then stores, then pictures, ascending by frame.
    pub blocks: Vec<Block>,
}

/// Whose state it is, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct Head {
    /// Program, machine and mission.
    pub identity: Identity,
    /// Scenario and options with which it was saved.
    pub words: Vec<String>,
    /// Where the machine is.
    pub place: Place,
    /// Tick of the master clock at which the digital side sees the place.
    pub tick: u64,
    /// Time since the start of the mission (s).
    pub time_s: f64,
}

/// What a block holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum BlockKind {
    /// What the sweeps of the frame have written so far.
    Rows,
    /// What an earlier frame wrote, in a storage tube.
    Store,
    /// What was read in an earlier frame, on the picture tube.
    Picture,
}

/// Rows of values: linear reflectivity, without unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// What the block holds.
    pub kind: BlockKind,
    /// Frame that wrote it, or in which it was read.
    pub frame: u64,
    /// Number of rows: sweeps of a store, lines of a picture.
    pub rows: u64,
    /// Values of a row: cells of a sweep, columns of a picture.
    pub row: u64,
    /// All values, row by row.
    pub values: Arc<Vec<f32>>,
}

/// The header as it is written.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Header {
    pub schema: String,
    pub saved_by: Identity,
    pub words: Vec<String>,
    pub place: Place,
    pub tick: u64,
    pub time_s: f64,
    pub digital_bytes: u64,
    pub blocks: Vec<BlockHeader>,
}

/// A block as the header says it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BlockHeader {
    pub kind: BlockKind,
    pub frame: u64,
    pub rows: u64,
    pub values_a_row: u64,
}

impl fmt::Display for BlockHeader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = BlockName { kind: self.kind, frame: self.frame };
        write!(f, "{name}: {} x {} values", self.rows, self.values_a_row)
    }
}

impl Block {
    /// Its name in messages.
    pub(crate) fn name(&self) -> BlockName {
        BlockName { kind: self.kind, frame: self.frame }
    }

    pub(crate) fn header(&self) -> BlockHeader {
        BlockHeader { kind: self.kind, frame: self.frame, rows: self.rows, values_a_row: self.row }
    }
}

impl State {
    /// The state in the file at `path`.
    ///
    /// # Errors
    /// If it cannot be read, or is damaged.
    pub fn read(path: &Path) -> Result<Self, StateError> {
        let bytes = files::read_all(path, MOST_BYTES)?;
        Self::parse(&bytes).map_err(|fault| fault.of(path))
    }

    /// The state in the bytes of a file. No more is allocated than the bytes at hand ask for.
    ///
    /// # Errors
    /// The first fault, with place, what was found and what was expected.
    pub fn parse(bytes: &[u8]) -> Result<Self, Fault> {
        decode(bytes)
    }

    /// The bytes of its file: the same state gives the same bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let header = self.header();
        let values: usize = self.blocks.iter().map(|block| 4 * block.values.len()).sum();
        let text = LEAD + header.len() + self.digital.len();
        let mut bytes = Vec::with_capacity(text.next_multiple_of(LEAD) + values);
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&FORMAT.to_le_bytes());
        bytes.extend_from_slice(&(header.len() as u32).to_le_bytes());
        bytes.resize(LEAD, 0);
        bytes.extend_from_slice(header.as_bytes());
        bytes.extend_from_slice(self.digital.as_bytes());
        bytes.resize(text.next_multiple_of(LEAD), 0);
        for block in &self.blocks {
            bytes.extend(block.values.iter().flat_map(|value| value.to_le_bytes()));
        }
        let length = bytes.len() as u64;
        bytes[16..24].copy_from_slice(&length.to_le_bytes());
        seal(&mut bytes);
        bytes
    }

    /// Writes its file, whole or not at all.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), StateError> {
        let bytes = self.bytes();
        Ok(files::write_atomic(path, |out| out.write_all(&bytes))?)
    }

    fn header(&self) -> String {
        let Head { identity, words, place, tick, time_s } = self.head.clone();
        let header = Header {
            schema: SCHEMA.into(),
            saved_by: identity,
            words,
            place,
            tick,
            time_s,
            digital_bytes: self.digital.len() as u64,
            blocks: self.blocks.iter().map(Block::header).collect(),
        };
        serde_json::to_string_pretty(&header).expect("plain values") + "\n"
    }

    /// Its blocks of a kind.
    pub(crate) fn of(&self, kind: BlockKind) -> impl Iterator<Item = &Block> {
        self.blocks.iter().filter(move |block| block.kind == kind)
    }

    /// What tubes and sweep memory hold.
    pub(crate) fn memory(&self) -> Memory {
        let all = |kind| self.of(kind).map(|block| (block.frame, Arc::clone(&block.values))).collect();
        Memory {
            rows: self.of(BlockKind::Rows).flat_map(|block| block.values.iter().copied()).collect(),
            stores: all(BlockKind::Store),
            pictures: all(BlockKind::Picture),
        }
    }

    /// The blocks of a machine of `sizes` that remembers `memory` at the start of a sweep.
    pub(crate) fn blocks_of(memory: Memory, place: Place, sizes: Sizes) -> Vec<Block> {
        let cells = sizes.cells as u64;
        let rows = (BlockKind::Rows, place.frame, u64::from(place.sweep), cells, Arc::new(memory.rows));
        let stores = memory
            .stores
            .into_iter()
            .map(|(frame, values)| (BlockKind::Store, frame, u64::from(sizes.sweeps), cells, values));
        let [columns, lines] = sizes.pixels.map(|count| count as u64);
        let pictures = memory
            .pictures
            .into_iter()
            .map(|(frame, values)| (BlockKind::Picture, frame, lines, columns, values));
        let all = [rows].into_iter().chain(stores).chain(pictures);
        all.map(|(kind, frame, rows, row, values)| Block { kind, frame, rows, row, values }).collect()
    }
}

/// BLAKE3 of a file of a state, but for the place of its checksum.
pub(crate) fn checksum(bytes: &[u8]) -> [u8; 32] {
    let mut hasher = blake3::Hasher::new();
    hasher.update(&bytes[..CHECKSUM]).update(&bytes[LEAD..]);
    *hasher.finalize().as_bytes()
}

/// Puts in the checksum of the bytes.
pub(crate) fn seal(bytes: &mut [u8]) {
    let found = checksum(bytes);
    bytes[CHECKSUM..LEAD].copy_from_slice(&found);
}

impl Fault {
    /// The fault of the file at `path`.
    pub(crate) fn of(self, path: &Path) -> StateError {
        StateError::Fault { path: path.to_owned(), fault: Box::new(self) }
    }
}
