//! What killed commands have left: temporary files that nobody will rename.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::path::Path;

use crate::error::{Action, FileError, folder_of};
use crate::kind::Kind;

/// Removes the temporary files in `folder` of files whose names are such that `is_ours`; tells how many. A file that a process still
/// writes stays.
///
/// # Errors
/// [`FileError`] when the folder cannot be read or a file not be removed.
pub fn remove_leftovers(folder: &Path, is_ours: impl Fn(&str) -> bool) -> Result<usize, FileError> {
    let unreadable = |source| FileError::new(folder, Action::Read, source);
    let mut removed = 0;
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let name = entry.file_name();
        let is_leftover = target_of(&name.to_string_lossy()).is_some_and(&is_ours);
        let is_file = entry.file_type().is_ok_and(|found| Kind::of_type(found) == Kind::File);
        if is_leftover && is_file && is_left(&entry.path()) {
            let failed = |source| FileError::new(&entry.path(), Action::Remove, source);
            fs::remove_file(entry.path()).map_err(failed)?;
            removed += 1;
        }
    }
    Ok(removed)
}

/// Removes what a killed command has left of the file at `path`.
///
/// # Errors
/// As [`remove_leftovers`].
pub fn remove_leftovers_of(path: &Path) -> Result<usize, FileError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    remove_leftovers(folder_of(path), |target| target == name)
}

/// The file that a temporary file was to become, by its name `.TARGET.PROCESS-NUMBER.tmp`.
fn target_of(name: &str) -> Option<&str> {
    let (target, tag) = name.strip_prefix('.')?.strip_suffix(".tmp")?.rsplit_once('.')?;
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let (process, count) = tag.split_once('-')?;
    (digits(process) && digits(count)).then_some(target)
}

/// Whether nobody writes the temporary file at `path`: its writer would hold its lock.
fn is_left(path: &Path) -> bool {
    let mut options = OpenOptions::new();
    options.write(true);
    crate::open::never_through_links(&mut options);
    // What cannot be opened or locked is left alone only if somebody holds it.
    let lock = |file: File| matches!(file.try_lock(), Err(TryLockError::WouldBlock));
    !options.open(path).is_ok_and(lock)
}
