//! A machine made ready for one stage.

use std::sync::Arc;

use control_plane::{
    Blocks, Crossings, Delivery, Digital, DigitalFrame, FramePlan, MachineStage, Supply, WrittenRaster,
    vertices,
};
use display_projection_processor::Processor;
use generator::{FrameCounts, FrameError, Omission, PlaneKind, Planes, Session};
use hardware_model::SweepMemoryKind;
use polyhedron_generator::NearTable;
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;
use remote_shadow::Footings;
use scenario::Pose;
use signal::{LANES, Probe, Real, Waveform, Wire};
use signal_plane::{Group, Look, RealParts, Recorded, Wanted, Workspace, wires};
use sweep_generator::RangeTable;
use sweep_memory::{Memory, Reading, Tube, View};
use sweep_program::{Event, Served, StepKind, SweepProgram};

use crate::counts::MachineCounts;
use crate::omissions::omissions;
use crate::picture::{Cells, Picture};
use crate::pool::Pool;
use crate::residue::{Recent, Written};

/// The machine, its tables, and buffers that wait for the next frame.
pub(crate) struct Elaborated<S> {
    stage: MachineStage,
    blocks: Blocks,
    table: RangeTable,
    near: NearTable,
    processor: Processor<S>,
    raster: WrittenRaster,
    footings: Footings,
    digital: Digital,
    parts: RealParts<S>,
    recent: Recent,
    workspaces: Pool<Box<Workspace<S>>>,
    deliveries: Pool<Delivery>,
    stores: Pool<Vec<f32>>,
    cells: Pool<Cells>,
}

impl<S: Real> Elaborated<S> {
    pub fn new(stage: MachineStage) -> Self {
        let settings = &stage.settings;
        let table = RangeTable::new(&settings.range, settings.raster.samples as usize);
        let laws = &settings.laws;
        Self {
            blocks: Blocks::new(&stage),
            near: NearTable::new(table.ranges().iter().map(|range| (1.0 / range) as f32)),
            processor: Processor::new(laws.occlusion, laws.curvature, table.ranges()),
            raster: WrittenRaster::new(settings),
            footings: Footings::default(),
            digital: Digital::new(&stage),
            parts: RealParts::new(&stage, table.ranges(), &WrittenRaster::new(settings)),
            recent: Recent::default(),
            table,
            workspaces: Pool::default(),
            deliveries: Pool::default(),
            stores: Pool::default(),
            cells: Pool::default(),
            stage,
        }
    }

    fn deliver(&self, plan: &FramePlan, digital: &DigitalFrame, time: f64) -> Result<Delivery, FrameError> {
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

    fn digital_frame(&self, plan: &FramePlan, time: f64) -> DigitalFrame {
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
    fn group<'g>(
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

    /// Runs the group `index` if anyone wants it, and leaves its lines in `rows`.
    fn run_group(
        &self,
        group: &Group<'_, S>,
        wanted: Wanted<'_, impl Look>,
        index: usize,
        rows: &mut [f32],
    ) -> GroupResult {
        let first = (index * LANES) as u32;
        if !wanted.group(first) {
            return GroupResult::default();
        }
        let mut work = self.workspaces.take();
        let result = self.draw_group(group, wanted, first, &mut work, rows);
        self.workspaces.give_back(work);
        result
    }

    /// Draws a group as the economy has it. Who looks at signals sees those of the whole machine, whatever has drawn the
    /// picture.
    fn draw_group(
        &self,
        group: &Group<'_, S>,
        wanted: Wanted<'_, impl Look>,
        first: u32,
        work: &mut Workspace<S>,
        rows: &mut [f32],
    ) -> GroupResult {
        if !self.blocks.swift {
            group.run(first, work, rows);
            return self.look_at(group, wanted.look, first, work, rows);
        }
        group.run_swiftly(first, work, rows);
        let mut result = self.look_at(group, &(), first, work, rows);
        if wanted.look.wants_any_of(first..first + LANES as u32) {
            let mut rows = rows.to_vec();
            group.run(first, work, &mut rows);
            result.waveforms = self.look_at(group, wanted.look, first, work, &rows).waveforms;
        }
        result
    }

    fn look_at(
        &self,
        group: &Group<'_, S>,
        look: &impl Look,
        first: u32,
        work: &Workspace<S>,
        rows: &[f32],
    ) -> GroupResult {
        let sweeps = rows.len() / self.raster.lines;
        let mut result = GroupResult::default();
        for lane in 0..sweeps {
            result.counts.add(&self.counts(work, lane));
            let recorded = Recorded { group, work, rows };
            look.look(&recorded, lane, first + lane as u32, &mut result.waveforms);
        }
        result
    }

    /// Work that a sweep was: the same for any number of threads.
    fn counts(&self, work: &Workspace<S>, lane: usize) -> MachineCounts {
        let mut counts = terrain_counts(&work.programs[lane]);
        if self.blocks.coarse.is_some() {
            counts.add(&terrain_counts(&work.coarse[lane]));
            counts.level_step_mm = (work.step * 1000.0).ceil() as u64;
        }
        if self.blocks.features {
            let program = &work.features[lane];
            let drawn = if self.blocks.swift { work.passings.count(lane) } else { program.loads.len() };
            counts.features = drawn as u64;
            counts.dropped_features = u64::from(program.dropped);
        }
        MachineCounts { sweeps: 1, samples: self.table.ranges().len() as u64, ..counts }
    }

    /// All sweeps of a frame, into `store`.
    fn write(
        &self,
        plan: &FramePlan,
        delivery: &Delivery,
        digital: &DigitalFrame,
        wanted: Wanted<'_, impl Look>,
        store: &mut Vec<f32>,
    ) -> Vec<GroupResult> {
        store.resize(self.stage.settings.raster.sweeps as usize * self.raster.lines, 0.0);
        let group = self.group(plan, delivery, digital);
        let rows = store.par_chunks_mut(LANES * self.raster.lines).enumerate().with_max_len(1);
        rows.map(|(index, rows)| self.run_group(&group, wanted, index, rows)).collect()
    }

    /// All sweeps of a frame, into a picture that no tube keeps: tiles are read while others are written.
    fn write_and_read(
        &self,
        plan: &FramePlan,
        delivery: &Delivery,
        digital: &DigitalFrame,
        wanted: Wanted<'_, impl Look>,
        picture: &Picture<'_>,
    ) -> Vec<GroupResult> {
        let sweeps = self.stage.settings.raster.sweeps as usize;
        let groups = sweeps.div_ceil(LANES);
        let group = self.group(plan, delivery, digital);
        // From both ends inwards: where threads meet, cells have not waited since the frame began.
        let inwards = |n: usize| if n < groups / 2 { n } else { groups - 1 - (n - groups / 2) };
        let run = |index: usize| {
            let mut cells = self.cells.take();
            let rows = Arc::get_mut(&mut cells).expect("nobody else has it");
            rows.resize((sweeps - index * LANES).min(LANES) * self.raster.lines, 0.0);
            let result = self.run_group(&group, wanted, index, rows);
            picture.take(index, cells, &self.cells);
            result
        };
        let turns = (0..groups).into_par_iter().with_max_len(1);
        let mut results: Vec<_> = turns.map(inwards).map(run).collect();
        results[groups / 2..].reverse();
        results
    }

    /// What the read beam makes of a store, and of what `tube` has left of earlier ones. A picture lies in its tube
    /// where it was written: each is read by its own fan and pitch.
    fn show(
        &self,
        tube: &Tube,
        plan: &FramePlan,
        yoke: f64,
        store: &mut [f32],
        columns: usize,
        picture: &mut [f32],
    ) -> Result<(), FrameError> {
        let mut scratch = self.stores.take();
        if tube.memory_frames() > 0 {
            let most = 2 * tube.memory_frames() + 2;
            self.recent.keep(plan.frame, Arc::new((*plan, store.to_vec())), most);
        }
        let earlier = tube.earlier(plan.frame).map_while(|frame| self.written(frame));
        let earlier: Vec<Arc<Written>> = earlier.collect::<Result<_, _>>()?;
        let pictures: Vec<Vec<f32>> = earlier
            .iter()
            .map(|written| {
                let (mut store, mut left) = (written.1.clone(), vec![0.0; picture.len()]);
                tube.read(plan.frame, &mut store, &mut scratch);
                self.reading(&written.0, yoke, columns).read_all(&store, &mut left);
                left
            })
            .collect();
        tube.read(plan.frame, store, &mut scratch);
        self.reading(plan, yoke, columns).read_all(store, picture);
        tube.combine(picture, &pictures.iter().map(Vec::as_slice).collect::<Vec<_>>());
        tube.add_noise(plan.frame, columns, picture, &mut scratch);
        self.stores.give_back(scratch);
        Ok(())
    }

    /// What was written in an earlier frame, drawn again if nobody has kept it; `None` if its pose is not known.
    fn written(&self, frame: u64) -> Option<Result<Arc<Written>, FrameError>> {
        if let Some(written) = self.recent.get(frame) {
            return Some(Ok(written));
        }
        let pose = self.stage.scenery.course().get(frame as usize)?;
        let draw = || {
            let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
            let digital = self.digital_frame(&plan, pose.time);
            let delivery = self.deliver(&plan, &digital, pose.time)?;
            let mut store = Vec::new();
            let wanted = Wanted { look: &(), picture: true };
            self.write(&plan, &delivery, &digital, wanted, &mut store);
            self.deliveries.give_back(delivery);
            Ok(Arc::new((plan, store)))
        };
        Some(draw())
    }

    /// How a picture of so many columns is read.
    fn reading(&self, plan: &FramePlan, yoke: f64, columns: usize) -> Reading {
        let settings = &self.stage.settings;
        let memory = match (settings.sweep_memory, settings.yoke) {
            (SweepMemoryKind::ScanConverter, _) => Memory::ScanConverter,
            (SweepMemoryKind::DigitalMemory, None) => Memory::Digital,
            (SweepMemoryKind::DigitalMemory, Some(_)) => Memory::DigitalTurned,
        };
        let view = View {
            fan: plan.fan,
            projection: settings.laws.projection,
            pitch: plan.pitch,
            raster: self.raster.field,
            field: settings.raster.field,
            yoke,
        };
        let (cells, lines) = (self.raster.lines, settings.raster.lines as usize);
        Reading { memory, view, cells, columns, lines }
    }
}

/// What a group has to say beside its lines.
#[derive(Default)]
struct GroupResult {
    counts: MachineCounts,
    waveforms: Vec<Waveform>,
}

fn terrain_counts(program: &SweepProgram) -> MachineCounts {
    let [mut folds, mut loads] = [0; 2];
    for step in &program.steps {
        folds += u64::from(step.kind.fold().is_some());
        loads += match step.kind {
            StepKind::Event(Event::Fold(_) | Event::BareFold(_)) => 0,
            StepKind::Event(Event::Load(_)) => 1,
            StepKind::Served(Served { corners, .. }) => corners.len() as u64,
        };
    }
    let late = program.misses.iter().map(|miss| u64::from(miss.words.0.count_ones())).sum();
    MachineCounts { folds, loads, late_words: late, ..MachineCounts::default() }
}

/// Work that the whole frame was, beside its sweeps.
fn delivery_counts(delivery: &Delivery) -> MachineCounts {
    let gates = || delivery.gates.iter();
    MachineCounts {
        shadow_toggles: gates().map(|gate| gate.toggles.len() as u64).sum(),
        dropped_segments: gates().map(|gate| u64::from(gate.dropped)).sum(),
        bodies: delivery.bodies,
        spans: delivery.polyhedra.table().len() as u64,
        bodies_left_out: delivery.left_out.bodies,
        craters_left_out: delivery.craters.left_out.craters,
        pixels_left_out: [delivery.left_out.cells, delivery.craters.left_out.cells]
            .map(|cells| cells.ceil() as u64)
            .into_iter()
            .sum(),
        ..MachineCounts::default()
    }
}

impl<S: Real> Elaborated<S> {
    /// One frame, and what `look` has seen of it.
    pub fn draw(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        look: &impl Look,
    ) -> Result<(FrameCounts, Vec<Waveform>), FrameError> {
        let settings = &self.stage.settings;
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        let digital = self.digital_frame(&plan, pose.time);
        let delivery = self.deliver(&plan, &digital, pose.time)?;
        let (columns, wanted) = (planes.columns(), Wanted { look, picture: planes.any() });
        let mut nothing = [];
        let pixels = planes.get_mut(PlaneKind::Intensity).unwrap_or(&mut nothing);
        let groups = match &self.parts.tube {
            Some(tube) if !pixels.is_empty() => {
                let mut store = self.stores.take();
                let groups = self.write(&plan, &delivery, &digital, wanted, &mut store);
                self.show(tube, &plan, pose.yoke, &mut store, columns, pixels)?;
                self.stores.give_back(store);
                groups
            }
            _ => {
                let picture = Picture::new(self.reading(&plan, pose.yoke, columns), pixels);
                self.write_and_read(&plan, &delivery, &digital, wanted, &picture)
            }
        };
        let regions = plan.visible_regions(self.stage.landscape.level(), settings.range.end);
        let mut total = MachineCounts { regions: regions as u64, ..delivery_counts(&delivery) };
        self.deliveries.give_back(delivery);
        let mut waveforms = Vec::new();
        for group in groups {
            total.add(&group.counts);
            waveforms.extend(group.waveforms);
        }
        Ok((total.into(), waveforms))
    }
}

impl<S: Real> Session for Elaborated<S> {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let (counts, waveforms) = self.draw(frame, pose, planes, &*probe)?;
        probe.waveforms.extend(waveforms);
        Ok(counts)
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        FramePlan::new(frame, pose, &self.stage, &self.raster.field).map(drop)
    }

    fn omissions(&self) -> Vec<Omission> {
        omissions(&self.stage, &self.blocks)
    }

    fn wires(&self) -> Vec<Wire> {
        wires(&self.stage, &self.blocks, &self.raster)
    }

    fn direction(&self, frame: u64, pose: &Pose, line: u32) -> Result<Option<[f64; 2]>, FrameError> {
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        Ok(Some(plan.direction(line)))
    }
}
