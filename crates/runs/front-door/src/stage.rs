//! From a scenario and settings to a stage.

use std::sync::Arc;

use control_plane::MachineStage;
use generator::Stage;
use hardware_model::{HardwareModel, Settings, SettingsError};
use landscape::{Bank, Landscape, bank_file};
use scenario::{Course, GroundSource, PathProblems, PoseTable, RollDisplay, Scenario, Scenery};

use crate::StageError;
use crate::face_lists::face_lists;
use crate::ground::landscape;

/// What `scenario` on `model` comes to.
///
/// # Errors
/// If wishes and model do not fit together.
pub fn settings(scenario: &Scenario, model: &HardwareModel) -> Result<Settings, SettingsError> {
    let wishes = scenario.raster;
    let columns = wishes.columns.or(wishes.sweeps).unwrap_or(model.raster.sweeps);
    // A scenario of one angle names its lines.
    let field = scenario.field.of_picture(columns, wishes.lines.unwrap_or(columns));
    let resolved = Settings::resolve(
        model,
        field,
        scenario.raster,
        scenario.range,
        scenario.laws,
        scenario.scalar,
        scenario.display,
    )?;
    Ok(Settings {
        yoke: (scenario.roll == RollDisplay::Yoke).then_some(model.yoke),
        levels: scenario.levels,
        shadows: scenario.shadows,
        ..resolved
    })
}

/// The stage of `scenario`, its ground read or made by the threads of the current pool.
///
/// # Errors
/// If the ground cannot be read or made, or something does not fit on it.
pub fn build(scenario: &Scenario, settings: Settings) -> Result<MachineStage, StageError> {
    over(bank(scenario)?, scenario, settings)
}

/// The stage of `scenario` over the ground of `bank`, whatever ground it names itself.
///
/// # Errors
/// If something does not fit on the ground.
pub fn over(bank: Bank, scenario: &Scenario, settings: Settings) -> Result<MachineStage, StageError> {
    upon(Arc::new(landscape(bank, scenario)?), scenario, settings)
}

/// The stage of `scenario` upon `landscape`, which is its own.
pub(crate) fn upon(
    landscape: Arc<Landscape>,
    scenario: &Scenario,
    settings: Settings,
) -> Result<MachineStage, StageError> {
    let lists = face_lists(scenario, &landscape, settings.timebase.update)?;
    let scenery = Scenery::of(scenario, &landscape, settings.timebase.update)?.with_face_lists(lists);
    joined(landscape, scenery, scenario, settings)
}

/// `stage` under other settings: ground and scenery are shared with it.
///
/// # Errors
/// If the path does not suit the settings.
pub fn under(stage: &Stage, scenario: &Scenario, settings: Settings) -> Result<MachineStage, StageError> {
    // What is chosen by frame 0 is chosen by the scenario's own, through its own channel.
    let first = PoseTable::resolve(scenario, &stage.landscape, settings.timebase.update, None, 0..1)?;
    let lists = face_lists(scenario, &stage.landscape, settings.timebase.update)?;
    let scenery =
        (*stage.scenery).clone().with_face_lists(lists).with_start(first.rows().first().map(|row| row.pose));
    joined(stage.landscape.clone(), scenery, scenario, settings)
}

fn joined(
    landscape: Arc<Landscape>,
    scenery: Scenery,
    scenario: &Scenario,
    settings: Settings,
) -> Result<MachineStage, StageError> {
    let scenery = scenery.through(scenario.channel.clone());
    let scenery = match settings.remembers_frames() {
        true => scenery.with_course(course(scenario, &landscape, &settings)?),
        false => scenery,
    };
    Ok(MachineStage { landscape, scenery: Arc::new(scenery), settings })
}

/// `stage` with the course of the mission, for a generator whose pictures may show frames before their own.
///
/// # Errors
/// If the vehicle cannot take the path.
pub fn with_course(stage: MachineStage, scenario: &Scenario) -> Result<MachineStage, StageError> {
    if !stage.scenery.course().is_empty() {
        return Ok(stage);
    }
    let course = course(scenario, &stage.landscape, &stage.settings)?;
    let scenery = Arc::new((*stage.scenery).clone().with_course(course));
    Ok(MachineStage { scenery, ..stage })
}

/// The pose of every frame.
fn course(scenario: &Scenario, landscape: &Landscape, settings: &Settings) -> Result<Course, PathProblems> {
    let update = settings.timebase.update;
    let table = PoseTable::resolve(scenario, landscape, update, settings.yoke, 0..scenario.frames(update))?;
    Ok(table.rows().iter().map(|row| row.pose).collect())
}

/// The ground of `scenario`: read, or made from its seed.
///
/// # Errors
/// If the file cannot be read, or the parameters do not make a landscape.
pub fn bank(scenario: &Scenario) -> Result<Bank, StageError> {
    let levels = match (&scenario.ground, &scenario.coarse) {
        (GroundSource::Bank(path), _) => return Ok(bank_file::read(path)?),
        (GroundSource::Generated(relief), None) => vec![relief.build()?],
        (GroundSource::Generated(relief), Some(coarse)) => relief.build_two(coarse)?.into(),
    };
    Ok(Bank::new(scenario.title.clone(), levels, None)?)
}
