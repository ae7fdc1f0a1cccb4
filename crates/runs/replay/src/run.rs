//! A job from beginning to end: what is there is verified, the rest drawn, the record written.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::PathBuf;

use generator::{PlaneKind, Session};
use picture::{Encoder, Transfer};
use quantities::Rate;
use scenario::{LimitReport, PoseRow, PoseTable, poses_csv};

use crate::ReplayError;
use crate::camera::camera;
use crate::check::{Check, expect_available};
use crate::draw::{Drawing, draw_all};
use crate::film::{write_animation, write_sheet};
use crate::fingerprint::Fingerprint;
use crate::folder::RunFolder;
use crate::held::{HeldRun, RUN_RECORD, frame_range, pretty, whole, write_changed};
use crate::job::{Control, Job, Progress};
use crate::journal::{self, JOURNAL, Journal, RunSpan};
use crate::listed::Listed;
use crate::names::{ANIMATION, CAMERA, CONTACT_SHEET, FRAMES, PERFORMANCE, POSES, picture_name};
use crate::performance::{CHECK, Performance, StepTimes, performance};
use crate::phases::Phases;
use crate::record::{Finished, run_record};
use crate::world::World;
use run_record::{CheckRecord, FileRecord, FrameRecord};

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// All frames are there.
    Finished {
        /// Frames of the run.
        frames: Range<u64>,
        /// Frames drawn now; the others were there.
        drawn: u64,
        /// Where the vehicle does more than it can.
        limits: Vec<LimitReport>,
        /// Wall times of this session, with the phases up to the end of the run.
        performance: Performance,
    },
    /// Told to end: the frames there are whole, and the same job goes on from them.
    Interrupted {
        /// Frames that are there.
        done: u64,
        /// Frames of the run.
        of: u64,
    },
}

/// Draws `job` into `folder`, or what is missing of it. `phases` are those before, to which those of the run are added.
///
/// # Errors
/// If the folder holds another run, a pose cannot be drawn, or a file cannot be written. What was finished before
/// stays, and the same job goes on from there.
pub fn run(
    job: &Job,
    folder: &RunFolder,
    control: &Control,
    phases: &mut Phases,
) -> Result<Outcome, ReplayError> {
    if job.frames.is_empty() {
        return Err(ReplayError::NoFrames(job.frames.clone()));
    }
    let mut run = Run::prepare(job, folder, control, phases)?;
    let journal = run.begin()?;
    let drawn = match run.draw(&journal) {
        Ok(drawn) => drawn,
        Err(error) => {
            run.leave(journal)?;
            return Err(error);
        }
    };
    let all = run.frames.end - run.frames.start;
    let done = run.kept.len() as u64 + drawn.len() as u64;
    if done < all {
        run.leave(journal)?;
        return Ok(Outcome::Interrupted { done, of: all });
    }
    let Some(performance) = run.finish(drawn)? else {
        return Ok(Outcome::Interrupted { done, of: all });
    };
    journal.end()?;
    let drawn = run.drawn;
    Ok(Outcome::Finished { frames: run.frames, drawn, limits: run.poses.limits().to_vec(), performance })
}

struct Run<'a> {
    job: &'a Job<'a>,
    folder: &'a RunFolder,
    control: &'a Control<'a>,
    session: Box<dyn Session>,
    world: World,
    fingerprint: Fingerprint,
    /// The record of an earlier, finished run of the same job, perhaps of fewer frames.
    earlier: Option<HeldRun>,
    /// Frames that are there and whole.
    kept: BTreeMap<u64, FrameRecord>,
    frames: Range<u64>,
    poses: PoseTable,
    phases: &'a mut Phases,
    times: StepTimes,
    drawn: u64,
    /// Wall time of the drawing (s).
    drawing_s: f64,
}

impl<'a> Run<'a> {
    /// Everything that can be refused before a file is written.
    fn prepare(
        job: &'a Job,
        folder: &'a RunFolder,
        control: &'a Control,
        phases: &'a mut Phases,
    ) -> Result<Self, ReplayError> {
        expect_colour(job)?;
        let world = World::of(job);
        let fingerprint = Fingerprint::of_job(job, &world);
        let held = Listed::read(folder)?;
        held.expect_same(folder, &fingerprint)?;
        held.expect_within(folder, job.scenario.frames(job.stage.view.update))?;
        let (listed, earlier) = (held.frames(), held.earlier);
        let frames = join(folder, &listed, &job.frames)?;
        expect_available(job, frames.end - frames.start)?;
        let poses = job.poses(frames.clone())?;
        expect_drivable(&poses)?;
        let session = job.session(control.pool)?;
        phases.mark("prepare");
        let times = StepTimes::default();
        let mut run = Self {
            job,
            folder,
            control,
            session,
            world,
            fingerprint,
            earlier,
            kept: BTreeMap::new(),
            frames,
            poses,
            phases,
            times,
            drawn: 0,
            drawing_s: 0.0,
        };
        run.verify(listed);
        run.expect_room()?;
        Ok(run)
    }

    /// Nobody else has a file where one is to be written.
    fn expect_room(&self) -> Result<(), ReplayError> {
        let missing = self.frames.clone().filter(|frame| !self.kept.contains_key(frame));
        let showings = self.showings();
        let pictures =
            missing.flat_map(|frame| (0..showings).map(move |nth| picture_name(frame * showings + nth)));
        let film = self.job.pictures.film.then_some(ANIMATION);
        let outputs = [PERFORMANCE, POSES, CAMERA, CONTACT_SHEET].into_iter().chain(film).map(str::to_owned);
        self.folder.expect_own(pictures.chain(outputs))
    }

    /// Keeps the frames whose files are what the record says.
    fn verify(&mut self, listed: BTreeMap<u64, FrameRecord>) {
        if listed.is_empty() {
            return;
        }
        (self.control.progress)(Progress::Verifying { frames: listed.len() as u64 });
        let listed: Vec<FrameRecord> = listed.into_values().collect();
        let folder = self.folder.path();
        let whole = self.control.pool.install(|| whole(listed, folder, |frame| &frame.files));
        self.kept = whole.into_iter().map(|frame| (frame.frame, frame)).collect();
        self.phases.mark("verify");
    }

    /// From here on the folder is this run's.
    fn begin(&self) -> Result<Journal, ReplayError> {
        let kept: Vec<FrameRecord> = self.kept.values().cloned().collect();
        let span = RunSpan { range: [self.frames.start, self.frames.end], shard: self.job.shard.clone() };
        let journal = Journal::begin_run(self.folder.join(JOURNAL), &self.fingerprint, span, &kept)?;
        self.folder.make(FRAMES)?;
        let (start, end) = (self.frames.start * self.showings(), self.frames.end * self.showings());
        self.folder.remove_strays(|index| (start..end).contains(&index))?;
        Ok(journal)
    }

    /// Leaves what is whole for the next time; a run that has nothing leaves nothing.
    fn leave(&self, journal: Journal) -> Result<(), ReplayError> {
        let found = journal::read::<FrameRecord>(&self.folder.join(JOURNAL))?;
        if found.is_some_and(|found| !found.frames.is_empty()) {
            return Ok(());
        }
        self.folder.remove_strays(|_| false)?;
        self.folder.remove_shadows()?;
        journal.end()
    }

    /// Pictures that are kept of one update.
    fn showings(&self) -> u64 {
        let view = &self.job.stage.view;
        let ratio = view.refresh.whole_ratio(view.update);
        if self.job.pictures.refresh { ratio.unwrap_or(1) } else { 1 }
    }

    /// Rate of the pictures that are kept.
    fn picture_rate(&self) -> Rate {
        let view = &self.job.stage.view;
        if self.job.pictures.refresh { view.refresh } else { view.update }
    }

    fn draw(&mut self, journal: &Journal) -> Result<BTreeMap<u64, FrameRecord>, ReplayError> {
        let display = &self.job.stage.view.display;
        let transfer =
            Transfer::new(display.white as f32, display.gamma as f32).map_err(ReplayError::Display)?;
        let missing = self.poses.rows().iter().filter(|row| !self.kept.contains_key(&row.frame));
        let missing: Vec<_> = missing.copied().collect();
        let (all, kept) = (self.frames.end - self.frames.start, self.kept.len() as u64);
        (self.control.progress)(Progress::Begins { what: "frames", frames: all, kept });
        self.phases.mark("begin");
        let drawing = Drawing {
            session: &*self.session,
            view: &self.job.stage.view,
            program: &self.job.program,
            encoder: Encoder::new(transfer, self.job.pictures.depth),
            colour: self.job.pictures.colour,
            showings: self.showings(),
            folder: self.folder,
            journal,
            times: &self.times,
        };
        let drawn = draw_all(&drawing, &missing, kept, self.control)?;
        self.drawing_s = self.phases.mark("draw");
        self.drawn = drawn.len() as u64;
        Ok(drawn)
    }

    /// Everything that follows from the frames; `None` if told to end.
    fn finish(&mut self, drawn: BTreeMap<u64, FrameRecord>) -> Result<Option<Performance>, ReplayError> {
        (self.control.progress)(Progress::Finishing);
        let fresh: Vec<u64> = drawn.keys().copied().collect();
        let mut all = std::mem::take(&mut self.kept);
        all.extend(drawn);
        let frames: Vec<FrameRecord> = all.into_values().collect();
        let Some((check, is_new)) = self.checked(&frames, fresh.is_empty())? else { return Ok(None) };
        if is_new {
            self.phases.mark(CHECK);
        }
        let omissions = self.session.omissions();
        let outputs = self.write_outputs(&frames)?;
        let finished = Finished {
            fingerprint: &self.fingerprint.hash,
            world: &self.world,
            omissions: &omissions,
            limits: self.poses.limits(),
            range: [self.frames.start, self.frames.end],
            check,
            frames: frames.clone(),
            outputs,
        };
        let record = run_record(self.job, finished);
        self.write(RUN_RECORD, record.text().as_bytes())?;
        self.phases.mark("finish");
        let drawn: Vec<&FrameRecord> =
            frames.iter().filter(|frame| fresh.binary_search(&frame.frame).is_ok()).collect();
        let threads = self.control.pool.current_num_threads();
        let update = self.job.stage.view.update;
        let counters = self.job.generator.counters();
        let times =
            performance(self.phases, &self.times, threads, &drawn, self.drawing_s, (update, counters));
        let performance = match drawn.is_empty() {
            false => Performance::of_drawing(times, self.folder)?,
            true => Performance::of_rest(times, self.folder, is_new)?,
        };
        Ok(Some(performance))
    }

    /// The check that the job asks for, and whether it was made now; `None` if told to end. One that was made of the same
    /// frames stays, unless another number of sweeps is asked for.
    fn checked(
        &self,
        frames: &[FrameRecord],
        nothing_drawn: bool,
    ) -> Result<Option<(Option<CheckRecord>, bool)>, ReplayError> {
        let earlier = self
            .earlier
            .as_ref()
            .filter(|earlier| nothing_drawn && frame_range(&earlier.frames).as_ref() == Some(&self.frames));
        let held = earlier.and_then(|earlier| earlier.check.clone());
        if self.job.check == 0 || held.as_ref().is_some_and(|held| held.sweeps == self.job.check) {
            return Ok(Some((held, false)));
        }
        let check = Check {
            job: self.job,
            session: &*self.session,
            folder: self.folder,
            poses: &self.poses,
            frames,
            fingerprint: &self.fingerprint.hash,
            cancel: self.control.cancel,
        };
        let record = self.control.pool.install(|| check.run(self.job.check))?;
        Ok(record.map(|record| (Some(record), true)))
    }

    /// Everything that follows from the frames; what is there and right is not written again.
    fn write_outputs(&self, frames: &[FrameRecord]) -> Result<Vec<FileRecord>, ReplayError> {
        let files = frames.iter().flat_map(|frame| &frame.files);
        let pictures: Vec<PathBuf> = files.map(|file| self.folder.join(&file.file)).collect();
        let film = self.job.pictures.film || self.earlier_output(ANIMATION).is_some();
        let mut outputs = vec![
            self.write(POSES, poses_csv(&self.poses).as_bytes())?,
            self.write(CAMERA, pretty(&camera(&self.job.stage)).as_bytes())?,
            self.unchanged(CONTACT_SHEET).map_or_else(|| write_sheet(self.folder, &pictures), Ok)?,
        ];
        if film {
            let write = || write_animation(self.folder, &pictures, self.picture_rate());
            outputs.push(self.unchanged(ANIMATION).map_or_else(write, Ok)?);
        }
        Ok(outputs)
    }

    fn earlier_output(&self, name: &str) -> Option<&FileRecord> {
        self.earlier.as_ref()?.outputs.iter().find(|output| output.file == name)
    }

    /// An output of the earlier run that still is what it should be.
    fn unchanged(&self, name: &str) -> Option<FileRecord> {
        let earlier = self.earlier.as_ref()?;
        let same_frames = frame_range(&earlier.frames).as_ref() == Some(&self.frames);
        let output = self.earlier_output(name).filter(|_| same_frames)?;
        output.is_whole(self.folder.path()).then(|| output.clone())
    }

    fn write(&self, name: &str, bytes: &[u8]) -> Result<FileRecord, ReplayError> {
        write_changed(self.folder.path(), name, bytes)
    }
}

/// Greatest speed that is drawn and recorded (m/s): beyond that of light nothing drives.
const MOST_SPEED: f64 = 299_792_458.0;

/// Whatever follows from the poses is a number that a record can hold.
fn expect_drivable(poses: &PoseTable) -> Result<(), ReplayError> {
    let is_wrong =
        |row: &&PoseRow| !(row.speed <= MOST_SPEED && row.turn_rate.is_finite() && row.slope.is_finite());
    match poses.rows().iter().find(is_wrong) {
        None => Ok(()),
        Some(row) => {
            let (frame, time, speed) = (row.frame, row.pose.time, row.speed);
            Err(ReplayError::Speed { frame, time, speed, most: MOST_SPEED })
        }
    }
}

/// The frames of the run: those asked for, and those that are there.
fn join(
    folder: &RunFolder,
    listed: &BTreeMap<u64, FrameRecord>,
    asked: &Range<u64>,
) -> Result<Range<u64>, ReplayError> {
    let (Some(first), Some(last)) = (listed.keys().next(), listed.keys().last()) else {
        return Ok(asked.clone());
    };
    let held = *first..*last + 1;
    if asked.start > held.end || asked.end < held.start {
        return Err(ReplayError::Gap { path: folder.path().to_owned(), held, asked: asked.clone() });
    }
    Ok(held.start.min(asked.start)..held.end.max(asked.end))
}

/// Frames in colour need a generator that fills all three planes.
fn expect_colour(job: &Job) -> Result<(), ReplayError> {
    let planes = job.generator.planes();
    match !job.pictures.colour || PlaneKind::COLOUR.iter().all(|kind| planes.contains(kind)) {
        true => Ok(()),
        false => Err(ReplayError::NoColour { generator: job.generator.name() }),
    }
}
