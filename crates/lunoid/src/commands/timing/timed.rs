//! What a timing record can be made of: the digital side of a machine, or a program.

use generator::{FrameError, Stage};
use hardware_model::HardwareModel;
use lunsim::Program;
use machine::ControlPlane;
use scenario::{Pose, Scenario};
use timing::{FrameTiming, Task};

use super::inputs::{inputs_hash, program_inputs_hash};

/// Something whose frames take time.
pub trait Timed: Sync {
    /// Its name in a record; `model` is the hardware model of the run.
    fn machine(&self, model: &HardwareModel) -> String;

    /// Its master clock in words.
    fn master(&self, stage: &Stage) -> String;

    /// Hash of all that decides its timing.
    fn inputs(&self, scenario: &Scenario, stage: &Stage) -> String;

    /// What it has to do before frame 0, whose pose is `first`.
    fn before_mission(&self, first: &Pose) -> Result<Vec<Task>, FrameError>;

    /// The timing of one frame.
    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError>;
}

impl Timed for ControlPlane {
    fn machine(&self, model: &HardwareModel) -> String {
        model.name.clone()
    }

    fn master(&self, stage: &Stage) -> String {
        stage.settings.timebase.master.to_string()
    }

    fn inputs(&self, scenario: &Scenario, stage: &Stage) -> String {
        inputs_hash(scenario, stage)
    }

    fn before_mission(&self, first: &Pose) -> Result<Vec<Task>, FrameError> {
        Self::before_mission(self, first)
    }

    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        Self::frame(self, frame, pose)
    }
}

/// A batch program is loaded with its job: there is nothing before it.
impl Timed for Program {
    fn machine(&self, _: &HardwareModel) -> String {
        lunsim::NAME.into()
    }

    fn master(&self, _: &Stage) -> String {
        format!("{} Hz", Self::MASTER_HZ)
    }

    fn inputs(&self, scenario: &Scenario, stage: &Stage) -> String {
        program_inputs_hash(scenario, stage, self.hardware())
    }

    fn before_mission(&self, _: &Pose) -> Result<Vec<Task>, FrameError> {
        Ok(Vec::new())
    }

    fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        Self::frame(self, frame, pose)
    }
}
