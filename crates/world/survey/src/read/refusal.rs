//! Refusals that all readers share.

use std::path::{Path, PathBuf};

use crate::error::SurveyError;

/// Refuses rasters that cannot carry a fit; gives the number of samples.
pub fn check_raster(path: &Path, lines: u64, columns: u64) -> Result<usize, SurveyError> {
    if lines < 2 || columns < 2 {
        return Err(SurveyError::Empty { path: path.to_path_buf(), lines, columns });
    }
    let count = usize::try_from(lines).ok().zip(usize::try_from(columns).ok());
    count.and_then(|(lines, columns)| lines.checked_mul(columns)).ok_or_else(|| SurveyError::Field {
        path: path.to_path_buf(),
        place: "raster size".into(),
        found: format!("{lines} x {columns}"),
        expected: "a number of samples that this machine can count".into(),
        advice: "the header is damaged: fetch the file again".into(),
    })
}

/// Text with its control characters made visible, for messages, titles and notes.
pub fn visible(text: &str) -> String {
    text.chars().fold(String::new(), |mut shown, character| {
        match character.is_control() {
            true => shown.extend(character.escape_debug()),
            false => shown.push(character),
        }
        shown
    })
}

/// The error for a field of a file: where it stands, what was found and expected, and what to do.
pub fn field(
    path: &Path,
    place: impl Into<String>,
    found: impl Into<String>,
    expected: impl Into<String>,
    advice: impl Into<String>,
) -> SurveyError {
    SurveyError::Field {
        path: PathBuf::from(path),
        place: visible(&place.into()),
        found: visible(&found.into()),
        expected: visible(&expected.into()),
        advice: visible(&advice.into()),
    }
}
