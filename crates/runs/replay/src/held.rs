//! What a run folder holds: frames with their hashes, and the record that lists them.

use std::collections::BTreeSet;
use std::io::Write;
use std::ops::{Deref, Range};
use std::path::{Path, PathBuf};

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use run_record::{FileRecord, FrameRecord, RecordError, RunRecord, TruthFrame, TruthRecord, hash};
use serde::Serialize;

use crate::ReplayError;
use crate::folder::is_of_run;
use crate::journal::{self, JOURNAL};
use crate::names::TRUTH;
use crate::truth_files;

/// Record of a run, in its folder.
pub const RUN_RECORD: &str = "run.json";

/// The record of a finished run, read from its folder.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldRun(RunRecord);

impl Deref for HeldRun {
    type Target = RunRecord;

    fn deref(&self) -> &RunRecord {
        &self.0
    }
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
        RunRecord::read(&path).map(Self).map_err(|error| match error {
            RecordError::File(error) => error.into(),
            RecordError::Content(reason) => ReplayError::Record { path, reason },
        })
    }

    /// The same, or nothing where the folder has no record.
    pub(crate) fn read_if_there(folder: &Path) -> Result<Option<Self>, ReplayError> {
        if folder.join(RUN_RECORD).exists() { Self::read(folder).map(Some) } else { Ok(None) }
    }

    /// The pictures in the order in which they are shown.
    pub fn pictures<'a>(&'a self, folder: &'a Path) -> impl Iterator<Item = PathBuf> + 'a {
        self.frames.iter().flat_map(|frame| &frame.files).map(|file| folder.join(&file.file))
    }

    /// Returns the record of the run.
    pub fn into_record(self) -> RunRecord {
        self.0
    }
}

/// Files of `folder` that its records and journals list, whatever is in them now. A record that cannot be read lists nothing.
pub(crate) fn listed_files(folder: &Path) -> BTreeSet<String> {
    let truth = folder.join(TRUTH);
    let mut files = BTreeSet::new();
    if let Ok(record) = RunRecord::read(&folder.join(RUN_RECORD)) {
        files.extend(record.files().map(str::to_owned));
    }
    if let Ok(Some(journal)) = journal::read::<FrameRecord>(&folder.join(JOURNAL)) {
        files.extend(journal.frames.iter().flat_map(|frame| names_of(&frame.files)).map(str::to_owned));
    }
    if let Ok(record) = TruthRecord::read(&truth.join(truth_files::RECORD)) {
        files.extend(record.files().map(|name| format!("{TRUTH}/{name}")));
    }
    if let Ok(Some(journal)) = journal::read::<TruthFrame>(&truth.join(truth_files::JOURNAL)) {
        let names = journal.frames.iter().flat_map(|frame| names_of(&frame.files));
        files.extend(names.map(|name| format!("{TRUTH}/{name}")));
    }
    files
}

fn names_of(files: &[FileRecord]) -> impl Iterator<Item = &str> {
    files.iter().map(|file| file.file.as_str())
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

/// A value as a file of a run holds it.
pub(crate) fn pretty(value: &impl Serialize) -> String {
    serde_json::to_string_pretty(value).expect("records are plain values") + "\n"
}

/// Writes the file `name` of `folder`, unless it is there with these bytes.
pub(crate) fn write_changed(folder: &Path, name: &str, bytes: &[u8]) -> Result<FileRecord, ReplayError> {
    let path = folder.join(name);
    if !files::holds(&path, bytes) {
        files::write_atomic(&path, |out: &mut dyn Write| out.write_all(bytes))?;
    }
    Ok(FileRecord { file: name.into(), blake3: hash(bytes) })
}
