//! Deadlines of a generator, and how much time was left to them.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::fmt;

use serde::de::{Error, Unexpected};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Longest name of a deadline (bytes).
const LONGEST: usize = 24;

/// What has to be ready when: a name of the generator's own, of small letters, digits and hyphens, such as `transfer`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Deadline {
    /// The name, and zeros behind it.
    name: [u8; LONGEST],
}

/// Those of the hybrid machine (hardware report, sections 4.4, 4.6 and 4.7).
impl Deadline {
    /// A register set is in its preload register before the stop that transfers it.
    pub const TRANSFER: Self = Self::new("transfer");
    /// The program of a sweep is complete before the sweep starts.
    pub const SWEEP_SET_UP: Self = Self::new("sweep-set-up");
    /// Tables and polyhedra of the next frame are ready before the frame ends.
    pub const FRAME_TASKS: Self = Self::new("frame-tasks");
    /// The record of a corner is in the storage buffer before a register asks for it.
    pub const CORNER: Self = Self::new("corner");
    /// The words of a crater are in its sub-generator before the sweep meets its edge.
    pub const FEATURE: Self = Self::new("feature");
    /// The words of a shadow boundary are in its line generator before the sweep crosses it.
    pub const SEGMENT: Self = Self::new("segment");

    /// The records of a square of craters are in the storage buffer before the frame that can show them begins.
    pub const FEATURE_RECORD: Self = Self::new("feature-record");
    /// The same of the boundaries of shadow in a square.
    pub const SHADOW_RECORD: Self = Self::new("shadow-record");
    /// The same of the bodies in a square.
    pub const BODY_RECORD: Self = Self::new("body-record");

    /// All of them, in the order of records and tables.
    pub const HYBRID: [Self; 9] = [
        Self::TRANSFER,
        Self::SWEEP_SET_UP,
        Self::FRAME_TASKS,
        Self::CORNER,
        Self::FEATURE,
        Self::SEGMENT,
        Self::FEATURE_RECORD,
        Self::SHADOW_RECORD,
        Self::BODY_RECORD,
    ];
}

impl Deadline {
    /// The deadline of this name.
    ///
    /// # Panics
    /// If that is no name: a constant does not compile then.
    pub const fn new(name: &str) -> Self {
        match Self::named(name) {
            Some(deadline) => deadline,
            None => panic!("a name has 1 to 24 small letters, digits and hyphens"),
        }
    }

    /// The deadline of this name; nothing if it has not 1 to 24 small letters, digits and hyphens.
    pub const fn named(name: &str) -> Option<Self> {
        let (written, mut kept, mut index) = (name.as_bytes(), [0; LONGEST], 0);
        if written.is_empty() || written.len() > LONGEST {
            return None;
        }
        while index < written.len() {
            if !matches!(written[index], b'a'..=b'z' | b'0'..=b'9' | b'-') {
                return None;
            }
            kept[index] = written[index];
            index += 1;
        }
        Some(Self { name: kept })
    }

    /// Its word in files and tables.
    pub fn word(&self) -> &str {
        let end = self.name.iter().position(|byte| *byte == 0).unwrap_or(LONGEST);
        str::from_utf8(&self.name[..end]).expect("letters, digits and hyphens")
    }

    /// Its place in records: those of the hybrid machine first, others behind them by name.
    fn place(&self) -> usize {
        Self::HYBRID.iter().position(|deadline| deadline == self).unwrap_or(Self::HYBRID.len())
    }
}

impl Ord for Deadline {
    fn cmp(&self, other: &Self) -> Ordering {
        self.place().cmp(&other.place()).then_with(|| self.name.cmp(&other.name))
    }
}

impl PartialOrd for Deadline {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Debug for Deadline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

impl fmt::Display for Deadline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

impl Serialize for Deadline {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word())
    }
}

impl<'de> Deserialize<'de> for Deadline {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = Cow::<str>::deserialize(deserializer)?;
        let wrong = || {
            Error::invalid_value(
                Unexpected::Str(&name),
                &"a deadline: 1 to 24 small letters, digits, hyphens",
            )
        };
        Self::named(&name).ok_or_else(wrong)
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
    /// Number of deadlines of the kind.
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
