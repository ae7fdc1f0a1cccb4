//! The mixing unit of real parts along a sweep: what it is given, and its gates (section 14).

use hardware_model::Gate as GateKind;
use scenario::TextureInShadow;

use crate::composite::{Features, Samples, Wires, gate, gates};
use crate::parts::broken::{Broken, Jump};
use crate::parts::crater_chains::Bend;
use crate::parts::gates::Gate;
use crate::parts::kit::Kit;
use crate::parts::mixer::{Inputs, MixerFigures};
use crate::parts::texture::Grain;
use crate::projector::hermite;
use crate::sweep::Walker;

/// A rim of a crater in its light.
#[derive(Debug, Clone, Copy)]
struct LitBend {
    /// Number of the sample at which its step ends.
    sample: usize,
    /// Part of the step.
    share: f64,
    /// Instant of the edge (steps).
    at: f64,
    /// Light of the surface just before and just behind it.
    video: [f64; 2],
    /// What input S of VS1 has just before and just behind it.
    sides: [f64; 2],
}

impl Walker<'_> {
    /// The unit of real parts.
    pub(crate) fn mix_by_parts(
        &mut self,
        wires: Wires,
        samples: &Samples<'_>,
        features: &Features,
        grain: Grain,
    ) -> Broken {
        let kit = Kit::of(self.scene, self.given);
        let unit = MixerFigures::of(&kit);
        let bends = self.lit_bends(samples, features);
        let vs1 = self.gate_of_features(samples, features, &bends, &unit);
        let (dark, edges) = self.given.shadow_edges;
        let of_shadow = || Gate::of_edges(dark, edges, samples.ranges, &unit.comparators[1]);
        let vs2 = self.scene.settings.shadows.is_some().then(of_shadow);
        let near = self.near(features, &vs1, vs2.as_ref());
        let has_features = !self.scene.landscape.features().is_empty();
        let vs1 = has_features.then_some(vs1);
        let present = has_features.then(|| self.presence(samples, features, &unit));
        self.put_gates(wires, &unit, [present, vs1.clone(), vs2.clone()], &near);
        let of_grain = grain.margins.iter().copied().chain(std::iter::repeat(f64::INFINITY));
        let of_gates = near[0].iter().zip(&near[1]).map(|(vs1, vs2)| vs1.min(*vs2));
        let of_video: Vec<f64> = of_gates.zip(of_grain).map(|(gate, grain)| gate.min(grain)).collect();
        ["mu.reflectivity", "sm.video"].into_iter().for_each(|name| self.put_near(name, &of_video));
        let video = unit.mix(Inputs {
            terrain: samples.light.to_vec(),
            features: has_features.then(|| video_of_features(features, &bends)),
            gates: [vs1, vs2],
            rims: bends.iter().map(|bend| bend.at).collect(),
            texture: grain.values,
            texture_first: self.scene.settings.laws.texture_in_shadow == TextureInShadow::Off,
        });
        self.put_wire(wires, "mu.reflectivity", &video.samples);
        video
    }

    /// Light of the features on both sides of each rim.
    fn lit_bends(&self, samples: &Samples<'_>, features: &Features) -> Vec<LitBend> {
        let eye = self.scene.eye[2];
        let lit = |bend: &Bend| {
            let Bend { sample, share, range, .. } = *bend;
            let step = samples.ranges[sample] - samples.ranges[sample - 1];
            let ends = [sample - 1, sample].map(|sample| &samples.ground[sample]);
            let slopes = ends.map(|ground| self.to_sweep(ground.slopes));
            let [from, to] = [0, 1].map(|end| [ends[end].height, slopes[end][0] * step]);
            let (height, along) = hermite(share, from, to);
            let across = slopes[0][1] + share * (slopes[1][1] - slopes[0][1]);
            let ground = self.to_map([along / step, across]);
            let above = height + bend.height - eye;
            let video = bend.slopes.map(|added| self.lit(ground, self.to_map(added), above, range));
            // What the terrain's light is there, as a straight line has it.
            let light =
                samples.light[sample - 1] + share * (samples.light[sample] - samples.light[sample - 1]);
            let sides = [0, 1].map(|side| {
                let is_lit = bend.present[side] || features.lit[sample - 1 + side];
                if is_lit { video[side] } else { light }
            });
            LitBend { sample, share, at: sample as f64 - 1.0 + share, video, sides }
        };
        features.surface.bends.iter().map(lit).collect()
    }

    /// When the comparators behind the line generators answer, edge by edge of the gate of shadow: at once in an ideal unit.
    pub(crate) fn shadow_answers(&self, ranges: &[f64]) -> Vec<Option<f64>> {
        let [_, comparator] = MixerFigures::of(&Kit::of(self.scene, self.given)).comparators;
        let (_, edges) = self.given.shadow_edges;
        edges.iter().map(|edge| edge.answered(ranges, &comparator)).collect()
    }

    /// The presence line behind its comparator.
    pub(crate) fn presence(&self, samples: &Samples<'_>, features: &Features, unit: &MixerFigures) -> Gate {
        let comparator = self.scene.settings.analog.comparator;
        if comparator.offset > 0.0 || comparator.overdrive > 0.0 {
            return Gate::of_edges(false, &features.surface.edges, samples.ranges, &unit.comparators[0]);
        }
        let rims = features.surface.bends.iter();
        let rims = rims.map(|bend| Rim { sample: bend.sample, share: bend.share, opens: bend.present[1] });
        followed(&behind(samples, &features.present), rims, unit.comparators[0].on_ramp(f64::INFINITY))
    }

    /// The gate of VS1 behind its comparator.
    fn gate_of_features(
        &self,
        samples: &Samples<'_>,
        features: &Features,
        bends: &[LitBend],
        unit: &MixerFigures,
    ) -> Gate {
        let mixing = self.scene.settings.mixing_unit;
        if mixing.gate == GateKind::Presence {
            return self.presence(samples, features, unit);
        }
        let opens = |video: f64| video.max(0.0) > mixing.threshold;
        let open: Vec<bool> =
            features.lit.iter().zip(&features.video).map(|(lit, video)| *lit && opens(*video)).collect();
        let rims = bends.iter();
        let rims =
            rims.map(|bend| Rim { sample: bend.sample, share: bend.share, opens: opens(bend.video[1]) });
        followed(&behind(samples, &open), rims, unit.comparators[0].on_ramp(f64::INFINITY))
    }

    /// How near the samples are to other decisions of the unit: by VS1, and by VS2.
    fn near(&self, features: &Features, vs1: &Gate, vs2: Option<&Gate>) -> [Vec<f64>; 2] {
        let (count, mixing) = (features.height.len(), self.scene.settings.mixing_unit);
        let mut keyed = f64::INFINITY;
        let of_vs1 = vs1.margins(count).into_iter().zip(&features.video).map(|(near, video)| {
            if mixing.gate == GateKind::SelfKeyed {
                // A gate that opens half way between samples is late for some more.
                keyed = keyed.min((video - mixing.threshold).abs());
            }
            near.min(keyed)
        });
        [of_vs1.collect(), vs2.map_or_else(|| vec![f64::INFINITY; count], |gate| gate.margins(count))]
    }

    fn put_gates(
        &mut self,
        wires: Wires,
        unit: &MixerFigures,
        given: [Option<Gate>; 3],
        near: &[Vec<f64>; 2],
    ) {
        let count = near[0].len();
        let [present, vs1, vs2] = given;
        let open = |gate: &Option<Gate>| {
            gate.as_ref().map_or_else(|| vec![0.0; count], |gate| gates(&gate.at_samples(count)))
        };
        let switches = [vs1, vs2];
        let fades = unit.fades(&switches).map(|fade| {
            let value = |sample: usize| fade.as_ref().map_or(0.0, |fade| fade.at(sample as f64)[1]);
            (0..count).map(value).collect::<Vec<f64>>()
        });
        self.put_gate(wires, "fg.present", &open(&present));
        let dark: Vec<f64> =
            self.given.shadow.iter().map(|gate_of| gate(*gate_of > 0.5)).take(wires.count).collect();
        self.record.signals.insert("sc.or".into(), dark);
        let names = [["mu.vs1", "mu.vs1.fade"], ["mu.vs2", "mu.vs2.fade"]];
        for (switch, [name, fade]) in names.into_iter().enumerate() {
            self.put_gate(wires, name, &open(&switches[switch]));
            self.put_wire(wires, fade, &fades[switch]);
            [name, fade].into_iter().for_each(|name| self.put_near(name, &near[switch]));
        }
        self.put_gate(wires, "sc.gate", &open(&switches[1]));
        self.put_near("fg.present", &near[0]);
        self.put_near("sc.gate", &near[1]);
    }

    fn put_near(&mut self, name: &str, near: &[f64]) {
        self.record.margins.insert(name.into(), near.to_vec());
    }
}

/// A rim between two samples, for a gate.
struct Rim {
    /// Number of the sample at which its step ends.
    sample: usize,
    /// Part of the step.
    share: f64,
    /// Whether the gate is open behind it.
    opens: bool,
}

/// A gate that follows a line at the samples and at the rims between them, `late` steps later: where it changes without a rim, half
/// way from the last sample or rim.
fn followed(open: &[bool], rims: impl Iterator<Item = Rim>, late: f64) -> Gate {
    let mut rims = rims.peekable();
    let begins_open = open.first().copied().unwrap_or(false);
    let (mut now, mut changes) = (begins_open, Vec::new());
    let mut change = |to: bool, at: f64| {
        if to != now {
            changes.push(at + late);
            now = to;
        }
    };
    for (sample, open) in open.iter().enumerate().skip(1) {
        let begin = sample as f64 - 1.0;
        let mut share = 0.0;
        while let Some(rim) = rims.next_if(|rim| rim.sample == sample) {
            share = rim.share;
            change(rim.opens, begin + share);
        }
        change(*open, begin + 0.5 * (share + 1.0));
    }
    Gate { begins_open, changes }
}

/// What input S of VS1 is given: beyond what is lit it is the ground's.
fn video_of_features(features: &Features, bends: &[LitBend]) -> Broken {
    let jumps = bends.iter().map(|bend| Jump { at: bend.at, before: bend.sides[0], after: bend.sides[1] });
    Broken { samples: features.video.clone(), jumps: jumps.collect() }
}

/// A line with the sample behind the stored ground, where there is one: features end there, and a fade begins before its gate changes.
fn behind(samples: &Samples<'_>, open: &[bool]) -> Vec<bool> {
    let ends = samples.ground.len() < samples.ranges.len();
    open.iter().copied().chain(ends.then_some(false)).collect()
}
