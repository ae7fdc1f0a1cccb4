//! The digital side before any sweep is drawn: what the data banks hold, and what the processor has ready.

use crate::stage::MachineStage;
use data_bank::{BankState, DrumUnit, FrameSupply};
use dpu::{CpuFrame, CpuLoad, CrossingTime, MissingCorner, cpu_frame, held_by_set_ups};
use hardware_model::{CrossingServer, Settings};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use remote_shadow::Footings;
use scenario::Standing;
use timing::Vertices;

use crate::absent::{Absent, AbsentCrater};
use crate::banks::{Bank, BankDemand, Supplied, banks};
use crate::blocks::Blocks;
use crate::crossings::Crossings;
use crate::data_kind::DataKind;
use crate::demand::{Asking, Layout, Layouts};
use crate::raster::WrittenRaster;
use crate::squares::SquareGrid;
use crate::sweep_recorder::SweepRecorder;
use crate::ticks::start_of;

/// The digital side of a mission.
#[derive(Debug)]
pub struct Digital {
    layouts: Layouts,
    /// Data banks, where data are not all at hand.
    banks: Vec<Bank>,
    /// Whether the processor takes any time.
    is_timed: bool,
}

/// The digital side of one frame.
#[derive(Debug, Default)]
pub struct DigitalFrame {
    /// Corners that are not in the storage buffers, by level.
    pub missing: [Vec<MissingCorner>; 2],
    /// What the banks did, kind by kind; none where all data are at hand.
    pub supplies: Vec<Supplied>,
    /// Squares of each kind beside terrain that has a bank.
    pub grids: Vec<(DataKind, SquareGrid)>,
    /// Craters that are not in the storage buffer as the frame begins, ascending.
    pub absent_craters: Vec<AbsentCrater>,
    /// Boundaries of shadow that are not, where any are not.
    pub absent_shadows: Option<Absent>,
    /// Bodies that are not, by their numbers in the list of the mission, ascending.
    pub absent_bodies: Vec<u32>,
    /// The processor, if it takes any time.
    pub cpu: Option<CpuFrame>,
    /// Ticks of each sweep in which crossings wait for a set-up that they cannot interrupt; empty if they never do.
    pub held: Vec<u64>,
    /// Vertices of polyhedra that the frame asks for, as far as anybody wants to know.
    pub vertices: u64,
}

impl DigitalFrame {
    /// The sweep whose set-up `sweep` is drawn with.
    #[inline]
    pub fn drawn(&self, sweep: u32) -> u32 {
        self.cpu.as_ref().map_or(sweep, |cpu| cpu.drawn[sweep as usize])
    }

    /// Vertices of polyhedra that the processor has ready, if they are not all that the frame asks for.
    #[inline]
    pub fn ready_vertices(&self) -> Option<u64> {
        self.cpu.as_ref().map(|cpu| cpu.vertices).filter(|&ready| ready < self.vertices)
    }

    /// Vertices asked for, and those that are ready.
    pub fn vertices(&self) -> Vertices {
        Vertices { asked: self.vertices, ready: self.ready_vertices().unwrap_or(self.vertices) }
    }

    /// What the bank of a kind did, if it has one.
    pub fn supplied(&self, kind: DataKind) -> Option<&Supplied> {
        self.supplies.iter().find(|supplied| supplied.kind == kind)
    }

    /// Notes what the storage buffers lack.
    fn note_missing(&mut self, stage: &MachineStage, layouts: &Layouts) {
        for supplied in &self.supplies {
            let supply = supplied.supply();
            let layout = layouts.of(supplied.kind);
            self.grids.extend(layout.map(|layout| (supplied.kind, layout.grid)));
            let absent = layout.and_then(|layout| Absent::of(layout.grid, supply));
            match supplied.kind {
                DataKind::Fine | DataKind::Coarse => {
                    let corner = |missing: &data_bank::Missing| MissingCorner {
                        corner: missing.item,
                        arrival: missing.arrival,
                    };
                    let level = supplied.kind as usize;
                    self.missing[level] = supply.missing.iter().map(corner).collect();
                }
                DataKind::Features => self.absent_craters = absent_craters(stage, layout, absent.as_ref()),
                DataKind::Shadows => self.absent_shadows = absent,
                DataKind::Polyhedra => self.absent_bodies = absent_bodies(stage, layout, absent.as_ref()),
            }
        }
    }

    /// Corners that are not in the storage buffer of the fine and of the coarse level.
    #[inline]
    pub fn missing(&self) -> [&[MissingCorner]; 2] {
        self.missing.each_ref().map(Vec::as_slice)
    }
}

/// What the frames of a mission have in common on their digital side.
#[derive(Debug, Clone, Copy)]
pub struct Surroundings<'a> {
    /// Blocks that are there.
    pub blocks: &'a Blocks,
    /// What the sweeps write.
    pub raster: &'a WrittenRaster,
    /// Feet and shadows of bodies, found once a body and a sun.
    pub footings: &'a Footings,
}

impl Digital {
    /// The digital side of a mission that draws `stage` with `blocks`.
    pub fn new(stage: &MachineStage, blocks: &Blocks) -> Self {
        let settings = &stage.settings;
        let layouts = Layouts::new(stage, blocks);
        let banks = banks(stage, blocks, &layouts);
        Self { layouts, banks, is_timed: processor_takes_time(settings) }
    }

    /// The drums that a kind lies on as the seed drew them, with the transfer of one of its records; none where all data are at
    /// hand.
    pub fn drums(&self, kind: DataKind) -> Vec<DrumUnit> {
        let of_bank = |bank: &Bank| Some(bank.units(bank.kinds.iter().position(|&there| there == kind)?));
        self.banks.iter().find_map(of_bank).unwrap_or_default()
    }

    /// Whether the processor takes any time.
    pub fn is_timed(&self) -> bool {
        self.is_timed
    }

    /// The digital side of the frame of `plan`.
    pub fn frame(
        &self,
        stage: &MachineStage,
        around: Surroundings<'_>,
        crossings: &Crossings<'_>,
        vertices: u64,
    ) -> DigitalFrame {
        let mut out = DigitalFrame { vertices, ..DigitalFrame::default() };
        let asking = self.asking(stage, around);
        for bank in &self.banks {
            out.supplies.extend(bank.frame(&asking, crossings.plan.frame));
        }
        out.note_missing(stage, &self.layouts);
        if self.is_timed {
            let starts = starts(stage, crossings.plan.frame);
            out.held = held(stage, &starts);
            let crossings = Crossings { missing: out.missing(), held: &out.held, ..*crossings };
            out.cpu = Some(processor(stage, &crossings, &starts, vertices));
        }
        out
    }

    /// What the banks have to bring before the mission, kind by kind.
    pub(crate) fn first_loads(
        &self,
        stage: &MachineStage,
        around: Surroundings<'_>,
    ) -> Vec<(DataKind, FrameSupply)> {
        let asking = self.asking(stage, around);
        let of_bank = |bank: &Bank| bank.kinds.clone().into_iter().zip(bank.first_load(&asking));
        self.banks.iter().flat_map(of_bank).collect()
    }

    /// What the banks remember as frame `frame` begins, before its demand is read: the kinds on the drums of each, and its state.
    pub(crate) fn banks_before(
        &self,
        stage: &MachineStage,
        around: Surroundings<'_>,
        frame: u64,
    ) -> Vec<(Vec<DataKind>, BankState)> {
        let asking = self.asking(stage, around);
        self.banks.iter().map(|bank| (bank.kinds.clone(), bank.before(&asking, frame))).collect()
    }

    /// What frames 0 to `last` ask of each bank, kind by kind.
    pub(crate) fn demands(
        &self,
        stage: &MachineStage,
        around: Surroundings<'_>,
        last: u64,
    ) -> Vec<Vec<BankDemand>> {
        let asking = self.asking(stage, around);
        self.banks.iter().map(|bank| bank.demands(&asking, last)).collect()
    }

    fn asking<'a>(&'a self, stage: &'a MachineStage, around: Surroundings<'a>) -> Asking<'a> {
        let Surroundings { blocks, raster, footings } = around;
        Asking { stage, blocks, raster, footings, layouts: &self.layouts }
    }
}

/// Whether the processor of a machine takes any time.
pub(crate) fn processor_takes_time(settings: &Settings) -> bool {
    settings.cpu.is_timed() || settings.loader.served_by == CrossingServer::CpuInterrupt
}

/// Craters whose records are not all there, ascending.
fn absent_craters(
    stage: &MachineStage,
    layout: Option<&Layout>,
    absent: Option<&Absent>,
) -> Vec<AbsentCrater> {
    let (Some(layout), Some(absent)) = (layout, absent) else { return Vec::new() };
    let craters = stage.landscape.features().craters();
    let crater = |crater: u32| {
        let records = layout.chains.records_of(&layout.grid, crater as usize, craters.circle(crater).0);
        Some(AbsentCrater { crater, comes: absent.last_of(records)? })
    };
    (0..craters.len() as u32).filter_map(crater).collect()
}

/// Bodies whose records are not all there as the frame begins, ascending.
fn absent_bodies(stage: &MachineStage, layout: Option<&Layout>, absent: Option<&Absent>) -> Vec<u32> {
    let (Some(layout), Some(absent)) = (layout, absent) else { return Vec::new() };
    let standing = stage.scenery.standing().iter().enumerate();
    let lacks = |(number, standing): &(usize, &Standing)| {
        absent.last_of(layout.records_of_body(*number, &standing.body)).is_some()
    };
    standing.filter(lacks).map(|(number, _)| number as u32).collect()
}

/// Starts of the sweeps of a frame and its end, in ticks from its start.
fn starts(stage: &MachineStage, frame: u64) -> Vec<u64> {
    let first = start_of(stage, frame, 0).0;
    (0..=stage.settings.raster.sweeps).map(|sweep| start_of(stage, frame, sweep).0 - first).collect()
}

/// With one level of interrupts the crossings of a sweep wait until the set-up that runs in it is done.
fn held(stage: &MachineStage, starts: &[u64]) -> Vec<u64> {
    let settings = &stage.settings;
    let waits = settings.loader.served_by == CrossingServer::CpuInterrupt && settings.cpu.has_one_level();
    if waits { held_by_set_ups(&settings.cpu, starts) } else { Vec::new() }
}

/// The processor's frame. What the crossings of each sweep take of it is worked out first: their interrupts and words where
/// it serves them itself, the memory cycles of their words where these go through its memory.
fn processor(stage: &MachineStage, crossings: &Crossings<'_>, starts: &[u64], vertices: u64) -> CpuFrame {
    let settings = &stage.settings;
    let taken = crossing_times(crossings);
    let unbroken = settings.loader.served_by == CrossingServer::CpuInterrupt && settings.cpu.has_one_level();
    cpu_frame(&settings.cpu, CpuLoad { starts, crossings: &taken, unbroken, vertices })
}

/// What the crossings of each sweep take of the processor; empty if they never take anything.
pub(crate) fn crossing_times(crossings: &Crossings<'_>) -> Vec<CrossingTime> {
    let settings = &crossings.stage.settings;
    let serves = settings.loader.served_by == CrossingServer::CpuInterrupt;
    let taken = |sweep: u32| {
        let sweep = SweepRecorder::of(crossings, [sweep, sweep], None);
        if serves { sweep.time_of_processor() } else { sweep.stolen(settings) }
    };
    let takes_time = serves || settings.cpu.stolen(1) > 0;
    let sweeps = if takes_time { 0..settings.raster.sweeps } else { 0..0 };
    sweeps.into_par_iter().map(taken).collect()
}
