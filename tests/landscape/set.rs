//! Sets: seeded ground, what a test puts on it, and where it looks from.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use control_plane::MachineStage;
use exact::Exact;
use features::{Crater, Features, Shape};
use generator::{Generator, PlaneKind, Planes};
use glam::{DMat3, DVec3};
use landscape::{Landscape, Layer, Level, Source, Sun, Texture};
use lunoid_tests::{ComparedScene, Dice, Drawn, level_of, plane};
use machine::Prepare;
use quantities::{radians, sin_cos};
use scenario::{
    Curvature, Occlusion, Pose, RangeLaw, RangeProgramme, Scenery, ShadowFineness, Standing, TrackPatch,
    VehicleShape,
};
use signal::Probe;
use solids::{Body, Kind, Solid};
use sweep_program::Fan;

/// Side of the regions of every set (m).
pub const REGION: f64 = 32.0;

/// Regions of every set, either way.
pub const REGIONS: usize = 16;

/// A stage and a pose, free to be changed.
#[derive(Clone)]
pub struct Set {
    pub stage: MachineStage,
    pub pose: Pose,
}

/// Azimuth and elevation in degrees.
pub fn sun(azimuth: f64, elevation: f64) -> Sun {
    Sun { azimuth: radians(azimuth), elevation: radians(elevation) }
}

/// Waves on the ground, all words of each corner in closed form: a few metres high, 100 m and more long.
pub fn rolling(seed: u64, height: f64) -> Level {
    let mut dice = Dice::new(seed);
    let waves: Vec<_> = (0..6)
        .map(|_| {
            let (length, (sin, cos)) = (dice.between(100.0, 250.0), sin_cos(dice.between(0.0, TAU)));
            let turn = TAU * REGION / length;
            ([turn * cos, turn * sin], dice.between(0.0, TAU), height * dice.between(0.1, 0.4))
        })
        .collect();
    level_of(REGION, [0.0; 2], [REGIONS + 1; 2], |m, n| {
        std::array::from_fn(|word| {
            let (p, q) = (word / 3, word % 3);
            let wave = |([k, l], phase, height): &([f64; 2], f64, f64)| {
                let phase = phase + k * m as f64 + l * n as f64 + (p + q) as f64 * FRAC_PI_2;
                height * [1.0, *k, k * k][p] * [1.0, *l, l * l][q] * libm::cos(phase)
            };
            waves.iter().map(wave).sum()
        })
    })
}

/// Level ground at height 0.
pub fn flat() -> Level {
    level_of(REGION, [0.0; 2], [REGIONS + 1; 2], plane(REGION, 0.0, [0.0; 2]))
}

/// `count` craters of all three types within `spread` m of `middle`, radii up to `largest` m, many inside others.
pub fn craters(seed: u64, count: usize, middle: [f64; 2], spread: f64, largest: f64) -> Vec<Crater> {
    let mut dice = Dice::new(seed);
    (0..count)
        .map(|index| {
            let centre = middle.map(|place| place + dice.between(-spread, spread));
            let r1 = largest * dice.between(0.15, 0.5);
            let (r2, r3) = (r1 * dice.between(1.3, 1.6), r1 * dice.between(1.8, 2.0));
            let (depth, rim) = (r1 * dice.between(0.1, 0.35), r1 * dice.between(0.02, 0.08));
            match index % 3 {
                0 => Crater::new(centre, Shape::Bowl { r1 }, depth, 0.0),
                1 => Crater::new(centre, Shape::RimmedBowl { r1, r2 }, depth, rim),
                _ => Crater::new(centre, Shape::FlatFloor { r1: 0.5 * r1, r2: r1, r3 }, depth, rim),
            }
            .expect("radii that ascend")
        })
        .collect()
}

/// A box along the axes, albedo 1, foot point in the middle of its base.
pub fn standing_box(object: u32, foot: [f64; 3], half: f64, height: f64) -> Standing {
    let (low, high) = (DVec3::new(-half, -half, 0.0), DVec3::new(half, half, height));
    let solid = Arc::new(Solid::boxed(low, high, 1.0).expect("a box"));
    let body = Body::place(object, Kind::Culture, &solid, DVec3::from_array(foot), &DMat3::IDENTITY, 1.0);
    Standing { from: 0.0, until: f64::INFINITY, body }
}

/// A quadrangle of shadow, laid at the start: clockwise from above.
pub fn patch([south, west, north, east]: [f64; 4]) -> TrackPatch {
    TrackPatch { laid: 0.0, corners: [[north, west], [north, east], [south, east], [south, west]] }
}

impl Set {
    /// Over `level`: 3 m above its middle, looking north and a little down; no occultation but peak-hold, f64, no
    /// curvature.
    pub fn over(level: Level) -> Self {
        let mut scene = ComparedScene::over(level);
        (scene.sweeps, scene.lines, scene.samples) = (64, 40, 700);
        scene.range = RangeProgramme { law: RangeLaw::Geometric, start: 2.0, end: 200.0 };
        scene.pitch = radians(-4.0);
        scene.laws.occlusion = Occlusion::PeakHold;
        scene.laws.curvature = Curvature::None;
        scene.eye[2] -= 7.0;
        Self { stage: scene.stage(), pose: scene.pose() }
    }

    /// North and east of the eye (m).
    pub fn foot(&self) -> [f64; 2] {
        [self.pose.eye[0], self.pose.eye[1]]
    }

    /// A place `ahead` and `starboard` (m) of the eye, at a heading of 0, on the ground.
    pub fn ahead(&self, ahead: f64, starboard: f64) -> [f64; 3] {
        let [x, y] = [self.pose.eye[0] + ahead, self.pose.eye[1] + starboard];
        [x, y, self.stage.landscape.height(x, y).expect("a place in the area")]
    }

    /// With the ground changed.
    pub fn dressed(mut self, dress: impl FnOnce(Landscape) -> Landscape) -> Self {
        self.stage.landscape = Arc::new(dress(Landscape::clone(&self.stage.landscape)));
        self
    }

    pub fn with_craters(self, craters: Vec<Crater>) -> Self {
        self.dressed(|ground| ground.with_features(Features::new(craters)))
    }

    /// Two grain sizes out to 60 m.
    pub fn with_texture(self, source: Source) -> Self {
        let layer = |cell, amplitude, range| Layer { cell, amplitude, range };
        let layers = [layer(4.0, 0.1, 60.0), layer(1.0, 0.05, 30.0)];
        let texture = Texture::new(&layers, source, 9, REGION, self.stage.landscape.level().origin());
        self.dressed(|ground| ground.with_texture(Some(texture.expect("a texture"))))
    }

    fn with_scenery(mut self, change: impl FnOnce(Scenery) -> Scenery) -> Self {
        self.stage.scenery = Arc::new(change(Scenery::clone(&self.stage.scenery)));
        self
    }

    pub fn with_bodies(self, bodies: Vec<Standing>) -> Self {
        self.with_scenery(|scenery| scenery.with_bodies(bodies))
    }

    pub fn with_patches(self, patches: Vec<TrackPatch>) -> Self {
        self.with_scenery(|scenery| scenery.with_patches(patches))
    }

    pub fn with_vehicle(self, shape: VehicleShape) -> Self {
        self.with_scenery(|scenery| scenery.with_vehicle(Some(shape)))
    }

    /// Under another sun, nothing else on the ground changed.
    pub fn under(self, sun: Sun) -> Self {
        self.with_scenery(|scenery| {
            let patches = scenery.patches(f64::INFINITY).to_vec();
            Scenery::still(sun).with_bodies(scenery.standing().to_vec()).with_patches(patches)
        })
    }

    /// With remote shadow, coarse.
    pub fn with_shadows(self) -> Self {
        self.with_fine_shadows([0.2, 2e-3])
    }

    /// With remote shadow on profiles at the smallest distance (m) and for each metre of distance (rad).
    pub fn with_fine_shadows(mut self, [finest, angle]: [f64; 2]) -> Self {
        let settings = &mut self.stage.settings;
        settings.shadows = Some(ShadowFineness { finest, angle, reach: None });
        self
    }

    /// Frame 0 of the machine, with `signals` (patterns) of every sweep.
    pub fn machine(&self, signals: &[&str]) -> Drawn {
        let raster = self.stage.settings.raster;
        let kinds = [PlaneKind::Intensity, PlaneKind::Range];
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &kinds);
        let patterns = signals.iter().map(|&pattern| pattern.to_owned()).collect();
        let mut probe = Probe::new(patterns, 0..raster.sweeps);
        let session = self.stage.clone().prepare();
        let counts = session.frame(0, &self.pose, &mut planes, &mut probe).expect("a pose that can be drawn");
        let plane = |kind| planes.get(kind).map(<[f32]>::to_vec).unwrap_or_default();
        Drawn {
            picture: plane(PlaneKind::Intensity),
            ranges: plane(PlaneKind::Range),
            counts,
            waveforms: probe.waveforms,
        }
    }

    /// Frame 0 of `exact`, all planes.
    pub fn exact(&self) -> Planes {
        let raster = self.stage.settings.raster;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &PlaneKind::ALL);
        let session = Exact.prepare(self.stage.stage()).expect("a stage that exact draws");
        session.frame(0, &self.pose, &mut planes, &mut Probe::off()).expect("a pose that can be drawn");
        planes
    }

    /// Unit vector (north, east) of a sweep.
    pub fn direction(&self, sweep: u32) -> [f64; 2] {
        let settings = &self.stage.settings;
        let (raster, attitude) = (settings.raster, self.pose.attitude);
        let fan = Fan::covering(settings.laws.projection, attitude.pitch, &raster.field, raster.sweeps);
        let (sin, cos) = sin_cos(attitude.heading);
        fan.expect("a pitch that a fan covers").direction(sweep, [cos, sin])
    }

    /// The place that a sweep has reached at a ground range (m).
    pub fn place(&self, sweep: u32, range: f64) -> [f64; 2] {
        let direction = self.direction(sweep);
        std::array::from_fn(|axis| self.pose.eye[axis] + range * direction[axis])
    }
}

/// A waveform of a sweep.
pub fn wave<'a>(drawn: &'a Drawn, sweep: u32, name: &str) -> &'a [f64] {
    let found = drawn.waveforms.iter().find(|wave| wave.sweep == sweep && wave.signal.name == name);
    &found.unwrap_or_else(|| panic!("{name} of sweep {sweep} was not recorded")).values
}

/// The bits of a picture.
pub fn bits(picture: &[f32]) -> Vec<u32> {
    picture.iter().map(|value| value.to_bits()).collect()
}
