//! A machine made ready for one stage.

use control_plane::{
    Blocks, Crossings, Delivery, Digital, DigitalFrame, Elaboration, FramePlan, MachineStage, Supply,
    WrittenRaster, vertices,
};
use display_projection_processor::Processor;
use generator::FrameError;
use polyhedron_generator::NearTable;
use remote_shadow::Footings;
use signal::Real;
use signal_plane::{Group, RealParts, Workspace};
use sweep_generator::RangeTable;

use crate::picture::Cells;
use crate::pool::Pool;
use crate::residue::Recent;

/// The machine, its tables, and buffers that wait for the next frame.
pub(crate) struct Elaborated<S> {
    pub stage: MachineStage,
    /// The list of blocks that the machine was made from.
    pub list: Elaboration,
    pub blocks: Blocks,
    pub table: RangeTable,
    pub near: NearTable,
    pub processor: Processor<S>,
    pub raster: WrittenRaster,
    pub footings: Footings,
    pub digital: Digital,
    pub parts: RealParts<S>,
    pub recent: Recent,
    pub workspaces: Pool<Box<Workspace<S>>>,
    pub deliveries: Pool<Delivery>,
    pub stores: Pool<Vec<f32>>,
    pub cells: Pool<Cells>,
}

impl<S: Real> Elaborated<S> {
    pub fn new(stage: MachineStage) -> Self {
        let settings = &stage.settings;
        let table = RangeTable::new(&settings.range, settings.raster.samples as usize);
        let (laws, list) = (&settings.laws, Elaboration::new(&stage));
        Self {
            blocks: Blocks::new(&stage, &list),
            near: NearTable::new(table.ranges().iter().map(|range| (1.0 / range) as f32)),
            processor: Processor::new(laws.occlusion, laws.curvature, table.ranges()),
            raster: WrittenRaster::new(settings),
            footings: Footings::default(),
            digital: Digital::new(&stage),
            parts: RealParts::new(&stage, &list, table.ranges(), &WrittenRaster::new(settings)),
            list,
            recent: Recent::default(),
            table,
            workspaces: Pool::default(),
            deliveries: Pool::default(),
            stores: Pool::default(),
            cells: Pool::default(),
            stage,
        }
    }

    /// Hands what the I/O processors and the digital side have for the frame of `plan` at `time` (s) to `run`.
    pub(crate) fn prepared<T>(
        &self,
        plan: &FramePlan,
        time: f64,
        run: impl FnOnce(&Delivery, &DigitalFrame) -> T,
    ) -> Result<T, FrameError> {
        let digital = self.digital_frame(plan, time);
        let delivery = self.deliver(plan, &digital, time)?;
        let result = run(&delivery, &digital);
        self.deliveries.give_back(delivery);
        Ok(result)
    }

    pub(crate) fn deliver(
        &self,
        plan: &FramePlan,
        digital: &DigitalFrame,
        time: f64,
    ) -> Result<Delivery, FrameError> {
        let mut delivery = self.deliveries.take();
        let supply = Supply {
            stage: &self.stage,
            blocks: &self.blocks,
            footings: &self.footings,
            plan,
            raster: self.raster,
            table: &self.table,
            ready: digital.ready_vertices(),
        };
        supply.deliver(time, &mut delivery);
        supply.check_cache()?;
        Ok(delivery)
    }

    pub(crate) fn digital_frame(&self, plan: &FramePlan, time: f64) -> DigitalFrame {
        let crossings = Crossings {
            stage: &self.stage,
            coarse: self.blocks.coarse.as_ref(),
            table: &self.table,
            plan,
            missing: Default::default(),
            held: &[],
        };
        // A processor that takes no time has them all ready, however many.
        let is_asked = self.digital.is_timed();
        let vertices = if is_asked { vertices(&self.stage, &self.blocks, plan, time) } else { 0 };
        self.digital.frame(&self.stage, &self.blocks, &self.raster, &crossings, vertices)
    }

    /// What all groups of a frame share.
    pub(crate) fn group<'g>(
        &'g self,
        plan: &'g FramePlan,
        delivery: &'g Delivery,
        digital: &'g DigitalFrame,
    ) -> Group<'g, S> {
        Group {
            stage: &self.stage,
            blocks: &self.blocks,
            table: &self.table,
            near: &self.near,
            processor: &self.processor,
            raster: self.raster,
            plan,
            delivery,
            digital,
            parts: &self.parts,
        }
    }
}
