//! What a run folder holds: frames with their hashes, and the record that lists them.

use std::fs;
use std::io::Write;
use std::ops::Range;
use std::path::{Component, Path, PathBuf};

use generator::{Counter, FrameCounts};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use run_record::{FileRecord, MAX_BYTES, hash};
use serde::{Deserialize, Serialize};

use crate::ReplayError;
use crate::folder::is_of_run;
use crate::journal::{self, JOURNAL};

/// Schema of `run.json`.
pub(crate) const RUN_SCHEMA: &str = "lunoid.run/2";

/// Record of a run, in its folder.
pub const RUN_RECORD: &str = "run.json";

/// One update: what the machine computed once, shown in one file, or in several at a higher refresh rate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrameRecord {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Seconds since the start of the mission.
    pub time_s: f64,
    /// BLAKE3 of the pixels, hexadecimal: independent of how the file packs them.
    pub pixels_blake3: String,
    /// The pictures, in order.
    pub files: Vec<FileRecord>,
    /// Work that it was.
    pub counts: FrameCounts,
}

/// A run as its record says.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldRun {
    /// Hash of everything that decides the pixels.
    pub fingerprint: String,
    /// Frames, ascending.
    pub frames: Vec<FrameRecord>,
    /// Other files that follow from the inputs.
    pub outputs: Vec<FileRecord>,
    /// The whole record.
    pub document: serde_json::Value,
}

#[derive(Deserialize)]
struct Wanted {
    schema: String,
    fingerprint: String,
    frames: Vec<FrameRecord>,
    outputs: Vec<FileRecord>,
}

impl HeldRun {
    /// The finished run in `folder`.
    ///
    /// # Errors
    /// If the run is not finished, or its record is gone or cannot be read.
    pub fn read(folder: &Path) -> Result<Self, ReplayError> {
        let path = folder.join(RUN_RECORD);
        if !path.exists() {
            if journal::read::<FrameRecord>(&folder.join(JOURNAL))?.is_some() {
                return Err(ReplayError::Unfinished { path: folder.to_owned() });
            }
            if is_of_run(folder) {
                return Err(ReplayError::NoRecord { path });
            }
        }
        let bytes = files::read_all(&path, MAX_BYTES)?;
        let refused = |reason: String| ReplayError::Record { path: path.clone(), reason };
        let document: serde_json::Value =
            serde_json::from_slice(&bytes).map_err(|error| refused(error.to_string()))?;
        let wanted = Wanted::deserialize(&document).map_err(|error| refused(error.to_string()))?;
        if wanted.schema != RUN_SCHEMA {
            return Err(refused(format!("schema {:?}, expected {RUN_SCHEMA:?}", wanted.schema)));
        }
        let Wanted { fingerprint, frames, outputs, .. } = wanted;
        let all = frames.iter().flat_map(|frame| &frame.files).chain(&outputs);
        if let Some(file) = all.map(|record| &record.file).find(|file| !stays_inside(file)) {
            return Err(refused(format!("it lists `{file}`, expected files of its folder")));
        }
        Ok(Self { fingerprint, frames, outputs, document })
    }

    /// The same, or nothing where the folder has no record.
    pub(crate) fn read_if_there(folder: &Path) -> Result<Option<Self>, ReplayError> {
        if folder.join(RUN_RECORD).exists() { Self::read(folder).map(Some) } else { Ok(None) }
    }

    /// The pictures in the order in which they are shown.
    pub fn pictures<'a>(&'a self, folder: &'a Path) -> impl Iterator<Item = PathBuf> + 'a {
        self.frames.iter().flat_map(|frame| &frame.files).map(|file| folder.join(&file.file))
    }
}

/// The work of all frames.
pub(crate) fn total_work<'a>(
    frames: impl IntoIterator<Item = &'a FrameRecord>,
    counters: &[Counter],
) -> FrameCounts {
    let mut total = FrameCounts::default();
    frames.into_iter().for_each(|frame| total.join(&frame.counts, counters));
    total
}

/// A record leads to files of its own folder only, whoever wrote it.
pub(crate) fn stays_inside(file: &str) -> bool {
    Path::new(file).components().all(|part| matches!(part, Component::Normal(_)))
}

/// First and end of ascending frames.
pub(crate) fn frame_range(frames: &[FrameRecord]) -> Option<Range<u64>> {
    Some(frames.first()?.frame..frames.last()?.frame + 1)
}

/// Those of `listed` whose files in `folder` are what the record says; by the threads of the current pool.
pub(crate) fn whole<T: Send>(
    listed: Vec<T>,
    folder: &Path,
    files: impl Fn(&T) -> &[FileRecord] + Sync,
) -> Vec<T> {
    let is_whole = |item: &T| files(item).iter().all(|file| file.is_whole(folder));
    listed.into_par_iter().filter(is_whole).collect()
}

/// Writes the file `name` of `folder`, unless it is there with these bytes.
pub(crate) fn write_changed(folder: &Path, name: &str, bytes: &[u8]) -> Result<FileRecord, ReplayError> {
    let path = folder.join(name);
    let is_there = fs::metadata(&path).is_ok_and(|found| found.len() == bytes.len() as u64)
        && fs::read(&path).is_ok_and(|found| found == bytes);
    if !is_there {
        files::write_atomic(&path, |out: &mut dyn Write| out.write_all(bytes))?;
    }
    Ok(FileRecord { file: name.into(), blake3: hash(bytes) })
}
