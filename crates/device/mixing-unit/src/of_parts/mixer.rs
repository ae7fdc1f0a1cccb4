//! Switches, adder and video amplifier in the order of fig. 28.

use hardware_model::{AnalogParts, MixingParts};
use parts::{
    Comparator, Delay, Driver, Fade, Jump, NoiseSource, Spread, Tolerance, relative_sigma, time_constant,
};
use scenario::TextureInShadow;
use signal::{LANES, Lanes, Real};

use crate::of_parts::edges::GateEdges;
use crate::of_parts::events::{Event, jumps};
use crate::of_parts::switch::{FadingSwitch, Leaks, limit};
use crate::{DriverScratch, FeatureInput, Inputs, Mixed, MixingUnit, OutputDrivers, ToggleList};

/// A mixing unit of real parts, drawn once from the seed of the model.
#[derive(Debug, Clone)]
pub struct PartsMixer<S> {
    /// The same unit without faults: its gates and the place of its adder.
    pub(crate) unit: MixingUnit,
    pub(crate) vs1: FadingSwitch<S>,
    pub(crate) vs2: FadingSwitch<S>,
    /// Comparators of feature presence and of the shadow gate; their offsets are the generators'.
    comparators: [Comparator<S>; 2],
    outputs: OutputDrivers<S>,
}

/// Gates, fades and wires of a group; used again from group to group.
#[derive(Debug, Clone, Default)]
pub struct SwitchScratch<S> {
    gate: GateEdges,
    /// Of VS1 and VS2.
    pub(crate) fades: [[Fade; LANES]; 2],
    pub(crate) leaks: [Leaks<S>; 2],
    /// Input S of VS1 at the samples, and where it jumps between them.
    pub(crate) video: Vec<Lanes<S>>,
    pub(crate) jumps: [Vec<Jump>; LANES],
    pub(crate) events: Vec<Event<S>>,
    pub(crate) terminators: Vec<Event<S>>,
    /// What comes to the limiter before VS2 at the samples: below 0 is local shadow.
    pub(crate) signed: Vec<Lanes<S>>,
    /// Steps of each lane over which that changes its sign.
    pub(crate) turns: [Vec<usize>; LANES],
    /// How far a switch is open at the samples.
    open: Vec<Lanes<S>>,
    before: Vec<Lanes<S>>,
    driver: DriverScratch<S>,
}

impl<S: Real> PartsMixer<S> {
    /// The unit for samples that are `h` seconds apart; `seed` is the model's.
    pub fn new(
        (mixing, texture_in_shadow): (&MixingParts, TextureInShadow),
        h: f64,
        parts: &AnalogParts,
        seed: u64,
    ) -> Self {
        let figures = Figures { parts, spread: Spread::new(seed) };
        let comparator = |part: &str| {
            let law = parts.comparator_law(&figures.spread, part, 0);
            Comparator::new(h, &law, NoiseSource::new(seed, part, 0))
        };
        let bandwidth = parts.video_bandwidth.map(|b| figures.draw("mu.video", b, relative_sigma::BANDWIDTH));
        Self {
            unit: MixingUnit::new(mixing, texture_in_shadow),
            vs1: FadingSwitch::new(h, &figures, "mu.vs1"),
            vs2: FadingSwitch::new(h, &figures, "mu.vs2"),
            comparators: ["fg.comparator", "sc.comparator"].map(comparator),
            outputs: OutputDrivers {
                height: None,
                video: bandwidth.map(|bandwidth| Driver::new(h, time_constant(bandwidth), f64::INFINITY)),
            },
        }
    }

    /// Mixes a group. All signals are as long as the terrain's, texture at most.
    pub fn run(&self, inputs: &Inputs<'_, S>, scratch: &mut SwitchScratch<S>, out: &mut Mixed<S>) {
        begin(inputs, out);
        scratch.open.resize(out.height.len(), Lanes::default());
        if let Some(features) = &inputs.features {
            self.lay_features(inputs, features, scratch, out);
        }
        let texture = inputs.texture.unwrap_or_default();
        let before_vs2 = self.unit.texture_in_shadow == TextureInShadow::Off;
        if before_vs2 {
            add(texture, &mut out.reflectivity);
        }
        scratch.signed.clone_from(&out.reflectivity);
        limit(&mut out.reflectivity);
        if let Some(shadow) = inputs.shadow {
            self.lay_shadow(shadow, scratch, &mut out.reflectivity);
        }
        if !before_vs2 {
            add(texture, &mut out.reflectivity);
        }
        limit(&mut out.reflectivity);
        scratch.list_breaks(self, inputs, out);
        self.outputs.run(out, &mut scratch.driver);
    }

    pub(crate) fn presence_comparator(&self) -> &Comparator<S> {
        &self.comparators[0]
    }

    pub(crate) fn shadow_comparator(&self) -> &Comparator<S> {
        &self.comparators[1]
    }

    /// VS1 and the height summer.
    fn lay_features(
        &self,
        inputs: &Inputs<'_, S>,
        features: &FeatureInput<'_, S>,
        scratch: &mut SwitchScratch<S>,
        out: &mut Mixed<S>,
    ) {
        scratch.take_video(inputs, features, self.vs1.late.as_ref());
        for lane in 0..LANES {
            self.follow_presence(&self.unit.vs1, features, lane, &mut scratch.gate);
            scratch.open(0, lane, &self.vs1);
        }
        let SwitchScratch { open, video, leaks: [leaks, _], .. } = scratch;
        self.vs1.leak(&out.reflectivity, Some(video), leaks);
        self.vs1.run(open, Some(video), leaks, &mut out.reflectivity);
        for (height, &feature) in out.height.iter_mut().zip(features.height) {
            *height = *height + feature;
        }
    }

    /// VS2: black at S.
    fn lay_shadow(
        &self,
        shadow: &[ToggleList<'_, S>; LANES],
        scratch: &mut SwitchScratch<S>,
        reflectivity: &mut [Lanes<S>],
    ) {
        for (lane, list) in shadow.iter().enumerate() {
            scratch.gate.follow(list, self.shadow_comparator());
            scratch.open(1, lane, &self.vs2);
        }
        let SwitchScratch { open, leaks: [_, leaks], .. } = scratch;
        self.vs2.leak(reflectivity, None, leaks);
        self.vs2.run(open, None, leaks, reflectivity);
    }
}

impl<S: Real> SwitchScratch<S> {
    /// The fade of a switch whose gate is `gate`, and what it is at the samples of a lane.
    fn open(&mut self, switch: usize, lane: usize, part: &FadingSwitch<S>) {
        let fade = &mut self.fades[switch][lane];
        fade.follow(self.gate.open_at_start, self.gate.edges.iter().copied(), part.transition);
        let open = &mut self.open;
        fade.sample(open.len(), |sample, g| open[sample][lane] = S::from_f64(g));
    }

    /// Input S of VS1: beyond its footprint a feature adds no slope, so its video goes on as the ground's.
    fn take_video(&mut self, inputs: &Inputs<'_, S>, features: &FeatureInput<'_, S>, delay: Option<&Delay>) {
        self.video.clear();
        let wires = features.lit.iter().zip(features.reflectivity.iter().zip(inputs.reflectivity));
        self.video.extend(wires.map(|(lit, (feature, ground))| {
            Lanes::from_fn(|lane| if lit[lane] > S::ZERO { feature[lane] } else { ground[lane] })
        }));
        for lane in 0..LANES {
            jumps(inputs, lane, &mut self.jumps[lane]);
        }
        if let Some(delay) = delay {
            delay.pass_broken(&mut self.video, &mut self.jumps, &mut self.before);
        }
    }
}

/// Parts and their deviates.
pub(crate) struct Figures<'a> {
    pub parts: &'a AnalogParts,
    pub spread: Spread,
}

impl Figures<'_> {
    /// The figure of one part, spread by `sigma` where parts are.
    pub fn draw(&self, part: &str, nominal: f64, sigma: f64) -> f64 {
        let sigma = if self.parts.spread { sigma } else { 0.0 };
        self.spread.figure(part, 0, &Tolerance { nominal, sigma })
    }
}

fn begin<S: Real>(inputs: &Inputs<'_, S>, out: &mut Mixed<S>) {
    out.height.clear();
    out.height.extend_from_slice(inputs.height);
    out.reflectivity.clear();
    out.reflectivity.extend_from_slice(inputs.reflectivity);
    out.breaks.iter_mut().for_each(Vec::clear);
    out.bends.iter_mut().for_each(Vec::clear);
}

fn add<S: Real>(texture: &[Lanes<S>], reflectivity: &mut [Lanes<S>]) {
    for (value, &texture) in reflectivity.iter_mut().zip(texture) {
        *value = *value + texture;
    }
}

/// Black and white are the ends of the video; what is not a number is black.
pub(crate) fn limited<S: Real>(value: S) -> S {
    let value = value.at_least(S::ZERO);
    if value > S::ONE { S::ONE } else { value }
}
