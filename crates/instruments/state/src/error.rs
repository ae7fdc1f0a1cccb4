//! Why a state cannot be read, or is not that of the machine at hand.

use std::path::PathBuf;

use event_list::EventListError;
use files::FileError;
use generator::FrameError;
use scenario::PathProblems;

use crate::PlaceError;
use crate::container::{BlockKind, FORMAT, SCHEMA};

/// What to do about a damaged file.
const AGAIN: &str = "the file is damaged: take a whole copy, or save the state again";

/// What is wrong with a state.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Fault {
    /// The file is something else.
    #[error(
        "byte 0: found `{found}`, expected `LUNOSTAT`; this is no state: name a file that `lunoid state save` wrote"
    )]
    NotState {
        /// The first bytes, those that are no letters escaped.
        found: String,
    },
    /// The format is another.
    #[error(
        "byte 8: found format {found}, expected {FORMAT}; read it with the version of lunoid that wrote it, or save the state again"
    )]
    Format {
        /// Format that was found.
        found: u32,
    },
    /// The file is shorter or longer than it says.
    #[error("the file has {found} bytes, expected {expected}; {AGAIN}")]
    Length {
        /// Bytes of the file.
        found: u64,
        /// Bytes that it should have.
        expected: u64,
    },
    /// The content is not what was written.
    #[error("byte 32: found checksum {expected}…, the content has {found}…; {AGAIN}")]
    Checksum {
        /// Checksum of the content, its first half.
        found: String,
        /// Checksum in the file, its first half.
        expected: String,
    },
    /// A length in the file leads out of the file.
    #[error(
        "{part}: found a length of {found} bytes, expected at most {most}, which are left in the file; {AGAIN}"
    )]
    TooLong {
        /// Part of the file.
        part: String,
        /// Length that was found; the largest number for one that no number holds.
        found: u64,
        /// Bytes that are left.
        most: u64,
    },
    /// A part of the file says something else than expected.
    #[error("{part}: found {found}, expected {expected}; {AGAIN}")]
    Value {
        /// Part of the file.
        part: String,
        /// What stands in the file.
        found: String,
        /// What should stand there.
        expected: String,
    },
    /// The header is of another schema.
    #[error(
        "header: found schema `{found}`, expected `{SCHEMA}`; read it with the version of lunoid that wrote it, or save the state again"
    )]
    Schema {
        /// Schema that was found.
        found: String,
    },
    /// A store or picture has a value that is no number.
    #[error(
        "{block}, row {row}, value {value} (byte {byte}): found {found}, expected a finite number; {AGAIN}"
    )]
    NotFinite {
        /// The block of values.
        block: BlockName,
        /// Row of the block: a sweep of a store, a line of a picture.
        row: u64,
        /// Value of the row.
        value: u64,
        /// Where it stands in the file.
        byte: u64,
        /// What stands in the file.
        found: f32,
    },
    /// Another program wrote the state.
    #[error(
        "found a state by {found}, this is {expected}; read it with that program, or save the state again"
    )]
    Program {
        /// The program that wrote it.
        found: String,
        /// The program that reads it.
        expected: String,
    },
    /// The state is that of another machine or mission.
    #[error(transparent)]
    Other(Box<Other>),
    /// The place is none of the mission.
    #[error("header, place: found {0}; {AGAIN}")]
    Place(PlaceError),
    /// A line of the digital side is not what the machine comes to.
    #[error(
        "digital side, line {line}: found `{found}`, expected `{expected}`; the digital side follows from mission and place: save the state again"
    )]
    Digital {
        /// Line of the text, from 1.
        line: usize,
        /// Line that was found.
        found: String,
        /// Line that the machine comes to.
        expected: String,
    },
}

/// What tells a state from that of the machine at hand.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "found the state of another machine or mission: hash {found}… of the {what} ({}), expected {expected}… ({}); it was saved \
     with `lunoid state save {words}`: give the same scenario and options, as they were then",
    .machines[0], .machines[1]
)]
pub struct Other {
    /// Part whose hash differs.
    pub what: &'static str,
    /// Hash in the file.
    pub found: String,
    /// Hash of the machine at hand.
    pub expected: String,
    /// Names of both machines.
    pub machines: [String; 2],
    /// Words with which the state was saved.
    pub words: String,
}

/// Name of a block in messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BlockName {
    /// What the block holds.
    pub kind: BlockKind,
    /// Frame that wrote it, or in which it was read.
    pub frame: u64,
}

impl std::fmt::Display for BlockName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let what = match self.kind {
            BlockKind::Rows => "rows",
            BlockKind::Store => "store",
            BlockKind::Picture => "picture",
        };
        write!(f, "{what} of frame {}", self.frame)
    }
}

/// Why a state cannot be read, saved or gone on from.
#[derive(Debug, thiserror::Error)]
pub enum StateError {
    /// The file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// What the file holds is damaged, or of something else.
    #[error("{}: {fault}", .path.display())]
    Fault {
        /// Path of the file.
        path: PathBuf,
        /// What is wrong with it.
        fault: Box<Fault>,
    },
    /// There is no such place.
    #[error(transparent)]
    Place(#[from] PlaceError),
    /// A frame cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// The path cannot be driven.
    #[error(transparent)]
    Path(#[from] PathProblems),
    /// The registers of a place cannot be shown.
    #[error(transparent)]
    Registers(#[from] EventListError),
}
