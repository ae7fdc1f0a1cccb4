//! What each frame of a run took.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use limits::Limit;
use serde_json::Value;

use crate::ReplayError;
use crate::names::PERFORMANCE;
use crate::performance::FRAMES_S;

/// Time that each of `frames` took in the run in `folder`, from pose to disk (microseconds), by its `performance.json`.
///
/// # Errors
/// If the file cannot be read, or lacks one of the frames: it has those of the session that drew last.
pub fn frame_costs(folder: &Path, frames: &Range<u64>) -> Result<Vec<u64>, ReplayError> {
    let path = folder.join(PERFORMANCE);
    let bytes = files::read_all(&path, Limit::RecordBytes)?;
    let refused = |reason: String| ReplayError::Costs { path: path.clone(), reason };
    let document: Value = serde_json::from_slice(&bytes).map_err(|error| refused(error.to_string()))?;
    let known: BTreeMap<u64, f64> = serde_json::from_value::<Vec<(u64, f64)>>(document[FRAMES_S].clone())
        .map_err(|_| refused(format!("it has no list `{FRAMES_S}` of frames and seconds")))?
        .into_iter()
        .collect();
    let cost = |frame: u64| {
        let seconds = known.get(&frame).filter(|seconds| (0.0..1e9).contains(*seconds));
        let cost = seconds.map(|seconds| (seconds * 1e6).round() as u64);
        cost.ok_or_else(|| refused(format!("it does not say how long frame {frame} took")))
    };
    frames.clone().map(cost).collect()
}
