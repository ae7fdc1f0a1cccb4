//! Pieces of work that are told one by one: what has to be done before the mission begins, and the steps of a frame.

use serde::{Deserialize, Serialize};

use crate::record::TimingRecord;

/// One task of a unit, before frame 0 or in a frame.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Task {
    /// Who does it, block first, as in [`UnitUse`](crate::UnitUse): `cpu`, `drum.fine`.
    pub unit: String,
    /// What, in one word: `sine-table`, `first-sector`; of a frame `slopes`, `plotting`.
    pub task: String,
    /// Pieces of it: entries, records, sets, vertices, pulses, points; at least 1.
    pub pieces: u64,
    /// Time it takes (master ticks), at least 1.
    pub ticks: u64,
}

impl TimingRecord {
    /// When the machine is ready (master ticks from when it is switched on): the tasks before the mission one after another,
    /// our choice. Sums stay at the largest number rather than run over.
    pub fn ready_after(&self) -> u64 {
        self.before_mission.iter().fold(0, |sum, task| sum.saturating_add(task.ticks))
    }
}
