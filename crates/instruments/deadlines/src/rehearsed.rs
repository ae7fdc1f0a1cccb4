//! A rehearsal of whatever a timing record can be made of.

use std::collections::BTreeMap;
use std::ops::Range;

use front_door::Opened;
use generator::{Planes, SizedFigure, Stage, Timed};
use rayon::ThreadPool;
use replay::Progress;
use signal::Probe;
use text::table;
use timing::{FrameTiming, TimingRecord};

use crate::rehearsal::TimedJob;
use crate::routines::{Routine, routines};
use crate::{DeadlineError, Rehearsal, misses};

/// The hybrid machine's digital side, or another generator whose frames take time.
pub enum Rehearsed {
    /// The digital side of the hybrid machine.
    Machine(Box<Rehearsal>),
    /// Another generator whose frames take time.
    Other(Box<Other>),
}

/// A generator that is no hybrid machine, as something that takes time.
pub struct Other {
    opened: Opened,
    keys: BTreeMap<String, String>,
    stage: Stage,
    timed: Box<dyn Timed>,
    pool: ThreadPool,
}

/// Lines of a frame by which misses are counted, and their name: sweeps, or those of the generator's own scan.
pub fn lines_of(opened: &Opened) -> (u32, &'static str) {
    let scan = opened.generator.scan(&opened.settings.view());
    match scan.filter(|_| !opened.is_machine()) {
        Some(scan) => (scan.timebase.sweeps, scan.line),
        None => (opened.settings.raster.sweeps, "sweep"),
    }
}

impl Rehearsed {
    /// Makes the ground by the threads of `pool`, and readies whatever draws.
    ///
    /// # Errors
    /// If the ground cannot be made, or the frames of the generator take no time.
    pub fn new(opened: Opened, pool: ThreadPool) -> Result<Self, DeadlineError> {
        match opened.is_machine() {
            true => Ok(Self::Machine(Box::new(Rehearsal::new(opened, pool)?))),
            false => Ok(Self::Other(Box::new(Other::new(opened, pool)?))),
        }
    }

    /// The timing record of `frames`, ascending, at least one. `progress` hears of every frame.
    ///
    /// # Errors
    /// If a frame cannot be drawn, or there are more misses than a record keeps.
    pub fn record(&self, frames: &[u64], progress: &dyn Fn(Progress)) -> Result<TimingRecord, DeadlineError> {
        match self {
            Self::Machine(machine) => machine.record(frames, progress),
            Self::Other(other) => other.job().record(frames, progress),
        }
    }

    /// The routines of `record` beside what the source of the generator reports; none if it reports nothing.
    pub fn routines(&self, record: &TimingRecord) -> Vec<Routine> {
        match self {
            Self::Machine(_) => Vec::new(),
            Self::Other(other) => other.routines(record),
        }
    }
}

impl Other {
    fn new(opened: Opened, pool: ThreadPool) -> Result<Self, DeadlineError> {
        let keys = opened.keys()?;
        let stage = pool.install(|| opened.stage())?;
        let timed = opened.generator.timed(stage.clone())?;
        let timed = timed.ok_or_else(|| DeadlineError::NoTime(opened.drawn_by().to_owned()))?;
        Ok(Self { opened, keys, stage, timed, pool })
    }

    fn job(&self) -> TimedJob<'_> {
        TimedJob {
            scenario: &self.opened.scenario,
            landscape: &self.stage.landscape,
            clock: (self.stage.view.update, self.stage.view.yoke),
            machine: self.opened.drawn_by(),
            keys: &self.keys,
            timed: &*self.timed,
            pool: &self.pool,
        }
    }

    /// What the front door opened.
    pub fn opened(&self) -> &Opened {
        &self.opened
    }

    /// The stage that is drawn.
    pub(crate) fn stage(&self) -> &Stage {
        &self.stage
    }

    /// Draws a frame into `planes`.
    pub(crate) fn draw(&self, frame: u64, mut planes: Planes) -> Result<Planes, DeadlineError> {
        let pose = self.job().poses(&[frame])?[0].pose;
        let session = self.opened.generator.prepare(self.stage.clone())?;
        self.pool.install(|| session.frame(frame, &pose, &mut planes, &mut Probe::off()))?;
        Ok(planes)
    }

    /// What the frames of `record` took beside what the formulas of the generator say; no figures if it has none.
    pub(crate) fn figures(&self, record: &TimingRecord) -> Vec<SizedFigure> {
        self.timed.sizing(&record.frames)
    }

    /// The routines of `record` beside what the source of the generator reports; none if it reports nothing.
    pub fn routines(&self, record: &TimingRecord) -> Vec<Routine> {
        routines(record, 1.0 / self.timed.master().hertz(), self.timed.reported())
    }

    /// A table of the misses in `lines` of every frame of the record: lines as the generator scans.
    pub fn misses_text(&self, record: &TimingRecord, lines: &Range<u64>) -> String {
        let (_, line) = lines_of(&self.opened);
        misses::lines_text(record, lines, line, 1e9 / self.timed.master().hertz())
    }

    /// A table of how long each frame of `record` takes, unit by unit and in all, or else how long the frame is: in seconds, or in
    /// milliseconds where it has deadlines.
    pub fn times_text(&self, record: &TimingRecord) -> String {
        times_text(record, self.timed.master().hertz(), |frame| self.timed.in_all(frame))
    }
}

fn times_text(record: &TimingRecord, master_hz: f64, in_all: impl Fn(&FrameTiming) -> Option<u64>) -> String {
    let is_short = record.frames.iter().any(|frame| !frame.deadlines.is_empty());
    let (scale, unit_of_time) = if is_short { (1e3, "ms") } else { (1.0, "s") };
    let time = |ticks: u64| format!("{:.2}", scale * ticks as f64 / master_hz);
    let head = |frame: &FrameTiming| -> Vec<String> {
        let units = frame.units.iter().map(|unit| unit.unit.as_str());
        // A frame with deadlines is as long as its period, whatever is done in it.
        let last = if is_short && in_all(frame).is_none() { "frame length" } else { "in all" };
        let columns = units.chain([last]).map(|column| format!("{column} ({unit_of_time})"));
        ["frame".to_owned()].into_iter().chain(columns).collect()
    };
    let row = |frame: &FrameTiming| -> Vec<String> {
        let units = frame.units.iter().map(|unit| time(unit.busy));
        let last = time(in_all(frame).unwrap_or(frame.ticks));
        [frame.frame.to_string()].into_iter().chain(units).chain([last]).collect()
    };
    let rows: Vec<_> =
        record.frames.first().map(head).into_iter().chain(record.frames.iter().map(row)).collect();
    format!("\n{}", table(&rows))
}
