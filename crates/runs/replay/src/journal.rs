//! The journal of work that is not finished: one line a frame, on the disk before the frame counts as done.

use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::ReplayError;

/// Name of the journal of a run.
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
pub(crate) struct Found<T> {
    pub fingerprint: String,
    pub frames: Vec<T>,
}

/// A journal that is being written.
#[derive(Debug)]
pub(crate) struct Journal {
    path: PathBuf,
    file: Mutex<File>,
}

/// The journal at `path`, if there is one. A last line that was cut short is left out.
pub(crate) fn read<T: DeserializeOwned>(path: &Path) -> Result<Option<Found<T>>, ReplayError> {
    if !path.exists() {
        return Ok(None);
    }
    let bytes = files::read_all(path, MAX_BYTES)?;
    let mut lines = bytes.split(|byte| *byte == b'\n');
    let heading: Option<Heading> = lines.next().and_then(|line| serde_json::from_slice(line).ok());
    let Some(Heading { fingerprint, .. }) = heading.filter(|heading| heading.schema == SCHEMA) else {
        let reason = format!("the first line has no schema {SCHEMA:?}");
        return Err(ReplayError::Record { path: path.to_owned(), reason });
    };
    let frames = lines.filter_map(|line| serde_json::from_slice(line).ok()).collect();
    Ok(Some(Found { fingerprint, frames }))
}

impl Journal {
    /// Begins a journal at `path` with frames that are known to be whole.
    pub fn begin<T: Serialize>(path: PathBuf, fingerprint: &str, frames: &[T]) -> Result<Self, ReplayError> {
        let heading = Heading { schema: SCHEMA.into(), fingerprint: fingerprint.into() };
        files::write_atomic(&path, |out| {
            out.write_all(&line(&heading)?)?;
            frames.iter().try_for_each(|frame| out.write_all(&line(frame)?))
        })?;
        let file = OpenOptions::new().append(true).open(&path).map_err(|source| failed(&path, source))?;
        Ok(Self { path, file: Mutex::new(file) })
    }

    /// Adds a frame whose files are on the disk.
    pub fn add(&self, frame: &impl Serialize) -> Result<(), ReplayError> {
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
    use super::{JOURNAL, Journal, read};
    use run_record::FrameRecord;

    #[test]
    fn what_is_read_is_what_was_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let record = |frame: u64| FrameRecord {
            frame,
            time_s: frame as f64 / 15.0,
            pixels_blake3: "p".into(),
            files: vec![],
            counts: generator::FrameCounts::default(),
        };
        let first: Vec<FrameRecord> = (0..500).map(record).collect();
        let path = folder.path().join(JOURNAL);
        let journal = Journal::begin(path.clone(), "f", &first).expect("begun");
        (500..1000).for_each(|frame| journal.add(&record(frame)).expect("added"));
        let found = read(&path).expect("readable").expect("there");
        assert_eq!((found.fingerprint.as_str(), found.frames), ("f", (0..1000).map(record).collect()));
        journal.end().expect("ended");
        assert!(read::<FrameRecord>(&path).expect("readable").is_none());
    }
}
