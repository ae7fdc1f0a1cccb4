//! Programs of single sweeps: what the control plane hands to the signal plane, looked at sweep by sweep.
//!
//! They are those of a storage buffer that holds every corner and of a processor whose set-ups are ready: what drums and
//! set-ups do to a sweep stands in the record of its frame.

use std::borrow::Cow;

use dpu::{CrossingService, TimedFold};
use generator::Stage;
use hardware_model::{LevelSwitch, Loader, Settings};
use landscape::Level;
use quantities::sin_cos;
use scenario::{FieldOfView, Pose};
use sweep_generator::{Folds, RangeTable, set_up};
use sweep_memory::covering;
use sweep_program::{Fan, RegisterSet, SweepProgram, SweepStart};

/// The sweeps of a stage behind a loader.
pub struct Sweeps<'a> {
    stage: &'a Stage,
    loader: Cow<'a, Loader>,
    /// Without what holds single words back: that is done on the fine level alone.
    coarse_loader: Loader,
    pub table: RangeTable,
    field: FieldOfView,
}

/// One level of terrain that sweeps run over.
#[derive(Clone, Copy)]
pub struct LevelOfSweeps<'a> {
    pub name: &'static str,
    pub level: &'a Level,
    /// Ground range up to which it is drawn, if the sweep does not leave its area before (m).
    pub reach: f64,
    is_fine: bool,
}

/// A sweep of a frame.
#[derive(Clone, Copy)]
pub struct Place<'a> {
    pub frame: u64,
    pub pose: &'a Pose,
    pub sweep: u32,
}

impl<'a> Sweeps<'a> {
    /// Behind the loader of the stage.
    pub fn new(stage: &'a Stage) -> Self {
        Self::behind(stage, Cow::Borrowed(&stage.settings.loader))
    }

    /// Behind another loader.
    pub fn behind(stage: &'a Stage, loader: Cow<'a, Loader>) -> Self {
        let Settings { raster, range, yoke, .. } = &stage.settings;
        Self {
            coarse_loader: Loader { delays: Vec::new(), ..loader.as_ref().clone() },
            loader,
            table: RangeTable::new(range, raster.samples as usize),
            field: yoke.map_or(raster.field, |yoke| covering(raster.field, yoke.travel)),
            stage,
        }
    }

    pub fn loader(&self) -> &Loader {
        &self.loader
    }

    pub fn settings(&self) -> &'a Settings {
        &self.stage.settings
    }

    /// The fine level, and the coarse one where the scenario goes over to it.
    pub fn levels(&self) -> Vec<LevelOfSweeps<'a>> {
        let end = self.stage.settings.range.end;
        let levels = self.stage.landscape.bank().levels();
        let switch = self.stage.settings.levels.filter(|_| levels.len() > 1);
        let reach = switch.map_or(end, |LevelSwitch { range, .. }| range.min(end));
        let fine = LevelOfSweeps { name: "fine", level: &levels[0], reach, is_fine: true };
        let coarse =
            switch.map(|_| LevelOfSweeps { name: "coarse", level: &levels[1], reach: end, is_fine: false });
        [fine].into_iter().chain(coarse).collect()
    }

    /// Writes the program of one sweep over one level.
    pub fn write(&self, of: &LevelOfSweeps<'_>, place: Place<'_>, program: &mut SweepProgram) {
        let Settings { cpu, timebase, seed, .. } = self.settings();
        let (level, size) = (of.level, of.level.region_size());
        let loader = if of.is_fine { self.loader() } else { &self.coarse_loader };
        let service = CrossingService { level, loader, cpu, timebase, missing: &[], seed: *seed };
        let direction = self.direction(place);
        let foot = level.in_regions(place.pose.eye[0], place.pose.eye[1]);
        let end = of.reach.min(way_to_edge(level, foot, direction)).min(self.settings().range.end);
        let start = set_up(foot, direction);
        let mut time_of = self.table.times();
        let folds = Folds::new(&start).map(|(regions, fold)| {
            let range = regions * size;
            TimedFold { time: time_of(range), range, fold }
        });
        let folds = folds.take_while(|fold| fold.range <= end);
        let range_at = |time| self.table.range_at(time);
        service.write_program((place.frame, place.sweep), start, folds, end, range_at, program, &mut ());
    }

    fn direction(&self, Place { pose, sweep, .. }: Place<'_>) -> [f64; 2] {
        let Settings { laws, raster, .. } = self.settings();
        let (sin, cos) = sin_cos(pose.attitude.heading);
        let fan = Fan::covering(laws.projection, pose.attitude.pitch, &self.field, raster.sweeps);
        // A pose that no fan covers is refused by the control plane before anyone looks at its sweeps.
        fan.map_or([cos, sin], |fan| fan.direction(sweep, [cos, sin]))
    }
}

/// Ground range at which a straight sweep leaves the stored area (m).
fn way_to_edge(level: &Level, foot: [f64; 2], direction: [f64; 2]) -> f64 {
    let way = |axis: usize| {
        let last = (level.corners()[axis] - 1) as f64;
        match direction[axis] {
            cosine if cosine > 0.0 => (last - foot[axis]) / cosine,
            cosine if cosine < 0.0 => -foot[axis] / cosine,
            _ => f64::INFINITY,
        }
    };
    way(0).min(way(1)) * level.region_size()
}

/// A program to be written into.
pub fn blank_program() -> SweepProgram {
    let ramp = sweep_program::Ramp { start: 0.0, rate: 0.0, polarity: 1.0 };
    SweepProgram {
        start: SweepStart { direction: [1.0, 0.0], region: [0, 0], ramps: [ramp; 2] },
        registers: [RegisterSet::default(); 4],
        steps: Vec::new(),
        end_range: 0.0,
        misses: Vec::new(),
    }
}
