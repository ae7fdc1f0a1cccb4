//! A machine made ready for one stage.

use std::ops::Range;
use std::sync::OnceLock;

use control_plane::{
    Blocks, Crossings, Delivery, Digital, DigitalFrame, Elaboration, FramePlan, MachineStage, Supply,
    Surroundings, WrittenRaster, vertices,
};
use display_projection_processor::Processor;
use generator::{BeamEntry, FrameError};
use light_point_generator::PointTable;
use polyhedron_generator::NearTable;
use remote_shadow::Footings;
use scenario::Pose;
use signal::{LANES, Real, Wire};
use signal_plane::{Drawing, Group, Look, RealParts, Wanted, Workspace};
use sweep_generator::RangeTable;

use crate::picture::Cells;
use crate::pool::Pool;
use crate::residue::{Recent, Written};

/// The machine, its tables, and buffers that wait for the next frame.
pub(crate) struct Elaborated<S> {
    pub stage: MachineStage,
    /// The list of blocks that the machine was made from.
    pub list: Elaboration,
    pub blocks: Blocks,
    pub table: RangeTable,
    /// Samples of the picture, if it is drawn straight between instants.
    pub drawing: Option<Drawing<S>>,
    pub near: NearTable,
    pub processor: Processor<S>,
    pub raster: WrittenRaster,
    pub footings: Footings,
    pub digital: Digital,
    pub parts: RealParts<S>,
    /// Wires with their scales, found when somebody first asks for them.
    pub wires: OnceLock<Vec<Wire>>,
    /// Stores of the last frames as they were written.
    pub stores_before: Recent<Written>,
    /// Pictures of the last frames as they were read.
    pub pictures: Recent<Vec<f32>>,
    /// Lists of the second beam in the last frames.
    pub beams: Recent<Vec<BeamEntry>>,
    pub workspaces: Pool<Box<Workspace<S>>>,
    pub deliveries: Pool<Delivery>,
    pub stores: Pool<Vec<f32>>,
    pub cells: Pool<Cells>,
}

/// A frame before its sweeps run: where they look, what its digital side does, what its I/O processors bring.
pub(crate) struct Begun {
    pub plan: FramePlan,
    pub digital: DigitalFrame,
    pub delivery: Delivery,
    /// Light points; `None` if none meets the picture.
    pub lights: Option<PointTable>,
}

impl<S: Real> Elaborated<S> {
    pub fn new(stage: MachineStage) -> Self {
        let settings = &stage.settings;
        let table = RangeTable::new(&settings.range, settings.raster.samples as usize);
        let (laws, list) = (&settings.laws, Elaboration::new(&stage));
        let blocks = Blocks::new(&stage, &list);
        Self {
            drawing: list.instants().map(|instants| Drawing::new(&table, instants, laws)),
            near: NearTable::new(table.ranges().iter().map(|range| (1.0 / range) as f32)),
            processor: Processor::new(laws.occlusion, laws.curvature, table.ranges()),
            raster: WrittenRaster::new(settings),
            footings: Footings::default(),
            digital: Digital::new(&stage, &blocks),
            blocks,
            parts: RealParts::new(&stage, &list, table.ranges(), &WrittenRaster::new(settings)),
            list,
            wires: OnceLock::new(),
            stores_before: Recent::default(),
            pictures: Recent::default(),
            beams: Recent::default(),
            table,
            workspaces: Pool::default(),
            deliveries: Pool::default(),
            stores: Pool::default(),
            cells: Pool::default(),
            stage,
        }
    }

    /// Begins `frame` from `pose`, for all that may be wanted of it.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub(crate) fn begin(&self, frame: u64, pose: &Pose) -> Result<Begun, FrameError> {
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        self.begin_for(plan, pose.time, Wanted { look: &(), picture: &self.all_sweeps() })
    }

    /// Begins the frame of `plan` at `time` (s) for what is `wanted` of it, and nothing more.
    ///
    /// # Errors
    /// If the shadow cache cannot be kept.
    pub(crate) fn begin_for(
        &self,
        plan: FramePlan,
        time: f64,
        wanted: Wanted<'_, impl Look>,
    ) -> Result<Begun, FrameError> {
        let digital = self.digital_frame(&plan, time);
        let delivery = self.deliver(&plan, &digital, time, self.gated(&digital, wanted))?;
        let lights = self.lights(&plan, time);
        Ok(Begun { plan, digital, delivery, lights })
    }

    /// All sweeps of a frame.
    pub(crate) fn all_sweeps(&self) -> Range<u32> {
        0..self.stage.settings.raster.sweeps
    }

    /// Sweeps from the first to the last whose shadow gates a frame needs: those of the set-ups that its groups are drawn with.
    fn gated(&self, digital: &DigitalFrame, wanted: Wanted<'_, impl Look>) -> Range<u32> {
        let all = self.all_sweeps();
        if *wanted.picture == all {
            return all;
        }
        let groups = all.clone().step_by(LANES).filter(|&first| wanted.group(first));
        let sweeps = groups.flat_map(|first| first..all.end.min(first + LANES as u32));
        let set_ups: Vec<u32> = sweeps.map(|sweep| digital.drawn(sweep)).collect();
        let ends = set_ups.iter().min().zip(set_ups.iter().max());
        ends.map_or(0..0, |(&first, &last)| first..last + 1)
    }

    /// What the I/O processors bring for the frame of `plan` at `time` (s), with the shadow gates of the sweeps `gated`.
    pub(crate) fn deliver(
        &self,
        plan: &FramePlan,
        digital: &DigitalFrame,
        time: f64,
        gated: Range<u32>,
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
            absent_shadows: digital.absent_shadows.as_ref(),
            absent_bodies: &digital.absent_bodies,
            gated,
        };
        supply.deliver(time, &mut delivery);
        supply.check_cache()?;
        Ok(delivery)
    }

    fn digital_frame(&self, plan: &FramePlan, time: f64) -> DigitalFrame {
        let crossings = Crossings {
            stage: &self.stage,
            coarse: self.blocks.coarse.as_ref(),
            table: &self.table,
            plan,
            missing: Default::default(),
            held: &[],
            absent_craters: &[],
        };
        // A processor that takes no time has them all ready, however many.
        let is_asked = self.digital.is_timed();
        let vertices = if is_asked { vertices(&self.stage, &self.blocks, plan, time) } else { 0 };
        let Self { blocks, raster, footings, .. } = self;
        let around = Surroundings { blocks, raster, footings };
        self.digital.frame(&self.stage, around, &crossings, vertices)
    }

    /// What all groups of a frame share.
    pub(crate) fn group<'g>(&'g self, plan: &'g FramePlan, begun: &'g Begun) -> Group<'g, S> {
        Group {
            stage: &self.stage,
            blocks: &self.blocks,
            clock: &self.table,
            instants: 1,
            table: &self.table,
            near: &self.near,
            processor: &self.processor,
            raster: self.raster,
            plan,
            delivery: &begun.delivery,
            lights: begun.lights.as_ref(),
            digital: &begun.digital,
            parts: &self.parts,
        }
    }
}
