//! The timing record of a frame: what the service of every sweep did, the processor, the data banks.

use std::collections::BTreeMap;

use dpu::{LineUse, Watch};
use generator::{FrameError, Stage};
use hardware_model::CrossingServer;
use quantities::{SweepTime, Tick};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Pose;
use sweep_generator::RangeTable;
use sweep_program::{
    Colour, Fold, Load, Miss, MissCause, NO_CORNER, PreloadRegister, RampAxis, Stop, SweepProgram, Target,
    WordMask,
};
use timing::{Cause, Deadline, EventHash, FrameTiming, Missed, Sets, Slack, UnitUse};

use crate::blocks::Blocks;
use crate::control_plane::FramePlan;
use crate::crossings::Crossings;
use crate::digital::{Digital, DigitalFrame, frame_ticks};
use crate::raster::WrittenRaster;
use crate::sight::vertices;
use crate::workspace::idle_program;

/// The digital side of the machine alone: timing records without a picture.
#[derive(Debug)]
pub struct ControlPlane {
    stage: Stage,
    blocks: Blocks,
    table: RangeTable,
    raster: WrittenRaster,
    digital: Digital,
}

impl ControlPlane {
    /// The control plane of a stage.
    pub fn new(stage: Stage) -> Self {
        let settings = &stage.settings;
        Self {
            blocks: Blocks::new(&stage),
            table: RangeTable::new(&settings.range, settings.raster.samples as usize),
            raster: WrittenRaster::new(settings),
            digital: Digital::new(&stage),
            stage,
        }
    }

    /// Timing of frame `frame`, by all threads of the current pool; the same for any number of them.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn frame(&self, frame: u64, pose: &Pose) -> Result<FrameTiming, FrameError> {
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        let crossings = Crossings {
            stage: &self.stage,
            coarse: self.blocks.coarse.as_ref(),
            table: &self.table,
            plan: &plan,
            missing: Default::default(),
        };
        let vertices = vertices(&self.stage, &self.blocks, &plan, pose.time);
        let digital = self.digital.frame(&self.stage, &self.blocks, &self.raster, &crossings, vertices);
        let crossings = Crossings { missing: digital.missing(), ..crossings };
        let sweeps = self.stage.settings.raster.sweeps;
        let record = |sweep: u32| SweepRecorder::of(&crossings, [digital.drawn(sweep), sweep]);
        let recorded: Vec<SweepRecorder> = (0..sweeps).into_par_iter().map(record).collect();
        Ok(self.summary(frame, &digital, recorded))
    }

    fn summary(&self, frame: u64, digital: &DigitalFrame, sweeps: Vec<SweepRecorder>) -> FrameTiming {
        let [start, end] = frame_ticks(&self.stage, frame);
        let (events, events_blake3) = EventHash::join(sweeps.iter().map(|sweep| sweep.events.part()));
        let mut deadlines = BTreeMap::from([(Deadline::Transfer, Slack::default())]);
        let mut sets = Sets::default();
        let (mut folds, mut late_words, mut misses) = (0, 0, Vec::new());
        let mut lines = [LineUse::default(); 4];
        for sweep in sweeps {
            deadlines.entry(Deadline::Transfer).or_default().merge(&sweep.transfers);
            if sweep.corners.count > 0 {
                deadlines.entry(Deadline::Corner).or_default().merge(&sweep.corners);
            }
            add_sets(&mut sets, &sweep.sets);
            folds += sweep.folds;
            late_words += sweep.late_words;
            for (line, used) in lines.iter_mut().zip(&sweep.lines) {
                line.busy += used.busy;
                line.longest_queue = line.longest_queue.max(used.longest_queue);
            }
            misses.extend(sweep.misses);
        }
        let mut units = self.loader_units(&lines);
        self.processor(digital, &lines, &mut deadlines, &mut units, &mut misses);
        units.extend(drum_units(digital));
        misses.sort_by(|a, b| a.sweep.cmp(&b.sweep).then(a.due.total_cmp(&b.due)));
        FrameTiming {
            frame,
            ticks: end.0 - start.0,
            folds,
            sets,
            late_words,
            deadlines,
            units,
            misses,
            events,
            events_blake3,
        }
    }

    fn loader_units(&self, lines: &[LineUse; 4]) -> Vec<UnitUse> {
        let unit = |unit: &str, line: &LineUse| UnitUse {
            unit: unit.into(),
            busy: line.busy,
            longest_queue: line.longest_queue,
        };
        match self.stage.settings.loader.served_by {
            CrossingServer::WiredPointers => Colour::ALL
                .map(|colour| unit(&format!("loader.{}", word(colour)), &lines[colour as usize]))
                .into(),
            CrossingServer::IoProcessor => vec![unit("io-processor", &lines[0])],
            CrossingServer::CpuInterrupt => Vec::new(),
        }
    }

    fn processor(
        &self,
        digital: &DigitalFrame,
        lines: &[LineUse; 4],
        deadlines: &mut BTreeMap<Deadline, Slack>,
        units: &mut Vec<UnitUse>,
        misses: &mut Vec<Missed>,
    ) {
        let Some(cpu) = &digital.cpu else { return };
        let serves = self.stage.settings.loader.served_by == CrossingServer::CpuInterrupt;
        let longest_queue = if serves { lines[0].longest_queue } else { 0 };
        units.push(UnitUse { unit: "cpu".into(), busy: cpu.busy, longest_queue });
        let set_up = deadlines.entry(Deadline::SweepSetUp).or_default();
        let per_sample = self.stage.settings.timebase.ticks_per_sample();
        for &(sweep, slack) in &cpu.set_ups {
            set_up.add(slack);
            if slack < 0 {
                misses.push(late_task(Deadline::SweepSetUp, sweep, Some(-slack as f64 / per_sample)));
            }
        }
        for (sweep, &drawn) in cpu.drawn.iter().enumerate() {
            let made = cpu.set_ups.iter().any(|&(made, _)| made as usize == sweep);
            if !made && drawn as usize != sweep {
                misses.push(late_task(Deadline::SweepSetUp, sweep as u32, None));
            }
        }
        deadlines.entry(Deadline::FrameTasks).or_default().add(cpu.frame_slack);
        if cpu.frame_slack < 0 {
            let last = self.stage.settings.raster.sweeps - 1;
            misses.push(late_task(Deadline::FrameTasks, last, None));
        }
    }
}

/// A task of the processor that was not ready.
fn late_task(deadline: Deadline, sweep: u32, came: Option<f64>) -> Missed {
    Missed {
        deadline,
        sweep,
        crossing: None,
        colour: None,
        register: None,
        region: None,
        range_m: None,
        due: 0.0,
        came,
        words: 0,
        cause: Cause::Processor,
    }
}

fn drum_units(digital: &DigitalFrame) -> Vec<UnitUse> {
    let levels = ["fine", "coarse"].into_iter().zip(&digital.supplies);
    let supplied = levels.filter_map(|(level, supply)| Some((level, supply.as_ref()?)));
    let units = supplied.flat_map(|(level, supply)| {
        let drums = supply.busy.iter().enumerate();
        drums.map(move |(number, &busy)| UnitUse {
            unit: format!("drum.{level}.{number}"),
            busy,
            longest_queue: supply.longest_queue,
        })
    });
    units.collect()
}

fn add_sets(sum: &mut Sets, sets: &Sets) {
    sum.wanted += sets.wanted;
    sum.loaded += sets.loaded;
    sum.late += sets.late;
    sum.wasted += sets.wasted;
    sum.cancelled += sets.cancelled;
}

fn word(colour: Colour) -> &'static str {
    match colour {
        Colour::Yellow => "yellow",
        Colour::Green => "green",
        Colour::Black => "black",
        Colour::Red => "red",
    }
}

/// What one sweep's service did.
#[derive(Debug, Default)]
pub(crate) struct SweepRecorder {
    events: EventHash,
    sets: Sets,
    folds: u64,
    late_words: u64,
    transfers: Slack,
    corners: Slack,
    lines: [LineUse; 4],
    misses: Vec<Missed>,
    sweep: u32,
    /// Corners of the level to the east.
    columns: usize,
    /// Master ticks of a sweep: what never comes is as late as that.
    period: i64,
}

impl SweepRecorder {
    /// Runs the service of one sweep, both levels.
    pub fn of(crossings: &Crossings<'_>, sweeps: [u32; 2]) -> Self {
        let timebase = &crossings.stage.settings.timebase;
        let period = (timebase.ticks_per_sample() * f64::from(timebase.sweep_samples())) as i64;
        let mut recorder = Self { sweep: sweeps[1], period, ..Self::default() };
        let mut program = idle_program();
        let levels = crossings.stage.landscape.bank().levels();
        recorder.columns = levels[0].corners()[1];
        crossings.write_fine(sweeps, &mut program, &mut recorder);
        recorder.note_misses(crossings, &program);
        if let Some(coarse) = crossings.coarse {
            recorder.columns = levels[1].corners()[1];
            crossings.write_coarse(coarse, sweeps, &mut program, &mut recorder);
            recorder.note_misses(crossings, &program);
        }
        recorder
    }

    /// Ticks of the only line of an I/O processor, or of the processor itself.
    pub fn busy_of_processor(&self) -> u64 {
        self.lines[0].busy
    }

    fn note_misses(&mut self, crossings: &Crossings<'_>, program: &SweepProgram) {
        let mut sets = 0;
        for miss in &program.misses {
            sets += 1;
            self.late_words += u64::from(miss.words.0.count_ones());
            if miss.arrival.is_none() {
                self.transfers.add(-self.period);
            }
            let missed = self.missed(miss, crossings.table.range_at(miss.time));
            self.misses.push(missed);
        }
        self.sets.late += sets;
    }

    /// North and east index of a corner.
    fn place(&self, corner: u32) -> Option<[i64; 2]> {
        let corner = (corner != NO_CORNER).then_some(corner as usize)?;
        Some([(corner / self.columns) as i64, (corner % self.columns) as i64])
    }

    fn missed(&self, miss: &Miss, range: f64) -> Missed {
        Missed {
            deadline: Deadline::Transfer,
            sweep: self.sweep,
            crossing: Some(miss.crossing),
            colour: Some(word(miss.colour).into()),
            register: Some(register_word(miss.register).into()),
            region: self.place(miss.corner),
            range_m: range.is_finite().then_some(range),
            due: miss.time.0,
            came: miss.arrival.map(|arrival| arrival.0),
            words: miss.words.0,
            cause: match miss.cause {
                MissCause::Access => Cause::Access,
                MissCause::Queue => Cause::Queue,
                MissCause::HeldBack => Cause::HeldBack,
            },
        }
    }
}

fn register_word(register: PreloadRegister) -> &'static str {
    match register {
        PreloadRegister::XFirst => "x-first",
        PreloadRegister::YFirst => "y-first",
    }
}

impl Watch for SweepRecorder {
    fn fold(&mut self, tick: Tick, fold: Fold) {
        self.folds += 1;
        let axis = if fold.axis == RampAxis::X { "x" } else { "y" };
        self.events.push(tick.0, "stop", axis, &[u64::from(fold.stop == Stop::One)]);
    }

    fn wanted(&mut self) {
        self.sets.wanted += 1;
    }

    fn loaded(&mut self) {
        self.sets.loaded += 1;
    }

    fn wasted(&mut self) {
        self.sets.wasted += 1;
    }

    fn cancelled(&mut self) {
        self.sets.cancelled += 1;
    }

    fn arrival(&mut self, tick: Tick, load: &Load) {
        let target = match load.target {
            Target::Hold => "hold",
            Target::Preload(register) => register_word(register),
        };
        self.events.push(
            tick.0,
            word(load.colour),
            target,
            &[u64::from(load.corner), u64::from(load.words.0)],
        );
    }

    fn transfer(&mut self, slack: i64) {
        self.transfers.add(slack);
    }

    fn starved(&mut self, tick: Tick, at: SweepTime, colour: Colour, corner: u32, arrival: Option<Tick>) {
        match arrival {
            Some(arrival) => self.corners.add(tick.0 as i64 - arrival.0 as i64),
            None => self.corners.add(-self.period),
        }
        self.misses.push(Missed {
            deadline: Deadline::Corner,
            sweep: self.sweep,
            crossing: None,
            colour: Some(word(colour).into()),
            register: None,
            region: self.place(corner),
            range_m: None,
            due: at.0,
            came: None,
            words: WordMask::ALL.0,
            cause: Cause::Drum,
        });
    }

    fn end(&mut self, lines: &[LineUse; 4]) {
        for (line, used) in self.lines.iter_mut().zip(lines) {
            line.busy += used.busy;
            line.longest_queue = line.longest_queue.max(used.longest_queue);
        }
    }
}
