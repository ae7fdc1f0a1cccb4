//! Ridge lines of a frame as `exact` sees them: what `compare` leaves out.

use std::path::Path;

use compare::ridge_mask;
use generator::{Generator, PlaneKind, Planes, Session, Stage};
use rayon::ThreadPool;
use replay::{HeldRun, SettingsRecord};
use scenario::{PoseTable, Scenario};
use serde_json::Value;
use signal::Probe;

use crate::Failure;
use crate::loading::StageArgs;

/// Settings of a run that decide where its ridge lines are.
const DECIDING: [&str; 6] =
    ["/laws", "/range", "/raster/columns", "/raster/lines", "/raster/field_of_view_deg", "/clocks/update"];

/// A scenario ready to be asked where its ridge lines are.
pub struct Ridges {
    scenario: Scenario,
    stage: Stage,
    session: Box<dyn Session>,
    jump: f32,
}

impl Ridges {
    /// Of the scenario in a file; `jump` is the relative step of range that makes a ridge.
    pub fn of(path: &Path, jump: f32, pool: &ThreadPool) -> Result<Self, Failure> {
        let mut loaded = StageArgs::of(path).load()?;
        let stage = loaded.stage(pool)?;
        let session = exact::Exact.prepare(stage.clone()).map_err(Failure::input)?;
        Ok(Self { scenario: loaded.scenario, stage, session, jump })
    }

    /// Draws on the raster of `run`, which must otherwise be a run of this scenario as it stands.
    pub fn expect_run(&mut self, folder: &Path, run: &HeldRun) -> Result<(), Failure> {
        let raster = &run.document["settings"]["raster"];
        let size = |key: &str| raster[key].as_u64().and_then(|size| u32::try_from(size).ok());
        if let (Some(columns), Some(lines)) = (size("columns"), size("lines")) {
            (self.stage.settings.raster.columns, self.stage.settings.raster.lines) = (columns, lines);
        }
        let settings = serde_json::to_value(SettingsRecord::new(&self.stage.settings));
        let settings = settings.map_err(Failure::input)?;
        let held = &run.document["settings"];
        match DECIDING.iter().find(|key| settings.pointer(key) != held.pointer(key)) {
            None => Ok(()),
            Some(key) => {
                let found = held.pointer(key).unwrap_or(&Value::Null);
                let expected = settings.pointer(key).unwrap_or(&Value::Null);
                Err(Failure::input(format!(
                    "{}: settings{} = {found}, but the scenario of --ridges has {expected}; name the scenario of \
                     the run",
                    folder.display(),
                    key.replace('/', "."),
                )))
            }
        }
    }

    /// Pixels along the ridge lines of a frame.
    pub fn mask(&self, frame: u64, pool: &ThreadPool) -> Result<Vec<bool>, Failure> {
        let update = self.stage.settings.timebase.update;
        let rows = PoseTable::resolve(&self.scenario, &self.stage.landscape, update, frame..frame + 1);
        let pose = rows.map_err(Failure::input)?.rows()[0].pose;
        let raster = &self.stage.settings.raster;
        let (columns, lines) = (raster.columns as usize, raster.lines as usize);
        let mut planes = Planes::new(columns, lines, &[PlaneKind::Range]);
        let draw = || self.session.frame(frame, &pose, &mut planes, &mut Probe::off());
        pool.install(draw).map_err(Failure::input)?;
        let range = planes.get(PlaneKind::Range).unwrap_or_default();
        Ok(ridge_mask(range, columns, lines, self.jump)?)
    }
}
