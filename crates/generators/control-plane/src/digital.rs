//! The digital side before any sweep is drawn: what the data banks hold, and what the processor has ready.

use std::sync::{Arc, Mutex, PoisonError};

use crate::stage::MachineStage;
use data_bank::{BankState, DataBank, Demand, DrumUnit, FrameSupply, corners_of, nearest_first};
use dpu::{CpuFrame, CpuLoad, CrossingTime, MissingCorner, Sector, cpu_frame, held_by_set_ups};
use hardware_model::{CrossingServer, DataBanks, Settings};
use landscape::Level;
use quantities::wrap_heading;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Pose;
use timing::Vertices;

use crate::blocks::Blocks;
use crate::crossings::Crossings;
use crate::frame_plan::FramePlan;
use crate::raster::WrittenRaster;
use crate::sweep_recorder::SweepRecorder;
use crate::ticks::{frame_ticks, start_of};

/// The digital side of a mission.
#[derive(Debug)]
pub struct Digital {
    /// Data banks of the fine and of the coarse level, where words are not all at hand.
    banks: [Option<Mutex<History>>; 2],
    /// Whether the processor takes any time.
    is_timed: bool,
}

/// A data bank from the start of the mission on, worked out once, in order of frames.
#[derive(Debug)]
struct History {
    bank: DataBank,
    supplies: Vec<Arc<FrameSupply>>,
}

/// The digital side of one frame.
#[derive(Debug, Default)]
pub struct DigitalFrame {
    /// Corners that are not in the storage buffers, by level.
    pub missing: [Vec<MissingCorner>; 2],
    /// Drums by level; none where all words are at hand.
    pub drums: [Vec<DrumUnit>; 2],
    /// What the data banks did, by level.
    pub supplies: [Option<Arc<FrameSupply>>; 2],
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

    /// Corners that are not in the storage buffer of the fine and of the coarse level.
    #[inline]
    pub fn missing(&self) -> [&[MissingCorner]; 2] {
        self.missing.each_ref().map(Vec::as_slice)
    }
}

impl Digital {
    /// The digital side of a mission that draws `stage`.
    pub fn new(stage: &MachineStage) -> Self {
        let settings = &stage.settings;
        let history = |number: usize| {
            let bank = bank_of(stage, number)?;
            Some(Mutex::new(History { bank, supplies: Vec::new() }))
        };
        let second = settings.levels.and_then(|_| history(1));
        let serves = settings.loader.served_by == CrossingServer::CpuInterrupt;
        Self { banks: [history(0), second], is_timed: settings.cpu.is_timed() || serves }
    }

    /// The drums of a level as the seed drew them; none where all words are at hand.
    pub fn drums(&self, level: usize) -> Vec<DrumUnit> {
        let Some(history) = &self.banks[level] else { return Vec::new() };
        history.lock().unwrap_or_else(PoisonError::into_inner).bank.drums().collect()
    }

    /// Whether the processor takes any time.
    pub fn is_timed(&self) -> bool {
        self.is_timed
    }

    /// The digital side of the frame of `plan`.
    pub fn frame(
        &self,
        stage: &MachineStage,
        blocks: &Blocks,
        raster: &WrittenRaster,
        crossings: &Crossings<'_>,
        vertices: u64,
    ) -> DigitalFrame {
        let mut out = DigitalFrame { vertices, ..DigitalFrame::default() };
        let levels = stage.landscape.bank().levels();
        for (number, bank) in self.banks.iter().enumerate() {
            let Some(bank) = bank else { continue };
            let sight = Sight { stage, raster, level: &levels[number], reach: reach(stage, blocks, number) };
            let supply = sight.supply(bank, crossings.plan.frame);
            let convert = |missing: &data_bank::Missing| MissingCorner {
                corner: missing.corner,
                arrival: missing.arrival,
            };
            out.missing[number] = supply.missing.iter().map(convert).collect();
            out.supplies[number] = Some(supply);
            out.drums[number] = self.drums(number);
        }
        if self.is_timed {
            let starts = starts(stage, crossings.plan.frame);
            out.held = held(stage, &starts);
            let crossings = Crossings { missing: out.missing(), held: &out.held, ..*crossings };
            out.cpu = Some(processor(stage, &crossings, &starts, vertices));
        }
        out
    }
}

/// The data bank of a level as a mission finds it, where words are not all at hand.
fn bank_of(stage: &MachineStage, number: usize) -> Option<DataBank> {
    let Settings { data_banks, seed, .. } = &stage.settings;
    let DataBanks { drum, channels, buffer_words } = *data_banks;
    let level = stage.landscape.bank().levels().get(number)?;
    Some(DataBank::new(drum?, channels, buffer_words, level.corners(), seed ^ number as u64))
}

/// Ground range up to which a level is drawn (m).
fn reach(stage: &MachineStage, blocks: &Blocks, number: usize) -> f64 {
    let end = stage.settings.range.end;
    match (number, &blocks.coarse) {
        (0, Some(coarse)) => coarse.switch.range.min(end),
        _ => end,
    }
}

/// What the data banks of the fine and of the coarse level have to bring before the mission, where there are any.
pub(crate) fn first_loads(
    stage: &MachineStage,
    blocks: &Blocks,
    raster: &WrittenRaster,
) -> [Option<FrameSupply>; 2] {
    with_banks(stage, blocks, raster, |bank, sight| bank.first_load(&sight.demand(0)))
}

/// What the data banks of the fine and of the coarse level remember as frame `frame` begins, before its demand is read.
pub(crate) fn banks_before(
    stage: &MachineStage,
    blocks: &Blocks,
    raster: &WrittenRaster,
    frame: u64,
) -> [Option<BankState>; 2] {
    with_banks(stage, blocks, raster, |mut bank, sight| {
        (0..frame).for_each(|earlier| {
            bank.frame(&sight.demand(earlier));
        });
        bank.state()
    })
}

/// What `ask` makes of the data bank of each level that is drawn, as the mission finds it.
fn with_banks<T>(
    stage: &MachineStage,
    blocks: &Blocks,
    raster: &WrittenRaster,
    ask: impl Fn(DataBank, &Sight<'_>) -> T,
) -> [Option<T>; 2] {
    let levels = stage.landscape.bank().levels();
    let drawn = 1 + usize::from(stage.settings.levels.is_some());
    [0, 1].map(|number| {
        let bank = bank_of(stage, number).filter(|_| number < drawn)?;
        let sight = Sight { stage, raster, level: &levels[number], reach: reach(stage, blocks, number) };
        Some(ask(bank, &sight))
    })
}

/// What the frames of a mission can see of one level.
struct Sight<'a> {
    stage: &'a MachineStage,
    raster: &'a WrittenRaster,
    level: &'a Level,
    /// Ground range up to which the level is drawn (m).
    reach: f64,
}

impl Sight<'_> {
    /// The data bank's supply of a frame, worked out from the first frame on.
    fn supply(&self, history: &Mutex<History>, asked: u64) -> Arc<FrameSupply> {
        let mut history = history.lock().unwrap_or_else(PoisonError::into_inner);
        let History { bank, supplies } = &mut *history;
        while supplies.len() as u64 <= asked {
            let demand = self.demand(supplies.len() as u64);
            supplies.push(Arc::new(bank.frame(&demand)));
        }
        Arc::clone(&supplies[asked as usize])
    }

    /// Corners that frame `frame` can meet, the nearest first, with the way that the view turns until the drum has come
    /// round once and a half (hardware section 4.7).
    fn demand(&self, frame: u64) -> Demand {
        let [start, end] = frame_ticks(self.stage, frame);
        let course = self.stage.scenery.course();
        let pose = |frame: u64| course.get((frame as usize).min(course.len().saturating_sub(1)));
        let Some(now) = pose(frame) else {
            return Demand { frame, start, end, corners: Vec::new() };
        };
        let before = pose(frame.saturating_sub(1)).unwrap_or(now);
        let turn = wrap_heading(now.attitude.heading - before.attitude.heading);
        let turn = if turn > std::f64::consts::PI { turn - 2.0 * std::f64::consts::PI } else { turn };
        let rotation = self.stage.settings.data_banks.drum.map_or(0, |drum| drum.rotation);
        // Orders are given as frames begin: one a little short of a frame away is a frame away.
        let margin = turn.abs() * (1.5 * rotation as f64 / (end.0 - start.0) as f64).ceil();
        Demand { frame, start, end, corners: self.corners(frame, now, margin) }
    }

    fn corners(&self, frame: u64, pose: &Pose, margin: f64) -> Vec<u32> {
        let Self { stage, raster, level, reach } = *self;
        let foot = level.in_regions(pose.eye[0], pose.eye[1]);
        let Ok(plan) = FramePlan::new(frame, pose, stage, &raster.field) else { return Vec::new() };
        let edges = plan.edges_beside(margin);
        let sector = Sector { foot, edges, range: reach / level.region_size() };
        let mut corners = corners_of(sector.regions(level), level.corners());
        nearest_first(&mut corners, level.corners()[1], foot);
        corners
    }
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
        let sweep = SweepRecorder::of(crossings, [sweep, sweep]);
        if serves { sweep.time_of_processor() } else { sweep.stolen(settings) }
    };
    let takes_time = serves || settings.cpu.stolen(1) > 0;
    let sweeps = if takes_time { 0..settings.raster.sweeps } else { 0..0 };
    sweeps.into_par_iter().map(taken).collect()
}
