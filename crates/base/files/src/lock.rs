//! One writer a folder at a time.

use std::fs::{self, File, TryLockError};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use crate::folder::FolderError;
use crate::open::open_own;

/// Name of the lock file.
pub const LOCK: &str = ".lunoid.lock";

/// Bytes of the holder's number that are read: a number has fewer.
const HOLDER_BYTES: u64 = 20;

/// How often a lock is tried that is held: whoever asks [`is_locked`] holds it for an instant.
const TRIES: u32 = 5;
/// Time between two tries.
const BETWEEN: Duration = Duration::from_millis(20);

/// Whether a process writes into `folder`. The answer is for this instant; a folder whose lock cannot be asked for counts as free.
pub fn is_locked(folder: &Path) -> bool {
    // Asking makes no file: a folder without a lock file is free.
    let Ok(file) = File::open(folder.join(LOCK)) else { return false };
    matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock))
}

/// A lock of the system: it ends with the process, so a file that a killed run left locks nobody out.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Takes the lock of `folder`, which must be there.
    ///
    /// # Errors
    /// If another process holds it, or the system gives no lock.
    pub fn take(folder: &Path) -> Result<Self, FolderError> {
        let path = folder.join(LOCK);
        let failed = |source| FolderError::System { path: path.clone(), doing: "lock the folder", source };
        let mut tries = 1;
        loop {
            let file = open_own(&path)?;
            match file.try_lock() {
                Ok(()) if is_named(&file, &path) => {
                    // From here on whatever fails removes the file.
                    let mut lock = Self { path: path.clone(), file };
                    let named =
                        lock.file.set_len(0).and_then(|()| write!(lock.file, "{}", std::process::id()));
                    return named.map(|()| lock).map_err(failed);
                }
                // The run that held it removed it between our opening and locking.
                Ok(()) => {}
                Err(TryLockError::WouldBlock) if tries < TRIES => {
                    tries += 1;
                    thread::sleep(BETWEEN);
                }
                Err(TryLockError::WouldBlock) => {
                    let mut holder = String::new();
                    // Without a number the message is still right.
                    let _ = file.take(HOLDER_BYTES).read_to_string(&mut holder);
                    return Err(FolderError::Locked { path: folder.to_owned(), holder });
                }
                Err(TryLockError::Error(source)) => return Err(failed(source)),
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Nothing is lost if it stays: it locks only while a process holds it.
        let _ = fs::remove_file(&self.path);
    }
}

#[cfg(unix)]
fn is_named(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let (held, named) = (file.metadata(), fs::symlink_metadata(path));
    matches!((held, named), (Ok(held), Ok(named)) if (held.dev(), held.ino()) == (named.dev(), named.ino()))
}

#[cfg(not(unix))]
fn is_named(_file: &File, path: &Path) -> bool {
    path.exists()
}
