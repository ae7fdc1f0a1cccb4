//! Switches, adder and video amplifier in the order of fig. 28.

use hardware_model::{AnalogParts, Gate, MixingParts};
use parts::{LagStep, Spread, Switch, SwitchLaw, Tolerance, relative_sigma, time_constant};
use scenario::TextureInShadow;
use signal::{LANES, Lanes, Real};

use crate::wired::edges::{FadingSwitch, GateEdges};
use crate::{FeatureInput, Inputs, Mixed, MixingUnit, ToggleList};

/// A mixing unit of real parts, drawn once from the seed of the model.
#[derive(Debug, Clone)]
pub struct PartsMixer<S> {
    /// The same unit without faults: its gates and the place of its adder.
    unit: MixingUnit,
    vs1: FadingSwitch<S>,
    vs2: FadingSwitch<S>,
    /// Delays of the comparators of feature presence and of the shadow gate (steps).
    late: [f64; 2],
    video: Option<LagStep<S>>,
}

/// Gates and fades of a group; used again from group to group.
#[derive(Debug, Clone, Default)]
pub struct SwitchScratch<S> {
    gate: GateEdges,
    fades: Vec<Lanes<S>>,
    video: Vec<Lanes<S>>,
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
        let late = |part: &str| {
            let delay = figures.draw(part, parts.comparator.delay, relative_sigma::SWITCH_DELAY);
            if delay == 0.0 { 0.0 } else { delay / h }
        };
        let bandwidth = parts.video_bandwidth.map(|b| figures.draw("mu.video", b, relative_sigma::BANDWIDTH));
        Self {
            unit: MixingUnit::new(mixing, texture_in_shadow),
            vs1: figures.switch(h, "mu.vs1"),
            vs2: figures.switch(h, "mu.vs2"),
            late: [late("fg.comparator"), late("sc.comparator")],
            video: bandwidth.map(|bandwidth| LagStep::new(h, time_constant(bandwidth))),
        }
    }

    /// Mixes a group, without breaks. All signals are as long as the terrain's, texture at most.
    pub fn run(&self, inputs: &Inputs<'_, S>, scratch: &mut SwitchScratch<S>, out: &mut Mixed<S>) {
        begin(inputs, out);
        scratch.fades.resize(out.height.len(), Lanes::default());
        if let Some(features) = &inputs.features {
            self.lay_features(features, scratch, out);
        }
        let texture = inputs.texture.unwrap_or_default();
        let before_vs2 = self.unit.texture_in_shadow == TextureInShadow::Off;
        if before_vs2 {
            add(texture, &mut out.reflectivity);
        }
        limit(&mut out.reflectivity);
        if let Some(shadow) = inputs.shadow {
            self.lay_shadow(shadow, scratch, &mut out.reflectivity);
        }
        if !before_vs2 {
            add(texture, &mut out.reflectivity);
        }
        limit(&mut out.reflectivity);
        if let Some(lag) = &self.video {
            amplify(lag, &mut out.reflectivity);
        }
    }

    /// VS1 and the height summer.
    fn lay_features(
        &self,
        features: &FeatureInput<'_, S>,
        scratch: &mut SwitchScratch<S>,
        out: &mut Mixed<S>,
    ) {
        let SwitchScratch { gate, fades, video } = scratch;
        for lane in 0..LANES {
            gate.follow_features(&self.unit.vs1, features, lane);
            gate.fade(&self.vs1, self.late[0], lane, fades);
        }
        video.clear();
        video.extend_from_slice(features.reflectivity);
        if self.unit.vs1.gate == Gate::Presence {
            go_on(features, S::from_f64(self.unit.vs1.threshold), &out.reflectivity, video);
        }
        for ((value, &video), &g) in out.reflectivity.iter_mut().zip(&*video).zip(&*fades) {
            *value = self.vs1.part.output(g, *value, video);
        }
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
        let SwitchScratch { gate, fades, .. } = scratch;
        for (lane, list) in shadow.iter().enumerate() {
            gate.follow_shadow(list);
            gate.fade(&self.vs2, self.late[1], lane, fades);
        }
        for (value, &g) in reflectivity.iter_mut().zip(&*fades) {
            *value = self.vs2.part.output(g, *value, Lanes::default());
        }
    }
}

/// Parts and their deviates.
struct Figures<'a> {
    parts: &'a AnalogParts,
    spread: Spread,
}

impl Figures<'_> {
    fn switch<S: Real>(&self, h: f64, name: &str) -> FadingSwitch<S> {
        let figures = &self.parts.video_switch;
        let time = self.draw(&format!("{name}.time"), figures.time, relative_sigma::SWITCH_DELAY);
        let law = SwitchLaw {
            transition: time,
            level_mismatch: self.spread.error(&format!("{name}.level"), 0, figures.level_mismatch),
            ..SwitchLaw::default()
        };
        FadingSwitch { part: Switch::new(h, &law), transition: time / h }
    }

    fn draw(&self, part: &str, nominal: f64, sigma: f64) -> f64 {
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

/// Beyond its footprint a feature adds no slope, so its video goes on as the ground's; but where the sample outside a rim
/// stands for some of the footprint, as that of the rim.
fn go_on<S: Real>(features: &FeatureInput<'_, S>, present: S, ground: &[Lanes<S>], video: &mut [Lanes<S>]) {
    for ((video, &ground), line) in video.iter_mut().zip(ground).zip(features.present) {
        *video = Lanes::from_fn(|lane| if line[lane] > present { video[lane] } else { ground[lane] });
    }
    for (lane, kinks) in features.kinks.iter().enumerate() {
        for kink in kinks {
            let is_early = kink.share < S::from_f64(0.5);
            let [outside, value] = match (kink.present, is_early) {
                ([false, true], true) => [kink.sample - 1, 1],
                ([true, false], false) => [kink.sample, 0],
                _ => continue,
            };
            if features.present[outside][lane] <= present {
                video[outside][lane] = kink.feature[value];
            }
        }
    }
}

fn add<S: Real>(texture: &[Lanes<S>], reflectivity: &mut [Lanes<S>]) {
    for (value, &texture) in reflectivity.iter_mut().zip(texture) {
        *value = *value + texture;
    }
}

/// Black and white are the ends of the video; what is not a number is black.
fn limit<S: Real>(reflectivity: &mut [Lanes<S>]) {
    let within = |value: S| {
        let value = value.at_least(S::ZERO);
        if value > S::ONE { S::ONE } else { value }
    };
    reflectivity.iter_mut().for_each(|value| *value = value.map(within));
}

/// Passes the video through its lag, settled at the first sample.
fn amplify<S: Real>(lag: &LagStep<S>, video: &mut [Lanes<S>]) {
    let Some(&first) = video.first() else { return };
    let (mut before, mut out) = (first, first);
    for value in video {
        out = lag.step(out, before, *value);
        before = *value;
        *value = out;
    }
}
