//! The projection processor along a sweep, of ideal and of real parts (section 15).

use scenario::Occlusion;

use crate::composite::{Composite, Wires, gates};
use crate::craters::{kinks, relief};
use crate::fan::{tangent, written_raster};
use crate::levels::GroundSample;
use crate::parts::beam::{Beam, Driven, Profile};
use crate::parts::broken::Broken;
use crate::parts::kit::Kit;
use crate::projector::{Circuit, Deflection, Rim, elevation, hermite, shown};
use crate::sweep::Walker;

const MICROSECONDS: f64 = 1e6;

impl Walker<'_> {
    /// Projection processor and what drives the beam.
    pub(crate) fn project(&mut self, ground: &[GroundSample], composite: &Composite) {
        let (scene, eye, laws) = (self.scene, self.scene.eye, self.scene.settings.laws);
        let places = composite.heights.iter().zip(self.given.ranges);
        let elevations: Vec<f64> =
            places.map(|(&height, &range)| elevation(height, eye[2], range, laws.curvature)).collect();
        let (field, lines) = written_raster(scene);
        let raster = (lines, field.tan_half_height);
        let deflection = Deflection::of(laws.projection, scene.pitch, tangent(scene, self.set_up), raster);
        if scene.settings.analog.beam_is_ideal() {
            let rims = self.rims(ground, composite);
            self.occlude(&elevations, &rims, &deflection);
        } else {
            self.drive(&elevations, composite, &deflection);
        }
    }

    /// The processor of ideal parts.
    fn occlude(&mut self, elevations: &[f64], rims: &[Rim], deflection: &Deflection) {
        let laws = self.scene.settings.laws;
        let steps_a_second = self.scene.settings.timebase.sample_rate().hertz();
        let mut circuit = Circuit::at_start(laws.occlusion);
        for (k, steps) in shown(elevations, rims).into_iter().enumerate() {
            let held_before = circuit.held;
            let mut margin = f64::INFINITY;
            for eta in steps {
                margin = margin.min((eta - circuit.held).abs());
                circuit.step(eta);
            }
            // A sample beside a top lies below the hold that it has just moved, and is in sight.
            let blank = elevations[k] < circuit.held && circuit.held == held_before;
            let rate = match (laws.occlusion, k) {
                (Occlusion::PeakHold, _) | (_, 0) => 0.0,
                _ => (elevations[k] - elevations[k - 1]) * steps_a_second / MICROSECONDS,
            };
            let video = if blank { 0.0 } else { self.record.signals["mu.reflectivity"][k] };
            let values = [
                ("dpp.elevation", elevations[k]),
                ("dpp.derivative", rate),
                ("dpp.hold", circuit.held),
                ("dpp.blank", if blank { 1.0 } else { 0.0 }),
                ("dpp.y", deflection.line(circuit.held)),
                ("sm.video", video),
            ];
            values.into_iter().for_each(|(name, value)| self.record.put(name, value));
            self.record.put_margin("dpp.blank", margin);
            self.come_near_video(k, margin);
        }
    }

    fn come_near_video(&mut self, sample: usize, margin: f64) {
        let video = self.record.margins.get_mut("sm.video").and_then(|margins| margins.get_mut(sample));
        if let Some(video) = video {
            *video = video.min(margin);
        }
    }

    /// The processor of real parts, at the samples of the machine.
    fn drive(&mut self, elevations: &[f64], composite: &Composite, deflection: &Deflection) {
        let (scene, between) = (self.scene, self.given.between);
        let wires = Wires { stride: between, count: elevations.len() };
        let kit = Kit::of(scene, self.given);
        let samples = elevations.len().div_ceil(between);
        let Broken { samples: video, jumps } = &composite.video;
        let every = (video.len() / samples.max(1)).max(1);
        let profile = Profile {
            tangents: elevations.iter().step_by(between).copied().collect(),
            samples: self.given.ranges.len().div_ceil(between),
            video: Broken { samples: video.iter().step_by(every).copied().collect(), jumps: jumps.clone() },
            number: scene.frame * u64::from(scene.settings.raster.sweeps) + u64::from(self.sweep),
        };
        let driven = Beam::of(&kit, scene.settings.laws.occlusion, deflection).project(&profile);
        self.put_driven(wires, &driven);
    }

    fn put_driven(&mut self, wires: Wires, driven: &Driven) {
        self.put_wire(wires, "dpp.elevation", &driven.elevation);
        self.put_wire(wires, "dpp.derivative", &driven.derivative);
        self.put_wire(wires, "dpp.hold", &driven.hold);
        self.put_wire(wires, "dpp.y", &driven.line);
        self.put_gate(wires, "dpp.blank", &gates(&driven.blank));
        let shown = driven.video.iter().zip(&driven.blank);
        let shown: Vec<f64> = shown.map(|(video, blank)| if *blank { 0.0 } else { video.max(0.0) }).collect();
        self.put_wire(wires, "sm.video", &shown);
        let [of_hold, of_blank] = &driven.margins;
        for (sample, margin) in of_blank.iter().enumerate() {
            self.come_near_video(sample, *margin);
        }
        for (name, margins) in [("dpp.hold", of_hold), ("dpp.y", of_hold), ("dpp.blank", of_blank)] {
            self.record.margins.insert(name.into(), margins.clone());
        }
    }

    /// Rims of craters between the samples: the terrain there is the cubic through heights and slopes beside.
    fn rims(&self, ground: &[GroundSample], composite: &Composite) -> Vec<Rim> {
        let ranges = &self.given.ranges[..composite.heights.len()];
        let [cos, sin] = self.direction;
        let rim = |(range, rise): (f64, f64)| {
            let step = ranges.partition_point(|sample| *sample < range);
            if step == 0 || step >= ranges.len() {
                return None;
            }
            let (from, to) = (ranges[step - 1], ranges[step]);
            let share = (range - from) / (to - from);
            let along =
                |ground: &GroundSample| (ground.slopes[0] * cos + ground.slopes[1] * sin) * (to - from);
            let (a, b) = (&ground[step - 1], &ground[step]);
            let (terrain, _) = hermite(share, [a.height, along(a)], [b.height, along(b)]);
            let curvature = self.scene.settings.laws.curvature;
            let elevation = elevation(terrain + rise, self.scene.eye[2], range, curvature);
            Some(Rim { step, share, elevation })
        };
        self.rises(composite).into_iter().filter_map(rim).collect()
    }

    /// Ground ranges of the rims, and what features add to the height there (m).
    fn rises(&self, composite: &Composite) -> Vec<(f64, f64)> {
        if let Some(bends) = &composite.bends {
            return bends.iter().map(|bend| (bend.range, bend.height)).collect();
        }
        let (foot, [cos, sin]) = ([self.scene.eye[0], self.scene.eye[1]], self.direction);
        let rise = |range: f64| relief(&self.craters, foot, [range * cos, range * sin], range).height;
        let kinks = kinks(&self.craters, foot, self.direction).into_iter();
        kinks.map(|range| (range, rise(range))).collect()
    }
}
