//! Files in the folder of the truth, beside those of the frames.

/// What the truth is of, and its frames with their hashes.
pub(crate) const RECORD: &str = "truth.json";
/// Poses of the frames, a row each.
pub(crate) const POSES_CSV: &str = "poses.csv";
/// The same with the camera.
pub(crate) const POSES_JSON: &str = "poses.json";
/// Frames that are there while the truth is being written.
pub(crate) const JOURNAL: &str = "truth.journal";

/// All of them, for the folder that knows its own; the record last, so that what a kill leaves is still known.
pub(crate) const TRUTH_FILES: [&str; 4] = [POSES_CSV, POSES_JSON, JOURNAL, RECORD];
