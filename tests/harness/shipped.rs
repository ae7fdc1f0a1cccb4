//! The scenarios that ship with the project, drawn by the library.

use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

use compare::{
    EDGE_PLANES, EdgeLimits, RidgeError, edge_mask, horizon_of_picture, horizon_of_range, ridge_error,
};
use control_plane::MachineStage;
use exact::Exact;
use generator::{FrameCounts, Generator, Label, PlaneKind, Planes, Session, Shade};
use hardware_model::{HardwareModel, ModelSource, Settings, ShadowCache};
use landscape::Landscape;
use machine::Prepare;
use picture::{Depth, Encoder, GreyPicture, Transfer};
use scenario::{FaceLists, Pose, PoseRow, PoseTable, Scenario, Scenery};
use signal::Probe;

/// Scenarios of terrain alone in the folder `scenarios/`, by name.
pub const TERRAIN: [&str; 6] =
    ["first-light", "ridge-crossing", "lunar-horizon", "low-sun", "descent", "range-programmes"];

/// Scenarios of the full landscape.
pub const FULL_LANDSCAPE: [&str; 12] = [
    "rough-ride",
    "craters",
    "long-shadows",
    "landing-site",
    "regolith",
    "far-mountains",
    "tracks",
    "moving-sun",
    "lunar-light",
    "showpiece",
    "full-drive",
    "two-levels-blended",
];

/// A shipped scenario, ready to be drawn under the ideal model.
#[derive(Debug, Clone)]
pub struct Shipped {
    /// As its file says.
    pub scenario: Scenario,
    /// Ground of the scenario, ready to be drawn.
    pub landscape: Arc<Landscape>,
    /// Poses that the frames before it leave a mark on a frame by.
    course: Vec<Pose>,
    /// Lists of faces of the scenario as it was read.
    face_lists: Arc<FaceLists>,
    /// Its settings, by its own machine; change them before drawing.
    pub settings: Settings,
}

/// A frame as displayed.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// The picture in grey, 8 bits a pixel.
    pub picture: GreyPicture,
    /// Linear intensity, and what edges are found from; zero where the generator does not fill it.
    pub planes: Planes,
    /// Counts of the work done.
    pub counts: FrameCounts,
}

/// How a frame of the machine agrees with `exact` (definition of done of first light).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Share of the pixels outside the edge mask that are off by more than 2 levels of 255.
    pub off: f64,
    /// Share of the pixels that the mask leaves out.
    pub masked: f64,
    /// Distance between the horizons of both that 99 of 100 columns keep, where the ridge is lit (lines).
    pub ridge: usize,
    /// The largest such distance (lines).
    pub ridge_at_most: usize,
    /// Columns where the ridge is lit.
    pub lit_columns: usize,
}

/// Ridge lines are where range jumps by more than this share between neighbours.
pub const RIDGE_JUMP: f32 = 0.1;

/// Shadow boundaries that this program has made: for one ground and sun they are the same in all its tests, and take
/// longer than its pictures. What another run of it has left is removed, so all are made by the code as it is.
static SHADOWS: LazyLock<PathBuf> = LazyLock::new(|| {
    let program = std::env::current_exe().expect("the program of the tests");
    let folder = program.with_extension("shadows");
    if folder.exists() {
        std::fs::remove_dir_all(&folder).expect("a folder of its own");
    }
    std::fs::create_dir_all(&folder).expect("a folder beside the program");
    folder
});

/// The folder of the shipped scenarios.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenarios")
}

impl Shipped {
    /// Reads a scenario of [`TERRAIN`] or [`FULL_LANDSCAPE`], with `sweeps` a frame or as many as it says.
    ///
    /// # Panics
    /// If it cannot be read or its settings do not fit together.
    pub fn read(name: &str, sweeps: Option<u32>) -> Self {
        Self::changed(name, sweeps, |_| {})
    }

    /// The same after a change of the scenario.
    ///
    /// # Panics
    /// As [`read`](Self::read).
    pub fn changed(name: &str, sweeps: Option<u32>, change: impl FnOnce(&mut Scenario)) -> Self {
        let file = folder().join(format!("{name}.toml"));
        let mut scenario =
            Scenario::read_beside(file, &registry::parameter_tables()).unwrap_or_else(|e| panic!("{e}"));
        if sweeps.is_some() {
            (scenario.raster.sweeps, scenario.raster.columns, scenario.raster.lines) = (sweeps, None, None);
        }
        change(&mut scenario);
        // These have no hardware model: raster, range and laws are over those of the ideal one.
        let has_none = registry::names().contains(&scenario.machine.as_str());
        let named = if has_none { "ideal" } else { &scenario.machine };
        let source = ModelSource::find(named, &folder()).unwrap_or_else(|e| panic!("{e}"));
        let model = HardwareModel::load(&source, &[], &[]).unwrap_or_else(|e| panic!("{e}")).model;
        let settings = front_door::settings(&scenario, &model).expect("shipped settings");
        let settings = Settings { shadow_cache: Some(ShadowCache::shared(&*SHADOWS)), ..settings };
        let stage = front_door::build(&scenario, settings).unwrap_or_else(|e| panic!("{name}: {e}"));
        let MachineStage { landscape, scenery, settings } = stage;
        let (course, face_lists) = (scenery.course().to_vec(), scenery.face_lists().clone());
        Self { landscape, course, face_lists, settings, scenario }
    }

    /// Frames that the scenario has.
    pub fn frames(&self) -> u64 {
        self.scenario.frames(self.settings.timebase.update)
    }

    /// Where the vehicle is in a frame.
    ///
    /// # Panics
    /// If the path cannot be driven.
    pub fn pose(&self, frame: u64) -> PoseRow {
        let (update, yoke) = (self.settings.timebase.update, self.settings.yoke);
        let table = PoseTable::resolve(&self.scenario, &self.landscape, update, yoke, frame..frame + 1);
        table.unwrap_or_else(|e| panic!("{e}")).rows()[0]
    }

    /// What changes over time, by the scenario as it is now.
    fn scenery(&self) -> Scenery {
        let scenery = Scenery::of(&self.scenario, &self.landscape, self.settings.timebase.update)
            .expect("a shipped scenery");
        scenery.with_course(self.course.clone()).with_face_lists(self.face_lists.clone())
    }

    /// What the machine draws, by the scenario as it is now.
    pub fn stage(&self) -> MachineStage {
        MachineStage {
            landscape: self.landscape.clone(),
            scenery: Arc::new(self.scenery()),
            settings: self.settings.clone(),
        }
    }

    /// A frame by a generator made ready for its stage.
    ///
    /// # Panics
    /// If it cannot be drawn.
    pub fn draw(&self, session: &dyn Session, frame: u64, probe: &mut Probe) -> Shown {
        let raster = self.settings.raster;
        let (columns, lines) = (raster.columns as usize, raster.lines as usize);
        let kinds: Vec<PlaneKind> = [PlaneKind::Intensity].into_iter().chain(EDGE_PLANES).collect();
        let mut planes = Planes::new(columns, lines, &kinds);
        let counts =
            session.frame(frame, &self.pose(frame).pose, &mut planes, probe).expect("a shipped frame");
        let display = self.settings.display;
        let transfer = Transfer::new(display.white as f32, display.gamma as f32).expect("a shipped display");
        let intensity = planes.get(PlaneKind::Intensity).expect("asked for");
        let picture = Encoder::new(transfer, Depth::Eight).encode(intensity, columns, lines);
        Shown { picture: picture.expect("no NaN reaches a frame"), planes, counts }
    }

    /// Draws a frame by the hybrid machine.
    pub fn machine(&self, frame: u64) -> Shown {
        self.draw(&*self.stage().prepare(), frame, &mut Probe::off())
    }

    /// The frame by closed form and root finding.
    pub fn exact(&self, frame: u64) -> Shown {
        {
            let exact = Exact.prepare(self.stage().stage()).expect("a stage that exact can draw");
            self.draw(&*exact, frame, &mut Probe::off())
        }
    }

    /// One signal of one sweep.
    pub fn waveform(&self, frame: u64, sweep: u32, signal: &str) -> Vec<f64> {
        let mut probe = Probe::new(vec![signal.into()], sweep..sweep + 1);
        self.draw(&*self.stage().prepare(), frame, &mut probe);
        probe.waveforms.remove(0).values
    }

    /// How the machine's frame agrees with `exact`.
    pub fn agreement(&self, frame: u64) -> Agreement {
        let (machine, exact) = (self.machine(frame), self.exact(frame));
        let (columns, lines) = (machine.picture.columns(), machine.picture.lines());
        let limits = EdgeLimits { jump: RIDGE_JUMP, ..EdgeLimits::default() };
        let mask = edge_mask(&exact.planes, &limits).expect("planes of exact").pixels;
        let found = compare::compare(&machine.picture, &exact.picture, Some(&mask), &[2]);
        let found = found.expect("pictures of one size");
        let share = |pixels: usize| pixels as f64 / (columns * lines) as f64;
        let ridge = lit_ridge_error(&machine.picture, &exact);
        Agreement {
            off: share(found.beyond[0].count),
            masked: share(found.masked),
            ridge: ridge.percentile_99,
            ridge_at_most: ridge.maximum,
            lit_columns: ridge.compared,
        }
    }
}

/// Codes up to this may be a line that is hardly touched by ground.
const NEARLY_SKY: u16 = 16;

/// Horizons of both pictures in the columns where the exact one shows a ridge of the ground, with no shadow, which is as
/// black as sky, and no outline of a body within a pixel. A faint first line of the machine counts as ground or sky,
/// whichever is nearer; a mast or rock may stand a column aside.
fn lit_ridge_error(machine: &GreyPicture, exact: &Shown) -> RidgeError {
    let (columns, lines) = (machine.columns(), machine.lines());
    let ranges = exact.planes.get(PlaneKind::Range).expect("asked for");
    let ground = horizon_of_range(ranges, columns, lines).expect("a plane of that size");
    let shades = exact.planes.get(PlaneKind::Shadow).expect("asked for");
    let labels = exact.planes.get(PlaneKind::Label).expect("asked for");
    let is_body =
        |label: f32| [Label::Rock, Label::Culture].iter().any(|body| label == f32::from(body.code()));
    let near = |at: usize, count: usize| at.saturating_sub(1)..(at + 2).min(count);
    let is_plain = |line: usize, column: usize| {
        let mut around =
            near(line, lines).flat_map(|line| near(column, columns).map(move |at| line * columns + at));
        around.all(|at| shades[at] == f32::from(Shade::Lit.code()) && !is_body(labels[at]))
    };
    let mut reference = horizon_of_picture(&exact.picture, NEARLY_SKY);
    for (column, (seen, ground)) in reference.iter_mut().zip(ground).enumerate() {
        let shown = seen.zip(ground).is_some_and(|(seen, ground)| seen.abs_diff(ground) <= 1);
        *seen = seen.filter(|&line| shown && is_plain(line, column));
    }
    let [faint, plain] = [NEARLY_SKY / 2, NEARLY_SKY].map(|sky| horizon_of_picture(machine, sky));
    let nearer = faint.into_iter().zip(plain).zip(&reference).map(|((faint, plain), reference)| {
        let distance = |line: &Option<usize>| line.zip(*reference).map_or(usize::MAX, |(a, b)| a.abs_diff(b));
        if distance(&faint) < distance(&plain) { faint } else { plain }
    });
    ridge_error(&nearer.collect::<Vec<_>>(), &reference, 1).expect("as many columns")
}
