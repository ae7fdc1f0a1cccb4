//! The control plane of a stage: what all its frames share.

use data_bank::{BankState, DrumUnit};
use generator::FrameError;
use remote_shadow::Footings;
use scenario::Pose;
use sweep_generator::RangeTable;

use crate::blocks::Blocks;
use crate::crossings::Crossings;
use crate::digital::{Digital, DigitalFrame, banks_before};
use crate::elaboration::Elaboration;
use crate::frame_plan::FramePlan;
use crate::raster::WrittenRaster;
use crate::stage::MachineStage;

/// The digital side of the machine alone: timing records without a picture.
#[derive(Debug)]
pub struct ControlPlane {
    stage: MachineStage,
    blocks: Blocks,
    table: RangeTable,
    raster: WrittenRaster,
    digital: Digital,
    footings: Footings,
}

impl ControlPlane {
    /// The control plane of a stage.
    pub fn new(stage: MachineStage) -> Self {
        let settings = &stage.settings;
        Self {
            blocks: Blocks::new(&stage, &Elaboration::new(&stage)),
            table: RangeTable::new(&settings.range, settings.raster.samples as usize),
            raster: WrittenRaster::new(settings),
            digital: Digital::new(&stage),
            footings: Footings::default(),
            stage,
        }
    }

    /// The drums of the fine level (0) or of the coarse one (1) as the seed drew them; none where all words are at hand.
    pub fn drums(&self, level: usize) -> Vec<DrumUnit> {
        self.digital.drums(level)
    }

    /// What the data banks of the fine and of the coarse level remember as frame `frame` begins, before its demand is read;
    /// none where all words are at hand. They are followed from the start of the mission.
    pub fn banks_before(&self, frame: u64) -> [Option<BankState>; 2] {
        banks_before(&self.stage, &self.blocks, &self.raster, frame)
    }

    pub(crate) fn stage(&self) -> &MachineStage {
        &self.stage
    }

    pub(crate) fn blocks(&self) -> &Blocks {
        &self.blocks
    }

    pub(crate) fn table(&self) -> &RangeTable {
        &self.table
    }

    pub(crate) fn raster(&self) -> &WrittenRaster {
        &self.raster
    }

    pub(crate) fn plan(&self, frame: u64, pose: &Pose) -> Result<FramePlan, FrameError> {
        FramePlan::new(frame, pose, &self.stage, &self.raster.field)
    }

    /// The digital side of the frame of `crossings`, in which `vertices` are to be transformed.
    pub(crate) fn digital_of(&self, crossings: &Crossings<'_>, vertices: u64) -> DigitalFrame {
        self.digital.frame(crossings.stage, &self.blocks, &self.raster, crossings, vertices)
    }

    pub(crate) fn footings(&self) -> &Footings {
        &self.footings
    }
}
