//! What files and wishes come to.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use control_plane::{Elaboration, MachineStage};
use generator::{Generator, Row, Stage};
use hardware_model::{EffectiveValue, HardwareModel, Settings, ShadowCache};
use machine::HybridMachine;
use run_record::Inputs;
use scenario::{PathProblems, PoseTable, Scenario};

use crate::error::stage_problems;
use crate::ground::has_same;
use crate::kind::read_scenario_over;
use crate::open::{guest, model, obstacle};
use crate::stage::{upon, with_course};
use crate::{OpenError, StageError, Wishes};

/// Everything that is known before there is ground.
#[derive(Clone)]
pub struct Opened {
    /// The scenario, with the wishes.
    pub scenario: Scenario,
    /// The hardware model, without the wishes of scenario and command line for raster, range and laws.
    pub model: HardwareModel,
    /// Settings of the hybrid machine; their view is that of any generator.
    pub settings: Settings,
    /// The row of the generator; `None` if the hybrid machine draws.
    pub row: Option<&'static Row>,
    /// Generator that draws, configured by the scenario and the wishes.
    pub generator: Arc<dyn Generator>,
    /// Values that decide how the generator draws, each with its origin: those of the hardware model, or of a guest's run parameters and gear and
    /// of the view.
    pub values: Vec<EffectiveValue>,
    /// What is odd about the files of model and scenario, in words.
    pub remarks: Vec<String>,
    /// Files, for the record of a run.
    pub inputs: Inputs,
    /// Path of the scenario's file.
    pub(crate) path: PathBuf,
    /// What was asked for.
    pub(crate) wishes: Wishes,
}

impl Opened {
    /// The world and the settings of the hybrid machine on it, made by the threads of the current pool.
    ///
    /// # Errors
    /// Every fault of the ground, or of something that does not fit on it.
    pub fn machine_stage(&self) -> Result<MachineStage, OpenError> {
        self.finished(crate::build(&self.scenario, self.settings.clone()))
    }

    /// The same upon the landscape of `stage`, which was made of `other`, where both have one landscape.
    ///
    /// # Errors
    /// As [`machine_stage`](Self::machine_stage).
    pub fn machine_stage_upon(&self, other: &Self, stage: &MachineStage) -> Result<MachineStage, OpenError> {
        match has_same(&self.scenario, &other.scenario) {
            true => self.finished(upon(Arc::clone(&stage.landscape), &self.scenario, self.settings.clone())),
            false => self.machine_stage(),
        }
    }

    fn finished(&self, built: Result<MachineStage, StageError>) -> Result<MachineStage, OpenError> {
        built.and_then(|stage| self.with_course(stage)).map_err(|error| match error {
            StageError::BankFile(error) => error.into(),
            other => OpenError::Problems(stage_problems(self.scenario_file(), &other)),
        })
    }

    /// What the generator draws, made by the threads of the current pool.
    ///
    /// # Errors
    /// As [`machine_stage`](Self::machine_stage).
    pub fn stage(&self) -> Result<Stage, OpenError> {
        Ok(self.machine_stage()?.stage())
    }

    /// The same over the ground of `first`, a stage of the same scenario for another generator.
    ///
    /// # Errors
    /// If the path does not suit the settings.
    pub fn machine_stage_beside(&self, first: &Stage) -> Result<MachineStage, StageError> {
        self.with_course(crate::under(first, &self.scenario, self.settings.clone())?)
    }

    fn with_course(&self, stage: MachineStage) -> Result<MachineStage, StageError> {
        match self.generator.remembers_frames() || self.generator.timing_remembers_frames() {
            true => with_course(stage, &self.scenario),
            false => Ok(stage),
        }
    }

    /// Poses of `frames` on `stage`.
    ///
    /// # Errors
    /// If the path cannot be driven.
    pub fn poses(&self, stage: &Stage, frames: Range<u64>) -> Result<PoseTable, PathProblems> {
        PoseTable::resolve(&self.scenario, &stage.landscape, stage.view.update, stage.view.yoke, frames)
    }

    /// What keeps the generator from drawing a preview, in words; `None` if nothing does.
    pub fn draft_obstacle(&self) -> Option<String> {
        obstacle(&self.inputs.model, self.row, &self.settings)
    }

    /// How the hybrid machine draws `stage`, in words; `None` of another generator.
    pub fn drawing(&self, stage: &MachineStage) -> Option<String> {
        let instants = self.is_machine().then(|| Elaboration::new(stage).instants())?;
        Some(match instants {
            Some(1) => "straight between the steps of a sweep".into(),
            Some(count) => format!("straight between {count} instants a step of a sweep"),
            None => "whole: each edge at its own instant".into(),
        })
    }

    /// Whether the hybrid machine draws.
    pub fn is_machine(&self) -> bool {
        self.row.is_none()
    }

    /// The generator with further keys set over everything else.
    ///
    /// # Errors
    /// Every fault of the keys, or that the hybrid machine draws, whose keys are settings.
    pub fn configure_with(&self, sets: &[(&str, &str)]) -> Result<Arc<dyn Generator>, OpenError> {
        let Some(row) = self.row else {
            return Err(OpenError::Wish("the hybrid machine has no run parameters".into()));
        };
        let mut wishes = self.wishes.clone();
        wishes.set.extend(sets.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())));
        Ok(guest(&self.path, row, &wishes)?.generator)
    }

    /// Keeps shadow boundaries in `cache`, unless the wishes name a folder for them.
    pub fn keep_shadows(&mut self, cache: ShadowCache) {
        if self.settings.shadow_cache.is_none() {
            self.settings.shadow_cache = Some(cache);
            if self.is_machine() {
                self.generator = Arc::new(HybridMachine::new(self.settings.clone()));
            }
        }
    }

    /// Name of who draws: the hardware model, or the generator.
    pub fn drawn_by(&self) -> &str {
        self.row.map_or(&self.inputs.model, |row| row.name)
    }

    /// What was asked for over the scenario.
    pub fn wishes(&self) -> &Wishes {
        &self.wishes
    }

    /// Path of the scenario's file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Folder of the scenario's file, at which its references start.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// Name of the scenario's file.
    pub fn scenario_file(&self) -> &str {
        self.inputs.scenario.as_ref().map_or("scenario", |record| &record.file)
    }

    /// Frames of the scenario.
    pub fn frames(&self) -> u64 {
        self.scenario.frames(self.settings.timebase.update)
    }

    /// Files that the scenario at `path` with `wishes` is made of beside itself: those it refers to, and those of its
    /// hardware model. Of what cannot be read there are none: [`open`](crate::open) says why.
    pub fn sources(path: &Path, wishes: &Wishes) -> [Vec<PathBuf>; 2] {
        let Ok(scenario) = read_scenario_over(path, wishes) else { return Default::default() };
        let row = registry::find(wishes.machine.as_deref().unwrap_or(&scenario.machine));
        let model = model(path, &scenario, row, wishes).map_or(Vec::new(), |model| model.files);
        [scenario.files().into_iter().map(Path::to_owned).collect(), model]
    }
}
