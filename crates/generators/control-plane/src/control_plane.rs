//! The control plane of a stage: what all its frames share.

use data_bank::{BankState, DrumUnit, FrameSupply};
use generator::FrameError;
use remote_shadow::Footings;
use scenario::Pose;
use sweep_generator::RangeTable;

use crate::banks::BankDemand;
use crate::blocks::Blocks;
use crate::crossings::Crossings;
use crate::data_kind::DataKind;
use crate::digital::{Digital, DigitalFrame, Surroundings};
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
        let blocks = Blocks::new(&stage, &Elaboration::new(&stage));
        let digital = Digital::new(&stage, &blocks);
        Self {
            table: RangeTable::new(&settings.range, settings.raster.samples as usize),
            raster: WrittenRaster::new(settings),
            digital,
            blocks,
            footings: Footings::default(),
            stage,
        }
    }

    /// The control plane that timing uses. How much is drawn in vain changes none of its events.
    pub fn of_timing(mut stage: MachineStage) -> Self {
        stage.settings.economy = stage.settings.economy.of_timing();
        Self::new(stage)
    }

    /// The drums that a kind of data lies on as the seed drew them, with the transfer of one of its records; none where all data
    /// are at hand.
    pub fn drums(&self, kind: DataKind) -> Vec<DrumUnit> {
        self.digital.drums(kind)
    }

    /// What the data banks remember as frame `frame` begins, before its demand is read: the kinds on the drums of each, and its
    /// state. They are followed from the start of the mission.
    pub fn banks_before(&self, frame: u64) -> Vec<(Vec<DataKind>, BankState)> {
        self.digital.banks_before(&self.stage, self.surroundings(), frame)
    }

    /// What frames 0 to `last` ask of each bank, kind by kind; nothing where all data are at hand.
    pub fn demands(&self, last: u64) -> Vec<Vec<BankDemand>> {
        self.digital.demands(&self.stage, self.surroundings(), last)
    }

    /// What the data banks have to bring before the mission, kind by kind.
    pub(crate) fn first_loads(&self) -> Vec<(DataKind, FrameSupply)> {
        self.digital.first_loads(&self.stage, self.surroundings())
    }

    fn surroundings(&self) -> Surroundings<'_> {
        Surroundings { blocks: &self.blocks, raster: &self.raster, footings: &self.footings }
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
        self.digital.frame(crossings.stage, self.surroundings(), crossings, vertices)
    }

    pub(crate) fn footings(&self) -> &Footings {
        &self.footings
    }
}
