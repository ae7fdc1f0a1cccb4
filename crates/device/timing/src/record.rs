//! What a run leaves behind about its digital side, frame by frame.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::EventHash;
use crate::deadline::{Deadline, Slack};
use crate::level_change::LevelChange;
use crate::missed::Missed;
use crate::task::Task;

/// Number of the file format; a file of another is refused. 2 has vertices, corners that are met, loads of features.
pub const FORMAT: u32 = 2;

/// Timing of the frames of one run. Given the same inputs it is the same to the bit, on any number of threads.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TimingRecord {
    /// Format number of the record: [`FORMAT`].
    pub format: u32,
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the hardware model.
    pub machine: String,
    /// Hash of everything that decides the result, as hexadecimal digits.
    pub inputs: String,
    /// Values of model, scenario and command line by their keys, as written. They name what differs where `inputs` does, and
    /// decide nothing by themselves. Empty in records of before 2026-11.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub keys: BTreeMap<String, String>,
    /// Master clock as a person writes it, such as `20000000 Hz`.
    pub master: String,
    /// What has to be done before frame 0, in the order in which it is; nothing in a machine that is ready at once. The key
    /// may be missing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub before_mission: Vec<Task>,
    /// Frames in rising order, at least one.
    pub frames: Vec<FrameTiming>,
}

/// Timing of one frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FrameTiming {
    /// Frame of the mission, from 0.
    pub frame: u64,
    /// Length of the frame (master ticks), at least 1.
    pub ticks: u64,
    /// Folds of both ramps in all sweeps (crossings of the hardware report, section 4.2).
    pub folds: u64,
    /// What became of the register sets.
    pub sets: Sets,
    /// Words that came after the stop they were meant for.
    pub late_words: u64,
    /// Counts of the vertices of polyhedra.
    pub vertices: Vertices,
    /// Slack of every kind of deadline that the machine has.
    pub deadlines: BTreeMap<Deadline, Slack>,
    /// Use of the units that the machine has, each named once.
    pub units: Vec<UnitUse>,
    /// What the units spend their time on, task by task in order, where their work is counted so; each task of a unit once.
    /// The key may be missing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tasks: Vec<Task>,
    /// Tiles of ground that are drawn at another level of detail than in the frame before, where the generator has levels. The
    /// key may be missing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub level_changes: Vec<LevelChange>,
    /// Deadlines that were not met, in order of sweep and time.
    pub misses: Vec<Missed>,
    /// Digital events of the frame.
    pub events: u64,
    /// [`crate::EventHash`] of their ordered list: 64 hexadecimal digits. Empty where totals alone are asked for; no record holds
    /// such a frame.
    pub events_blake3: String,
}

impl FrameTiming {
    /// The timing of a frame that is work without deadlines: its length is the time of all units together, at least 1 tick.
    pub fn of_work(frame: u64, units: Vec<UnitUse>, tasks: Vec<Task>, events: &EventHash) -> Self {
        let (events, events_blake3) = events.finish();
        Self {
            frame,
            ticks: units.iter().map(|unit| unit.busy).sum::<u64>().max(1),
            folds: 0,
            sets: Sets::default(),
            late_words: 0,
            vertices: Vertices::default(),
            deadlines: BTreeMap::new(),
            units,
            tasks,
            level_changes: Vec::new(),
            misses: Vec::new(),
            events,
            events_blake3,
        }
    }
}

/// Register sets of nine words, counted (hardware report, section 4.4).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sets {
    /// Number of sets asked for.
    pub wanted: u64,
    /// Brought to their register.
    pub loaded: u64,
    /// After the stop that transfers them.
    pub late: u64,
    /// Loaded, and overwritten unused.
    pub wasted: u64,
    /// Dropped before they were on their way, or on it.
    pub cancelled: u64,
}

/// Vertices of polyhedra that the frame shows (hardware report, section 4.6).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vertices {
    /// Of the bodies in view.
    pub asked: u64,
    /// Transformed and projected when the frame began, at most those asked for.
    pub ready: u64,
}

/// Use of one unit in one frame.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UnitUse {
    /// Name, block first: `cpu`, `loader.red`, `io-processor`, `drum.fine.0`.
    pub unit: String,
    /// Time at work (master ticks).
    pub busy: u64,
    /// Most requests that waited at one time.
    pub longest_queue: u32,
}

impl FrameTiming {
    /// Part of the frame in which `unit` is at work: 0 idle, 1 all the time; more if its work runs over.
    pub fn utilisation(&self, unit: &UnitUse) -> f64 {
        unit.busy as f64 / self.ticks as f64
    }
}
