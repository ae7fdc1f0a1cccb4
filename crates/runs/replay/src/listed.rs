//! What a run folder lists before a run goes on in it.

use std::collections::BTreeMap;

use run_record::FrameRecord;

use crate::ReplayError;
use crate::fingerprint::{Fingerprint, differences};
use crate::folder::RunFolder;
use crate::held::{HeldRun, RUN_RECORD};
use crate::journal::{self, Found, JOURNAL};

/// What an earlier run of the folder lists, finished or not.
pub(crate) struct Listed {
    /// The record of the run, where it was finished, perhaps with fewer frames.
    pub earlier: Option<HeldRun>,
    journal: Option<Found<FrameRecord>>,
}

impl Listed {
    /// What is in `folder`.
    pub fn read(folder: &RunFolder) -> Result<Self, ReplayError> {
        let earlier = HeldRun::read_if_there(folder.path())?;
        let journal = journal::read::<FrameRecord>(&folder.join(JOURNAL))?;
        Ok(Self { earlier, journal })
    }

    /// The earlier run is of the same job.
    pub fn expect_same(&self, folder: &RunFolder, now: &Fingerprint) -> Result<(), ReplayError> {
        let found = [
            self.earlier.as_ref().map(|run| Fingerprint::of_record(run)),
            self.journal.as_ref().map(|journal| journal.fingerprint.clone()),
        ];
        match found.into_iter().flatten().find(|then| then.hash != now.hash) {
            None => Ok(()),
            Some(then) => {
                let path = folder.path().to_owned();
                Err(ReplayError::OtherRun { path, differences: differences(&then, now) })
            }
        }
    }

    /// It lists no frame that the mission of `frames` frames does not have.
    pub fn expect_within(&self, folder: &RunFolder, frames: u64) -> Result<(), ReplayError> {
        let last = |frames: &[FrameRecord]| frames.iter().map(|frame| frame.frame).max();
        let found = [
            (RUN_RECORD, self.earlier.as_ref().and_then(|run| last(&run.frames))),
            (JOURNAL, self.journal.as_ref().and_then(|journal| last(&journal.frames))),
        ];
        match found.into_iter().find_map(|(name, last)| Some((name, last.filter(|last| *last >= frames)?))) {
            None => Ok(()),
            Some((name, frame)) => Err(ReplayError::Beyond { path: folder.join(name), frame, frames }),
        }
    }

    /// All frames, by their numbers.
    pub fn frames(&self) -> BTreeMap<u64, FrameRecord> {
        let listed = self.earlier.iter().flat_map(|run| &run.frames);
        let listed = listed.chain(self.journal.iter().flat_map(|journal| &journal.frames));
        listed.map(|frame| (frame.frame, frame.clone())).collect()
    }
}
