//! What is studied: a scenario on a model, some of its frames, the ground below them.

use control_plane::MachineStage;
use front_door::StageError;
use generator::{FrameError, PrepareError};
use hardware_model::{HardwareModel, SettingsError};
use scenario::{PathProblems, Pose, PoseTable, Scenario};

use crate::change::{Change, Variant};
use crate::reference::ReferenceError;

/// Why a study cannot go on.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// A variant does not fit together.
    #[error(transparent)]
    Settings(#[from] SettingsError),
    /// A generator cannot have the settings of a ladder.
    #[error("{0}")]
    Ladder(String),
    /// Its stage cannot be built.
    #[error(transparent)]
    Stage(#[from] StageError),
    /// The vehicle cannot follow its path.
    #[error(transparent)]
    Path(#[from] PathProblems),
    /// The machine lacks what the stage asks for.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// A frame cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// Pictures of `exact` cannot be kept.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// A bank cannot be fitted.
    #[error(transparent)]
    Survey(Box<survey::SurveyError>),
    /// Pictures cannot be compared.
    #[error(transparent)]
    Compare(#[from] compare::CompareError),
    /// A picture cannot be encoded.
    #[error(transparent)]
    Picture(#[from] picture::PictureError),
}

impl From<survey::SurveyError> for StudyError {
    fn from(error: survey::SurveyError) -> Self {
        Self::Survey(Box::new(error))
    }
}

/// The base setting of a study, and the frames that it looks at.
#[derive(Debug, Clone)]
pub struct Subject {
    /// The scenario, its raster, range and laws settled: no model changes them any more.
    pub scenario: Scenario,
    /// Hardware model of the base setting.
    pub model: HardwareModel,
    /// What is drawn at the base setting.
    pub stage: MachineStage,
    /// Frames and their poses.
    pub frames: Vec<(u64, Pose)>,
}

impl Subject {
    /// The subject of `scenario` on `model` with the stage that these two have made; `frames` ascending, at least one.
    ///
    /// # Errors
    /// If the vehicle cannot follow its path.
    pub fn new(
        scenario: Scenario,
        model: HardwareModel,
        stage: MachineStage,
        frames: &[u64],
    ) -> Result<Self, StudyError> {
        let scenario = settled(scenario, &stage);
        let subject = Self { scenario, model, stage, frames: Vec::new() };
        let poses = frames.iter().map(|&frame| Ok((frame, subject.pose(frame)?)));
        let frames = poses.collect::<Result<_, StudyError>>()?;
        Ok(Self { frames, ..subject })
    }

    fn pose(&self, frame: u64) -> Result<Pose, StudyError> {
        let settings = &self.stage.settings;
        let (update, yoke) = (settings.timebase.update, settings.yoke);
        let table =
            PoseTable::resolve(&self.scenario, &self.stage.landscape, update, yoke, frame..frame + 1)?;
        Ok(table.rows()[0].pose)
    }

    fn base(&self) -> Variant {
        let economy = self.stage.settings.economy;
        Variant { scenario: self.scenario.clone(), model: self.model.clone(), economy }
    }

    /// How many of `changes` change something: a rung may be the base itself.
    pub fn differing(&self, changes: &[Change]) -> usize {
        let base = self.base();
        let differs = |change: &&Change| {
            let mut variant = base.clone();
            change.apply(&mut variant);
            variant != base
        };
        changes.iter().filter(differs).count()
    }

    /// The stage under `changes`; ground and scenery are shared.
    ///
    /// # Errors
    /// If what comes out does not fit together.
    pub fn changed(&self, changes: &[Change]) -> Result<MachineStage, StudyError> {
        let mut variant = self.base();
        changes.iter().for_each(|change| change.apply(&mut variant));
        let mut settings = front_door::settings(&variant.scenario, &variant.model)?;
        settings.economy = variant.economy;
        settings.shadow_cache.clone_from(&self.stage.settings.shadow_cache);
        Ok(front_door::under(&self.stage.stage(), &variant.scenario, settings)?)
    }
}

/// `scenario` with everything wished that a model would otherwise decide and that no part is.
fn settled(mut scenario: Scenario, stage: &MachineStage) -> Scenario {
    let settings = &stage.settings;
    let raster = &mut scenario.raster;
    raster.sweeps = Some(settings.raster.sweeps);
    raster.samples = Some(settings.raster.samples);
    raster.columns = Some(settings.raster.columns);
    raster.lines = Some(settings.raster.lines);
    raster.update = Some(settings.timebase.update);
    raster.refresh = Some(settings.raster.refresh);
    scenario.range = Some(settings.range);
    scenario.laws = settings.laws.into();
    scenario
}
