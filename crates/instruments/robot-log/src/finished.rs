//! Pictures and truth of a finished run, frame by frame, each file held against its hash.

use std::ops::Range;
use std::path::{Path, PathBuf};

use files::{Npy, parse_npz};
use replay::{HeldRun, Job, RunFolder, TRUTH, TruthItem, TruthItems, held_truth, read_listed};
use run_record::{FrameRecord, TruthFrame, TruthRecord};
use scenario::{PoseRow, View};

use crate::LogError;

/// A finished run, with the truth that was asked for.
pub struct FinishedRun<'a> {
    job: &'a Job<'a>,
    folder: &'a RunFolder,
    run: HeldRun,
    /// Kinds of truth that were asked for, and their record.
    items: TruthItems,
    truth: Option<TruthRecord>,
    rows: Vec<PoseRow>,
}

/// What the folder has of a frame.
#[derive(Debug)]
pub struct FrameFiles {
    /// Bytes of the pictures, one for each showing that the run keeps.
    pub pictures: Vec<Vec<u8>>,
    /// Paths of the pictures, for messages.
    pub paths: Vec<PathBuf>,
    /// Arrays of the truth, in the order of the file; none if no truth was asked for.
    pub truth: Vec<(TruthItem, Npy)>,
}

impl FrameFiles {
    /// The array of `item`, if the truth has it.
    pub fn array(&self, item: TruthItem) -> Option<&Npy> {
        self.truth.iter().find(|(found, _)| *found == item).map(|(_, array)| array)
    }
}

impl<'a> FinishedRun<'a> {
    /// The frames of `job` that are finished in `folder`. `items` is the truth that was asked for.
    ///
    /// # Errors
    /// If the run is not finished, a record cannot be read, or the path cannot be driven.
    pub fn read(
        job: &'a Job<'a>,
        folder: &'a RunFolder,
        items: Option<&TruthItems>,
    ) -> Result<Self, LogError> {
        let run = HeldRun::read(folder.path())?;
        let truth = if items.is_some() { held_truth(folder.path())? } else { None };
        let rows = job.poses(job.frames.clone())?.rows().to_vec();
        let items = items.cloned().unwrap_or(TruthItems::of([]));
        Ok(Self { job, folder, run, items, truth, rows })
    }

    /// The record of the run.
    pub fn record(&self) -> &HeldRun {
        &self.run
    }

    /// Kinds of truth that were asked for.
    pub fn items(&self) -> &TruthItems {
        &self.items
    }

    /// The record of the truth, if truth was asked for.
    pub fn truth(&self) -> Option<&TruthRecord> {
        self.truth.as_ref()
    }

    /// What is asked of every picture.
    pub fn view(&self) -> &View {
        &self.job.stage.view
    }

    /// Eye and attitude of every frame, ascending.
    pub fn rows(&self) -> &[PoseRow] {
        &self.rows
    }

    /// Frames of the job, counted at the update rate.
    pub fn frames(&self) -> Range<u64> {
        self.job.frames.clone()
    }

    /// Path of the run folder.
    pub fn folder(&self) -> &RunFolder {
        self.folder
    }

    /// Pictures and truth of a frame.
    ///
    /// # Errors
    /// If the folder has not the frame, or a file is not what its record says.
    pub fn frame(&self, frame: u64) -> Result<FrameFiles, LogError> {
        let path = self.folder.path();
        let none = |what| LogError::NoFrame { path: path.to_owned(), what, frame };
        let record = find(&self.run.frames, frame, |row: &FrameRecord| row.frame);
        let record = record.ok_or_else(|| none("picture"))?;
        let pictures = record.files.iter().map(|file| read_listed(path, file)).collect::<Result<_, _>>()?;
        let paths = record.files.iter().map(|file| path.join(&file.file)).collect();
        let truth = match &self.truth {
            None => Vec::new(),
            Some(truth) => {
                let row = find(&truth.frames, frame, |row: &TruthFrame| row.frame);
                self.arrays(row.ok_or_else(|| none("ground truth"))?)?
            }
        };
        Ok(FrameFiles { pictures, paths, truth })
    }

    /// The arrays of a frame of the truth.
    fn arrays(&self, row: &TruthFrame) -> Result<Vec<(TruthItem, Npy)>, LogError> {
        let folder = self.folder.path().join(TRUTH);
        let mut arrays = Vec::new();
        for file in &row.files {
            let path = folder.join(&file.file);
            let found = parse_npz(&read_listed(&folder, file)?).map_err(LogError::array(path.clone()))?;
            for (name, array) in found {
                let item = self.expect_array(&path, &name, &array)?;
                arrays.push((item, array));
            }
        }
        Ok(arrays)
    }

    /// An array that the program knows, with a value for every pixel.
    fn expect_array(&self, path: &Path, name: &str, array: &Npy) -> Result<TruthItem, LogError> {
        let wrong = |reason| LogError::Array { path: path.to_owned(), reason };
        let item = TruthItem::ALL.into_iter().find(|item| item.name() == name);
        let item = item.ok_or_else(|| wrong(format!("holds an array `{name}`, which is no ground truth")))?;
        let mut expected = vec![self.view().lines as usize, self.view().columns as usize];
        expected.extend((item.kinds().len() > 1).then_some(item.kinds().len()));
        match array.shape() == expected {
            true => Ok(item),
            false => Err(wrong(format!(
                "`{name}` has the shape {:?}, expected {expected:?}: lines, columns",
                array.shape()
            ))),
        }
    }
}

/// The record of `frame` among ascending ones.
fn find<T>(records: &[T], frame: u64, number: impl Fn(&T) -> u64) -> Option<&T> {
    records.binary_search_by_key(&frame, number).ok().map(|at| &records[at])
}
