//! Machine and interpreter side by side.

use std::collections::BTreeMap;
use std::fmt;

use machine::HybridMachine;
use scenario::Scalar;

use crate::interpreter::{Record, interpret, range_programme};
use crate::scene::{Drawn, Scene};

/// Agreement of ideal signals in f64, as a part of full scale (architecture, section 9).
pub const F64_BOUND: f64 = 1e-12;

/// Agreement in f32, as a part of full scale. A sample's range is rounded to 24 bits, that is, by 6e-8 of up to 20
/// regions; height answers with its slope (up to a few full scales a region), and the sum of 11 terms adds its own.
/// Largest found over 400 random scenes: 3.8e-6.
pub const F32_BOUND: f64 = 8e-6;

/// Signals that both sides have.
pub const SIGNALS: [&str; 9] = [
    "sweep.x",
    "sweep.y",
    "tg.height",
    "tg.slope.u",
    "tg.slope.v",
    "tg.reflectivity",
    "dpp.elevation",
    "dpp.hold",
    "dpp.blank",
];

/// Where two sides part for the first time.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Signal, or counter.
    pub signal: String,
    /// Sweep of the frame.
    pub sweep: u32,
    /// Sample of the sweep.
    pub sample: usize,
    /// Ground range of that sample (m).
    pub range: f64,
    /// The machine's value.
    pub found: f64,
    /// The other value.
    pub expected: f64,
    /// Difference that is allowed.
    pub allowed: f64,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { signal, sweep, sample, range, found, expected, allowed } = self;
        let off = found - expected;
        write!(
            f,
            "{signal}, sweep {sweep}, sample {sample} ({range} m): machine {found:e}, expected {expected:e}, \
             off by {off:e}, allowed {allowed:e}"
        )
    }
}

/// A frame of the machine and the interpreter's opinion of each sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Lockstep {
    /// What the machine drew and recorded.
    pub drawn: Drawn,
    /// The interpreter's records, by sweep.
    pub records: Vec<Record>,
    /// Ground range of each sample by the scene's law (m).
    programme: Vec<f64>,
    /// Condition of that law: how much of a rounding of 1/range shows in the farthest range.
    reach: f64,
    /// Height of the eye, without its sign (m).
    eye: f64,
    bound: f64,
}

impl Lockstep {
    /// Runs frame `frame` of a scene on both.
    ///
    /// # Panics
    /// If the machine cannot draw the scene.
    pub fn run(scene: &Scene, frame: u64) -> Self {
        let mut probed = SIGNALS.to_vec();
        probed.push("sweep.range");
        let drawn = scene.draw(&HybridMachine, frame, &probed).expect("a pose that can be drawn");
        let ranges = waveform(&drawn, 0, "sweep.range");
        let records = (0..scene.sweeps).map(|sweep| interpret(scene, frame, sweep, ranges)).collect();
        let bound = match scene.scalar {
            Scalar::F64 => F64_BOUND,
            Scalar::F32 => F32_BOUND,
        };
        let (programme, reach) = (range_programme(scene), scene.range.end / scene.range.start);
        Self { drawn, records, programme, reach, eye: scene.eye[2].abs(), bound }
    }

    /// The first difference: ground ranges, signals sample by sample in the order of the drawing, counters.
    pub fn first_difference(&self) -> Option<Difference> {
        let scales = self.full_scales();
        self.in_ranges()
            .or_else(|| (0..self.records.len()).find_map(|sweep| self.in_sweep(sweep, &scales)))
            .or_else(|| self.in_counters())
    }

    /// The largest difference of any signal as a part of its full scale: what a bound is set from.
    pub fn largest_difference(&self) -> f64 {
        let scales = self.full_scales();
        let mut largest = 0.0_f64;
        for (sweep, record) in self.records.iter().enumerate() {
            for (name, expected) in record.signals.iter().filter(|(name, _)| **name != "dpp.blank") {
                let found = waveform(&self.drawn, sweep, name);
                for (found, expected) in found.iter().zip(expected) {
                    largest = largest.max((found - expected).abs() / scales[name]);
                }
            }
        }
        largest
    }

    /// Full scale of each signal: the largest value that the frame has. The summer takes the eye's height off, so
    /// that counts as a height.
    fn full_scales(&self) -> BTreeMap<&'static str, f64> {
        let mut scales = BTreeMap::from([("sweep.x", 1.0), ("sweep.y", 1.0), ("tg.height", self.eye)]);
        for (&name, values) in self.records.iter().flat_map(|record| &record.signals) {
            let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            let scale = scales.entry(name).or_insert(f64::MIN_POSITIVE);
            *scale = scale.max(largest);
        }
        scales
    }

    /// The range programme, to the rounding that its law allows.
    fn in_ranges(&self) -> Option<Difference> {
        let found = waveform(&self.drawn, 0, "sweep.range");
        (0..self.programme.len()).find_map(|sample| {
            let (found, range) = (found[sample], self.programme[sample]);
            let allowed = 4.0 * f64::EPSILON * self.reach.max(16.0) * range;
            let signal = "sweep.range".to_owned();
            let difference = Difference { signal, sweep: 0, sample, range, found, expected: range, allowed };
            let agree = (found - range).abs() <= allowed;
            (!agree).then_some(difference)
        })
    }

    fn in_sweep(&self, sweep: usize, scales: &BTreeMap<&str, f64>) -> Option<Difference> {
        let record = &self.records[sweep];
        let waves: Vec<_> = SIGNALS.iter().map(|&name| (name, waveform(&self.drawn, sweep, name))).collect();
        for (sample, &range) in record.range.iter().enumerate() {
            for &(name, found) in &waves {
                let (found, expected) = (found[sample], record.signals[name][sample]);
                let allowed = self.bound * scales[name];
                let agree = if name == "dpp.blank" {
                    found == expected || self.is_doubtful(record, sample, scales)
                } else {
                    (found - expected).abs() <= allowed
                };
                if !agree {
                    let (signal, sweep) = (name.to_owned(), sweep as u32);
                    return Some(Difference { signal, sweep, sample, range, found, expected, allowed });
                }
            }
        }
        None
    }

    /// Whether elevation and held elevation are too close to one another for the gate to be certain.
    fn is_doubtful(&self, record: &Record, sample: usize, scales: &BTreeMap<&str, f64>) -> bool {
        let now = record.signals["dpp.elevation"][sample];
        let before = if sample == 0 { now } else { record.signals["dpp.hold"][sample - 1] };
        (now - before).abs() <= 2.0 * self.bound * scales["dpp.elevation"]
    }

    /// Counters are results. Stops beyond the stored area are nobody's, so folds are compared within it only.
    fn in_counters(&self) -> Option<Difference> {
        let sum = |count: fn(&Record) -> u64| self.records.iter().map(count).sum::<u64>() as f64;
        let inside = self.records.iter().all(|record| !record.left_the_area);
        let counters = [
            ("folds", inside, self.drawn.counts.folds as f64, sum(|record| record.folds)),
            ("late words", inside, self.drawn.counts.late_words as f64, sum(|record| record.late_words)),
        ];
        counters.into_iter().find(|&(_, compared, found, expected)| compared && found != expected).map(
            |(name, _, found, expected)| Difference {
                signal: name.to_owned(),
                sweep: 0,
                sample: 0,
                range: 0.0,
                found,
                expected,
                allowed: 0.0,
            },
        )
    }
}

fn waveform<'a>(drawn: &'a Drawn, sweep: usize, name: &str) -> &'a [f64] {
    let mut all = drawn.waveforms.iter();
    let wave = all.find(|wave| wave.sweep as usize == sweep && wave.signal.name == name);
    &wave.unwrap_or_else(|| panic!("the machine did not record {name} of sweep {sweep}")).values
}
