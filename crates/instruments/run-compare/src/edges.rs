//! Edges of a frame as `exact` sees them: what `compare` leaves out.

use std::path::Path;

use compare::{EDGE_PLANES, EdgeLimits, EdgeMask, edge_mask, ridge_mask};
use front_door::Wishes;
use generator::{PlaneKind, Planes, Session, Stage};
use rayon::ThreadPool;
use replay::HeldRun;
use run_record::{SceneryRecord, ViewRecord};
use scenario::{PoseTable, Scenario};
use serde_json::{Value, json};
use signal::Probe;

use crate::RunCompareError;

/// What of a run decides where its edges are.
const DECIDING: [&str; 8] = [
    "/view/laws",
    "/view/ranges_m",
    "/view/columns",
    "/view/lines",
    "/view/field_of_view_deg",
    "/view/update",
    "/view/yoke",
    "/scenery/blake3",
];

/// Which edges are left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EdgeKind {
    /// Ridge lines alone; `jump` is the relative step of range that makes one.
    Ridges {
        /// Share of the nearer range.
        jump: f32,
    },
    /// Ridges, outlines, shadow boundaries and kinks.
    Edges(EdgeLimits),
}

impl EdgeKind {
    /// The option that asks for it.
    fn option(self) -> &'static str {
        match self {
            Self::Ridges { .. } => "--ridges",
            Self::Edges(_) => "--edges",
        }
    }

    fn planes(self) -> &'static [PlaneKind] {
        match self {
            Self::Ridges { .. } => &[PlaneKind::Range],
            Self::Edges(_) => &EDGE_PLANES,
        }
    }
}

/// A scenario ready to be asked where its edges are.
pub(crate) struct Edges {
    scenario: Scenario,
    stage: Stage,
    session: Box<dyn Session>,
    kind: EdgeKind,
}

impl Edges {
    /// Of the scenario in a file.
    pub fn of(path: &Path, kind: EdgeKind, pool: &ThreadPool) -> Result<Self, RunCompareError> {
        let opened = front_door::open(path, &Wishes::default())?;
        let stage = pool.install(|| opened.stage())?;
        let session = registry::judge_on(stage.clone())?;
        Ok(Self { scenario: opened.scenario, stage, session, kind })
    }

    /// Draws on the raster of `run`, which must otherwise be a run of this scenario as it stands.
    pub fn expect_run(&mut self, folder: &Path, run: &HeldRun) -> Result<(), RunCompareError> {
        let held = &json!({ "view": run.view, "scenery": run.scenery });
        let size = |key: &str| held["view"][key].as_u64().and_then(|size| u32::try_from(size).ok());
        if let (Some(columns), Some(lines)) = (size("columns"), size("lines")) {
            (self.stage.view.columns, self.stage.view.lines) = (columns, lines);
        }
        let expected = json!({
            "view": ViewRecord::from(&self.stage.view),
            "scenery": SceneryRecord::new(&self.stage),
        });
        match DECIDING.iter().find(|key| expected.pointer(key) != held.pointer(key)) {
            None => Ok(()),
            Some(key) => {
                let found = held.pointer(key).unwrap_or(&Value::Null);
                let expected = expected.pointer(key).unwrap_or(&Value::Null);
                Err(RunCompareError::OtherScenario {
                    folder: folder.to_owned(),
                    key: key.trim_start_matches('/').replace('/', "."),
                    found: found.to_string(),
                    option: self.kind.option(),
                    expected: expected.to_string(),
                })
            }
        }
    }

    /// Pixels along the edges of a frame.
    pub fn mask(&self, frame: u64, pool: &ThreadPool) -> Result<EdgeMask, RunCompareError> {
        let planes = self.planes(frame, pool)?;
        match self.kind {
            EdgeKind::Edges(limits) => Ok(edge_mask(&planes, &limits)?),
            EdgeKind::Ridges { jump } => {
                let range = planes.get(PlaneKind::Range).unwrap_or_default();
                let pixels = ridge_mask(range, planes.columns(), planes.lines(), jump)?;
                let ridges = pixels.iter().filter(|pixel| **pixel).count();
                Ok(EdgeMask { pixels, ridges, outlines: 0, shadows: 0, kinks: 0 })
            }
        }
    }

    fn planes(&self, frame: u64, pool: &ThreadPool) -> Result<Planes, RunCompareError> {
        let (update, yoke) = (self.stage.view.update, self.stage.view.yoke);
        let rows = PoseTable::resolve(&self.scenario, &self.stage.landscape, update, yoke, frame..frame + 1)?;
        let pose = rows.rows()[0].pose;
        let raster = &self.stage.view;
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, self.kind.planes());
        let draw = || self.session.frame(frame, &pose, &mut planes, &mut Probe::off());
        pool.install(draw)?;
        Ok(planes)
    }
}
