//! Frames of all folders by their numbers.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::path::{Path, PathBuf};

use run_record::{FrameRecord, TruthFrame};
use serde::Serialize;

use crate::MergeError;
use crate::same::differences;
use crate::source::Source;

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

/// Frames by their numbers, each with the folder that has its files.
pub(crate) type Frames<'a, F> = BTreeMap<u64, (&'a F, &'a Path)>;

/// The frames of all `sources`. `of` returns the frames of a source and the path of the record that lists them.
///
/// # Errors
/// If two sources have a frame differently.
pub(crate) fn join_frames<'a, F: Frame + 'a>(
    sources: &'a [Source],
    of: impl Fn(&'a Source) -> Option<(&'a [F], PathBuf)>,
) -> Result<Frames<'a, F>, MergeError> {
    let mut joined: Frames<F> = BTreeMap::new();
    for source in sources {
        let Some((frames, record)) = of(source) else { continue };
        for frame in frames {
            match joined.entry(frame.number()) {
                Entry::Vacant(place) => {
                    place.insert((frame, &source.folder));
                }
                Entry::Occupied(held) if held.get().0 == frame => {}
                Entry::Occupied(held) => {
                    let (first, folder) = *held.get();
                    let first_record = sources
                        .iter()
                        .find(|other| other.folder == folder)
                        .and_then(&of)
                        .map(|(_, path)| path);
                    return Err(MergeError::Overlap {
                        frame: frame.number(),
                        first: first_record.unwrap_or_default(),
                        second: record,
                        differences: differences(first, frame),
                    });
                }
            }
        }
    }
    Ok(joined)
}

/// Records and folders, side by side and ascending.
pub(crate) fn apart<'a, F: Frame>(frames: &Frames<'a, F>) -> (Vec<F>, Vec<&'a Path>) {
    frames.values().map(|(frame, folder)| ((*frame).clone(), *folder)).unzip()
}
