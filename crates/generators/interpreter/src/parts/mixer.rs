//! The mixing unit of real parts along a sweep (sheet of the mixing unit, "Real parts").
//!
//! Between samples the video is straight lines, but for places of its own: rims, jumps of the features' video, begin and end of the
//! fades, and where the video comes out of black. Each place is asked by itself what comes before it and behind it.

use super::broken::{Broken, Jump};
use super::comparator::ComparatorFigures;
use super::gates::{Fade, Gate};
use super::kit::Kit;
use super::video_amplifier::amplified;
use super::video_switch::SwitchFigures;

/// What the unit is given.
#[derive(Debug, Clone, Default)]
pub struct Inputs {
    /// Light of the terrain at the samples, with its sign.
    pub terrain: Vec<f64>,
    /// Video of the features, which jumps; none where there are no features.
    pub features: Option<Broken>,
    /// Gate of VS1, and that of VS2 where there is remote shadow.
    pub gates: [Option<Gate>; 2],
    /// Instants of the rims (steps).
    pub rims: Vec<f64>,
    /// What texture adds, up to its reach.
    pub texture: Vec<f64>,
    /// Whether texture is added before VS2.
    pub texture_first: bool,
}

/// Parts of the mixing unit.
#[derive(Debug, Clone, Copy)]
pub struct MixerFigures {
    /// Comparators of presence and of remote shadow.
    pub comparators: [ComparatorFigures; 2],
    /// Figures of VS1 and of VS2.
    switches: [SwitchFigures; 2],
    /// Time constant of the video amplifier (steps).
    tau: f64,
}

impl MixerFigures {
    /// As the seed drew them.
    pub fn of(kit: &Kit<'_>) -> Self {
        Self {
            comparators: ["fg.comparator", "sc.comparator"].map(|part| ComparatorFigures::of(kit, part, 0)),
            switches: ["mu.vs1", "mu.vs2"].map(|name| SwitchFigures::of(kit, name)),
            tau: kit.lag("mu.video", 0, kit.analog.video_bandwidth),
        }
    }

    /// How far both switches are open; none where a switch is not there.
    pub fn fades(&self, gates: &[Option<Gate>; 2]) -> [Option<Fade>; 2] {
        [0, 1]
            .map(|switch| gates[switch].as_ref().map(|gate| Fade::of(gate, self.switches[switch].transition)))
    }

    /// Video behind the amplifier.
    pub fn mix(&self, inputs: Inputs) -> Broken {
        let mut unit = Unit::of(self, inputs);
        unit.signed = unit.at_samples(|unit, time| unit.signed_at(time)[1]);
        let signed = &unit.signed;
        unit.leaks[1] = [self.switches[1].leak(signed), vec![0.0; signed.len()]];
        let samples = unit.at_samples(|unit, time| unit.video_at(time)[1]);
        let places = unit.places();
        let jumps = places.into_iter().map(|at| {
            let [before, after] = unit.video_at(at);
            Jump { at, before, after }
        });
        let jumps = jumps.collect();
        amplified(self.tau, Broken { samples, jumps })
    }
}

/// The unit at work.
struct Unit<'a> {
    figures: &'a MixerFigures,
    inputs: Inputs,
    terrain: Broken,
    fades: [Option<Fade>; 2],
    /// Crosstalk of both inputs of both switches, by sample.
    leaks: [[Vec<f64>; 2]; 2],
    /// What comes to the limiter before VS2 at the samples.
    signed: Vec<f64>,
}

impl<'a> Unit<'a> {
    fn of(figures: &'a MixerFigures, mut inputs: Inputs) -> Self {
        let [first, _] = &figures.switches;
        inputs.features = inputs.features.map(|video| video.delayed(first.late));
        let terrain = Broken { samples: inputs.terrain.clone(), jumps: Vec::new() };
        let of_s = inputs.features.as_ref().map_or(vec![], |video| first.leak(&video.samples));
        Self {
            leaks: [[first.leak(&terrain.samples), of_s], [vec![], vec![]]],
            fades: figures.fades(&inputs.gates),
            figures,
            inputs,
            terrain,
            signed: Vec::new(),
        }
    }

    fn at_samples(&self, value: impl Fn(&Self, f64) -> f64) -> Vec<f64> {
        (0..self.terrain.samples.len()).map(|sample| value(self, sample as f64)).collect()
    }

    /// A switch at an instant: its fade, its inputs, and what leaks at the end of the step.
    fn switched(&self, switch: usize, time: f64, [c, s]: [[f64; 2]; 2]) -> [f64; 2] {
        let Some(fade) = &self.fades[switch] else { return c };
        let (shares, sample) = (fade.at(time), time.ceil() as usize);
        let leaks = [0, 1].map(|input| self.leaks[switch][input].get(sample).copied().unwrap_or(0.0));
        [0, 1].map(|side| self.figures.switches[switch].output(shares[side], [c[side], s[side]], leaks))
    }

    /// What comes to the limiter before VS2, just before and just behind an instant.
    fn signed_at(&self, time: f64) -> [f64; 2] {
        let ground = self.terrain.at(time);
        let lit = match &self.inputs.features {
            None => ground,
            Some(features) => self.switched(0, time, [ground, features.at(time)]),
        };
        let grain = if self.inputs.texture_first { self.grain(time) } else { 0.0 };
        lit.map(|value| value + grain)
    }

    /// What comes to the amplifier.
    fn video_at(&self, time: f64) -> [f64; 2] {
        let lit = self.signed_at(time).map(|value| value.clamp(0.0, 1.0));
        let shown = self.switched(1, time, [lit, [0.0; 2]]);
        let grain = if self.inputs.texture_first { 0.0 } else { self.grain(time) };
        shown.map(|value| (value + grain).clamp(0.0, 1.0))
    }

    /// Texture at an instant; none in the step in which it ends.
    fn grain(&self, time: f64) -> f64 {
        let (texture, end) = (&self.inputs.texture, time.ceil() as usize);
        let Some(&value) = texture.get(end) else { return 0.0 };
        let share = end as f64 - time;
        if share > 0.0 { value + (texture[end - 1] - value) * share } else { value }
    }

    /// Instants between samples at which the video bends or jumps, ascending.
    fn places(&self) -> Vec<f64> {
        let last = self.terrain.samples.len() as f64 - 1.0;
        let jumps = self.inputs.features.iter().flat_map(|video| &video.jumps).map(|jump| jump.at);
        let knots = self.fades.iter().flatten().flat_map(|fade| &fade.knots).map(|knot| knot[0]);
        let mut places: Vec<f64> = self.inputs.rims.iter().copied().chain(jumps).chain(knots).collect();
        places.retain(|at| *at > 0.0 && *at < last);
        places.sort_by(f64::total_cmp);
        places.dedup();
        let ends = self.terminators(&places);
        places.extend(ends);
        places.sort_by(f64::total_cmp);
        places
    }

    /// Where the video passes black, straight from place to place.
    fn terminators(&self, places: &[f64]) -> Vec<f64> {
        let samples = (0..self.signed.len()).map(|sample| sample as f64);
        let mut marks: Vec<f64> = places.iter().copied().chain(samples).collect();
        marks.sort_by(f64::total_cmp);
        marks.dedup();
        let passes = |pair: &[f64]| {
            let (value, target) = (self.signed_at(pair[0])[1], self.signed_at(pair[1])[0]);
            if value * target >= 0.0 {
                return None;
            }
            let at = pair[0] + (pair[1] - pair[0]) * (value / (value - target));
            (at > pair[0] && at < pair[1]).then_some(at)
        };
        marks.windows(2).filter_map(passes).collect()
    }
}
