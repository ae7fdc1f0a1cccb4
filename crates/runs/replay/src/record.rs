//! The record of a job.

use generator::Omission;
use run_record::{
    ChannelRecord, FileRecord, FrameRecord, LimitRecord, ModelRecord, OmissionRecord, PathRecord,
    PicturesRecord, RUN_FORMAT, RUN_SCHEMA, RunRecord, ScenarioRecord, SkyRecord, SunRecord, VehicleRecord,
    total_work,
};
use scenario::LimitReport;

use crate::job::{COLOUR, Job, REFRESH};
use crate::world::World;

/// What is known when the run is finished.
pub(crate) struct Finished<'a> {
    pub fingerprint: &'a str,
    pub world: &'a World,
    pub omissions: &'a [Omission],
    pub limits: &'a [LimitReport],
    pub range: [u64; 2],
    /// Error against the judge, if sweeps were checked.
    pub check: Option<run_record::CheckRecord>,
    pub frames: Vec<FrameRecord>,
    pub outputs: Vec<FileRecord>,
}

/// The record of `job`, finished.
pub(crate) fn run_record(job: &Job, finished: Finished<'_>) -> RunRecord {
    let World { ground, scenery, view, settings } = finished.world.clone();
    RunRecord {
        schema: RUN_SCHEMA.into(),
        format: RUN_FORMAT,
        fingerprint: finished.fingerprint.into(),
        program: job.program.clone(),
        scenario: scenario_record(job),
        references: job.inputs.references.clone(),
        generator: job.generator.name().into(),
        line: job.generator.scan(&job.stage.view).map(|scan| scan.line.into()),
        model: ModelRecord::from(&job.inputs),
        ground,
        scenery,
        sun: SunRecord::from(&job.stage.scenery.sun(0.0)),
        sky: job.stage.scenery.sky().map(SkyRecord::from),
        vehicle: VehicleRecord::from(&job.scenario.vehicle),
        path: PathRecord::from(job.scenario.way()),
        channel: job.scenario.channel.as_ref().map(ChannelRecord::from),
        view,
        settings,
        pictures: PicturesRecord {
            kind: if job.pictures.colour { COLOUR } else { "grey PNG" }.into(),
            depth: job.pictures.depth.bits(),
            one_file_for_each: if job.pictures.refresh { REFRESH } else { "update" }.into(),
        },
        omissions: finished.omissions.iter().map(OmissionRecord::from).collect(),
        limits: finished.limits.iter().map(LimitRecord::from).collect(),
        range: finished.range,
        shard: job.shard.clone().filter(|_| finished.range == [job.frames.start, job.frames.end]),
        totals: total_work(&finished.frames, job.generator.counters()),
        check: finished.check,
        frames: finished.frames,
        outputs: finished.outputs,
    }
}

/// The scenario by name and hash.
pub(crate) fn scenario_record(job: &Job) -> ScenarioRecord {
    ScenarioRecord {
        file: job.inputs.scenario.clone(),
        title: job.scenario.title.clone(),
        shows: job.scenario.shows.clone(),
    }
}
