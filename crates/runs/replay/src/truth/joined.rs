//! Truth whose arrays were made in other folders.

use std::path::Path;
use std::sync::atomic::Ordering;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use run_record::{TruthFrame, TruthRecord};
use serde_json::Value;

use super::held;
use crate::fingerprint::Fingerprint;
use crate::held::{pretty, write_changed};
use crate::job::Control;
use crate::joined::copy;
use crate::journal::Journal;
use crate::names::{TRUTH, truth_name};
use crate::truth_files::{JOURNAL, POSES_CSV, POSES_JSON, RECORD, TRUTH_FILES};
use crate::{ReplayError, RunFolder};

/// The truth of a run that is put together from arrays of other folders.
#[derive(Debug)]
pub struct JoinedTruth<'a> {
    /// Record of the truth; its outputs are not read.
    pub record: TruthRecord,
    /// For each frame of the record, the run folder that has its arrays.
    pub sources: Vec<&'a Path>,
    /// Bytes of `poses.csv` and the document of `poses.json`, where poses are part of the truth.
    pub poses: Option<(Vec<u8>, Value)>,
}

/// The finished truth of the run in `folder`; nothing if the run has none, or none that is finished.
///
/// # Errors
/// If the record cannot be read.
pub fn held_truth(folder: &Path) -> Result<Option<TruthRecord>, ReplayError> {
    let truth = folder.join(TRUTH);
    if truth.join(JOURNAL).exists() { Ok(None) } else { held(truth.join(RECORD)) }
}

impl JoinedTruth<'_> {
    /// Writes the truth beside the finished run in `folder`. Returns false if told to end; the same call goes on from there.
    ///
    /// # Errors
    /// If an array is not what the record says, or a file cannot be written.
    pub fn write(mut self, folder: &RunFolder, control: &Control) -> Result<bool, ReplayError> {
        let truth = folder.join(TRUTH);
        let names = self.record.frames.iter().map(|frame| truth_name(frame.frame));
        let names = names.chain(TRUTH_FILES.map(str::to_owned));
        folder.expect_own(names.map(|name| format!("{TRUTH}/{name}")))?;
        folder.make(TRUTH)?;
        let fingerprint = Fingerprint { hash: self.record.fingerprint.clone(), of: Value::Null };
        let journal = Journal::begin(truth.join(JOURNAL), &fingerprint, &self.record.frames)?;
        let has_frame = |frame| self.record.frames.binary_search_by_key(&frame, |row| row.frame).is_ok();
        folder.remove_stray_truth(has_frame)?;
        if !self.copy_arrays(&truth, control)? {
            return Ok(false);
        }
        self.record.outputs = match &self.poses {
            None => Vec::new(),
            Some((csv, document)) => vec![
                write_changed(&truth, POSES_CSV, csv)?,
                write_changed(&truth, POSES_JSON, pretty(document).as_bytes())?,
            ],
        };
        write_changed(&truth, RECORD, pretty(&self.record).as_bytes())?;
        journal.end()?;
        Ok(true)
    }

    /// Copies the arrays; false if told to end.
    fn copy_arrays(&self, truth: &Path, control: &Control) -> Result<bool, ReplayError> {
        let one = |(frame, source): (&TruthFrame, &&Path)| {
            if control.cancel.load(Ordering::Relaxed) {
                return Ok(());
            }
            frame.files.iter().try_for_each(|file| copy(&source.join(TRUTH), truth, file))
        };
        control.pool.install(|| self.record.frames.par_iter().zip(&self.sources).try_for_each(one))?;
        Ok(!control.cancel.load(Ordering::Relaxed))
    }
}
