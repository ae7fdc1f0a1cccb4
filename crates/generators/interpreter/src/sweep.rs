//! One sweep, in the order of section 24.

use std::collections::BTreeMap;

use features::Crater;
use scenario::Occlusion;

use crate::craters::{Relief, kinks, relief};
use crate::event::Event;
use crate::fan::{direction, tangent, written_raster};
use crate::given::Given;
use crate::levels::{GroundSample, Terrain, terrain};
use crate::light::Light;
use crate::loads::{Loads, Passing, craters};
use crate::mixing::{Inputs, Mixed, mix, texture};
use crate::output_amplifiers::OutputAmplifiers;
use crate::parts::{Array, ReflectivityStage};
use crate::projector::{Circuit, Deflection, Rim, elevation, shown};
use crate::scene::SceneData;
use crate::shadows::segments;
use crate::wires;
use landscape::Level;
use scenario::FeatureLight;

const MICROSECONDS: f64 = 1e6;

/// What one sweep gave, up to the last sample within the stored ground.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Record {
    /// Signals by the name that the machine gives them.
    pub signals: BTreeMap<String, Vec<f64>>,
    /// How near each sample of a signal is to a threshold that decides it, in the unit of the signal that is compared
    /// there or as a share of a radius; signals that nothing decides are not here.
    pub margins: BTreeMap<String, Vec<f64>>,
    /// Event lists of both levels, and loads of craters and of shadow boundaries.
    pub events: Vec<Event>,
    /// The last tick of each level's walk: later events are nobody's.
    pub last_ticks: [i64; 2],
    /// Ticks, by level, in which rounding says when a stop is seen.
    pub undecided: [Vec<i64>; 2],
    /// Whether rounding says which tick sees a load of a crater or of a shadow boundary.
    pub loads_undecided: bool,
    /// Instants of the stops of the fine level, in accumulator steps from the first sample, with axis (0 is X).
    pub stops: Vec<(f64, usize)>,
    /// Distance of the accumulators of either level from another word of their converters (full scales), by sample: the least within
    /// the memory of the parts.
    pub stairs: Vec<f64>,
    /// Samples within the stored ground.
    pub samples: usize,
    /// Whether the sweep left the stored ground before its end.
    pub left_the_area: bool,
    /// Whether it met a crater or an edge of shadow: what main signals with amplifiers do there it does not know.
    pub has_breaks: bool,
}

impl Record {
    fn put(&mut self, name: impl Into<String>, value: f64) {
        self.signals.entry(name.into()).or_default().push(value);
    }

    fn put_margin(&mut self, name: &str, value: f64) {
        self.margins.entry(name.to_owned()).or_default().push(value);
    }
}

/// Walks sweep `sweep` step by step.
pub fn interpret(scene: &SceneData<'_>, sweep: u32, given: &Given<'_>) -> Record {
    let set_up = given.frame.set_ups[sweep as usize];
    let direction = direction(scene, set_up);
    let mut terrain = terrain(scene, sweep, direction, given);
    let passing = Passing { sweep, direction, ranges: given.ranges, end: terrain.end(scene) };
    let wires = OutputAmplifiers::of(scene, given);
    let mut walker = Walker {
        scene,
        given,
        set_up,
        direction,
        wires,
        light: Light::of(scene, direction),
        craters: met(scene, direction, given.ranges),
        record: Record::default(),
    };
    walker.array(&terrain);
    drive(&wires, &mut terrain.ground);
    let composite = walker.landscape(&terrain.ground);
    walker.project(&terrain.ground, &composite);
    // The gate of another sweep's set-up comes with the times of that sweep.
    let lines = if set_up == sweep { given.lines } else { &[] };
    walker.finish(terrain, [craters(scene, &passing), segments(scene, &passing, lines)])
}

/// The array of real parts of a level (0 fine, 1 coarse) as sweep `sweep` drives it; none where the level or its parts are not there.
pub fn array(scene: &SceneData<'_>, sweep: u32, given: &Given<'_>, level: usize) -> Option<Array> {
    let direction = direction(scene, given.frame.set_ups[sweep as usize]);
    let Terrain { fine, coarse, .. } = terrain(scene, sweep, direction, given);
    [Some(fine), coarse].into_iter().nth(level)??.array
}

/// Height and slopes of the terrain behind their amplifiers.
fn drive(wires: &OutputAmplifiers<'_>, ground: &mut [GroundSample]) {
    let pass =
        |name: &str, value: fn(&GroundSample) -> f64| wires.pass(name, ground.iter().map(value).collect());
    let heights = pass("tg.height", |ground| ground.height);
    let north = pass("tg.slope.u", |ground| ground.slopes[0]);
    let east = pass("tg.slope.v", |ground| ground.slopes[1]);
    for (k, ground) in ground.iter_mut().enumerate() {
        *ground = GroundSample { height: heights[k], slopes: [north[k], east[k]] };
    }
}

/// Craters that the sweep meets, in the order of the list.
fn met(scene: &SceneData<'_>, [cos, sin]: [f64; 2], ranges: &[f64]) -> Vec<Crater> {
    let end = ranges.last().copied().unwrap_or(0.0);
    let meets = |crater: &Crater| {
        let (north, east) = (crater.centre()[0] - scene.eye[0], crater.centre()[1] - scene.eye[1]);
        let (along, beside) = (north * cos + east * sin, east * cos - north * sin);
        let reach = crater.outer() * 1.001;
        beside.abs() <= reach && along >= -reach && along <= end + reach
    };
    scene.landscape.features().craters().iter().filter(meets).collect()
}

struct Walker<'a> {
    scene: &'a SceneData<'a>,
    given: &'a Given<'a>,
    /// The sweep whose set-up this one is drawn with.
    set_up: u32,
    direction: [f64; 2],
    wires: OutputAmplifiers<'a>,
    light: Light,
    craters: Vec<Crater>,
    record: Record,
}

impl Walker<'_> {
    /// Signals of the arrays.
    fn array(&mut self, terrain: &Terrain) {
        let coarse = terrain.coarse.iter().map(|walk| ("coarse.", walk, self.scene.coarse()));
        let levels: Vec<_> =
            [("", &terrain.fine, Some(self.scene.fine()))].into_iter().chain(coarse).collect();
        for (name, walk, level) in levels {
            let region_size = level.map_or(1.0, Level::region_size);
            self.record.signals.extend(wires::of(name, &walk.samples, region_size));
            let stairs = &mut self.record.stairs;
            stairs.resize(stairs.len().max(walk.samples.len()), f64::INFINITY);
            stairs
                .iter_mut()
                .zip(&walk.samples)
                .for_each(|(least, sample)| *least = least.min(sample.stairs));
        }
    }

    /// Generators and mixing unit; returns heights of the composite landscape (m).
    fn landscape(&mut self, ground: &[GroundSample]) -> Vec<f64> {
        let scene = self.scene;
        let eye = scene.eye;
        let mut heights = Vec::new();
        let lights = self.lights(ground);
        let mut videos = Vec::new();
        for (k, (&GroundSample { height, slopes }, &range)) in
            ground.iter().zip(self.given.ranges).enumerate()
        {
            let from_foot = self.direction.map(|cosine| range * cosine);
            let place = [eye[0] + from_foot[0], eye[1] + from_foot[1]];
            let Relief { height: rise, slopes: added, present, clear } =
                relief(&self.craters, [eye[0], eye[1]], from_foot);
            let terrain_light = lights[k];
            let lit_slopes = match scene.settings.laws.feature_light {
                FeatureLight::Combined => [slopes[0] + added[0], slopes[1] + added[1]],
                FeatureLight::AsReported => added,
            };
            let feature_light = self.light.reflectivity(lit_slopes, (height + rise - eye[2]) / range);
            let grain = scene.landscape.texture().and_then(|pattern| texture(pattern, place, range));
            let shadow = self.given.shadow.get(k).is_some_and(|gate| *gate > 0.5);
            let inputs =
                Inputs { terrain: terrain_light, features: feature_light, present, shadow, texture: grain };
            let mixed = mix(scene, &inputs);
            let gate = |open: bool| if open { 1.0 } else { 0.0 };
            let values = [
                ("tg.height", height),
                ("tg.slope.u", slopes[0]),
                ("tg.slope.v", slopes[1]),
                ("tg.reflectivity", terrain_light.max(0.0)),
                ("fg.height", rise),
                ("fg.slope.u", added[0]),
                ("fg.slope.v", added[1]),
                ("fg.or", gate(present)),
                ("fg.present", gate(present)),
                ("fg.reflectivity", if present { feature_light.max(0.0) } else { 0.0 }),
                ("txg.texture", grain.unwrap_or(0.0)),
                ("mu.vs1", gate(mixed.vs1)),
                ("mu.vs1.fade", gate(mixed.vs1)),
                ("sc.or", gate(shadow)),
                ("sc.gate", gate(shadow)),
                ("mu.vs2", gate(shadow)),
                ("mu.vs2.fade", gate(shadow)),
            ];
            values.into_iter().for_each(|(name, value)| self.record.put(name, value));
            let threshold = scene.settings.mixing_unit.threshold;
            let keyed = clear.min((feature_light - threshold).abs());
            for name in ["fg.slope.u", "fg.slope.v", "fg.or", "fg.present", "fg.reflectivity"] {
                self.record.put_margin(name, clear);
            }
            for name in ["mu.vs1", "mu.vs1.fade", "mu.reflectivity", "sm.video"] {
                self.record.put_margin(name, keyed);
            }
            heights.push(height + rise);
            videos.push(mixed);
        }
        let heights = self.wires.pass("mu.height", heights);
        self.record.signals.insert("mu.height".into(), heights.clone());
        self.record.signals.insert("mu.reflectivity".into(), self.video(&videos));
        heights
    }

    /// Light of the terrain behind its stage and its amplifier.
    fn lights(&self, ground: &[GroundSample]) -> Vec<f64> {
        let eye = self.scene.eye;
        let places = ground.iter().zip(self.given.ranges);
        let raw = places
            .map(|(ground, range)| self.light.reflectivity(ground.slopes, (ground.height - eye[2]) / range));
        let stage = ReflectivityStage::of(self.scene);
        self.wires.pass("tg.reflectivity", stage.pass(raw.collect(), self.given.between))
    }

    /// Video behind its amplifier.
    fn video(&self, mixed: &[Mixed]) -> Vec<f64> {
        if !self.wires.lags("mu.reflectivity") {
            return mixed.iter().map(|mixed| mixed.reflectivity).collect();
        }
        self.wires.pass_lit("mu.reflectivity", mixed.iter().map(|mixed| mixed.signed).collect())
    }

    /// Projection processor and what drives the beam.
    fn project(&mut self, ground: &[GroundSample], heights: &[f64]) {
        let SceneData { settings, eye, pitch, .. } = *self.scene;
        let laws = settings.laws;
        let places = heights.iter().zip(self.given.ranges);
        let elevations: Vec<f64> =
            places.map(|(&height, &range)| elevation(height, eye[2], range, laws.curvature)).collect();
        let rims = self.rims(ground, heights.len());
        let (field, lines) = written_raster(self.scene);
        let raster = (lines, field.tan_half_height);
        let deflection = Deflection::of(laws.projection, pitch, tangent(self.scene, self.set_up), raster);
        let steps_a_second = {
            let timebase = &settings.timebase;
            let steps = timebase.sweeps as f64 * (timebase.active_samples + timebase.retrace_samples) as f64;
            timebase.update.hertz() * steps
        };
        let mut circuit = Circuit::at_start(laws.occlusion);
        for (k, steps) in shown(&elevations, &rims).into_iter().enumerate() {
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
            let video = self.record.margins.get_mut("sm.video").and_then(|margins| margins.get_mut(k));
            if let Some(video) = video {
                *video = video.min(margin);
            }
        }
    }

    /// Rims of craters between the samples: the terrain there is the cubic through heights and slopes beside.
    fn rims(&self, ground: &[GroundSample], samples: usize) -> Vec<Rim> {
        let (eye, ranges) = (self.scene.eye, &self.given.ranges[..samples]);
        let [cos, sin] = self.direction;
        let foot = [eye[0], eye[1]];
        let mut rims = Vec::new();
        for kink in kinks(&self.craters, foot, self.direction) {
            let step = ranges.partition_point(|range| *range < kink);
            if step == 0 || step >= samples {
                continue;
            }
            let (from, to) = (ranges[step - 1], ranges[step]);
            let share = (kink - from) / (to - from);
            let along =
                |ground: &GroundSample| (ground.slopes[0] * cos + ground.slopes[1] * sin) * (to - from);
            let (a, b) = (&ground[step - 1], &ground[step]);
            let terrain = hermite(share, [a.height, along(a)], [b.height, along(b)]);
            let rise = relief(&self.craters, foot, [kink * cos, kink * sin]).height;
            let curvature = self.scene.settings.laws.curvature;
            rims.push(Rim { step, share, elevation: elevation(terrain + rise, eye[2], kink, curvature) });
        }
        rims
    }

    fn finish(mut self, terrain: Terrain, loads: [Loads; 2]) -> Record {
        let Terrain { fine, coarse, ground } = terrain;
        self.record.has_breaks = !self.craters.is_empty() || self.given.shadow.iter().any(|gate| *gate > 0.5);
        self.record.samples = ground.len();
        self.record.left_the_area = ground.len() < self.given.ranges.len();
        self.record.stops = fine.stops;
        self.record.last_ticks = [fine.last_tick, coarse.as_ref().map_or(i64::MIN, |walk| walk.last_tick)];
        self.record.undecided =
            [fine.undecided, coarse.as_ref().map_or(vec![], |walk| walk.undecided.clone())];
        self.record.loads_undecided = loads.iter().any(|loads| loads.undecided);
        let [craters, segments] = loads.map(|loads| loads.events);
        let coarse = coarse.map_or(vec![], |walk| walk.events);
        self.record.events = [fine.events, coarse, craters, segments].concat();
        self.record
    }
}

/// The cubic with value and derivative (a step) at both ends.
fn hermite(s: f64, [y0, m0]: [f64; 2], [y1, m1]: [f64; 2]) -> f64 {
    let (s2, s3) = (s * s, s * s * s);
    (2.0 * s3 - 3.0 * s2 + 1.0) * y0 + (s3 - 2.0 * s2 + s) * m0 + (3.0 * s2 - 2.0 * s3) * y1 + (s3 - s2) * m1
}
