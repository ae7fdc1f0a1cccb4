//! Level ground in colour, ray by ray: the example of `docs/adding-a-generator.md`.
//!
//! **Law.** The ray through a pixel's centre meets the plane `z = h` at the distance `(z_eye - h) / down`. The plane sends
//! back `albedo x sin(elevation of the sun)` of the light, in the colour of `[flat] colour`.
//! **Run parameters.**
//!
//! | key | range | default | what it is |
//! |---|---|---|---|
//! | `flat.colour` | three numbers, 0 to 1 | [1, 0.9, 0.7] | colour of the ground: linear red, green and blue |
//!
//! **Timing.** A painter takes one tick of 1 MHz a pixel; each line that is finished is an event.
//! **Not modelled.** Craters, bodies, lights, sheets, tracks, a map of albedo, texture, silhouettes, shadow, curvature, a second
//! level: listed. Ground with relief and other laws of reflection: refused.

use std::sync::Arc;

use blake3::Hasher;
use diagnostics::Reader;
use generator::{
    Along, Counter, Fact, FrameCounts, FrameError, Generator, Joined, Omission, PlaneKind, Planes,
    PrepareError, Role, Row, Scan, Session, Stage, Timed, Weight, check_eye,
};
use glam::DVec3;
use landscape::{Attitude, Photometry, bank_file};
use quantities::{Rate, Timebase, luminance};
use scenario::{Curvature, Pose, Scenario, View};
use serde_json::{Value, json};
use signal::{Probe, Signal, Unit, Waveform, Wire};
use timing::{EventHash, FrameTiming, Task, UnitUse};

/// The row of the registry.
pub static ROW: Row = Row {
    name: "flat",
    about: "level ground in colour, ray by ray",
    role: Role::Guest,
    signals: &SIGNALS,
    timed: true,
    parameters: Some("flat"),
    gear: None,
    ladders: &[],
    details: &[],
    lamps: &[],
    configure,
};

/// Signals along a line of the picture, pixel by pixel.
static SIGNALS: [Signal; 2] = [
    Signal::ground("flat.range", Unit::Metre, "ground range; -1 where there is sky", "none: an example"),
    Signal::ground("flat.light", Unit::Reflectivity, "luminance", "none: an example"),
];

static COUNTERS: [Counter; 1] = [Counter { name: "samples", joined: Joined::Sum }];

/// Ticks of its records in a second.
const MASTER_HZ: u64 = 1_000_000;

/// Reads `[flat] colour`: linear red, green and blue, 0..=1.
fn configure(root: &Reader) -> Option<Arc<dyn Generator>> {
    let colour =
        root.table_or_empty("flat").f64_array("colour").between(0.0, 1.0).default([1.0, 0.9, 0.7])?;
    Some(Arc::new(Flat { colour }))
}

/// Generator of level ground in one colour.
#[derive(Debug, Clone, Copy)]
struct Flat {
    colour: [f64; 3],
}

impl Generator for Flat {
    fn name(&self) -> &'static str {
        ROW.name
    }

    fn counters(&self) -> &'static [Counter] {
        &COUNTERS
    }

    fn planes(&self) -> &'static [PlaneKind] {
        &[PlaneKind::Intensity, PlaneKind::Range, PlaneKind::Red, PlaneKind::Green, PlaneKind::Blue]
    }

    fn draws_colour(&self, _: &Stage) -> bool {
        true
    }

    fn signals(&self) -> &'static [Signal] {
        &SIGNALS
    }

    fn scan(&self, view: &View) -> Option<Scan> {
        let timebase =
            Timebase::new(Rate::new(MASTER_HZ, 1)?, view.update, view.lines, view.columns, 0).ok()?;
        Some(Scan { line: "line", timebase, place: "flat.range", along: Along::Range })
    }

    fn record(&self) -> Value {
        json!({ "colour": self.colour })
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn Session>, PrepareError> {
        Ok(Box::new(Plain::new(stage, self.colour)?))
    }

    fn timed(&self, stage: Stage) -> Result<Option<Box<dyn Timed>>, PrepareError> {
        Ok(Some(Box::new(Plain::new(stage, self.colour)?)))
    }
}

/// The plane made ready.
struct Plain {
    stage: Stage,
    /// Height of the ground (m).
    height: f64,
    colour: [f64; 3],
}

/// What a ray sees: ground range (m) and light; nothing where there is sky.
type Seen = Option<(f64, [f64; 3])>;

impl Plain {
    fn new(stage: Stage, colour: [f64; 3]) -> Result<Self, PrepareError> {
        let height = stage.landscape.level().words()[0][0];
        let is_level = |words: &[f64; 9]| words[0] == height && words[1..].iter().all(|word| *word == 0.0);
        let refused = |what: &str| PrepareError::Unsupported {
            generator: ROW.name,
            what: what.into(),
            remedy: "give it level ground under Lambert's law".into(),
        };
        if !stage.landscape.level().words().iter().all(is_level) {
            return Err(refused("ground with relief"));
        }
        match *stage.landscape.photometry() == Photometry::Lambert {
            true => Ok(Self { stage, height, colour }),
            false => Err(refused("another law of reflection")),
        }
    }

    /// Direction of the ray through the centre of a pixel: north, east, down.
    fn ray(&self, pose: &Pose, [column, line]: [usize; 2]) -> DVec3 {
        let View { columns, lines, field, .. } = self.stage.view;
        let centre = |index: usize, count: u32| (2 * index + 1) as f64 / f64::from(count) - 1.0;
        let x = field.tan_half_width * centre(column, columns);
        let y = field.tan_half_height * centre(line, lines);
        let attitude = Attitude { roll: pose.yoke, ..pose.attitude };
        attitude.to_terrain() * DVec3::new(1.0, x, y)
    }

    fn seen(&self, pose: &Pose, pixel: [usize; 2]) -> Seen {
        let ray = self.ray(pose, pixel);
        let way = (pose.eye[2] - self.height) / ray.z;
        let range = ray.truncate().length() * way;
        let [near, far] = self.stage.view.ranges;
        let elevation = self.stage.scenery.sun(pose.time).elevation;
        let light = self.stage.landscape.albedo() * libm::sin(elevation).max(0.0);
        (ray.z > 0.0 && (near..=far).contains(&range)).then(|| (range, self.colour.map(|part| part * light)))
    }

    fn columns(&self) -> usize {
        self.stage.view.columns as usize
    }

    fn record(&self, frame: u64, pose: &Pose, probe: &mut Probe) {
        for line in (0..self.stage.view.lines).filter(|line| probe.wants_sweep(*line)).collect::<Vec<_>>() {
            let seen = |column| self.seen(pose, [column, line as usize]);
            let readings: [fn(Seen) -> f64; 2] = [
                |seen| seen.map_or(-1.0, |(range, _)| range),
                |seen| seen.map_or(0.0, |(_, light)| luminance(light)),
            ];
            for (signal, reading) in SIGNALS.into_iter().zip(readings) {
                if probe.wants(&signal) {
                    let values = (0..self.columns()).map(|column| reading(seen(column))).collect();
                    probe.waveforms.push(Waveform { signal, frame, sweep: line, times: Vec::new(), values });
                }
            }
        }
    }
}

/// The value of a plane where `seen` is seen.
fn value(kind: PlaneKind, seen: Seen) -> f32 {
    let Some((range, light)) = seen else { return kind.sky() };
    let channel = PlaneKind::COLOUR.iter().position(|channel| *channel == kind);
    match (kind, channel) {
        (_, Some(channel)) => light[channel] as f32,
        (PlaneKind::Range, _) => range as f32,
        _ => luminance(light) as f32,
    }
}

impl Session for Plain {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        self.check(frame, pose)?;
        for kind in PlaneKind::ALL {
            let Some(values) = planes.get_mut(kind) else { continue };
            for (at, pixel) in values.iter_mut().enumerate() {
                *pixel = value(kind, self.seen(pose, [at % self.columns(), at / self.columns()]));
            }
        }
        self.record(frame, pose, probe);
        let samples = u64::from(self.stage.view.columns) * u64::from(self.stage.view.lines);
        Ok(FrameCounts::of([("samples", samples)]))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        check_eye(&self.stage.landscape, frame, pose)
    }

    fn omissions(&self) -> Vec<Omission> {
        let Stage { landscape, scenery, view } = &self.stage;
        let lacks = [
            (!landscape.features().is_empty(), "craters"),
            (!scenery.standing().is_empty(), "rocks and man-made things"),
            (!scenery.all_guests().is_empty(), "objects that move, open surfaces"),
            (!scenery.all_effects().is_empty(), "lights, sheets and discs of the sky"),
            (!scenery.patches(f64::INFINITY).is_empty(), "vehicle tracks"),
            (landscape.albedo_map().is_some(), "a map of albedo"),
            (landscape.texture().is_some(), "texture"),
            (!landscape.silhouettes().is_empty(), "far silhouettes"),
            (view.shadows.is_some(), "remote shadow"),
            (view.levels.is_some(), "a second level of ground"),
            (view.laws.curvature != Curvature::None, "curvature of the lunoid"),
        ];
        let omission = |what: &str| Omission {
            block: ROW.name,
            what: what.into(),
            why: "it draws one plane".into(),
            weight: Weight::NotModelled,
        };
        lacks.into_iter().filter(|(is_there, _)| *is_there).map(|(_, what)| omission(what)).collect()
    }

    fn wires(&self) -> Vec<Wire> {
        let scales = [self.stage.view.ranges[1], 1.0];
        let wire = |(signal, full_scale)| Wire { signal, full_scale, volts: 0.0, datum: 0.0 };
        SIGNALS.into_iter().zip(scales).map(wire).collect()
    }

    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        self.check(frame, pose)?;
        let ray = self.ray(pose, pixel).normalize();
        let mut facts =
            vec![Fact::new("ray", format!("{:.4} north, {:.4} east, {:.4} down", ray.x, ray.y, ray.z))];
        match self.seen(pose, pixel) {
            None => {
                facts.push(Fact::new("sky", "the ray meets no ground between the first and the last range"))
            }
            Some((range, [red, green, blue])) => {
                facts.push(Fact::new("range", format!("{range:.3} m")));
                facts.push(Fact::new("light", format!("red {red:.4}, green {green:.4}, blue {blue:.4}")));
            }
        }
        Ok(facts)
    }
}

impl Timed for Plain {
    fn master(&self) -> Rate {
        Rate::new(MASTER_HZ, 1).expect("a whole number above 0")
    }

    fn inputs(&self, scenario: &Scenario) -> String {
        let mut hasher = Hasher::new();
        hasher.update(&bank_file::content_hash(self.stage.landscape.bank()));
        hasher.update(format!("{:?} {:?}", scenario.path, self.stage.view).as_bytes());
        hasher.finalize().to_hex().to_string()
    }

    fn before_mission(&self, _: &Pose) -> Result<Vec<Task>, FrameError> {
        Ok(Vec::new())
    }

    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        self.check(frame, pose)?;
        let (columns, lines) = (self.columns() as u64, u64::from(self.stage.view.lines));
        let mut events = EventHash::new();
        (0..lines).for_each(|line| events.push((line + 1) * columns, "painter", "line", &[line]));
        let busy = columns * lines;
        let task = Task { unit: "painter".into(), task: "pixels".into(), pieces: busy, ticks: busy };
        let unit = UnitUse { unit: "painter".into(), busy, longest_queue: 0 };
        Ok(FrameTiming::of_work(frame, vec![unit], vec![task], &events))
    }
}
