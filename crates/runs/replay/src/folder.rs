//! The folder of a run: whose files are in it, and who may write.

use std::path::{Path, PathBuf};

use files::{Folder, Kind};
use remote_shadow::is_tile_file;

use crate::ReplayError;
use crate::held::{HeldRun, RUN_RECORD, listed_files};
use crate::journal::JOURNAL;
use crate::names::{
    FOLDERS, FRAMES, OWN, PAGE, PAGE_DATA, PERFORMANCE, SHADOWS, TRUTH, frame_index, is_own, is_run_file,
    truth_index,
};
use crate::truth_files;
use crate::written::is_written;

/// A folder that this process, and no other, draws into. Nothing that a run writes into it is a link.
#[derive(Debug)]
pub struct RunFolder(Folder);

impl RunFolder {
    /// Makes the folder if need be, locks it, and clears what a killed run left half-written. `fresh` removes the
    /// files of an earlier run, and nothing else.
    ///
    /// # Errors
    /// If the folder cannot be made or written, another run is drawing into it, or it holds files that are not of
    /// a run.
    pub fn claim(path: &Path, fresh: bool) -> Result<Self, ReplayError> {
        let folder = Self(Folder::claim(path, &FOLDERS, is_own)?);
        match (folder.holds_run(), is_of_run(path)) {
            (false, false) => folder.check_foreign(fresh)?,
            // It has the words for what is wrong.
            (false, true) if !fresh => HeldRun::read(path).map(drop)?,
            _ => folder.clear_leftovers()?,
        }
        if fresh {
            folder.remove_run()?;
        }
        Ok(folder)
    }

    /// Returns the path of the run folder.
    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// Where the run keeps shadow boundaries.
    pub fn shadows(&self) -> PathBuf {
        self.join(SHADOWS)
    }

    /// A file in it.
    pub(crate) fn join(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// Makes one of its folders, such as [`SCOPES`](crate::SCOPES).
    ///
    /// # Errors
    /// If the folder cannot be made, or is a link.
    pub fn make(&self, name: &str) -> Result<(), ReplayError> {
        Ok(self.0.make(name)?)
    }

    fn clear_leftovers(&self) -> Result<(), ReplayError> {
        Ok(self.0.remove_leftovers(is_own)?)
    }

    /// Without files of a run everything in the folder is somebody's, but for a journal that was never begun.
    fn check_foreign(&self, fresh: bool) -> Result<(), ReplayError> {
        self.0.remove_leftovers(|name| name == JOURNAL)?;
        let mut names = self.0.names("")?;
        let is_folder = |name: &str| FOLDERS.contains(&name);
        let mut empty = Vec::new();
        for name in FOLDERS {
            empty.extend(self.0.names(name)?.is_empty().then_some(name));
        }
        names.retain(|name| !empty.contains(&name.as_str()));
        let ours = |name: &&String| OWN.contains(&name.as_str()) || is_folder(name);
        match (names.iter().find(ours), names.first()) {
            (Some(found), _) => Err(self.would_replace(found)),
            (None, Some(found)) if !fresh => {
                Err(ReplayError::Foreign { path: self.path().to_owned(), found: found.clone() })
            }
            _ => Ok(()),
        }
    }

    /// A run is known by its record or its journal.
    fn holds_run(&self) -> bool {
        [RUN_RECORD, JOURNAL].iter().any(|name| is_written(self.path(), name))
    }

    /// Removes the files of a run; the journal and the record last, so that a kill in between leaves a folder that is still known as
    /// a run's. Nothing is removed where a file of somebody else has a name of the run's.
    fn remove_run(&self) -> Result<(), ReplayError> {
        let names = self.run_files()?;
        self.expect_own(names.iter().cloned())?;
        names.iter().rev().try_for_each(|name| self.remove(name))?;
        FOLDERS.iter().for_each(|name| self.0.remove_empty(name));
        Ok(())
    }

    /// Nobody else has a file of one of these `names`, under which the run writes. Records and journals of a run may be damaged, as may
    /// the files that they list.
    ///
    /// # Errors
    /// If somebody else has one.
    pub fn expect_own(&self, names: impl IntoIterator<Item = String>) -> Result<(), ReplayError> {
        let mut listed = listed_files(self.path());
        listed.extend([RUN_RECORD, JOURNAL, PERFORMANCE, PAGE_DATA].map(str::to_owned));
        listed.extend([truth_files::RECORD, truth_files::JOURNAL].map(|name| format!("{TRUTH}/{name}")));
        let is_own = |name: &String| match Kind::of(&self.join(name)) {
            Ok(Kind::Nothing) => true,
            Ok(Kind::File) => listed.contains(name) || is_written(self.path(), name),
            _ => false,
        };
        match names.into_iter().find(|name| !is_own(name)) {
            None => Ok(()),
            Some(found) => Err(self.would_replace(&found)),
        }
    }

    fn would_replace(&self, name: &str) -> ReplayError {
        ReplayError::WouldReplace { path: self.path().to_owned(), found: name.into() }
    }

    /// Removes frames that a run wrote here and that are no part of the one whose pictures are `is_known`.
    pub(crate) fn remove_strays(&self, is_known: impl Fn(u64) -> bool) -> Result<(), ReplayError> {
        self.remove_unknown(FRAMES, frame_index, is_known)
    }

    /// Removes the truth that a run wrote here of frames that are not `is_known`.
    pub(crate) fn remove_stray_truth(&self, is_known: impl Fn(u64) -> bool) -> Result<(), ReplayError> {
        self.remove_unknown(TRUTH, truth_index, is_known)
    }

    /// Removes the shadow boundaries that a run keeps here.
    pub(crate) fn remove_shadows(&self) -> Result<(), ReplayError> {
        let kept = self.0.names(SHADOWS)?.into_iter().filter(|name| is_tile_file(name));
        kept.map(|name| format!("{SHADOWS}/{name}")).try_for_each(|name| self.remove_written(&name))
    }

    fn remove_unknown(
        &self,
        folder: &str,
        index: fn(&str) -> Option<u64>,
        is_known: impl Fn(u64) -> bool,
    ) -> Result<(), ReplayError> {
        let names = self.0.names(folder)?;
        let strays = names.iter().filter(|name| index(name).is_some_and(|index| !is_known(index)));
        let mut strays = strays.map(|name| format!("{folder}/{name}"));
        strays.try_for_each(|name| self.remove_written(&name))
    }

    /// Removes a file, if a run wrote it.
    fn remove_written(&self, name: &str) -> Result<(), ReplayError> {
        if is_written(self.path(), name) { self.remove(name) } else { Ok(()) }
    }

    fn remove(&self, name: &str) -> Result<(), ReplayError> {
        Ok(self.0.remove(name)?)
    }

    /// Everything in the folder that has the name of a run's file: the record first, then the journal, what stands beside them, and
    /// what lies in the run's folders.
    fn run_files(&self) -> Result<Vec<String>, ReplayError> {
        let here = self.0.names("")?;
        let mut names: Vec<String> =
            OWN.into_iter().filter(|own| here.iter().any(|name| name == own)).map(str::to_owned).collect();
        for folder in FOLDERS {
            let below = self.0.names(folder)?.into_iter().map(|name| format!("{folder}/{name}"));
            names.extend(below.filter(|name| is_run_file(name)));
        }
        Ok(names)
    }
}

/// Whether a run has written into `folder`, even where its record is gone: some file of it says so. A page alone does not: runs side
/// by side have one as well.
pub(crate) fn is_of_run(folder: &Path) -> bool {
    let below = FOLDERS.iter().flat_map(|below| {
        let entries = folder.join(below).read_dir().into_iter().flatten().flatten();
        entries.map(move |entry| format!("{below}/{}", entry.file_name().to_string_lossy()))
    });
    let mut names =
        OWN.into_iter().map(str::to_owned).chain(below).filter(|name| is_run_file(name) && name != PAGE);
    names.any(|name| is_written(folder, &name))
}
