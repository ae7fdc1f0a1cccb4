//! A plan as meant: what its samples are drawn from.

use std::path::{Path, PathBuf};

use front_door::Wishes;
use replay::TruthItems;

use crate::draws::{Counter, Draw, between};
use crate::{Split, Splits};

/// Name of the draw that decides the split of a sample.
const SPLIT: &str = "split";
/// Name of the draw of the frame.
const FRAME: &str = "frame";

/// What a data set is drawn from.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// File of the plan.
    pub path: PathBuf,
    /// Bytes of the file.
    pub text: Vec<u8>,
    /// Title of the data set in a few words.
    pub title: String,
    /// What the data set is for, in a sentence or two.
    pub about: String,
    /// Licence of the samples, as an SPDX expression.
    pub licence: String,
    /// Path of the file with its text, from the folder of the plan.
    pub licence_file: Option<String>,
    /// Seed of all draws.
    pub seed: u64,
    /// Samples of each combination of scenario, machine and fault.
    pub draws: u64,
    /// Paths of the scenarios, from the folder of the plan.
    pub scenarios: Vec<String>,
    /// Names of the machines; a path starts at the folder of the scenario.
    pub machines: Vec<String>,
    /// Faults of the machines; one without overlay and draws is a healthy machine.
    pub faults: Vec<Fault>,
    /// Planes of truth that a sample has.
    pub truth: Option<TruthItems>,
    /// Counters that a sample has among its labels.
    pub counters: Vec<String>,
    /// Whether each sample is compared with the picture of the healthy machine.
    pub compare: bool,
    /// Keys that all samples have set, with their values.
    pub set: Vec<(String, String)>,
    /// Keys that are drawn.
    pub keys: Vec<KeyDraw>,
    /// Where the vehicle may be.
    pub pose: PoseDraws,
    /// Blocks of ground and shares.
    pub splits: Splits,
}

/// A key that is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyDraw {
    /// Key, as `--set` takes it.
    pub key: String,
    /// Values that it is drawn from.
    pub draw: Draw,
}

/// A fault of the machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// Name, which the samples have as a label.
    pub name: String,
    /// Overlay over the machine: the name of one that ships, or a path from the folder of the plan.
    pub overlay: Option<String>,
    /// Keys by which its size is drawn.
    pub keys: Vec<KeyDraw>,
}

impl Fault {
    /// Whether nothing is wrong with the machine.
    pub fn is_none(&self) -> bool {
        self.overlay.is_none() && self.keys.is_empty()
    }
}

/// Ranges that poses are drawn from.
#[derive(Debug, Clone, PartialEq)]
pub struct PoseDraws {
    /// North of the origin (m).
    pub x_m: [f64; 2],
    /// East of the origin (m).
    pub y_m: [f64; 2],
    /// Clockwise from north (degrees).
    pub heading_deg: [f64; 2],
    /// How it flies; the vehicle stands on its wheels if left out.
    pub flight: Option<FlightDraws>,
    /// First and last frame whose time the sample has.
    pub frames: [u64; 2],
}

/// Ranges that heights and attitudes of a vehicle that flies are drawn from.
#[derive(Debug, Clone, PartialEq)]
pub struct FlightDraws {
    /// Eye above the tangent plane (m).
    pub z_m: [f64; 2],
    /// Pitch, nose up (degrees).
    pub pitch_deg: [f64; 2],
    /// Roll, starboard down (degrees).
    pub roll_deg: [f64; 2],
}

/// Which scenario, machine and fault a sample has: their places in the lists of the plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Combination {
    /// Its place in [`Plan::scenarios`].
    pub scenario: usize,
    /// Its place in [`Plan::machines`].
    pub machine: usize,
    /// Its place in [`Plan::faults`].
    pub fault: usize,
}

/// What a sample is to be, before there is ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// Number of the sample.
    pub sample: u64,
    /// Scenario, machine and fault.
    pub of: Combination,
    /// What the sample is for.
    pub split: Split,
    /// Frame whose time the sample has.
    pub frame: u64,
    /// Keys that were drawn, with their values; those of the fault come last.
    pub drawn: Vec<(String, String)>,
    /// Number of those that the healthy machine has too.
    pub healthy: usize,
}

impl Plan {
    /// Number of combinations of scenario, machine and fault.
    pub fn combinations(&self) -> u64 {
        (self.scenarios.len() * self.machines.len() * self.faults.len()) as u64
    }

    /// Number of all samples.
    pub fn samples(&self) -> u64 {
        self.combinations() * self.draws
    }

    /// All combinations; that of sample n is at n modulo their number. The fault changes first, the scenario last.
    pub fn all(&self) -> impl Iterator<Item = Combination> + '_ {
        (0..self.combinations()).map(|number| self.combination(number))
    }

    /// The combination of sample `sample`.
    pub fn combination(&self, sample: u64) -> Combination {
        let number = (sample % self.combinations()) as usize;
        let (rest, fault) = (number / self.faults.len(), number % self.faults.len());
        Combination { scenario: rest / self.machines.len(), machine: rest % self.machines.len(), fault }
    }

    /// The split of sample `sample`, which is drawn before its place.
    pub fn split(&self, sample: u64) -> Split {
        self.splits.of_share(self.counter(sample, 0).share(SPLIT))
    }

    /// What sample `sample` is to be.
    pub fn wanted(&self, sample: u64) -> Wanted {
        let (of, counter) = (self.combination(sample), self.counter(sample, 0));
        let value = |KeyDraw { key, draw }: &KeyDraw| (key.clone(), draw.value(counter, key));
        let drawn: Vec<_> = self.keys.iter().chain(&self.faults[of.fault].keys).map(value).collect();
        let frame = Draw::Whole(self.pose.frames).value(counter, FRAME).parse().unwrap_or_default();
        Wanted { sample, of, split: self.split(sample), frame, drawn, healthy: self.keys.len() }
    }

    /// The counter of attempt `attempt` at sample `sample`.
    pub(crate) fn counter(&self, sample: u64, attempt: u32) -> Counter {
        Counter { seed: self.seed, sample, attempt }
    }

    /// Where attempt `attempt` at sample `sample` puts the vehicle.
    pub(crate) fn place(&self, sample: u64, attempt: u32) -> drive::Place {
        let counter = self.counter(sample, attempt);
        let drawn = |ends: [f64; 2], name: &str| between(ends, counter.share(name));
        let flight = |flight: &FlightDraws| drive::Flight {
            z_m: drawn(flight.z_m, "z_m"),
            pitch_deg: drawn(flight.pitch_deg, "pitch_deg"),
            roll_deg: drawn(flight.roll_deg, "roll_deg"),
        };
        drive::Place {
            at_m: [drawn(self.pose.x_m, "x_m"), drawn(self.pose.y_m, "y_m")],
            heading_deg: drawn(self.pose.heading_deg, "heading_deg"),
            flight: self.pose.flight.as_ref().map(flight),
        }
    }

    /// Folder of the plan's file, at which its paths start.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// Path of a file that the plan names.
    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.folder().join(name)
    }

    /// What is asked for of `of` with the keys `drawn`; without the fault if `healthy`.
    pub(crate) fn wishes(&self, of: Combination, drawn: &[(String, String)], healthy: bool) -> Wishes {
        let overlay = self.faults[of.fault].overlay.as_ref().filter(|_| !healthy);
        let path = |name: &String| {
            let file = self.file(name);
            if files::is_file(&file) { file } else { PathBuf::from(name) }
        };
        Wishes {
            machine: Some(self.machines[of.machine].clone()),
            overlays: overlay.map(path).into_iter().collect(),
            set: self.set.iter().chain(drawn).cloned().collect(),
            ..Wishes::default()
        }
    }
}
