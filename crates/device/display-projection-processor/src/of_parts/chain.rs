//! The processor of parts, from height to the wires of the write beam.

use hardware_model::AnalogParts;
use parts::{Delay, Jump, LagStep, NearJumps, time_constant};
use scenario::{Curvature, Occlusion};
use signal::{Break, Breaks, LANES, Lanes, Real, Stretches};

use crate::of_parts::derivative::Derivative;
use crate::of_parts::field::Field;
use crate::of_parts::figures::Figures;
use crate::of_parts::function::Function;
use crate::of_parts::lane::{Beam, Group, Output};
use crate::of_parts::peak_hold::PeakHold;
use crate::processor::deflect_samples;
use crate::{Deflection, Processor};

/// A processor of real parts, drawn once from the seed of the model.
#[derive(Debug, Clone)]
pub struct PartsProcessor<S> {
    divider: Processor<S>,
    lines: f64,
    elevation: Function<S>,
    deflection: Function<S>,
    circuit: Circuit<S>,
    /// Delay line of the intensity.
    video: Delay,
    /// Delay line of the blanking (steps).
    blanking: f64,
}

#[derive(Debug, Clone)]
enum Circuit<S> {
    Derivative(Derivative<S>),
    PeakHold(PeakHold<S>),
}

/// What goes to the sweep memory and to probes: one [`Lanes`] a sample.
#[derive(Debug, Clone, Default)]
pub struct Driven<S> {
    /// Tangent of the elevation behind its function generator.
    pub elevation: Vec<Lanes<S>>,
    /// Tangent that the sample-and-hold has.
    pub hold: Vec<Lanes<S>>,
    /// Line position of the write beam, from the top of the picture; at most a tenth of it outside.
    pub position: Vec<Lanes<S>>,
    /// The highest line position that the hold has had: where bodies and silhouettes come into sight. Never grows.
    pub line: Vec<Lanes<S>>,
    /// Reflectivity, delayed to meet its position.
    pub intensity: Vec<Lanes<S>>,
    /// Where `intensity` jumps or bends between samples, delayed like it.
    pub breaks: Breaks<S>,
    /// Where the beam is on, within the sweep.
    pub on: Stretches,
}

/// What the circuits of a sweep need room for; used again from sweep to sweep.
#[derive(Debug, Clone, Default)]
pub struct Scratch<S> {
    /// Trips of both comparators.
    pub(crate) outputs: [[Output; LANES]; 2],
    /// How far noise can move the thresholds of a comparator, sample by sample.
    pub(crate) reaches: Vec<f64>,
    /// What the differentiator has of the group, sample by sample.
    pub(crate) rates: Vec<Lanes<S>>,
    jumps: Vec<Jump>,
}

impl<S: Real> PartsProcessor<S> {
    /// A processor for samples at `ranges` (m, ascending, above 0) that are `h` seconds apart, and pictures of `lines`
    /// lines; `seed` is the model's.
    pub fn new(
        (occlusion, curvature): (Occlusion, Curvature),
        ranges: &[f64],
        lines: f64,
        h: f64,
        parts: &AnalogParts,
        seed: u64,
    ) -> Self {
        let figures = Figures { parts, seed };
        let function = |name: &str| Function {
            bow: figures.bow(name).map(S::from_f64),
            lag: figures.bandwidth(&format!("{name}.bandwidth")).map(|b| LagStep::new(h, time_constant(b))),
        };
        let nominal = parts.projection.bandwidth.map_or(0.0, time_constant);
        let video = parts.video_bandwidth.map_or(0.0, time_constant);
        let blanking = Delay::new(h, nominal);
        Self {
            divider: Processor::new(occlusion, curvature, ranges),
            lines,
            elevation: function("dpp.elevation"),
            deflection: function("dpp.deflection"),
            circuit: match occlusion {
                Occlusion::Derivative => Circuit::Derivative(Derivative::new(h, &figures)),
                Occlusion::PeakHold => Circuit::PeakHold(PeakHold::new(h, &figures)),
            },
            video: Delay::new(h, (2.0 * nominal - video).max(0.0)),
            blanking: blanking.whole as f64 + blanking.share,
        }
    }

    /// Projects a group: `height` above the eye (m) and `reflectivity` with its `breaks` as they leave the mixing unit,
    /// `deflection` in lines, `sweeps` counted over all frames (the address of noise).
    pub fn run(
        &self,
        height: &[Lanes<S>],
        (reflectivity, breaks): (&[Lanes<S>], &Breaks<S>),
        deflection: &[Deflection; LANES],
        sweeps: &[u64; LANES],
        scratch: &mut Scratch<S>,
        out: &mut Driven<S>,
    ) {
        for signal in [&mut out.elevation, &mut out.hold, &mut out.position, &mut out.line] {
            signal.resize(height.len(), Lanes::default());
        }
        self.divider.tangents(height, &mut out.elevation);
        let field = Field::of(deflection, self.lines);
        let ends = field.enter(&mut out.elevation);
        self.elevation.pass(&mut out.elevation, S::ZERO, S::ONE);
        self.occlude(ends, sweeps, scratch, out);
        field.leave(&mut out.elevation);
        field.leave(&mut out.hold);
        self.deflect(deflection, out);
        self.delay_video(reflectivity, &mut out.intensity);
        for (lane, breaks) in breaks.iter().enumerate() {
            self.delay_breaks(reflectivity, lane, breaks, &mut scratch.jumps, out);
        }
    }

    /// `dpp.derivative` of a lane of what was driven (tangents a second): what the comparator of falls sees, at the time at
    /// which its trips count. `None` where occlusion is by peak-hold, and there is no differentiator.
    pub fn derivative(&self, driven: &Driven<S>, lane: usize) -> Option<Vec<f64>> {
        let Circuit::Derivative(circuit) = &self.circuit else { return None };
        Some(circuit.falls.rates(&driven.elevation, lane))
    }

    fn occlude(
        &self,
        ends: [usize; LANES],
        sweeps: &[u64; LANES],
        scratch: &mut Scratch<S>,
        out: &mut Driven<S>,
    ) {
        let Driven { elevation, hold, on, .. } = out;
        let mut beams = on.each_mut().map(Beam::begin);
        if elevation.is_empty() {
            return;
        }
        let group = Group { elevation, ends, sweeps: *sweeps };
        hold[0] = elevation[0];
        match &self.circuit {
            Circuit::Derivative(circuit) => circuit.run(&group, scratch, &mut beams, hold),
            Circuit::PeakHold(circuit) => {
                for (lane, beam) in beams.iter_mut().enumerate() {
                    circuit.run(&group.wire(lane), scratch, beam, hold);
                }
            }
        }
        for (lane, end) in ends.into_iter().enumerate() {
            // Beyond its end a profile stays where it was.
            let (profile, beyond) = hold.split_at_mut(end.max(1));
            let last = profile[profile.len() - 1][lane];
            beyond.iter_mut().for_each(|hold| hold[lane] = last);
            if end > 0 {
                beams[lane].turn_off((end - 1) as f64);
            }
            self.delay_blanking(beams[lane].on, elevation.len());
        }
    }

    /// Both deflection signals, and the highest line so far.
    fn deflect(&self, deflection: &[Deflection; LANES], out: &mut Driven<S>) {
        let middle = S::from_f64(0.5 * self.lines);
        let Driven { elevation, hold, position, line, .. } = out;
        for (tangents, lines) in [(elevation, position), (hold, &mut *line)] {
            deflect_samples(deflection, tangents, lines);
            self.deflection.pass(lines, middle, middle);
        }
        for sample in 1..line.len() {
            let highest = line[sample - 1];
            let lower = |lane: usize| {
                if line[sample][lane] < highest[lane] { line[sample][lane] } else { highest[lane] }
            };
            line[sample] = Lanes::from_fn(lower);
        }
    }

    /// The blanking meets the position, which is behind the elevation by the deflection's function generator.
    fn delay_blanking(&self, on: &mut Vec<[f64; 2]>, samples: usize) {
        let last = samples.saturating_sub(1) as f64;
        let later = |time: f64| if time == 0.0 { 0.0 } else { (time + self.blanking).min(last) };
        on.iter_mut().for_each(|stretch| *stretch = stretch.map(later));
        on.retain(|[begin, end]| begin < end);
    }

    fn delay_video(&self, reflectivity: &[Lanes<S>], intensity: &mut Vec<Lanes<S>>) {
        let (share, whole) = (Lanes::splat(S::from_f64(self.video.share)), self.video.whole);
        let Some(&first) = reflectivity.first() else { return intensity.clear() };
        intensity.clear();
        intensity.resize(reflectivity.len().min(whole), first);
        let mut before = first;
        for &now in &reflectivity[..reflectivity.len() - intensity.len()] {
            intensity.push(now + (before - now) * share);
            before = now;
        }
    }

    /// Breaks are as late as the samples, and no straight line is drawn across one.
    fn delay_breaks(
        &self,
        reflectivity: &[Lanes<S>],
        lane: usize,
        breaks: &[Break<S>],
        jumps: &mut Vec<Jump>,
        out: &mut Driven<S>,
    ) {
        out.breaks[lane].clear();
        jumps.clear();
        jumps.extend(breaks.iter().map(|place| Jump {
            at: place.sample as f64 - 1.0 + place.share.to_f64(),
            before: place.before.to_f64(),
            after: place.after.to_f64(),
        }));
        let (late, last) = (self.video.whole as f64 + self.video.share, reflectivity.len().saturating_sub(1));
        let mut near = NearJumps::new(jumps);
        for (place, jump) in breaks.iter().zip(&*jumps) {
            let behind = place.sample.saturating_add(self.video.whole);
            if behind <= last {
                let video = |sample: usize| reflectivity[sample][lane].to_f64();
                let [_, value] = near.at(video, last, behind as f64 - late);
                out.intensity[behind][lane] = S::from_f64(value);
            }
            let at = jump.at + late;
            if at < last as f64 {
                let sample = (at.ceil() as usize).max(1);
                let share = S::from_f64(at - (sample - 1) as f64);
                out.breaks[lane].push(Break { sample, share, ..*place });
            }
        }
    }
}

impl<S: Real> Driven<S> {
    /// `dpp.blank` of a lane: 1 at each sample at which its beam is off.
    pub fn blank(&self, lane: usize) -> Vec<f64> {
        let mut gate = vec![1.0; self.elevation.len()];
        for &[begin, end] in &self.on[lane] {
            let first = begin as usize + usize::from(begin > begin.floor());
            gate[first..=end as usize].fill(0.0);
        }
        gate
    }
}
