//! The scenes: each shows what some artefacts do to it, and is as deaf as can be to the others.

use std::sync::Arc;

use features::{Crater, Features, Shape};
use glam::{DMat3, DVec3};
use hardware_model::Settings;
use landscape::{Bank, Landscape, Level};
use lunoid_tests::{Dice, level_of, plane};
use quantities::{Rate, radians};
use scenario::{
    LevelSwitch, Pose, PoseTable, RangeLaw, RangeProgramme, RasterWishes, Scenario, ShadowFineness, Standing,
    TrackPatch,
};
use solids::{Body, Kind, Solid};

use crate::artefacts::scene::{Scene, Turn, facing, field, heights, level_ground};

/// A scene by its place in [`all`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    Plane,
    Relief,
    Rows,
    Plateau,
    Waves,
    Levels,
    Strips,
    Bowls,
    Flat,
    Pictures,
    Turn,
    Roll,
    Motion,
}

impl Place {
    /// Those that a detector looks at.
    pub const ALL: [Self; 12] = [
        Self::Plane,
        Self::Relief,
        Self::Rows,
        Self::Plateau,
        Self::Waves,
        Self::Levels,
        Self::Strips,
        Self::Flat,
        Self::Pictures,
        Self::Turn,
        Self::Roll,
        Self::Motion,
    ];

    pub fn scene(self) -> Scene {
        match self {
            Self::Plane => tilted(),
            Self::Relief => relief(),
            Self::Rows => rows(),
            Self::Plateau => plateau(),
            Self::Waves => waves(),
            Self::Levels => levels(),
            Self::Strips => strips(),
            Self::Bowls => bowls(),
            Self::Flat => flat(),
            Self::Pictures => pictures(),
            Self::Turn => turning(),
            Self::Roll => rolling(),
            Self::Motion => driving(),
        }
    }
}

/// Slope of the tilted plane, to the north alone.
pub const SLOPE: f64 = 0.1;

/// A plane: where the ramp of the north axis is, the height is. 100 m/µs, regions of 200 m.
fn tilted() -> Scene {
    let level = level_of(200.0, [0.0; 2], [20, 14], plane(200.0, -190.0, [SLOPE, 0.0]));
    let mut scene = Scene::over(level, [210.0, 1110.0], [8, 2000], 3200.0);
    scene.field = field(10.0, 15.0);
    scene.heading = radians(15.0);
    scene.signals = &["sweep.fold.x", "sweep.fold.y", "tg.height"];
    scene
}

/// Corners of any height, seen across the diagonal: 100 m/µs, regions of 64 m.
fn relief() -> Scene {
    let corners = [58, 58];
    let level = heights(64.0, corners, corner_height);
    let mut scene = Scene::over(level, [70.0, 75.0], [32, 2000], 3200.0);
    scene.eye[2] = 40.0;
    scene.field = field(20.0, 15.0);
    scene.heading = radians(45.0);
    scene.signals = &["sweep.fold.x", "sweep.fold.y", "tg.height"];
    scene.timed = true;
    scene
}

/// Height of a corner of the relief (m): within the 32 m of the full scale, whose middle is 0.
fn corner_height(m: usize, n: usize) -> f64 {
    match (m, n) {
        (0, 0) => 30.0,
        (0, 1) => -30.0,
        _ => Dice::new((100 * m + n) as u64).between(-30.0, 30.0),
    }
}

/// Heights of the rows of [`Place::Rows`] (m), as 32 m of full scale have them: up and down in turn.
pub fn row_height(row: usize) -> f64 {
    let side = if row.is_multiple_of(2) { -1.0 } else { 1.0 };
    match row {
        0 => -30.0,
        1 => 30.0,
        2 => 0.0,
        _ => side * Dice::new(row as u64).between(9.0, 30.0),
    }
}

/// Rows of one height each, up and down in turn: what the ramp of the north axis makes of them is all there is.
fn rows() -> Scene {
    let level = heights(200.0, [20, 9], |row, _| row_height(row));
    let mut scene = Scene::over(level, [404.0, 810.0], [8, 2000], 3200.0);
    scene.eye[2] = 40.0;
    scene.field = field(10.0, 15.0);
    scene.signals = &["sweep.fold.x", "sweep.fold.y", "tg.height"];
    scene
}

/// Height of the plateau (m), of 32 m of full scale.
pub const PLATEAU: f64 = 14.0;

/// A plateau: only gains can bend it.
fn plateau() -> Scene {
    let level = heights(200.0, [20, 7], |row, column| match (row, column) {
        (0, 0) => 20.0,
        (0, 1) => -20.0,
        _ => PLATEAU,
    });
    let mut scene = Scene::over(level, [310.0, 600.5], [8, 2000], 3200.0);
    scene.eye[2] = 30.0;
    scene.field = field(1.0, 15.0);
    scene.signals = &["sweep.fold.x", "sweep.fold.y", "tg.height"];
    scene
}

/// Waves of [`Place::Waves`]: length (m), and height (m) such that their only word is 5/32 of the full scale.
pub const WAVE: [f64; 2] = [1000.0, 5.0 * 81.0 / 16.0 / std::f64::consts::PI];

/// Waves with their crests in the middles of regions of 500 m, out of one word a corner.
fn waves() -> Scene {
    let [length, height] = WAVE;
    let half = std::f64::consts::PI;
    let level = level_of(0.5 * length, [0.0; 2], [12, 7], |row, column| {
        let mut words = [0.0; 9];
        match (row, column) {
            (0, 0) => words[0] = 17.0,
            (0, 1) => words[0] = -17.0,
            _ => words[3] = if row.is_multiple_of(2) { height * half } else { -height * half },
        }
        words
    });
    let mut scene = Scene::over(level, [760.0, 1510.0], [8, 2000], 4000.0);
    scene.field = field(5.0, 15.0);
    scene.signals = &[
        "sweep.fold.x",
        "sweep.fold.y",
        "tg.height",
        "tg.slope.u",
        "tg.reflectivity",
        "dpp.elevation",
        "dpp.hold",
        "dpp.blank",
    ];
    scene
}

/// Height of the coarse level of [`Place::Levels`] over the fine one (m), and where the sweeps go over.
pub const LIFT: f64 = 20.0;
pub const OVER: LevelSwitch = LevelSwitch { range: 2000.0, blend: 400.0 };

/// Level ground on a fine level, and the same [`LIFT`] higher on a coarse one: 100 m/µs.
fn levels() -> Scene {
    let fine = level_ground(200.0, 34);
    let mut scene = Scene::over(fine.clone(), [210.0, 3310.0], [8, 2000], 3200.0);
    let coarse = heights(400.0, [17, 17], |_, _| LIFT);
    let bank = Bank::new("artefacts", vec![fine, coarse], None).expect("two levels are a bank");
    scene.landscape = Landscape::new(bank, 1.0);
    scene.levels = Some(OVER);
    scene.eye[2] = 40.0;
    scene.field = field(10.0, 15.0);
    scene.signals = &["sweep.fold.x", "sweep.fold.y", "tg.height", "tg.slope.u", "tg.slope.v"];
    scene
}

/// Edges of the shadows of [`Place::Strips`] (m ahead).
pub const STRIPS: [[f64; 2]; 3] = [[80.0, 130.0], [180.0, 240.0], [300.0, 340.0]];

/// Three strips of shadow across level ground: 12.5 m/µs.
fn strips() -> Scene {
    let mut scene = Scene::over(level_ground(32.0, 18), [40.0, 280.0], [8, 2000], 400.0);
    scene.field = field(5.0, 15.0);
    scene.shadows = Some(ShadowFineness { finest: 1.0, angle: 2e-3, reach: None });
    scene.patches = STRIPS.map(|strip| patch(&scene, strip)).to_vec();
    scene.signals = &["sweep.fold.x", "sweep.fold.y", "mu.reflectivity"];
    scene
}

fn patch(scene: &Scene, [near, far]: [f64; 2]) -> TrackPatch {
    let [x, y, _] = scene.eye;
    let (south, north, west, east) = (x + near, x + far, y - 100.0, y + 100.0);
    TrackPatch { laid: 0.0, corners: [[north, west], [north, east], [south, east], [south, west]] }
}

/// Bowls of [`Place::Bowls`]: their radius, and where their centres lie (m ahead).
pub const BOWL: f64 = 20.0;
pub const BOWLS: [f64; 3] = [90.03, 190.11, 300.17];

/// Three bowls straight ahead on level ground, their near walls dark: 12.5 m/µs.
fn bowls() -> Scene {
    let mut scene = Scene::over(level_ground(32.0, 18), [40.0, 280.0], [8, 2000], 400.0);
    scene.field = field(0.1, 15.0);
    let [x, y, _] = scene.eye;
    let bowl = |ahead| Crater::new([x + ahead, y], Shape::Bowl { r1: BOWL }, 4.0, 0.0).expect("a bowl");
    scene.landscape = scene.landscape.clone().with_features(Features::new(BOWLS.map(bowl).to_vec()));
    scene.signals = &["sweep.fold.x", "sweep.fold.y", "mu.reflectivity"];
    scene
}

/// Level ground to the horizon, of which the machine may choose how it is swept and hidden.
fn flat() -> Scene {
    let mut scene = Scene::over(level_ground(500.0, 13), [300.0, 3010.0], [16, 1000], 5000.0);
    scene.eye[2] = 1.6334;
    scene.raster.lines = Some(240);
    scene.range = None;
    scene.laws.occlusion = None;
    scene.signals = &["sweep.fold.x", "sweep.fold.y", "sweep.range", "dpp.y", "dpp.blank", "sm.write"];
    scene
}

/// Level ground with two bodies, at the machine's own rates, the nose up in the second frame.
fn pictures() -> Scene {
    let mut scene = Scene::over(level_ground(100.0, 18), [400.0, 850.0], [96, 400], 900.0);
    scene.eye[2] = 3.0;
    scene.raster.lines = Some(96);
    (scene.raster.update, scene.raster.refresh) = (None, None);
    scene.range = Some(RangeProgramme { law: RangeLaw::Geometric, start: 2.0, end: 900.0 });
    scene.field = field(20.0, 20.0);
    // Behind the eye: faces towards it are bright.
    scene.sun.azimuth = std::f64::consts::PI;
    scene.bodies = vec![boxed(&scene, 1, [25.0, -4.0]), boxed(&scene, 2, [30.0, 6.0])];
    scene.pose = |scene, frame, time| {
        let pitch = if frame == 0 { -4.0 } else { 5.0 };
        facing(scene, time, 0.0, radians(pitch))
    };
    (scene.course, scene.frames) = (3, vec![0, 1, 2]);
    scene
}

/// A box of albedo 1, 4 m wide and 4 m high.
fn boxed(scene: &Scene, object: u32, [ahead, aside]: [f64; 2]) -> Standing {
    let (low, high) = (DVec3::new(-2.0, -2.0, 0.0), DVec3::new(2.0, 2.0, 4.0));
    let solid = Arc::new(Solid::boxed(low, high, 1.0).expect("a box"));
    let foot = DVec3::new(scene.eye[0] + ahead, scene.eye[1] + aside, 0.0);
    let body = Body::place(object, Kind::Culture, &solid, foot, &DMat3::IDENTITY, 1.0);
    Standing { from: 0.0, until: f64::INFINITY, body }
}

/// Rate of the turn (degrees/s).
pub const TURN: f64 = 50.0;

/// A turn on the spot, of which the control plane alone is looked at.
fn turning() -> Scene {
    turning_at(|scene, _, time| facing(scene, time, radians(TURN * time), 0.0))
}

/// The same at a rate of one's own.
pub fn turning_at(pose: fn(&Scene, u64, f64) -> Pose) -> Scene {
    let mut scene = Scene::over(level_ground(200.0, 34), [3310.0, 3290.0], [16, 500], 3000.0);
    (scene.raster.update, scene.raster.refresh) = (None, None);
    scene.pose = pose;
    (scene.course, scene.frames) = (31, (20..31).collect());
    (scene.timed, scene.drawn) = (true, false);
    scene
}

/// Frames a second of the yoke's scene, and the frame at which the vehicle leans by one degree.
pub const ROLL: [u64; 2] = [240, 24];

/// A vehicle that leans to one side all at once.
fn rolling() -> Scene {
    let mut scene = Scene::over(level_ground(200.0, 20), [300.0, 1910.0], [24, 100], 2500.0);
    scene.eye[2] = 3.0;
    scene.raster = RasterWishes { lines: Some(96), ..scene.raster };
    (scene.raster.update, scene.raster.refresh) = (Rate::new(ROLL[0], 1), Rate::new(ROLL[0], 1));
    scene.range = Some(RangeProgramme { law: RangeLaw::Geometric, start: 2.0, end: 2500.0 });
    scene.turn = Turn::ByOneDegree;
    (scene.course, scene.frames) = (60, (22..60).collect());
    scene
}

/// The course of [`rolling`], with the yoke of the machine.
pub fn rolled(scene: &Scene, settings: &Settings) -> Vec<Pose> {
    let [rate, step] = ROLL;
    let [x, y, h] = scene.eye;
    let row = |frame: u64| {
        let roll = if frame < step { 0 } else { 1 };
        format!("{},{x},{y},{h},0,0,{roll}\n", frame as f64 / rate as f64)
    };
    let folder = tempfile::tempdir().expect("a folder");
    let rows: String = (0..scene.course + 1).map(row).collect();
    let path = format!("t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n{rows}");
    std::fs::write(folder.path().join("path.csv"), path).expect("a path");
    let file = folder.path().join("roll.toml");
    std::fs::write(&file, ROLL_SCENARIO).expect("a scenario");
    let scenario = Scenario::read(&file).unwrap_or_else(|e| panic!("{e}"));
    let update = settings.timebase.update;
    let table = PoseTable::resolve(&scenario, &scene.landscape, update, settings.yoke, 0..scene.course);
    table.unwrap_or_else(|e| panic!("{e}")).rows().iter().map(|row| row.pose).collect()
}

const ROLL_SCENARIO: &str = r#"format = 1
title = "Roll"
shows = "A vehicle leans to one side."
machine = "ideal"
frames = 60

[landscape.generated]
seed = 1
extent_m = [2000, 2000]
region_size_m = 200

[landscape.generated.undulation]
rms_height_m = 1
hurst = 0.8
longest_m = 1000
shortest_m = 700
waves = 4

[sun]
azimuth_deg = 0
elevation_deg = 25

[path]
file = "path.csv"
"#;

/// A drive past a body, at the machine's own rates.
fn driving() -> Scene {
    let mut scene = pictures();
    scene.raster = RasterWishes { sweeps: Some(48), samples: Some(200), lines: Some(48), ..scene.raster };
    scene.pose = |scene, _, time| {
        let mut pose = facing(scene, time, 0.0, 0.0);
        pose.eye[0] += 4.9 * time;
        pose
    };
    (scene.course, scene.frames) = (3, vec![1, 2]);
    scene
}

/// The level of a scene.
pub fn level(scene: &Scene) -> &Level {
    scene.landscape.level()
}
