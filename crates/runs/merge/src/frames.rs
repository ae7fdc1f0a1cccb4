//! Frames of all folders by their numbers.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::path::{Path, PathBuf};

use run_record::{FrameRecord, TruthFrame};
use serde::Serialize;
use timing::FrameTiming;

use crate::MergeError;
use crate::same::differences;

/// The record of a frame in a run or in its truth.
pub(crate) trait Frame: Clone + PartialEq + Serialize {
    /// Number of the frame, counted at the update rate.
    fn number(&self) -> u64;
}

impl Frame for FrameRecord {
    fn number(&self) -> u64 {
        self.frame
    }
}

impl Frame for TruthFrame {
    fn number(&self) -> u64 {
        self.frame
    }
}

impl Frame for FrameTiming {
    fn number(&self) -> u64 {
        self.frame
    }
}

/// Frames by their numbers, each with the folder that has its files.
pub(crate) type Frames<'a, F> = BTreeMap<u64, (&'a F, &'a Path)>;

/// What a record lists.
pub(crate) struct Listed<'a, F> {
    pub frames: &'a [F],
    /// Folder of the run.
    pub folder: &'a Path,
    /// Path of the record.
    pub record: PathBuf,
}

/// The frames of all records.
///
/// # Errors
/// If two records have a frame differently.
pub(crate) fn join_frames<'a, F: Frame + 'a>(
    records: impl Iterator<Item = Listed<'a, F>>,
) -> Result<Frames<'a, F>, MergeError> {
    let mut joined: BTreeMap<u64, (&'a F, usize)> = BTreeMap::new();
    let mut listed: Vec<Listed<'a, F>> = Vec::new();
    for record in records {
        for frame in record.frames {
            match joined.entry(frame.number()) {
                Entry::Vacant(place) => {
                    place.insert((frame, listed.len()));
                }
                Entry::Occupied(held) if held.get().0 == frame => {}
                Entry::Occupied(held) => {
                    let (first, at) = *held.get();
                    return Err(MergeError::Overlap {
                        frame: frame.number(),
                        first: listed[at].record.clone(),
                        second: record.record,
                        differences: differences(first, frame),
                    });
                }
            }
        }
        listed.push(record);
    }
    Ok(joined.into_iter().map(|(number, (frame, at))| (number, (frame, listed[at].folder))).collect())
}

/// Records and folders, side by side and ascending.
pub(crate) fn apart<'a, F: Frame>(frames: &Frames<'a, F>) -> (Vec<F>, Vec<&'a Path>) {
    frames.values().map(|(frame, folder)| ((*frame).clone(), *folder)).unzip()
}
