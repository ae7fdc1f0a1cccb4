//! The journal of work that is not finished: one line a frame, on the disk before the frame counts as done.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use limits::Limit;
use run_record::{FrameRecord, ShardRecord, TruthFrame, is_as_sealed, sealed};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::ReplayError;
use crate::fingerprint::Fingerprint;

/// Name of the journal of a run.
pub const JOURNAL: &str = "frames.journal";

/// Schema of the first line.
const SCHEMA: &str = "lunoid.journal/1";

#[derive(Serialize, Deserialize)]
struct Heading {
    schema: String,
    fingerprint: String,
    /// What the fingerprint is of; journals of earlier versions do not say.
    #[serde(default)]
    of: Value,
    /// Frames of the run; journals of other work do not say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    span: Option<RunSpan>,
}

/// Frames of a run that is being drawn.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RunSpan {
    /// First frame, and the frame behind the last.
    pub range: [u64; 2],
    /// The part of a larger run that this run is, where a worker draws it as a shard.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shard: Option<ShardRecord>,
}

/// A line of a journal: a frame and the files that it became.
pub trait Entry: Serialize + DeserializeOwned {
    /// What no run can have written, in words.
    fn fault(&self) -> Option<String>;
}

impl Entry for FrameRecord {
    fn fault(&self) -> Option<String> {
        self.fault()
    }
}

impl Entry for TruthFrame {
    fn fault(&self) -> Option<String> {
        self.fault()
    }
}

/// What a journal on disk says.
#[derive(Debug)]
pub struct Found<T> {
    /// What the work is made from.
    pub fingerprint: Fingerprint,
    /// Frames of the run, where the journal is a run's and says so.
    pub span: Option<RunSpan>,
    /// All its whole lines.
    pub frames: Vec<T>,
}

/// A journal that is being written.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: Mutex<File>,
}

/// The journal at `path`, if there is one. A line that was cut short or changed is left out, so that its frame is drawn again.
///
/// # Errors
/// If the file cannot be read, is no journal, or has a line that no run writes.
pub fn read<T: Entry>(path: &Path) -> Result<Option<Found<T>>, ReplayError> {
    if !path.exists() {
        return Ok(None);
    }
    let bytes = files::read_all(path, Limit::RecordBytes)?;
    let mut lines = bytes.split(|byte| *byte == b'\n');
    let heading: Option<Heading> = lines.next().and_then(|line| serde_json::from_slice(line).ok());
    let refuse = |reason| Err(ReplayError::Record { path: path.to_owned(), reason });
    let Some(Heading { fingerprint, of, span, .. }) = heading.filter(|heading| heading.schema == SCHEMA)
    else {
        return refuse(format!("the first line has no schema {SCHEMA:?}"));
    };
    let whole = lines.filter_map(|line| str::from_utf8(line).ok()).filter(|line| is_as_sealed(line));
    let frames: Vec<T> = whole.filter_map(|line| serde_json::from_str(line).ok()).collect();
    if let Some(fault) = frames.iter().find_map(T::fault) {
        return refuse(fault);
    }
    Ok(Some(Found { fingerprint: Fingerprint { hash: fingerprint, of }, span, frames }))
}

impl Journal {
    /// Begins a journal at `path` with frames that are known to be whole.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn begin<T: Serialize>(
        path: PathBuf,
        fingerprint: &Fingerprint,
        frames: &[T],
    ) -> Result<Self, ReplayError> {
        Self::begin_headed(path, fingerprint, None, frames)
    }

    /// Begins a journal of a run, whose heading has the frames of that run.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(crate) fn begin_run(
        path: PathBuf,
        fingerprint: &Fingerprint,
        span: RunSpan,
        frames: &[FrameRecord],
    ) -> Result<Self, ReplayError> {
        Self::begin_headed(path, fingerprint, Some(span), frames)
    }

    fn begin_headed<T: Serialize>(
        path: PathBuf,
        fingerprint: &Fingerprint,
        span: Option<RunSpan>,
        frames: &[T],
    ) -> Result<Self, ReplayError> {
        let Fingerprint { hash, of } = fingerprint.clone();
        let heading = Heading { schema: SCHEMA.into(), fingerprint: hash, of, span };
        files::write_atomic(&path, |out| {
            out.write_all(&line(&heading)?)?;
            frames.iter().try_for_each(|frame| out.write_all(&line(frame)?))
        })?;
        let file = files::append_own(&path)?;
        Ok(Self { path, file: Mutex::new(file) })
    }

    /// Adds a frame whose files are on the disk.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn add(&self, frame: &impl Serialize) -> Result<(), ReplayError> {
        let failed = |source| failed(&self.path, source);
        let line = line(frame).map_err(failed)?;
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.write_all(&line).and_then(|()| file.sync_data()).map_err(failed)
    }

    /// Ends the journal: the record of the run says all that it said, or nothing was done.
    ///
    /// # Errors
    /// If the file cannot be removed.
    pub fn end(self) -> Result<(), ReplayError> {
        fs::remove_file(&self.path).map_err(|source| failed(&self.path, source))
    }
}

fn failed(path: &Path, source: std::io::Error) -> ReplayError {
    ReplayError::Folder { path: path.to_owned(), doing: "keep the journal", source }
}

fn line(value: &impl Serialize) -> std::io::Result<Vec<u8>> {
    Ok((sealed(&serde_json::to_string(value)?) + "\n").into_bytes())
}

#[cfg(test)]
mod tests {
    use super::{JOURNAL, Journal, read};
    use crate::fingerprint::Fingerprint;
    use run_record::{FileRecord, FrameRecord};

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
        let fingerprint = Fingerprint { hash: "f".into(), of: serde_json::json!({ "view": 3 }) };
        let journal = Journal::begin(path.clone(), &fingerprint, &first).expect("begun");
        (500..1000).for_each(|frame| journal.add(&record(frame)).expect("added"));
        let found = read(&path).expect("readable").expect("there");
        assert_eq!((found.fingerprint, found.frames), (fingerprint, (0..1000).map(record).collect()));
        let mut elsewhere = record(1000);
        elsewhere.files.push(FileRecord { file: "../../mine.png".into(), blake3: "h".into() });
        journal.add(&elsewhere).expect("added");
        let said = read::<FrameRecord>(&path).expect_err("refused").to_string();
        assert!(said.contains("it lists `../../mine.png`, expected files of its folder"), "{said}");
        journal.end().expect("ended");
        assert!(read::<FrameRecord>(&path).expect("readable").is_none());
    }
}
