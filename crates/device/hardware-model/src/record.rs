//! Settings of the hybrid machine for the record of a run: units in the keys, clocks as exact fractions.

use std::collections::BTreeMap;

use quantities::Timebase;
use scenario::{RangeLaw, RangeProgramme, Scalar};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::{
    CrossingServer, Economy, FeatureParts, Gate, LatePolicy, LevelTurn, LoadDelay, Loader, MixingParts,
    Organisation, Settings, ShadowParts, SweepMemoryKind,
};

/// Everything that decides a picture of the hybrid machine beside ground, light, view and pose.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MachineRecord {
    /// Scalar type of the analog signals: "f32" or "f64".
    pub scalar: String,
    /// Sweeps and their samples.
    pub raster: SweepRecord,
    /// Clocks of the machine.
    pub clocks: ClockRecord,
    /// Ground-range programme by key.
    pub range: BTreeMap<String, Value>,
    /// Central processor, times in ticks of the master clock.
    pub cpu_ticks: Value,
    /// Delivery of coefficient words.
    pub loader: LoaderRecord,
    /// Drums and storage buffers, times in ticks of the master clock.
    pub data_banks_ticks: Value,
    /// Banks of the other kinds of data, times in ticks of the master clock; none where each kind lies in a memory of its generator.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kind_banks_ticks: Option<Value>,
    /// Words a second that reach the sub-generators of the feature generator; none where it is any number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub feature_words_a_second: Option<f64>,
    /// Words a second that reach the line generators of the shadow controller; none where it is any number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub segment_words_a_second: Option<f64>,
    /// What the processor does about far ground while the vehicle turns, in rad/s and as a share; none where it does nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub level_turn: Option<Value>,
    /// The analog side in SI units.
    pub analog_si: Value,
    /// Seed of part-to-part spread and noise.
    pub seed: u64,
    /// Kind of sweep memory.
    pub sweep_memory: String,
    /// Parts of the blocks beside the terrain path; a number that is not there is "any".
    pub blocks: BlocksRecord,
    /// What may be left out.
    pub economy: String,
}

/// Sweeps of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct SweepRecord {
    /// Number of sweeps a frame.
    pub sweeps: u32,
    /// Samples drawn in one sweep.
    pub samples_per_sweep: u32,
}

/// Clocks. Rates are whole numbers or fractions of hertz, in words such as `10000000 Hz`: a float would round them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClockRecord {
    /// Master clock of the digital side.
    pub master: String,
    /// Samples a second, as a rate in words.
    pub sample: String,
    /// Samples that are drawn in one sweep.
    pub active_samples: u32,
    /// Samples of retrace in one sweep.
    pub retrace_samples: u32,
}

/// Delivery of coefficient words; times in ticks of the master clock.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LoaderRecord {
    /// Who answers the folds.
    pub served_by: String,
    /// Words of a set that one access brings.
    pub words_per_access: u32,
    /// Time of one access (ticks).
    pub access_ticks: u64,
    /// Pointer arithmetic of one set.
    pub pointer_ticks: u64,
    /// Channel programme of an I/O processor.
    pub io_processor_ticks: Value,
    /// Strobe of the words into their register.
    pub strobe_ticks: u64,
    /// Whether the set that the next stop of the other axis may need goes first.
    pub urgent_first: bool,
    /// Whether a third preload register holds the corner beyond both stops.
    pub diagonal_register: bool,
    /// Crossings of a sweep after which nothing is transferred any more.
    pub stop_after_crossings: Option<u32>,
    /// What happens to words that come late.
    pub late_policy: String,
    /// Single words held back.
    pub delay: Vec<DelayRecord>,
}

/// A word that is held back.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct DelayRecord {
    /// Frame, or every frame.
    pub frame: Option<u64>,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// The fold that asks for the word, counted from 0 in the sweep.
    pub crossing: u32,
    /// Colour register that waits for the word.
    pub colour: String,
    /// Preload register of that colour.
    pub register: String,
    /// Orders of the derivatives to the north and to the east.
    pub word: [usize; 2],
    /// Ticks that it comes later.
    pub ticks: u64,
}

/// Parts of the blocks beside the terrain path.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BlocksRecord {
    /// Parts of the feature generator.
    pub feature_generator: FeatureRecord,
    /// Parts of the shadow controller.
    pub shadow_controller: ShadowRecord,
    /// Parts of the mixing unit.
    pub mixing_unit: MixingRecord,
}

/// Parts of the feature generator.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FeatureRecord {
    /// Which sub-generator takes which crater.
    pub organisation: String,
    /// Sub-generators; any number if `None`.
    pub sub_generators: Option<u32>,
}

/// Shadow controller, by its variant.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "variant", rename_all = "kebab-case")]
pub enum ShadowRecord {
    /// Line generators make the shadow gate.
    Digital {
        /// How many; any number if `None`.
        line_generators: Option<u32>,
    },
    /// A scan converter holds the boundaries as a map.
    ScanConverter {
        /// Displacement of the reading, north and east, as a share of the map's side.
        offset_share: [f64; 2],
        /// Error of the reading's scale, as a share.
        gain_share: f64,
    },
}

/// Parts of the mixing unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MixingRecord {
    /// What opens the first video switch.
    pub gate: String,
    /// Threshold of the gate.
    pub threshold: f64,
}

impl MachineRecord {
    /// The record of `settings`. What all generators are asked for stands in the record of the view. The place where shadow boundaries
    /// are kept is left out: it changes no picture.
    pub fn of(settings: &Settings) -> Self {
        // Taken apart, so that no setting is forgotten.
        let Settings {
            raster,
            timebase,
            range,
            laws: _,
            scalar,
            display: _,
            cpu,
            level_turn,
            loader,
            data_banks,
            kind_banks,
            seed,
            sweep_memory,
            feature_generator,
            shadow_controller,
            mixing_unit,
            feature_words,
            segment_words,
            analog,
            yoke: _,
            levels: _,
            shadows: _,
            shadow_cache: _,
            economy,
        } = settings;
        let scalar = match scalar {
            Scalar::F32 => "f32",
            Scalar::F64 => "f64",
        };
        let sweep_memory = match sweep_memory {
            SweepMemoryKind::ScanConverter => "scan-converter",
            SweepMemoryKind::DigitalMemory => "digital-memory",
        };
        let economy = match economy {
            Economy::Normal => "normal",
            Economy::Bounded => "bounded",
            Economy::Instants(_) => "preview",
            Economy::Lossless | Economy::LosslessBut(_) => "lossless",
            Economy::Everything => "everything",
        };
        Self {
            scalar: scalar.into(),
            raster: SweepRecord { sweeps: raster.sweeps, samples_per_sweep: raster.samples },
            clocks: ClockRecord::of(timebase),
            range: programme(range),
            cpu_ticks: json!(cpu),
            loader: LoaderRecord::of(loader),
            data_banks_ticks: json!(data_banks),
            kind_banks_ticks: (!kind_banks.is_plain()).then(|| json!(kind_banks)),
            feature_words_a_second: *feature_words,
            segment_words_a_second: *segment_words,
            level_turn: (*level_turn != LevelTurn::NEVER).then(|| json!(level_turn)),
            analog_si: json!(analog),
            seed: *seed,
            sweep_memory: sweep_memory.into(),
            blocks: BlocksRecord {
                feature_generator: FeatureRecord::of(feature_generator),
                shadow_controller: ShadowRecord::of(shadow_controller),
                mixing_unit: MixingRecord::of(mixing_unit),
            },
            economy: economy.into(),
        }
    }
}

impl SweepRecord {
    /// Sweeps and samples as plain counts.
    pub fn counts(&self) -> [u64; 2] {
        [self.sweeps, self.samples_per_sweep].map(u64::from)
    }
}

impl ClockRecord {
    fn of(clocks: &Timebase) -> Self {
        Self {
            master: clocks.master.to_string(),
            sample: clocks.sample_rate().to_string(),
            active_samples: clocks.active_samples,
            retrace_samples: clocks.retrace_samples,
        }
    }
}

impl LoaderRecord {
    fn of(loader: &Loader) -> Self {
        let served_by = match loader.served_by {
            CrossingServer::WiredPointers => "wired-pointers",
            CrossingServer::IoProcessor => "io-processor",
            CrossingServer::CpuInterrupt => "cpu-interrupt",
        };
        let late_policy = match loader.late_policy {
            LatePolicy::StrobeThrough => "strobe-through",
            LatePolicy::Latched => "latched",
        };
        Self {
            served_by: served_by.into(),
            words_per_access: loader.words_per_access,
            access_ticks: loader.access,
            pointer_ticks: loader.pointer,
            io_processor_ticks: json!(loader.io_processor),
            strobe_ticks: loader.strobe,
            urgent_first: loader.urgent_first,
            diagonal_register: loader.diagonal_register,
            stop_after_crossings: loader.stop_after_crossings,
            late_policy: late_policy.into(),
            delay: loader.delays.iter().map(DelayRecord::of).collect(),
        }
    }
}

impl DelayRecord {
    fn of(delay: &LoadDelay) -> Self {
        Self {
            frame: delay.frame,
            sweep: delay.sweep,
            crossing: delay.crossing,
            colour: format!("{:?}", delay.colour).to_lowercase(),
            register: format!("{:?}", delay.register).to_lowercase(),
            word: [delay.word / 3, delay.word % 3],
            ticks: delay.ticks,
        }
    }
}

impl FeatureRecord {
    fn of(parts: &FeatureParts) -> Self {
        let organisation = match parts.organisation {
            Organisation::ByRegion => "by-region",
            Organisation::Scheduled => "scheduled",
        };
        Self { organisation: organisation.into(), sub_generators: parts.sub_generators }
    }
}

impl ShadowRecord {
    fn of(parts: &ShadowParts) -> Self {
        match *parts {
            ShadowParts::Digital { line_generators } => Self::Digital { line_generators },
            ShadowParts::ScanConverter { offset, gain } => {
                Self::ScanConverter { offset_share: offset, gain_share: gain }
            }
        }
    }
}

impl MixingRecord {
    fn of(parts: &MixingParts) -> Self {
        let gate = match parts.gate {
            Gate::Presence => "presence",
            Gate::SelfKeyed => "self-keyed",
        };
        Self { gate: gate.into(), threshold: parts.threshold }
    }
}

fn programme(programme: &RangeProgramme) -> BTreeMap<String, Value> {
    let (word, more) = match programme.law {
        RangeLaw::ConstantRate => ("constant-rate", None),
        RangeLaw::TwoRate { switch, fine_share } => ("two-rate", Some((switch, fine_share))),
        RangeLaw::ConstantElevation => ("constant-elevation", None),
        RangeLaw::Geometric => ("geometric", None),
    };
    let ends =
        [("programme", word.into()), ("start_m", programme.start.into()), ("end_m", programme.end.into())];
    let more = more.into_iter().flat_map(|(switch, fine_share)| {
        [("switch_m", Value::from(switch)), ("fine_share", fine_share.into())]
    });
    ends.into_iter().chain(more).map(|(key, value)| (key.to_owned(), value)).collect()
}
