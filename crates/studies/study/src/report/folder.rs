//! Where results are left: a folder of tables and plots.

use std::io;
use std::path::Path;

use ::plots::{Drawing, PlotError};
use files::{FileError, FolderError};
use serde_json::Value;

/// Why results cannot be left in a folder.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The folder cannot be made, or is a link.
    #[error("--out {0}; name a folder that can be written")]
    Folder(#[from] FolderError),
    /// A table cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A plot cannot be drawn or written.
    #[error(transparent)]
    Plot(#[from] PlotError),
}

/// Makes a folder for results, if it is not there.
///
/// # Errors
/// If the folder cannot be made.
pub fn make_folder(folder: &Path) -> Result<(), ReportError> {
    files::make_folder(folder)?;
    Ok(())
}

/// Whether the study of that name writes a file called `file`: a table of its own name, or a plot.
pub fn is_of(study: &str, file: &str) -> bool {
    match file.rsplit_once('.') {
        Some((stem, "json" | "csv" | "md")) => stem == study,
        Some((stem, "svg" | "png")) => !stem.contains('/'),
        _ => false,
    }
}

/// Writes `name.json`, `name.csv` and `name.md` into `folder`.
pub(super) fn write(
    folder: &Path,
    name: &str,
    document: &Value,
    csv: &str,
    page: &str,
) -> Result<(), ReportError> {
    make_folder(folder)?;
    for (end, text) in [("json", format!("{document:#}\n").as_str()), ("csv", csv), ("md", page)] {
        let path = folder.join(format!("{name}.{end}"));
        files::write_atomic(path, |out: &mut dyn io::Write| out.write_all(text.as_bytes()))?;
    }
    Ok(())
}

/// Writes `name.svg` and `name.png` into `folder`.
pub(super) fn save(
    folder: &Path,
    name: &str,
    drawing: Result<Drawing, PlotError>,
) -> Result<(), ReportError> {
    let drawing = drawing?;
    for end in ["svg", "png"] {
        drawing.write(folder.join(format!("{name}.{end}")))?;
    }
    Ok(())
}
