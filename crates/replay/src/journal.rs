//! The journal of a run that is not finished: one line a frame, on the disk before the frame counts as done.

use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::{Deserialize, Serialize};

use crate::ReplayError;
use crate::held::FrameRecord;

/// Name of the journal.
pub(crate) const JOURNAL: &str = "frames.journal";

/// Schema of the first line.
const SCHEMA: &str = "lunoid.journal/1";

const MAX_BYTES: u64 = 1 << 32;

#[derive(Serialize, Deserialize)]
struct Heading {
    schema: String,
    fingerprint: String,
}

/// What a journal on disk says.
#[derive(Debug)]
pub(crate) struct Found {
    pub fingerprint: String,
    pub frames: Vec<FrameRecord>,
}

/// A journal that is being written.
#[derive(Debug)]
pub(crate) struct Journal {
    path: PathBuf,
    file: Mutex<File>,
}

/// The journal of `folder`, if there is one. A last line that was cut short is left out.
pub(crate) fn read(folder: &Path) -> Result<Option<Found>, ReplayError> {
    let path = folder.join(JOURNAL);
    if !path.exists() {
        return Ok(None);
    }
    let bytes = files::read_all(&path, MAX_BYTES)?;
    let mut lines = bytes.split(|byte| *byte == b'\n');
    let heading: Option<Heading> = lines.next().and_then(|line| serde_json::from_slice(line).ok());
    let Some(Heading { fingerprint, .. }) = heading.filter(|heading| heading.schema == SCHEMA) else {
        return Err(ReplayError::Record { path, reason: format!("the first line has no schema {SCHEMA:?}") });
    };
    let frames = lines.filter_map(|line| serde_json::from_slice(line).ok()).collect();
    Ok(Some(Found { fingerprint, frames }))
}

impl Journal {
    /// Begins a journal with frames that are known to be whole.
    pub fn begin(folder: &Path, fingerprint: &str, frames: &[FrameRecord]) -> Result<Self, ReplayError> {
        let path = folder.join(JOURNAL);
        let heading = Heading { schema: SCHEMA.into(), fingerprint: fingerprint.into() };
        files::write_atomic(&path, |out| {
            out.write_all(&line(&heading)?)?;
            frames.iter().try_for_each(|frame| out.write_all(&line(frame)?))
        })?;
        let file = OpenOptions::new().append(true).open(&path).map_err(|source| failed(&path, source))?;
        Ok(Self { path, file: Mutex::new(file) })
    }

    /// Adds a frame whose files are on the disk.
    pub fn add(&self, frame: &FrameRecord) -> Result<(), ReplayError> {
        let failed = |source| failed(&self.path, source);
        let line = line(frame).map_err(failed)?;
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.write_all(&line).and_then(|()| file.sync_data()).map_err(failed)
    }

    /// Ends the journal: the record of the run says all that it said, or nothing was done.
    pub fn end(self) -> Result<(), ReplayError> {
        fs::remove_file(&self.path).map_err(|source| failed(&self.path, source))
    }
}

fn failed(path: &Path, source: std::io::Error) -> ReplayError {
    ReplayError::Folder { path: path.to_owned(), doing: "keep the journal", source }
}

fn line(value: &impl Serialize) -> std::io::Result<Vec<u8>> {
    let mut line = serde_json::to_vec(value)?;
    line.push(b'\n');
    Ok(line)
}

#[cfg(test)]
mod tests {
    use super::{Journal, read};
    use crate::held::{FrameRecord, WorkRecord};

    #[test]
    fn what_is_read_is_what_was_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let record = |frame: u64| FrameRecord {
            frame,
            time_s: frame as f64 / 15.0,
            pixels_blake3: "p".into(),
            files: vec![],
            counts: WorkRecord::default(),
        };
        let first: Vec<FrameRecord> = (0..500).map(record).collect();
        let journal = Journal::begin(folder.path(), "f", &first).expect("begun");
        (500..1000).for_each(|frame| journal.add(&record(frame)).expect("added"));
        let found = read(folder.path()).expect("readable").expect("there");
        assert_eq!((found.fingerprint.as_str(), found.frames), ("f", (0..1000).map(record).collect()));
        journal.end().expect("ended");
        assert!(read(folder.path()).expect("readable").is_none());
    }
}
