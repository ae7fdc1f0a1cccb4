//! One deadline that was not met, with all that leads from a fault in the picture to its cause.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::deadline::Deadline;

/// A deadline that was missed, with all that is known of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Missed {
    /// Kind of the deadline.
    pub deadline: Deadline,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// The fold that found it missing, counted from 0 in the sweep.
    #[serde(deserialize_with = "Option::deserialize")]
    pub crossing: Option<u32>,
    /// Colour whose registers wait: `yellow`, `green`, `black`, `red`.
    #[serde(deserialize_with = "Option::deserialize")]
    pub colour: Option<String>,
    /// Preload register of that colour: `x-first`, `y-first`.
    #[serde(deserialize_with = "Option::deserialize")]
    pub register: Option<String>,
    /// What else waits: `sub-generator.2.0`, the first of type 2; `line-generator`.
    #[serde(deserialize_with = "Option::deserialize")]
    pub part: Option<String>,
    /// Crater, as an index into those of the ground.
    #[serde(deserialize_with = "Option::deserialize")]
    pub crater: Option<u32>,
    /// Lattice corner, or south-west region of a square: north index and east index.
    #[serde(deserialize_with = "Option::deserialize")]
    pub region: Option<[i64; 2]>,
    /// Ground range of the fold, of the crater's edge or of the shadow's; none of a square (m).
    #[serde(deserialize_with = "Option::deserialize")]
    pub range_m: Option<f64>,
    /// When it was due (sweep clock, samples).
    pub due: f64,
    /// When it came (sweep clock, samples); none if never.
    #[serde(deserialize_with = "Option::deserialize")]
    pub came: Option<f64>,
    /// The words concerned: bit `3 p + q` of a corner, the first 8 bits for a crater, 4 for a boundary.
    pub words: u16,
    /// Reason why it was missed.
    pub cause: Cause,
}

impl Missed {
    /// A deadline of the start of a sweep, of which no more is known: a task of the processor.
    pub fn of(deadline: Deadline, sweep: u32, cause: Cause) -> Self {
        Self {
            deadline,
            sweep,
            crossing: None,
            colour: None,
            register: None,
            part: None,
            crater: None,
            region: None,
            range_m: None,
            due: 0.0,
            came: None,
            words: 0,
            cause,
        }
    }
}

/// Why a deadline was missed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cause {
    /// One load by itself takes longer than the time there was.
    Access,
    /// It waited for other loads.
    Queue,
    /// The central processor was busy or too slow.
    Processor,
    /// The drum had not brought the record.
    Drum,
    /// No part was free to take it.
    Occupied,
    /// The model holds this word back on purpose.
    HeldBack,
}

impl Cause {
    /// All causes, in the order of tables.
    pub const ALL: [Self; 6] =
        [Self::Access, Self::Queue, Self::Processor, Self::Drum, Self::Occupied, Self::HeldBack];

    /// Its word in files and tables.
    pub fn word(self) -> &'static str {
        match self {
            Self::Access => "access",
            Self::Queue => "queue",
            Self::Processor => "processor",
            Self::Drum => "drum",
            Self::Occupied => "occupied",
            Self::HeldBack => "held-back",
        }
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

impl Missed {
    /// How late it came (sweep clock, samples); none if never.
    pub fn lateness(&self) -> Option<f64> {
        Some(self.came? - self.due)
    }
}
