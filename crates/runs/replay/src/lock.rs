//! One run a folder at a time.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use crate::ReplayError;

/// Name of the lock file.
pub(crate) const LOCK: &str = ".lunoid.lock";

/// A lock of the system: it ends with the process, so a file that a killed run left locks nobody out.
#[derive(Debug)]
pub(crate) struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Takes the lock of `folder`.
    pub fn take(folder: &Path) -> Result<Self, ReplayError> {
        let path = folder.join(LOCK);
        let failed =
            |source| ReplayError::Folder { path: path.clone(), doing: "lock the run folder", source };
        loop {
            let mut options = OpenOptions::new();
            let mut file =
                options.read(true).write(true).create(true).truncate(false).open(&path).map_err(failed)?;
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
                Err(TryLockError::WouldBlock) => {
                    let mut holder = String::new();
                    // Without a number the message is still right.
                    let _ = file.read_to_string(&mut holder);
                    return Err(ReplayError::Locked { path: folder.to_owned(), holder });
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
    let (held, named) = (file.metadata(), fs::metadata(path));
    matches!((held, named), (Ok(held), Ok(named)) if (held.dev(), held.ino()) == (named.dev(), named.ino()))
}

#[cfg(not(unix))]
fn is_named(_file: &File, path: &Path) -> bool {
    path.exists()
}
