//! Sweeps that were recorded in other folders of the same run.

use std::io::Write;
use std::path::Path;

use replay::{HeldRun, RunFolder, SCOPES};
use report::{Beside, ScopePlot, SweepWaves};
use run_record::MAX_BYTES;

use crate::PageError;

/// Takes over the plots, with their values, of the run folders `from` into the finished run of `folder`, and into its page.json. Of two plots of one
/// sweep the one that shows more signals stays; the order of the folders changes nothing.
///
/// # Errors
/// If a record, a page.json or a plot cannot be read, or a file cannot be written.
pub fn gather<'a>(from: impl IntoIterator<Item = &'a Path>, folder: &RunFolder) -> Result<(), PageError> {
    let fingerprint = HeldRun::read(folder.path())?.fingerprint.clone();
    let mut beside = Beside::read(folder.path(), &fingerprint)?;
    let mut plots: Vec<(ScopePlot, Option<SweepWaves>, &Path)> = Vec::new();
    for other in from {
        let Beside { scopes, waves, .. } = Beside::read(other, &fingerprint)?;
        for plot in scopes {
            let values = waves.iter().find(|of| (of.frame, of.sweep) == (plot.frame, plot.sweep));
            plots.push((plot, values.cloned(), other));
        }
    }
    plots.sort_by(|(one, ..), (other, ..)| (one.signals.len(), one).cmp(&(other.signals.len(), other)));
    for (plot, waves, other) in plots {
        folder.make(SCOPES)?;
        let bytes = files::read_all(other.join(plot.file()), MAX_BYTES)?;
        files::write_atomic(folder.path().join(plot.file()), |out: &mut dyn Write| out.write_all(&bytes))?;
        beside.add(plot, waves);
    }
    Ok(beside.write(folder.path())?)
}
