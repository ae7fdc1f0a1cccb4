//! Several machines or channels of one scenario: errors against one of them, times, and the page that shows both.

mod figures;
mod page;

use std::io::Write;
use std::path::{Path, PathBuf};

use serde::Serialize;
use text::visible;

use crate::ReportError;
use figures::figures;
pub use figures::{FrameError, MachineFigures};
use page::page;

/// Name of the figures in the folder that holds the runs.
pub const SIDE_BY_SIDE: &str = "side-by-side.json";

const SCHEMA: &str = "lunoid.side-by-side/1";

/// What the runs of several machines come to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SideBySide {
    schema: &'static str,
    /// Title of the scenario.
    pub title: String,
    /// Folder of the run that errors are told against, if they are told against one.
    pub reference: Option<String>,
    /// The runs, as they were asked for.
    pub machines: Vec<MachineFigures>,
}

/// Holds the finished runs in the folders `names` of `folder` against the one in `reference`, which is among them if there is one, and
/// writes [`SIDE_BY_SIDE`] and the page; tells the figures and where the page is. Frames are compared by the threads of the
/// current pool.
///
/// # Errors
/// If a folder holds no finished run, pictures of two runs cannot be compared, or a file cannot be written.
pub fn write_side_by_side(
    folder: &Path,
    names: &[String],
    reference: Option<&str>,
) -> Result<(SideBySide, PathBuf), ReportError> {
    let runs = figures::read(folder, names)?;
    let machines = figures(folder, &runs, reference)?;
    let title = runs.first().map_or_else(String::new, |(_, run)| run.scenario.title.clone());
    let figures = SideBySide { schema: SCHEMA, title, reference: reference.map(str::to_owned), machines };
    let json = serde_json::to_string_pretty(&figures).expect("figures are plain values") + "\n";
    write_changed(&folder.join(SIDE_BY_SIDE), &json)?;
    let path = folder.join(replay::PAGE);
    write_changed(&path, &visible(&page(folder, &runs, &figures)?.into_string()))?;
    Ok((figures, path))
}

fn write_changed(path: &Path, text: &str) -> Result<(), ReportError> {
    if !files::holds(path, text.as_bytes()) {
        files::write_atomic(path, |out: &mut dyn Write| out.write_all(text.as_bytes()))?;
    }
    Ok(())
}
