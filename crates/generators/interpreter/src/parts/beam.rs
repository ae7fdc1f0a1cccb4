//! The projection processor of real parts, from height to the wires of the write beam (sheet of the projection processor).

use scenario::Occlusion;

use super::broken::Broken;
use super::comparator::ComparatorFigures;
use super::falls::{self, Falls};
use super::kit::Kit;
use super::latch::{self, Occluded, Parts};
use super::peak_detector;
use super::sample_hold::SampleHold;
use super::series::LagMap;
use crate::projector::Deflection;

/// Length of a microsecond (s).
const MICROSECOND: f64 = 1e-6;

/// What leaves the divider is held within this share of the field.
const LIMIT: f64 = 1.1;

/// A sweep as the processor is given it.
#[derive(Debug, Clone)]
pub struct Profile {
    /// Tangents of the elevation at the samples within the stored ground.
    pub tangents: Vec<f64>,
    /// Samples of a whole sweep.
    pub samples: usize,
    /// Video, with its sign.
    pub video: Broken,
    /// Number of the sweep over all frames.
    pub number: u64,
}

/// What goes to the sweep memory, and to probes, at the samples.
#[derive(Debug, Clone, Default)]
pub struct Driven {
    /// Tangent of the elevation behind its function generator.
    pub elevation: Vec<f64>,
    /// Its change (tangents a microsecond); 0 where nothing differentiates.
    pub derivative: Vec<f64>,
    /// Tangent in the sample-and-hold.
    pub hold: Vec<f64>,
    /// Highest line position so far, from the top.
    pub line: Vec<f64>,
    /// Whether the beam is off.
    pub blank: Vec<bool>,
    /// Video behind its delay line.
    pub video: Vec<f64>,
    /// How near a decision, or a turn of the beam on the wire of the hold and on that of the blanking, is to one that rounding makes.
    pub margins: [Vec<f64>; 2],
}

/// Margins are distances from thresholds in shares of full scale times the first, and of turns from samples in steps times the second:
/// 1e-9 of a margin is 1e-10 of full scale, or 1e-6 of a step.
const MARGINS: [f64; 2] = [10.0, 1e-3];

/// The projection processor of the model.
pub struct Beam<'a> {
    kit: &'a Kit<'a>,
    law: Occlusion,
    deflection: &'a Deflection,
    falls: Falls,
    hold: SampleHold,
    comparator: ComparatorFigures,
}

impl<'a> Beam<'a> {
    /// As the seed drew it, for one sweep.
    pub fn of(kit: &'a Kit<'a>, law: Occlusion, deflection: &'a Deflection) -> Self {
        let against_hold = ComparatorFigures::of(kit, "dpp.hold.comparator", 0);
        Self {
            kit,
            law,
            deflection,
            falls: Falls::of(kit),
            hold: SampleHold::of(kit),
            comparator: ComparatorFigures { noise: falls::noise(kit), ..against_hold },
        }
    }

    /// Projects the samples of a sweep.
    pub fn project(&self, profile: &Profile) -> Driven {
        let end = profile.tangents.len();
        let [middle, half] = self.deflection.field();
        let share = |tangent: &f64| ((tangent - middle) / half).clamp(-LIMIT, LIMIT);
        let mut shares: Vec<f64> = profile.tangents.iter().map(share).collect();
        // Beyond its end a profile stays where it was.
        let last = shares.last().copied().unwrap_or(-LIMIT);
        shares.resize(profile.samples.max(end), last);
        let elevation = self.function("dpp.elevation", shares, [0.0, 1.0]);
        let occluded = self.occlude(&elevation, end, profile.number);
        let tangent = |share: &f64| middle + half * share;
        let elevation: Vec<f64> = elevation.iter().map(tangent).collect();
        let hold: Vec<f64> = occluded.hold.iter().map(tangent).collect();
        Driven {
            derivative: self.derivative(&elevation, end),
            line: self.lines(&hold),
            blank: self.blank(&occluded, end),
            video: self.delayed(&profile.video, end),
            margins: self.margins(&occluded, end),
            elevation: elevation[..end].to_vec(),
            hold,
        }
    }

    /// A function generator: bow in the field about `middle`, then a lag that is settled at the first sample.
    fn function(&self, name: &str, wire: Vec<f64>, [middle, half]: [f64; 2]) -> Vec<f64> {
        let projection = self.kit.analog.projection;
        let bow = self.kit.drawn.error(name, 0, projection.error);
        let tau = self.kit.lag(&format!("{name}.bandwidth"), 0, projection.bandwidth);
        let lag = LagMap::of(1.0, tau);
        let mut last: Option<[f64; 2]> = None;
        let pass = |value: f64| {
            let place = (value - middle) / half;
            let input = value + bow * half * (1.0 - place * place).max(0.0);
            let output = last.map_or(input, |[before, output]| lag.step(output, [before, input]));
            last = Some([input, output]);
            output
        };
        wire.into_iter().map(pass).collect()
    }

    fn occlude(&self, elevation: &[f64], end: usize, number: u64) -> Occluded {
        let deviate = |source: &'static str| {
            move |sample: usize| {
                (self.kit.drawn.noise)(self.kit.drawn.seed, (source, 0), [number, sample as u64])
            }
        };
        let [falling, returning, aperture] =
            ["dpp.derivative.comparator", "dpp.hold.comparator", "dpp.hold.aperture"].map(deviate);
        let parts =
            Parts { hold: &self.hold, comparator: self.comparator, deviates: [&returning, &aperture] };
        match self.law {
            Occlusion::Derivative => {
                let (trips, near) = self.falls.trips(elevation, end, falling);
                let near: Vec<f64> = ahead(&near, self.falls.late);
                latch::occlude(parts, &elevation[..end], (trips, &near))
            }
            Occlusion::PeakHold => peak_detector::occlude(parts, &elevation[..end]),
        }
    }

    fn derivative(&self, elevation: &[f64], end: usize) -> Vec<f64> {
        if self.law == Occlusion::PeakHold {
            return vec![0.0; end];
        }
        let steps_a_microsecond = MICROSECOND / self.kit.step;
        self.falls.rates(elevation).into_iter().take(end).map(|rate| rate * steps_a_microsecond).collect()
    }

    fn lines(&self, hold: &[f64]) -> Vec<f64> {
        let middle = 0.5 * self.deflection.lines();
        let lines = hold.iter().map(|tangent| self.deflection.line(*tangent)).collect();
        let mut highest = f64::INFINITY;
        let pass = |line: f64| {
            highest = highest.min(line);
            highest
        };
        self.function("dpp.deflection", lines, [middle, middle]).into_iter().map(pass).collect()
    }

    /// Blanking waits for the position.
    fn blanking(&self) -> f64 {
        self.kit.nominal_lag(self.kit.analog.projection.bandwidth)
    }

    /// The beam of a profile goes off with its last sample; a turn at the first is not delayed.
    fn blank(&self, occluded: &Occluded, end: usize) -> Vec<bool> {
        let last = end as f64 - 1.0;
        let later = |time: f64| if time == 0.0 { 0.0 } else { time + self.blanking() };
        let stretches: Vec<[f64; 2]> = occluded
            .on
            .iter()
            .map(|[from, to]| [*from, to.min(last)])
            .filter(|[from, to]| from < to)
            .map(|stretch| stretch.map(later))
            .collect();
        let is_off = |sample: usize| {
            let time = sample as f64;
            // The beam is on up to the begin of the step in which it goes off.
            !stretches.iter().any(|[from, to]| *from <= time && time <= to.floor())
        };
        (0..end).map(is_off).collect()
    }

    /// The delay line of the video: two function generators, less the lag of the video.
    fn delayed(&self, video: &Broken, end: usize) -> Vec<f64> {
        let lag = self.kit.nominal_lag(self.kit.analog.video_bandwidth);
        let late = (2.0 * self.blanking() - lag).max(0.0);
        let mut samples = video.delayed(late).samples;
        samples.truncate(end);
        samples
    }

    fn margins(&self, occluded: &Occluded, end: usize) -> [Vec<f64>; 2] {
        [0.0, self.blanking()].map(|later| {
            let near = |sample: usize| {
                // A turn at a sample itself is one that the begin of a step holds back: both engines have it there.
                let turns = occluded.turns.iter().filter(|turn| turn.fract() != 0.0);
                let turns = turns.map(|turn| (turn + later - sample as f64).abs());
                turns.map(|turn| turn * MARGINS[1]).fold(occluded.near[sample] * MARGINS[0], f64::min)
            };
            (0..end).map(near).collect()
        })
    }
}

/// What is known at a sample and counts `late` steps earlier.
fn ahead(near: &[f64], late: f64) -> Vec<f64> {
    let later = late.ceil() as usize;
    let last = near.len().saturating_sub(1);
    (0..near.len()).map(|sample| near[(sample + later).min(last)]).collect()
}
