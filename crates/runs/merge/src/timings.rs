//! Timing records of shards into one.

use std::ops::Range;
use std::path::PathBuf;

use timing::{FrameTiming, TimingRecord};

use crate::frames::{Listed, apart, join_frames};
use crate::gaps::{expect_inside, missing};
use crate::same::expect_same;
use crate::{Gap, MergeError};

/// What timing records come to.
#[derive(Debug, Clone, PartialEq)]
pub enum Timings {
    /// The record of all frames.
    Joined(TimingRecord),
    /// Frames that no record has, ascending.
    Gaps(Vec<Gap>),
}

/// Joins the timing records in `files`, in any order. `frames` are those of the whole record; those from the first to the last of all
/// files if left out.
///
/// # Errors
/// If a file cannot be read, the records are not of one machine on one mission, or do not agree on a frame.
pub fn merge_timings(files: &[PathBuf], frames: Option<&Range<u64>>) -> Result<Timings, MergeError> {
    let read = |path: &PathBuf| Ok((timing::read(path)?, path.clone()));
    let records = files.iter().map(read).collect::<Result<Vec<(TimingRecord, PathBuf)>, MergeError>>()?;
    expect_same(records.iter().map(|(record, path)| (record, path.clone())))?;
    let listed = |(record, path): &'_ (TimingRecord, PathBuf)| (range(&record.frames), path.clone());
    let all = records.iter().map(listed);
    let whole = match frames {
        Some(asked) => {
            expect_inside(asked, all)?;
            asked.clone()
        }
        None => {
            let ends = all.clone().map(|(range, _)| range.end);
            all.map(|(range, _)| range.start).min().unwrap_or(0)..ends.max().unwrap_or(0)
        }
    };
    let listed = records.iter().map(|(record, path)| Listed {
        frames: &record.frames[..],
        folder: path,
        record: path.clone(),
    });
    let frames = join_frames(listed)?;
    let gaps = missing(&whole, frames.keys().copied());
    if !gaps.is_empty() {
        return Ok(Timings::Gaps(gaps.into_iter().map(Gap::of_frames).collect()));
    }
    let (frames, _): (Vec<FrameTiming>, _) = apart(&frames);
    match records.into_iter().next() {
        Some((first, _)) => Ok(Timings::Joined(TimingRecord { frames, ..first })),
        None => Ok(Timings::Gaps(Vec::new())),
    }
}

/// From the first frame to the one behind the last.
fn range(frames: &[FrameTiming]) -> Range<u64> {
    let first = frames.first().map_or(0, |frame| frame.frame);
    first..frames.last().map_or(first, |frame| frame.frame + 1)
}
