//! From folders to one folder.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use generator::Counter;
use replay::{ANIMATION, Control, JoinedRun, JoinedTruth, POSES, RunFolder};
use run_record::{FrameRecord, RunRecord, total_work};

use crate::frames::{Frames, Listed, apart, join_frames};
use crate::gaps::{gaps_of_frames, gaps_of_truth, missing, whole};
use crate::limits::join_limits;
use crate::rows::{Rows, poses_and_camera};
use crate::same::expect_same;
use crate::source::{Source, Sources};
use crate::truth::join_truth;
use crate::verify::verify;
use crate::{Gap, MergeError};

/// Folders that are to be joined.
#[derive(Debug, Clone, Copy)]
pub struct Merge<'a> {
    /// Run folders, in any order.
    pub folders: &'a [PathBuf],
    /// Frames of the whole run, counted at the update rate; by the folders if left out.
    pub frames: Option<&'a Range<u64>>,
}

/// How the joining of shards ended.
#[derive(Debug)]
pub enum Outcome {
    /// The joined run is whole.
    Joined(Joined),
    /// Frames are missing, ascending; nothing was written.
    Gaps {
        /// Stretches of missing frames, then folders without the truth that others have.
        gaps: Vec<Gap>,
        /// Words of the command that draws the whole run, behind `lunoid replay`, where a shard has them.
        words: Option<Vec<String>>,
    },
    /// Told to end: the same call goes on from there.
    Interrupted {
        /// Frames that are whole in the folder of the joined run.
        done: u64,
        /// Frames of the run.
        of: u64,
    },
}

/// What was joined, in figures.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Joined {
    /// Frames of the run.
    pub frames: Range<u64>,
    /// Frames that more than one folder has, and that agree.
    pub overlap: u64,
    /// Frames that have ground truth.
    pub truth: u64,
    /// Whether a folder has a check, which is left out.
    pub left_check_out: bool,
}

/// Joins the runs of `wish` into `folder`.
///
/// # Errors
/// If the folders are not of one run, do not agree, or hold a file that was changed; nothing is written then. If the joined run
/// cannot be written.
pub fn merge(wish: Merge, folder: &RunFolder, control: &Control) -> Result<Outcome, MergeError> {
    expect_apart(wish.folders, folder.path())?;
    let Sources { finished, unfinished } = Sources::read(wish.folders)?;
    if finished.is_empty() {
        let path = wish.folders.first().cloned().unwrap_or_default();
        return Err(MergeError::NothingFinished { path });
    }
    expect_same(finished.iter().map(|source| (&source.run, source.record())))?;
    let whole = whole(&finished, wish.frames)?;
    let frames = join_frames(finished.iter().map(listed))?;
    let truth = join_truth(&finished)?;
    let mut gaps = gaps_of_frames(missing(&whole, frames.keys().copied()), &unfinished);
    gaps.extend(gaps_of_truth(&finished));
    if !gaps.is_empty() {
        let shard = finished.iter().find_map(|source| source.run.shard.as_ref());
        return Ok(Outcome::Gaps { gaps, words: shard.map(|shard| shard.words.clone()) });
    }
    let run = join_run(&finished, &frames)?;
    let interrupted = |done| Ok(Outcome::Interrupted { done, of: whole.end - whole.start });
    if !verify(&finished, control)? {
        return interrupted(0);
    }
    let given: u64 = finished.iter().map(|source| source.run.frames.len() as u64).sum();
    let joined = Joined {
        overlap: given - frames.len() as u64,
        truth: truth.as_ref().map_or(0, |truth| truth.record.frames.len() as u64),
        left_check_out: finished.iter().any(|source| source.run.check.is_some()),
        frames: whole.clone(),
    };
    match write(run, truth, folder, control)? {
        Some(done) => interrupted(done),
        None => Ok(Outcome::Joined(joined)),
    }
}

/// What the record of a source lists.
fn listed(source: &Source) -> Listed<'_, FrameRecord> {
    Listed { frames: &source.run.frames, folder: &source.folder, record: source.record() }
}

/// Writes run and truth. Returns the number of whole frames if told to end.
fn write(
    run: JoinedRun,
    truth: Option<JoinedTruth>,
    folder: &RunFolder,
    control: &Control,
) -> Result<Option<u64>, MergeError> {
    let frames = run.record.frames.len() as u64;
    let done = run.write(folder, control)?;
    if done < frames {
        return Ok(Some(done));
    }
    let is_whole = truth.map_or(Ok(true), |truth| truth.write(folder, control))?;
    Ok((!is_whole).then_some(done))
}

/// Every folder is given once, and none is the folder of the joined run.
fn expect_apart(folders: &[PathBuf], out: &Path) -> Result<(), MergeError> {
    let place = |path: &Path| fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let out = place(out);
    for (at, path) in folders.iter().enumerate() {
        if place(path) == out {
            return Err(MergeError::IntoItself { path: path.clone() });
        }
        if folders[..at].iter().any(|other| place(other) == place(path)) {
            return Err(MergeError::Twice { path: path.clone() });
        }
    }
    Ok(())
}

/// The run of all `frames`.
fn join_run<'a>(
    sources: &'a [Source],
    frames: &Frames<'a, FrameRecord>,
) -> Result<JoinedRun<'a>, MergeError> {
    let (poses, camera): (Rows, _) = poses_and_camera(sources)?;
    if !poses.frames().eq(frames.keys().copied()) {
        let path = sources[0].folder.join(POSES);
        let reason = "its rows and those of the other folders are not the frames of their runs".into();
        return Err(MergeError::Table { path, reason });
    }
    let (records, folders) = apart(frames);
    let first = &sources[0];
    let ends = (records.first(), records.last());
    let range = if let (Some(first), Some(last)) = ends { [first.frame, last.frame + 1] } else { [0, 0] };
    let record = RunRecord {
        range,
        shard: None,
        totals: total_work(&records, counters(first)?),
        limits: join_limits(sources.iter().flat_map(|source| &source.run.limits)),
        check: None,
        frames: records,
        outputs: Vec::new(),
        ..first.run.clone()
    };
    let has_film = |source: &Source| source.run.outputs.iter().any(|output| output.file == ANIMATION);
    let film = sources.iter().any(has_film);
    Ok(JoinedRun { record, sources: folders, poses: poses.table(), camera, film })
}

/// The counters of the generator that drew `source`.
fn counters(source: &Source) -> Result<&'static [Counter], MergeError> {
    let name = &source.run.generator;
    let unknown = || MergeError::Generator { path: source.record(), name: name.clone() };
    if name == HYBRID {
        return Ok(machine::COUNTERS);
    }
    let row = registry::find(name).ok_or_else(unknown)?;
    Ok(registry::configure_with(row, &[]).map_err(|_| unknown())?.counters())
}

/// Name of the hybrid machine in records.
const HYBRID: &str = "hybrid";
