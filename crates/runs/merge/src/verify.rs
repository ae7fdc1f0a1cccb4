//! Whether the files of all folders are what their records say.

use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use replay::{Control, Progress, ReplayError, TRUTH};
use run_record::{FileRecord, file_hash};

use crate::MergeError;
use crate::source::Source;

/// Reads and hashes every file that the records list, each thread one at a time. Returns false if told to end.
///
/// # Errors
/// Of the files that cannot be read or were changed, the first in the order of the folders.
pub(crate) fn verify(sources: &[Source], control: &Control) -> Result<bool, MergeError> {
    let files: Vec<(PathBuf, &FileRecord)> = sources.iter().flat_map(listed).collect();
    let frames = sources.iter().map(|source| source.run.frames.len() as u64).sum();
    (control.progress)(Progress::Verifying { frames });
    let check = |(folder, file): &(PathBuf, &FileRecord)| {
        if control.cancel.load(Ordering::Relaxed) { Ok(()) } else { expect_whole(folder, file) }
    };
    let found: Vec<ReplayError> =
        control.pool.install(|| files.par_iter().filter_map(|file| check(file).err()).collect());
    match found.into_iter().next() {
        Some(error) => Err(error.into()),
        None => Ok(!control.cancel.load(Ordering::Relaxed)),
    }
}

/// The files of a source, with the folder that their names begin at.
fn listed(source: &Source) -> impl Iterator<Item = (PathBuf, &FileRecord)> {
    let of_run = source.run.frames.iter().flat_map(|frame| &frame.files);
    let of_truth = source
        .truth
        .iter()
        .flat_map(|truth| truth.frames.iter().flat_map(|frame| &frame.files).chain(&truth.outputs));
    let truth = source.folder.join(TRUTH);
    of_run.map(|file| (source.folder.clone(), file)).chain(of_truth.map(move |file| (truth.clone(), file)))
}

fn expect_whole(folder: &Path, file: &FileRecord) -> Result<(), ReplayError> {
    let path = folder.join(&file.file);
    let is_whole = path.exists() && file_hash(&path)? == file.blake3;
    if is_whole { Ok(()) } else { Err(ReplayError::Changed { path }) }
}
