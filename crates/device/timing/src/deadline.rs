//! Deadlines of the digital side, and how much time was left to them.

use std::fmt;

use serde::{Deserialize, Serialize};

/// What has to be ready when (hardware report, sections 4.4, 4.6 and 4.7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Deadline {
    /// A register set is in its preload register before the stop that transfers it.
    Transfer,
    /// The program of a sweep is complete before the sweep starts.
    SweepSetUp,
    /// Tables and polyhedra of the next frame are ready before the frame ends.
    FrameTasks,
    /// The record of a corner is in the storage buffer before a register asks for it.
    Corner,
    /// The words of a crater are in its sub-generator before the sweep meets its edge.
    Feature,
    /// The words of a shadow boundary are in its line generator before the sweep crosses it.
    Segment,
}

impl Deadline {
    /// All kinds, in the order of records and tables.
    pub const ALL: [Self; 6] =
        [Self::Transfer, Self::SweepSetUp, Self::FrameTasks, Self::Corner, Self::Feature, Self::Segment];

    /// Its word in files and tables.
    pub fn word(self) -> &'static str {
        match self {
            Self::Transfer => "transfer",
            Self::SweepSetUp => "sweep-set-up",
            Self::FrameTasks => "frame-tasks",
            Self::Corner => "corner",
            Self::Feature => "feature",
            Self::Segment => "segment",
        }
    }
}

impl fmt::Display for Deadline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// Bins of a slack histogram: half of them for missed deadlines.
pub const BINS: usize = 16;
const LAST_BIN: usize = BINS - 1;

/// Where one bin ends and the next begins (master ticks): 0, and the powers of two nearest to 1, 10, ... 10^6 on
/// both sides. Bin `i` holds `EDGES[i - 1] <= slack < EDGES[i]`; the first and the last are open.
const EDGES: [i64; LAST_BIN] = [
    -(1 << 20),
    -(1 << 17),
    -(1 << 13),
    -(1 << 10),
    -(1 << 7),
    -(1 << 3),
    -1,
    0,
    1,
    1 << 3,
    1 << 7,
    1 << 10,
    1 << 13,
    1 << 17,
    1 << 20,
];

/// Slack of the deadlines of one kind: time from ready to due (master ticks), negative if missed. Ready in the very
/// tick in which it is due is met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Slack {
    /// Deadlines.
    pub count: u64,
    /// Those with negative slack.
    pub missed: u64,
    /// Least slack (master ticks); none without deadlines.
    #[serde(deserialize_with = "Option::deserialize")]
    pub least: Option<i64>,
    /// Deadlines by slack; see [`Slack::edges`]. Their sum is `count`, that of the first eight `missed`.
    pub bins: [u64; BINS],
}

impl Slack {
    /// Counts one deadline. What never became ready counts with the instant at which it was given up.
    pub fn add(&mut self, ticks: i64) {
        self.count += 1;
        self.missed += u64::from(ticks < 0);
        self.least = Some(self.least.map_or(ticks, |least| least.min(ticks)));
        self.bins[Self::bin_of(ticks)] += 1;
    }

    /// Adds the deadlines of `other`, in whatever order. Counts stay at the largest number rather than run over.
    pub fn merge(&mut self, other: &Self) {
        self.count = self.count.saturating_add(other.count);
        self.missed = self.missed.saturating_add(other.missed);
        self.least = self.least.into_iter().chain(other.least).min();
        for (bin, more) in self.bins.iter_mut().zip(other.bins) {
            *bin = bin.saturating_add(more);
        }
    }

    /// Edges of the bins (master ticks), rising: bin `i` holds `edges()[i - 1] <= slack < edges()[i]`, and the first
    /// and the last are open. 0 and the powers of two nearest to the decades from 1 to 10^6, on both sides.
    pub fn edges() -> [i64; LAST_BIN] {
        EDGES
    }

    /// The bin of a slack (master ticks).
    pub fn bin_of(ticks: i64) -> usize {
        EDGES.partition_point(|&edge| edge <= ticks)
    }

    /// What bin `bin` (0..[`BINS`]) holds, in words; the end of a stretch belongs to the next bin.
    pub(crate) fn bin_label(bin: usize) -> String {
        match bin {
            0 => format!("< {}", EDGES[0]),
            LAST_BIN => format!(">= {}", EDGES[LAST_BIN - 1]),
            _ => format!("{}..{}", EDGES[bin - 1], EDGES[bin]),
        }
    }

    /// Label and count of every bin, from the latest to the earliest: `< -1048576`, `-8..-1`, `>= 1048576`.
    pub fn histogram(&self) -> Vec<(String, f64)> {
        self.bins.iter().enumerate().map(|(bin, &count)| (Self::bin_label(bin), count as f64)).collect()
    }
}
