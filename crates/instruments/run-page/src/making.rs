//! What a replay puts into the folder of its run for the page, and the page.

use std::collections::BTreeMap;

use deadlines::spread;
use front_door::Opened;
use generator::{Scan, Timed};
use machine::MachineStage;
use rayon::ThreadPool;
use replay::{HeldRun, Job, Phases, RunFolder};
use report::{Beside, ReportError, TimingSummary, write_page};
use scenario::{PoseRow, PoseTable};
use timing::{FORMAT, FrameTiming, TimingRecord};

use crate::recording::record;
use crate::sight::sight;
use crate::{PageError, Request};

/// Frames whose timing is summed up: enough to see whether the machine keeps up, few enough to cost nothing.
const TIMED_FRAMES: u64 = 8;

/// A page in the making.
pub struct Making<'a> {
    /// Job whose frames are all drawn.
    pub job: &'a Job<'a>,
    /// The words of a command line that chose its stage.
    pub words: Vec<String>,
    /// What these words came to.
    pub opened: &'a Opened,
    /// Sweeps to record for the page.
    pub requests: &'a [Request],
    /// Threads that draw and record.
    pub pool: &'a ThreadPool,
}

impl Making<'_> {
    /// Writes page.json, plots and page into `folder`. What is there and right is not worked out again. The phases of the page are
    /// added to `phases`.
    ///
    /// # Errors
    /// If the record of the run cannot be read, a frame cannot be drawn, or a file cannot be written.
    pub fn write(&self, folder: &RunFolder, phases: &mut Phases) -> Result<(), PageError> {
        let held = HeldRun::read(folder.path())?;
        let mut beside = match Beside::read(folder.path(), &held.fingerprint) {
            Err(ReportError::Content { .. }) => Beside::new(&held.fingerprint),
            other => other?,
        };
        beside.stage = self.words.clone();
        if !self.job.generator.signals().is_empty() {
            let poses = self.poses(&held)?;
            if self.opened.is_machine() {
                let stage = MachineStage::new(self.job.stage.clone(), self.opened.settings.clone());
                beside.sight = sight(&stage?, &poses);
            }
            phases.mark("sight");
            self.sum_up_timing(&poses, &mut beside)?;
            phases.mark("timing");
            record(self, &poses, folder, &mut beside)?;
            phases.mark("probe");
        }
        beside.write(folder.path())?;
        write_page(folder.path())?;
        phases.mark("page");
        Ok(())
    }

    /// How the signals of the generator run, if it has any.
    pub(crate) fn scan(&self) -> Option<Scan> {
        self.job.generator.scan(&self.job.stage.view)
    }

    /// Poses of the frames that the folder holds.
    fn poses(&self, held: &HeldRun) -> Result<Vec<PoseRow>, PageError> {
        let (Some(first), Some(last)) = (held.frames.first(), held.frames.last()) else { return Ok(vec![]) };
        let view = &self.job.stage.view;
        let frames = first.frame..last.frame + 1;
        let landscape = &self.job.stage.landscape;
        let table = PoseTable::resolve(self.job.scenario, landscape, view.update, view.yoke, frames)?;
        Ok(table.rows().to_vec())
    }

    fn sum_up_timing(&self, poses: &[PoseRow], beside: &mut Beside) -> Result<(), PageError> {
        let chosen = spread(TIMED_FRAMES)(poses.len() as u64);
        let rows: Vec<&PoseRow> = chosen.iter().map(|&index| &poses[index as usize]).collect();
        let frames = rows.iter().map(|row| row.frame);
        if beside.timing.as_ref().is_some_and(|known| frames.eq(known.frames.iter().copied())) {
            return Ok(());
        }
        let timed = self.job.generator.timed(self.job.stage.clone())?;
        let Some(timed) = timed else { return Ok(()) };
        let frames = self.timed(&rows, &*timed)?;
        let tick_s = 1.0 / timed.master().hertz();
        let record = TimingRecord {
            format: FORMAT,
            scenario: self.job.scenario.title.clone(),
            machine: self.opened.drawn_by().to_owned(),
            inputs: String::new(),
            keys: BTreeMap::new(),
            master: String::new(),
            before_mission: Vec::new(),
            frames,
        };
        beside.timing = Some(TimingSummary::of(&record, tick_s));
        Ok(())
    }

    fn timed(&self, rows: &[&PoseRow], by: &dyn Timed) -> Result<Vec<FrameTiming>, PageError> {
        let frame = |row: &&PoseRow| self.pool.install(|| by.frame_for_totals(row.frame, &row.pose));
        Ok(rows.iter().map(frame).collect::<Result<_, _>>()?)
    }
}
