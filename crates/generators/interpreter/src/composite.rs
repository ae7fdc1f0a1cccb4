//! Generators and mixing unit along a sweep, in the order of the drawing (sections 9, 10, 13, 14).
//!
//! Where the feature generator or the mixing unit has real parts, both are worked out at the samples of the machine, and their wires
//! are straight between them.

use hardware_model::Gate as GateKind;
use landscape::Texture;
use scenario::FeatureLight;

use crate::craters::relief;
use crate::given::spread;
use crate::levels::GroundSample;
use crate::loads::{DrawnCrater, Loads};
use crate::mixing::{Inputs, mix, texture};
use crate::parts::broken::Broken;
use crate::parts::crater_chains::{Bend, Line, Loaded, Surface, surface};
use crate::parts::kit::Kit;
use crate::parts::sub_generator::SubGeneratorFigures;
use crate::parts::texture::{Grain, enlarged, grained};
use crate::parts::{LightStage, ReflectivityStage, light_stage};
use crate::sweep::{Walker, met};

/// A chain at the edge of rest by this part of what counts as rest has a margin of 1e-9.
const REST: f64 = 1e-3;

/// What leaves the mixing unit.
#[derive(Debug, Clone, Default)]
pub(crate) struct Composite {
    /// Heights behind their amplifier (m).
    pub heights: Vec<f64>,
    /// Video behind its amplifier, with its sign; at the samples of the machine where its parts are real.
    pub video: Broken,
    /// Rims of craters as the sub-generators have them; none where these are ideal.
    pub bends: Option<Vec<Bend>>,
}

/// Features at the samples.
#[derive(Debug, Clone, Default)]
pub(crate) struct Features {
    pub height: Vec<f64>,
    /// Slopes to the north and to the east.
    pub slopes: Vec<[f64; 2]>,
    pub present: Vec<bool>,
    /// Whether their video is that of the surface they make.
    pub lit: Vec<bool>,
    /// Their video where it is lit, with its sign; the terrain's elsewhere.
    pub video: Vec<f64>,
    pub clear: Vec<f64>,
    pub surface: Surface,
}

/// The sweep at the samples that are looked at.
pub(crate) struct Samples<'a> {
    pub ground: &'a [GroundSample],
    /// Light of the terrain behind its stage and its amplifier, with its sign.
    pub light: &'a [f64],
    pub ranges: &'a [f64],
}

pub(crate) fn gate(open: bool) -> f64 {
    if open { 1.0 } else { 0.0 }
}

pub(crate) fn gates(open: &[bool]) -> Vec<f64> {
    open.iter().map(|open| gate(*open)).collect()
}

impl Walker<'_> {
    /// Steps of the clock from one sample that is looked at to the next.
    fn stride(&self) -> usize {
        let analog = &self.scene.settings.analog;
        let is_ideal = analog.features_are_ideal() && analog.switching_is_ideal();
        if is_ideal { 1 } else { self.given.between }
    }

    /// Generators and mixing unit.
    pub(crate) fn landscape(&mut self, ground: &[GroundSample], craters: &Loads) -> Composite {
        let stride = self.stride();
        let lights = self.lights(ground);
        self.put_ground(ground, &lights);
        let every = |values: &[f64]| -> Vec<f64> { values.iter().step_by(stride).copied().collect() };
        let (lights, ranges) = (every(&lights), every(self.given.ranges));
        let seen: Vec<GroundSample> = ground.iter().step_by(stride).copied().collect();
        let samples = Samples { ground: &seen, light: &lights, ranges: &ranges };
        let wires = Wires { stride, count: ground.len() };
        let features = self.features(&samples, &craters.drawn);
        self.put_sub_generators(wires, &samples, &craters.drawn);
        let added = self.added_by_craters(&samples, &craters.drawn);
        let grain = self.grain(&samples, added.as_deref());
        self.put_features(wires, &features);
        self.put_grain(wires, &grain, (added.as_deref(), &features.clear));
        let raised = samples.ground.iter().zip(&features.height).map(|(ground, rise)| ground.height + rise);
        let heights = spread(&raised.collect::<Vec<_>>(), stride, ground.len(), false);
        let heights = self.wires.pass("mu.height", heights);
        self.record.signals.insert("mu.height".into(), heights.clone());
        let bends =
            (!self.scene.settings.analog.features_are_ideal()).then(|| features.surface.bends.clone());
        self.record.shadow_answers = self.shadow_answers(samples.ranges);
        let video = if self.scene.settings.analog.switching_is_ideal() {
            self.mix_ideally(&samples, &features, &grain)
        } else {
            self.mix_by_parts(wires, &samples, &features, grain)
        };
        Composite { heights, video, bends }
    }

    fn put_ground(&mut self, ground: &[GroundSample], lights: &[f64]) {
        for (ground, light) in ground.iter().zip(lights) {
            self.record.put("tg.height", ground.height);
            self.record.put("tg.slope.u", ground.slopes[0]);
            self.record.put("tg.slope.v", ground.slopes[1]);
            self.record.put("tg.reflectivity", light.max(0.0));
        }
    }

    /// Light of the terrain behind its stage, its delay and its amplifier.
    fn lights(&mut self, ground: &[GroundSample]) -> Vec<f64> {
        let (kit, between) = (Kit::of(self.scene, self.given), self.given.between);
        let slopes: Vec<[f64; 2]> = ground.iter().map(|ground| ground.slopes).collect();
        let parts = LightStage::of(&kit, between);
        let wires = match &parts {
            None => light_stage::ideal(&slopes, self.light.to_sun()),
            Some(stage) => stage.run(&slopes, self.light.to_sun()),
        };
        let raw = (0..ground.len()).map(|step| {
            let sight = (ground[step].height - self.scene.eye[2]) / self.given.ranges[step];
            let [.., cosine] = &wires;
            match parts {
                None => self.light.reflectivity(slopes[step], sight),
                Some(_) => self.light.beyond_lambert(cosine[step], slopes[step], sight),
            }
        });
        let stage = ReflectivityStage::of(self.scene);
        let raw: Vec<f64> = raw.collect();
        let named = light_stage::NAMES.iter().map(|name| format!("tg.light.{name}"));
        self.record.signals.extend(named.zip(wires));
        self.wires.pass("tg.reflectivity", stage.pass(raw, between))
    }

    /// Whether the rims of craters between samples are needed.
    fn needs_chains(&self) -> bool {
        let analog = &self.scene.settings.analog;
        !(analog.features_are_ideal() && analog.switching_is_ideal())
    }

    /// Height, slopes and presence of some craters at the samples.
    pub(crate) fn relief(&self, samples: &Samples<'_>, craters: &[DrawnCrater]) -> Features {
        let mut features = Features::default();
        if self.needs_chains() {
            features.surface = self.chains(samples, craters);
        }
        if self.scene.settings.analog.features_are_ideal() {
            // Ideal sub-generators are seen to have late words at the next sample.
            features.surface.bends.retain(|bend| !bend.is_late);
            self.follow_the_law(samples, craters, &mut features);
        } else {
            self.follow_the_chains(&mut features);
        }
        features
    }

    /// Features at the samples, and what the video is made of between them.
    fn features(&self, samples: &Samples<'_>, craters: &[DrawnCrater]) -> Features {
        let is_needed = self.needs_chains();
        let mut features = self.relief(samples, craters);
        let video = |sample: usize| {
            if !features.lit[sample] && is_needed {
                samples.light[sample]
            } else {
                self.video_at(samples, &features, sample)
            }
        };
        features.video = (0..samples.ground.len()).map(video).collect();
        features
    }

    /// The sub-generators with the craters that are in them, in the order of the list.
    fn chains(&self, samples: &Samples<'_>, craters: &[DrawnCrater]) -> Surface {
        let (scene, kit) = (self.scene, Kit::of(self.scene, self.given));
        let comparator = kit.analog.comparator;
        let limit = scene.settings.feature_generator.sub_generators;
        let all = scene.landscape.features();
        let load = |drawn: &DrawnCrater| {
            let crater = all.crater(drawn.crater);
            let figures = SubGeneratorFigures::of(&kit, crater.type_number(), drawn.sub_generator, limit);
            Loaded { crater, figures, from: drawn.from }
        };
        let loads: Vec<Loaded> = craters.iter().map(load).collect();
        let ranges = &samples.ranges[..samples.ground.len()];
        let line = Line { foot: [scene.eye[0], scene.eye[1]], direction: self.direction, ranges };
        surface(&line, &loads, comparator.offset > 0.0 || comparator.overdrive > 0.0)
    }

    /// Features of ideal parts.
    fn follow_the_law(&self, samples: &Samples<'_>, craters: &[DrawnCrater], features: &mut Features) {
        let craters = met(self.scene, craters);
        let foot = [self.scene.eye[0], self.scene.eye[1]];
        for range in &samples.ranges[..samples.ground.len()] {
            let from_foot = self.direction.map(|cosine| range * cosine);
            let relief = relief(&craters, foot, from_foot, *range);
            features.height.push(relief.height);
            features.slopes.push(relief.slopes);
            features.present.push(relief.present);
            features.clear.push(relief.clear);
        }
        features.lit = features.present.clone();
    }

    fn follow_the_chains(&self, features: &mut Features) {
        let surface = &features.surface;
        features.slopes = surface.slopes.iter().map(|slopes| self.to_map(*slopes)).collect();
        features.height = surface.height.clone();
        features.present = surface.present.clone();
        features.lit = surface.at_work.clone();
        features.clear = surface.clear.clone();
    }

    /// Slopes along and across the sweep as slopes to the north and to the east.
    pub(crate) fn to_map(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        let [cos, sin] = self.direction;
        [along * cos - across * sin, along * sin + across * cos]
    }

    /// Slopes to the north and to the east as slopes along and across the sweep.
    pub(crate) fn to_sweep(&self, [north, east]: [f64; 2]) -> [f64; 2] {
        let [cos, sin] = self.direction;
        [north * cos + east * sin, east * cos - north * sin]
    }

    /// Light of ground with features at a range: slopes of both, height of both above the eye.
    pub(crate) fn lit(&self, ground: [f64; 2], added: [f64; 2], height: f64, range: f64) -> f64 {
        let slopes = match self.scene.settings.laws.feature_light {
            FeatureLight::Combined => [ground[0] + added[0], ground[1] + added[1]],
            FeatureLight::AsReported => added,
        };
        self.light.reflectivity(slopes, height / range)
    }

    fn video_at(&self, samples: &Samples<'_>, features: &Features, sample: usize) -> f64 {
        let GroundSample { height, slopes } = samples.ground[sample];
        let above = height + features.height[sample] - self.scene.eye[2];
        self.lit(slopes, features.slopes[sample], above, samples.ranges[sample])
    }

    /// Texture, with what craters add to its gain.
    fn grain(&self, samples: &Samples<'_>, added: Option<&[f64]>) -> Grain {
        let Some(pattern) = self.scene.landscape.texture() else { return Grain::default() };
        let (eye, is_ideal) = (self.scene.eye, self.scene.settings.analog.texture_is_ideal());
        let at = |range: &f64| {
            let place = [0, 1].map(|axis| eye[axis] + range * self.direction[axis]);
            texture(pattern, place, *range)
        };
        let values: Vec<f64> = samples.ranges[..samples.ground.len()].iter().map_while(at).collect();
        if is_ideal {
            let margins = vec![f64::INFINITY; values.len()];
            return Grain { values: enlarged(values, added), margins };
        }
        self.grained(pattern, &values, added, samples.ranges)
    }

    /// Texture behind its parts, which have the machine's samples.
    fn grained(&self, pattern: &Texture, values: &[f64], added: Option<&[f64]>, ranges: &[f64]) -> Grain {
        let kit = Kit::of(self.scene, self.given);
        let between = self.given.between / self.stride();
        let every = |values: &[f64]| -> Vec<f64> { values.iter().step_by(between).copied().collect() };
        let added = added.map(every);
        let grain = grained(&kit, pattern, &every(values), added.as_deref(), &every(ranges));
        let wide = |wire: &[f64]| spread(wire, between, values.len(), false);
        Grain { values: wide(&grain.values), margins: wide(&grain.margins) }
    }

    fn put_features(&mut self, wires: Wires, features: &Features) {
        let axis = |axis: usize| features.slopes.iter().map(|slopes| slopes[axis]).collect::<Vec<_>>();
        let present = gates(&features.present);
        let shown = features.video.iter().zip(&features.lit);
        let shown: Vec<f64> = shown.map(|(video, lit)| if *lit { video.max(0.0) } else { 0.0 }).collect();
        self.put_wire(wires, "fg.height", &features.height);
        self.put_wire(wires, "fg.slope.u", &axis(0));
        self.put_wire(wires, "fg.slope.v", &axis(1));
        self.put_gate(wires, "fg.or", &present);
        self.put_gate(wires, "fg.present", &present);
        self.put_wire(wires, "fg.reflectivity", &shown);
        for name in ["fg.slope.u", "fg.slope.v", "fg.or", "fg.present"] {
            self.record.margins.insert(name.into(), features.clear.clone());
        }
        let rest =
            features.surface.rest.iter().map(|rest| rest * REST).chain(std::iter::repeat(f64::INFINITY));
        let near = features.clear.iter().zip(rest).map(|(clear, rest)| clear.min(rest)).collect();
        self.record.margins.insert("fg.reflectivity".into(), near);
    }

    /// Texture and what craters add to its gain; `clear` is how near each sample is to where a crater begins.
    fn put_grain(&mut self, wires: Wires, grain: &Grain, (added, clear): (Option<&[f64]>, &[f64])) {
        let whole = |values: &[f64]| {
            let mut values = values.to_vec();
            values.resize(wires.count.div_ceil(wires.stride), 0.0);
            values
        };
        self.put_wire(wires, "fg.grain", &whole(added.unwrap_or_default()));
        self.put_wire(wires, "txg.texture", &whole(&grain.values));
        let mut margins = grain.margins.clone();
        if added.is_some() {
            self.record.margins.insert("fg.grain".into(), clear.to_vec());
            margins.iter_mut().zip(clear).for_each(|(margin, clear)| *margin = margin.min(*clear));
        }
        self.record.margins.insert("txg.texture".into(), margins);
    }

    pub(crate) fn put_wire(&mut self, wires: Wires, name: &str, values: &[f64]) {
        self.record.signals.insert(name.into(), spread(values, wires.stride, wires.count, false));
    }

    pub(crate) fn put_gate(&mut self, wires: Wires, name: &str, values: &[f64]) {
        self.record.signals.insert(name.into(), spread(values, wires.stride, wires.count, true));
    }

    /// The unit of ideal parts.
    fn mix_ideally(&mut self, samples: &Samples<'_>, features: &Features, grain: &Grain) -> Broken {
        let mixing = self.scene.settings.mixing_unit;
        let mut signed = Vec::new();
        for sample in 0..samples.ground.len() {
            // A gate of the video itself is open wherever there is video.
            let present = match mixing.gate {
                GateKind::Presence => features.present[sample],
                GateKind::SelfKeyed => features.lit[sample],
            };
            let shadow = self.given.shadow.get(sample).is_some_and(|gate| *gate > 0.5);
            let inputs = Inputs {
                terrain: samples.light[sample],
                features: features.video[sample],
                present,
                shadow,
                texture: grain.values.get(sample).copied(),
            };
            let mixed = mix(self.scene, &inputs);
            let values = [("mu.vs1", mixed.vs1), ("mu.vs1.fade", mixed.vs1)];
            let dark = ["sc.or", "sc.gate", "mu.vs2", "mu.vs2.fade"].map(|name| (name, shadow));
            values.into_iter().chain(dark).for_each(|(name, open)| self.record.put(name, gate(open)));
            let keyed = (features.video[sample] - mixing.threshold).abs();
            let near = features.clear[sample].min(keyed);
            for name in ["mu.vs1", "mu.vs1.fade", "mu.reflectivity", "sm.video"] {
                self.record.put_margin(name, near);
            }
            signed.push(mixed.signed);
        }
        let video = Broken { samples: self.video(signed), jumps: Vec::new() };
        let seen = video.samples.iter().map(|video| video.max(0.0)).collect();
        self.record.signals.insert("mu.reflectivity".into(), seen);
        video
    }

    /// Video behind its output amplifier.
    fn video(&self, signed: Vec<f64>) -> Vec<f64> {
        if self.wires.lags("mu.reflectivity") {
            self.wires.pass_lit("mu.reflectivity", signed)
        } else {
            signed
        }
    }
}

/// How the samples that are looked at lie on the clock.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wires {
    /// Steps from one to the next.
    pub stride: usize,
    /// Steps of the sweep within the stored ground.
    pub count: usize,
}
