//! How fast pictures come.

use std::fs;
use std::path::Path;
use std::time::{Duration, SystemTime};

/// Pictures that are older than this count for no rate.
const WINDOW: Duration = Duration::from_secs(600);
/// Shortest time that pictures are counted over.
const LEAST: Duration = Duration::from_secs(1);

/// Pictures a second (Hz) in these run folders, up to `now`; `None` if none was written within the window.
pub(crate) fn rate_hz<'a>(folders: impl Iterator<Item = &'a Path>, now: SystemTime) -> Option<f64> {
    let pictures = folders.flat_map(|folder| fs::read_dir(folder.join("frames")).into_iter().flatten());
    // A picture may go while it is looked at.
    let written = pictures.filter_map(|entry| entry.ok()?.metadata().ok()?.modified().ok());
    // A picture of the next instant is one of now.
    let ages = written.map(|at| now.duration_since(at).unwrap_or_default());
    let ages: Vec<Duration> = ages.filter(|age| *age <= WINDOW).collect();
    let oldest = *ages.iter().max()?;
    Some(ages.len() as f64 / oldest.max(LEAST).as_secs_f64())
}
