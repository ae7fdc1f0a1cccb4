//! Which band of a file holds the heights.

use std::path::Path;

use super::options::ReadOptions;
use super::refusal::visible;
use crate::error::SurveyError;

/// Most bands that a message lists.
const MOST_LISTED: usize = 100;

/// The band that the user chose, or the only one of `likely`; from 0. `name` describes a band of a message.
///
/// # Errors
/// If the file has no such band, or several and none was chosen.
pub fn chosen(
    path: &Path,
    options: &ReadOptions,
    count: usize,
    likely: &[usize],
    name: impl Fn(usize) -> Option<String>,
) -> Result<usize, SurveyError> {
    let listed = |band: usize| match name(band) {
        Some(name) => format!("{} ({})", band + 1, visible(&name)),
        None => (band + 1).to_string(),
    };
    let list = || (0..count.min(MOST_LISTED)).map(listed).collect::<Vec<_>>().join(", ");
    let path = path.to_path_buf();
    match (options.band, likely) {
        (Some(chosen), _) if (1..=count).contains(&chosen) => Ok(chosen - 1),
        (Some(chosen), _) => Err(SurveyError::NoSuchBand { path, chosen, count, list: list() }),
        (None, &[only]) => Ok(only),
        (None, _) => Err(SurveyError::BandNotChosen { path, count, list: list() }),
    }
}

/// The band of a raw file, from 0: the chosen one, or the only one.
pub fn of_raw(path: &Path, options: &ReadOptions, count: usize) -> Result<usize, SurveyError> {
    let likely: &[usize] = if count == 1 { &[0] } else { &[] };
    chosen(path, options, count, likely, |_| None)
}
