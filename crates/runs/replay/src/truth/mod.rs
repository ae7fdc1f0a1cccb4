//! Ground truth: what each pixel of a run shows, from `exact` at the pixel's centre.
//!
//! ```text
//! truth/frame-000000.npz        one array for each kind that was asked for
//! truth/poses.csv  poses.json   time, eye, attitude, rotation, sun
//! truth/truth.json              units, codes, conventions, error, what it was made from, a hash of every file
//! ```
//!
//! It is written after the pictures, frame by frame, whoever drew them, and resumes as they do. The format stands in
//! `docs/truth-format.md`.

mod item;
mod joined;
mod poses;
mod record;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

use files::{Npy, write_npz};
use generator::{PlaneKind, Planes, Session};
use run_record::{FileRecord, RecordError, TruthFrame, TruthRecord, file_hash, hash};
use scenario::{PixelRule, PoseRow, PoseTable};
use serde_json::json;
use signal::Probe;

use crate::fingerprint::Fingerprint;
use crate::held::{frame_range, pretty, whole, write_changed};
use crate::job::{Control, Job, Progress};
use crate::journal::{self, Journal};
use crate::names::{TRUTH, truth_name};
use crate::truth_files::{JOURNAL, POSES_CSV, POSES_JSON, RECORD, TRUTH_FILES};
use crate::{HeldRun, ReplayError, RunFolder};
use record::{FORMAT, Finished, truth_record};

pub use item::{TruthItem, TruthItems};
pub use joined::{JoinedTruth, held_truth};
pub use record::TRUTH_ERROR;

/// How far the truth of a run is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TruthOutcome {
    /// Frames that have or are to have their truth.
    pub frames: u64,
    /// Frames that have it.
    pub done: u64,
    /// Of these made now.
    pub made: u64,
}

/// Writes the truth of `job.frames` beside the finished run in `folder`, or what is missing of it. Frames that have
/// theirs keep it.
///
/// # Errors
/// If the folder has no finished run or holds truth of other kinds, or a file cannot be written. What was finished
/// before stays, and the same call goes on from there.
pub fn write_truth(
    job: &Job,
    items: &TruthItems,
    folder: &RunFolder,
    control: &Control,
) -> Result<TruthOutcome, ReplayError> {
    let mut truth = Truth::prepare(job, items, folder, control)?;
    let kept = truth.frames.len() as u64;
    let journal = truth.begin()?;
    truth.draw(&journal)?;
    let done = truth.frames.len() as u64;
    let frames = truth.rows.len() as u64;
    if done == frames {
        truth.finish()?;
        journal.end()?;
    }
    Ok(TruthOutcome { frames, done, made: done - kept })
}

struct Truth<'a> {
    /// The job with the pixel rule of the truth.
    job: Job<'a>,
    items: &'a TruthItems,
    folder: &'a RunFolder,
    control: &'a Control<'a>,
    run: HeldRun,
    session: Box<dyn Session>,
    fingerprint: Fingerprint,
    /// Poses of all frames that are to have truth.
    rows: Vec<PoseRow>,
    /// Frames that have it.
    frames: BTreeMap<u64, TruthFrame>,
}

impl<'a> Truth<'a> {
    fn prepare(
        job: &Job<'a>,
        items: &'a TruthItems,
        folder: &'a RunFolder,
        control: &'a Control<'a>,
    ) -> Result<Self, ReplayError> {
        let mut job = job.clone();
        job.stage.view.laws.pixel_rule = PixelRule::Centre;
        let run = HeldRun::read(folder.path())?;
        let fingerprint = fingerprint(&run, items);
        let listed = listed(folder, &fingerprint.hash, items)?;
        expect_frames_of(&run, folder, &listed)?;
        let rows = rows(&job, &run, &listed.keys().copied().chain(job.frames.clone()).collect())?;
        let session = control.pool.install(|| registry::judge_on(job.stage.clone()))?;
        (control.progress)(Progress::Verifying { frames: listed.len() as u64 });
        let listed = listed.into_values().collect();
        let check = || whole(listed, &folder.join(TRUTH), |frame: &TruthFrame| &frame.files);
        let frames: BTreeMap<_, _> =
            control.pool.install(check).into_iter().map(|frame| (frame.frame, frame)).collect();
        let missing = rows.iter().filter(|row| !frames.contains_key(&row.frame));
        let names = missing.map(|row| truth_name(row.frame)).chain(TRUTH_FILES.map(str::to_owned));
        folder.expect_own(names.map(|name| format!("{TRUTH}/{name}")))?;
        Ok(Self { job, items, folder, control, run, session, fingerprint, rows, frames })
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(TRUTH).join(name)
    }

    /// From here on the folder has truth of these kinds.
    fn begin(&self) -> Result<Journal, ReplayError> {
        self.folder.make(TRUTH)?;
        let kept: Vec<&TruthFrame> = self.frames.values().collect();
        let journal = Journal::begin(self.path(JOURNAL), &self.fingerprint, &kept)?;
        let has_row = |frame| self.rows.binary_search_by_key(&frame, |row| row.frame).is_ok();
        self.folder.remove_stray_truth(has_row)?;
        Ok(journal)
    }

    /// Makes what is missing, one frame after the other: `exact` uses all threads for each.
    fn draw(&mut self, journal: &Journal) -> Result<(), ReplayError> {
        let missing: Vec<PoseRow> =
            self.rows.iter().filter(|row| !self.frames.contains_key(&row.frame)).copied().collect();
        let (frames, kept) = (self.rows.len() as u64, self.frames.len() as u64);
        (self.control.progress)(Progress::Begins { what: "truth", frames, kept });
        let mut planes = self.planes();
        for row in &missing {
            if self.control.cancel.load(Ordering::Relaxed) {
                break;
            }
            let frame = self.frame(row, &mut planes)?;
            journal.add(&frame)?;
            self.frames.insert(row.frame, frame);
            (self.control.progress)(Progress::Frame { done: self.frames.len() as u64 });
        }
        Ok(())
    }

    fn planes(&self) -> Planes {
        let raster = &self.job.stage.view;
        let kinds: Vec<PlaneKind> = self.items.arrays().flat_map(TruthItem::kinds).copied().collect();
        Planes::new(raster.columns as usize, raster.lines as usize, &kinds)
    }

    fn frame(&self, row: &PoseRow, planes: &mut Planes) -> Result<TruthFrame, ReplayError> {
        let (frame, time_s) = (row.frame, row.pose.time);
        if self.items.arrays().next().is_none() {
            return Ok(TruthFrame { frame, time_s, files: Vec::new() });
        }
        let draw = || self.session.frame(frame, &row.pose, planes, &mut Probe::off());
        self.control.pool.install(draw)?;
        let mut arrays: Vec<(&str, Npy)> = Vec::new();
        for item in self.items.arrays() {
            check_numbers(frame, item, planes)?;
            let array = item.array(planes).map_err(|source| ReplayError::TruthArray { frame, source })?;
            arrays.push((item.name(), array));
        }
        let file = truth_name(frame);
        let path = self.path(&file);
        write_npz(&path, arrays.iter().map(|(name, array)| (*name, array)))?;
        Ok(TruthFrame { frame, time_s, files: vec![FileRecord { blake3: file_hash(&path)?, file }] })
    }

    fn finish(&self) -> Result<(), ReplayError> {
        (self.control.progress)(Progress::Finishing);
        let (folder, stage) = (self.folder.join(TRUTH), &self.job.stage);
        let mut outputs = Vec::new();
        if self.items.has_pose() {
            outputs.push(write_changed(&folder, POSES_CSV, poses::csv(stage, &self.rows).as_bytes())?);
            let document = pretty(&poses::document(stage, &self.rows));
            outputs.push(write_changed(&folder, POSES_JSON, document.as_bytes())?);
        }
        let frames: Vec<TruthFrame> = self.frames.values().cloned().collect();
        let record = truth_record(&Finished {
            job: &self.job,
            run: &self.run,
            items: self.items,
            fingerprint: &self.fingerprint.hash,
            frames: &frames,
            outputs: &outputs,
            omissions: &self.session.omissions(),
        });
        write_changed(&folder, RECORD, pretty(&record).as_bytes())?;
        Ok(())
    }
}

/// What decides the arrays: the run, the format, the kinds.
fn fingerprint(run: &HeldRun, items: &TruthItems) -> Fingerprint {
    let document = json!({ "run": run.fingerprint, "format": FORMAT, "items": items.to_string() });
    Fingerprint { hash: hash(document.to_string().as_bytes()), of: document }
}

/// No frame has truth that the run does not have.
fn expect_frames_of(
    run: &HeldRun,
    folder: &RunFolder,
    listed: &BTreeMap<u64, TruthFrame>,
) -> Result<(), ReplayError> {
    let range = frame_range(&run.frames).unwrap_or(0..0);
    match listed.keys().find(|frame| !range.contains(frame)) {
        None => Ok(()),
        Some(frame) => {
            let reason =
                format!("it lists frame {frame}, expected frames {}..{} of the run", range.start, range.end);
            Err(ReplayError::TruthRecord { path: folder.join(TRUTH).join(RECORD), reason })
        }
    }
}

/// The record at `path`, if there is one.
fn held(path: PathBuf) -> Result<Option<TruthRecord>, ReplayError> {
    if !path.exists() {
        return Ok(None);
    }
    TruthRecord::read(&path).map(Some).map_err(|error| match error {
        RecordError::File(error) => error.into(),
        RecordError::Content(reason) => ReplayError::TruthRecord { path, reason },
    })
}

/// Frames that the record or the journal lists.
fn listed(
    folder: &RunFolder,
    fingerprint: &str,
    items: &TruthItems,
) -> Result<BTreeMap<u64, TruthFrame>, ReplayError> {
    let path = folder.join(TRUTH);
    let held = held(path.join(RECORD))?;
    let journal = journal::read::<TruthFrame>(&path.join(JOURNAL))?;
    let held = held.map(|held| (held.fingerprint, held.frames));
    let found = [held, journal.map(|journal| (journal.fingerprint.hash, journal.frames))];
    let mut frames = BTreeMap::new();
    for (found, list) in found.into_iter().flatten() {
        if found != fingerprint {
            return Err(ReplayError::OtherTruth { path, asked: items.to_string() });
        }
        frames.extend(list.into_iter().map(|frame| (frame.frame, frame)));
    }
    Ok(frames)
}

/// Poses of `frames` that the run has.
fn rows(job: &Job, run: &HeldRun, frames: &BTreeSet<u64>) -> Result<Vec<PoseRow>, ReplayError> {
    let range: Range<u64> = frame_range(&run.frames).unwrap_or(0..0);
    let (update, yoke) = (job.stage.view.update, job.stage.view.yoke);
    let table = PoseTable::resolve(job.scenario, &job.stage.landscape, update, yoke, range)?;
    Ok(table.rows().iter().filter(|row| frames.contains(&row.frame)).copied().collect())
}

fn check_numbers(frame: u64, item: TruthItem, planes: &Planes) -> Result<(), ReplayError> {
    let mut values = item.kinds().iter().filter_map(|kind| planes.get(*kind)).flatten();
    match values.any(|value| value.is_nan()) {
        true => Err(ReplayError::TruthNotANumber { frame, item: item.name() }),
        false => Ok(()),
    }
}
