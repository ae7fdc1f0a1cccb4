//! What a job draws, as records: made once, before any file is written.

use run_record::{GroundRecord, SceneryRecord, ViewRecord};
use serde_json::Value;

use crate::job::Job;

/// World, view and settings of a job.
#[derive(Debug, Clone)]
pub(crate) struct World {
    pub ground: GroundRecord,
    pub scenery: SceneryRecord,
    pub view: ViewRecord,
    /// The generator's own settings.
    pub settings: Value,
}

impl World {
    /// The records of `job`.
    pub fn of(job: &Job) -> Self {
        Self {
            ground: GroundRecord::new(&job.scenario.ground, &job.stage.landscape),
            scenery: SceneryRecord::new(&job.stage),
            view: ViewRecord::from(&job.stage.view),
            settings: job.generator.record(),
        }
    }
}
