//! A folder that is to be joined.

use std::path::{Path, PathBuf};

use replay::{HeldRun, RUN_RECORD, ReplayError, held_truth, unfinished_frames};
use run_record::{RunRecord, TruthRecord};

use crate::MergeError;

/// The finished run of a folder.
pub(crate) struct Source {
    pub folder: PathBuf,
    pub run: RunRecord,
    pub truth: Option<TruthRecord>,
}

/// A run that was begun.
pub(crate) struct Unfinished {
    pub folder: PathBuf,
    /// Frames that are whole, ascending.
    pub frames: Vec<u64>,
}

/// What the folders hold.
#[derive(Default)]
pub(crate) struct Sources {
    pub finished: Vec<Source>,
    pub unfinished: Vec<Unfinished>,
}

impl Source {
    /// Path of the record.
    pub fn record(&self) -> PathBuf {
        self.folder.join(RUN_RECORD)
    }
}

impl Sources {
    /// Reads the records of `folders`. A run that has a journal and no record yet is unfinished.
    pub fn read(folders: &[PathBuf]) -> Result<Self, MergeError> {
        let mut sources = Self::default();
        for folder in folders {
            match read(folder) {
                Ok(source) => sources.finished.push(source),
                Err(ReplayError::Unfinished { path }) => {
                    let frames = unfinished_frames(&path)?.unwrap_or_default();
                    sources.unfinished.push(Unfinished { folder: path, frames });
                }
                Err(error) => return Err(error.into()),
            }
        }
        Ok(sources)
    }
}

fn read(folder: &Path) -> Result<Source, ReplayError> {
    let run = HeldRun::read(folder)?.into_record();
    Ok(Source { folder: folder.to_owned(), run, truth: held_truth(folder)? })
}
