//! Sweeps that were recorded in other folders of the same run.

use std::io::Write;
use std::path::Path;

use replay::{HeldRun, RunFolder, SCOPES};
use report::{Beside, ScopePlot};
use run_record::MAX_BYTES;

use crate::PageError;

/// Takes over the plots of the run folders `from` into the finished run of `folder`, and into its page.json. Of two plots of one
/// sweep the one that shows more signals stays; the order of the folders changes nothing.
///
/// # Errors
/// If a record, a page.json or a plot cannot be read, or a file cannot be written.
pub fn gather<'a>(from: impl IntoIterator<Item = &'a Path>, folder: &RunFolder) -> Result<(), PageError> {
    let fingerprint = HeldRun::read(folder.path())?.fingerprint.clone();
    let mut beside = Beside::read(folder.path(), &fingerprint)?;
    let mut plots: Vec<(ScopePlot, &Path)> = Vec::new();
    for other in from {
        let found = Beside::read(other, &fingerprint)?.scopes;
        plots.extend(found.into_iter().map(|plot| (plot, other)));
    }
    plots.sort_by(|(one, _), (other, _)| (one.signals.len(), one).cmp(&(other.signals.len(), other)));
    for (plot, other) in plots {
        folder.make(SCOPES)?;
        let bytes = files::read_all(other.join(plot.file()), MAX_BYTES)?;
        files::write_atomic(folder.path().join(plot.file()), |out: &mut dyn Write| out.write_all(&bytes))?;
        beside.add(plot);
    }
    Ok(beside.write(folder.path())?)
}
