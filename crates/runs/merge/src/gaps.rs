//! Frames that no folder has.

use std::ops::Range;
use std::path::PathBuf;

use crate::MergeError;
use crate::source::{Source, Unfinished};

/// Frames that are missing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gap {
    /// Frames to be drawn, counted at the update rate.
    pub frames: Range<u64>,
    /// A folder that holds a part of them, and that the same replay goes on in.
    pub folder: Option<PathBuf>,
    /// Whether the pictures are there and only their ground truth is missing.
    pub truth: bool,
}

impl Gap {
    /// Frames that no folder has a part of.
    pub(crate) fn of_frames(frames: Range<u64>) -> Self {
        Self { frames, folder: None, truth: false }
    }
}

/// The whole run: `asked`, or the smallest range that holds the frames of all sources and every run that one is a shard of.
/// Without sources the range is empty.
///
/// # Errors
/// If a source has frames outside `asked`.
pub(crate) fn whole(sources: &[Source], asked: Option<&Range<u64>>) -> Result<Range<u64>, MergeError> {
    let Some(asked) = asked else {
        let of_source = |source: &Source| {
            let shard = source.run.shard.as_ref().map(|shard| shard.of);
            [Some(source.run.range), shard].into_iter().flatten()
        };
        let ranges = || sources.iter().flat_map(of_source);
        let start = ranges().map(|[start, _]| start).min().unwrap_or_default();
        return Ok(start..ranges().map(|[_, end]| end).max().unwrap_or_default());
    };
    let range = |source: &Source| (source.run.range[0]..source.run.range[1], source.record());
    expect_inside(asked, sources.iter().map(range))?;
    Ok(asked.clone())
}

/// Refuses records with frames outside `asked`.
pub(crate) fn expect_inside(
    asked: &Range<u64>,
    mut records: impl Iterator<Item = (Range<u64>, PathBuf)>,
) -> Result<(), MergeError> {
    let is_outside = |(held, _): &(Range<u64>, PathBuf)| held.start < asked.start || held.end > asked.end;
    match records.find(is_outside) {
        None => Ok(()),
        Some((held, path)) => Err(MergeError::Outside { path, held, asked: asked.clone() }),
    }
}

/// Stretches of `whole` that are not among the ascending numbers `there`.
pub(crate) fn missing(whole: &Range<u64>, there: impl Iterator<Item = u64>) -> Vec<Range<u64>> {
    let mut gaps = Vec::new();
    let mut next = whole.start;
    for frame in there.chain([whole.end]) {
        if next < frame {
            gaps.push(next..frame);
        }
        next = frame + 1;
    }
    gaps
}

/// The gaps of the frames. A gap that holds frames of an unfinished run is that run's to fill.
pub(crate) fn gaps_of_frames(missing: Vec<Range<u64>>, unfinished: &[Unfinished]) -> Vec<Gap> {
    let of = |frames: Range<u64>| {
        let is_part = |run: &&Unfinished| {
            !run.frames.is_empty() && run.frames.iter().all(|frame| frames.contains(frame))
        };
        let folder = unfinished.iter().find(is_part).map(|run| run.folder.clone());
        Gap { folder, ..Gap::of_frames(frames) }
    };
    missing.into_iter().map(of).collect()
}

/// Sources without truth, where others have it.
pub(crate) fn gaps_of_truth(sources: &[Source]) -> Vec<Gap> {
    if sources.iter().all(|source| source.truth.is_none()) {
        return Vec::new();
    }
    let lacks = sources.iter().filter(|source| source.truth.is_none());
    let gap = |source: &Source| {
        let [start, end] = source.run.range;
        Gap { frames: start..end, folder: Some(source.folder.clone()), truth: true }
    };
    lacks.map(gap).collect()
}
