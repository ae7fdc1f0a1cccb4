//! A machine made ready for one stage.

use std::sync::{Mutex, PoisonError};

use display_projection_processor::Processor;
use generator::{FrameCounts, FrameError, Omission, PlaneKind, Planes, Session, Stage};
use hardware_model::SweepMemoryKind;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;
use scenario::Pose;
use signal::{LANES, Probe, Real, Waveform};
use sweep_generator::RangeTable;
use sweep_memory::{View, digital_memory, scan_converter};
use sweep_program::{StepKind, SweepProgram};

use crate::control_plane::FramePlan;
use crate::omissions::omissions;
use crate::record::Recorded;
use crate::signal_plane::{Group, Workspace};

/// The machine, its tables, and buffers that wait for the next frame.
pub(crate) struct Elaborated<S> {
    stage: Stage,
    table: RangeTable,
    processor: Processor<S>,
    workspaces: Pool<Workspace<S>>,
    stores: Pool<Vec<f32>>,
}

/// Buffers that are used again; what they held last never matters.
struct Pool<T>(Mutex<Vec<T>>);

impl<T: Default> Pool<T> {
    fn take(&self) -> T {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default()
    }

    fn give_back(&self, buffer: T) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(buffer);
    }
}

impl<S: Real> Elaborated<S> {
    pub fn new(stage: Stage) -> Self {
        let settings = &stage.settings;
        let table = RangeTable::new(&settings.range, settings.raster.samples as usize);
        let laws = &settings.laws;
        let processor = Processor::new(laws.occlusion, laws.curvature, table.ranges());
        let (workspaces, stores) = (Pool(Mutex::default()), Pool(Mutex::default()));
        Self { stage, table, processor, workspaces, stores }
    }

    /// Runs all groups; each writes its own sweeps of `store`.
    fn sweep_all(&self, plan: &FramePlan, probe: &Probe, store: &mut [f32]) -> Vec<GroupResult> {
        let lines = self.stage.settings.raster.lines as usize;
        let group = Group { stage: &self.stage, table: &self.table, processor: &self.processor, plan };
        store
            .par_chunks_mut(LANES * lines)
            .enumerate()
            .map(|(index, rows)| {
                let first = (index * LANES) as u32;
                let mut work = self.workspaces.take();
                group.run(first, &mut work, rows);
                let result = self.look_at(plan, probe, first, &work, rows);
                self.workspaces.give_back(work);
                result
            })
            .collect()
    }

    fn look_at(
        &self,
        plan: &FramePlan,
        probe: &Probe,
        first: u32,
        work: &Workspace<S>,
        rows: &[f32],
    ) -> GroupResult {
        let lines = self.stage.settings.raster.lines as usize;
        let sweeps = rows.len() / lines;
        let mut result = GroupResult::default();
        for lane in 0..sweeps {
            result.counts.add(&counts(&work.programs[lane], self.table.ranges().len()));
            let sweep = first + lane as u32;
            if probe.wants_sweep(sweep) {
                let region_size = self.stage.landscape.level().region_size();
                let ranges = self.table.ranges();
                let recorded = Recorded { plan, ranges, region_size, work, rows, lines };
                result.waveforms.extend(recorded.waveforms(probe, lane, sweep));
            }
        }
        result
    }

    fn read_out(&self, plan: &FramePlan, store: &[f32], planes: &mut Planes) {
        let (columns, lines) = (planes.columns(), planes.lines());
        let Some(picture) = planes.get_mut(PlaneKind::Intensity) else { return };
        let settings = &self.stage.settings;
        match settings.sweep_memory {
            SweepMemoryKind::DigitalMemory => digital_memory(store, lines, columns, picture),
            SweepMemoryKind::ScanConverter => {
                let view = View {
                    fan: plan.fan,
                    projection: settings.laws.projection,
                    pitch: plan.pitch,
                    field: settings.raster.field,
                };
                scan_converter(store, lines, columns, &view, picture);
            }
        }
    }
}

/// What a group has to say beside its lines.
#[derive(Default)]
struct GroupResult {
    counts: FrameCounts,
    waveforms: Vec<Waveform>,
}

/// Work that a sweep was: the same for any number of threads.
fn counts(program: &SweepProgram, samples: usize) -> FrameCounts {
    let folds = program.steps.iter().filter(|step| matches!(step.kind, StepKind::Fold(_))).count();
    let late = program.misses.iter().map(|miss| u64::from(miss.words.0.count_ones())).sum();
    FrameCounts {
        sweeps: 1,
        samples: samples as u64,
        regions: 0,
        folds: folds as u64,
        loads: (program.steps.len() - folds) as u64,
        late_words: late,
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
        let raster = &self.stage.settings.raster;
        let plan = FramePlan::new(frame, pose, &self.stage)?;
        let mut store = self.stores.take();
        store.resize(raster.sweeps as usize * raster.lines as usize, 0.0);
        let groups = self.sweep_all(&plan, probe, &mut store);
        self.read_out(&plan, &store, planes);
        self.stores.give_back(store);
        let regions = plan.visible_regions(self.stage.landscape.level(), self.stage.settings.range.end);
        let mut total = FrameCounts { regions: regions as u64, ..FrameCounts::default() };
        for group in groups {
            total.add(&group.counts);
            probe.waveforms.extend(group.waveforms);
        }
        Ok(total)
    }

    fn omissions(&self) -> Vec<Omission> {
        omissions(self.stage.landscape.bank().levels().len())
    }
}
