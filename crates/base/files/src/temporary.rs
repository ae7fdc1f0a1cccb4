//! Files that are not whole yet.

use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::mem;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::error::folder_of;

/// All that this process has made and not renamed yet.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A file that is not whole yet, under a name of its own beside the file that it will be. Unless it is renamed, nothing of
/// it stays.
#[derive(Debug)]
pub struct Temporary {
    /// None once it is renamed.
    path: Option<PathBuf>,
}

impl Temporary {
    /// An empty file beside `target`, to be written and read.
    ///
    /// # Errors
    /// If `target` names no file, or none can be made there.
    pub fn beside(target: &Path) -> io::Result<(Self, File)> {
        let path = name_beside(target)?;
        let mut unfinished = unfinished();
        // A new name is never a link.
        let file = OpenOptions::new().read(true).write(true).create_new(true).open(&path)?;
        // The lock tells other processes that the file is no leftover; where the system has none, the worst is a failure to rename.
        let _ = file.try_lock();
        unfinished.insert(path.clone());
        Ok((Self { path: Some(path) }, file))
    }

    /// Gives it its name.
    ///
    /// # Errors
    /// If the system refuses; then nothing of it stays.
    pub fn rename(mut self, target: &Path) -> io::Result<()> {
        let Some(path) = &self.path else { return Ok(()) };
        let mut unfinished = unfinished();
        fs::rename(path, target)?;
        unfinished.remove(path);
        self.path = None;
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            let mut unfinished = unfinished();
            // Whoever drops it has another failure to tell, or none; a leftover is removed by the next run.
            let _ = fs::remove_file(path);
            unfinished.remove(path);
        }
    }
}

/// Removes every file of this process that is not whole, and lets no other be made or renamed: whoever tries waits for the
/// end of the process, which the caller brings about at once.
pub fn abandon_temporaries() {
    let unfinished = unfinished();
    for path in &*unfinished {
        // What cannot be removed is removed by the next run.
        let _ = fs::remove_file(path);
    }
    mem::forget(unfinished);
}

/// `.name.<pid>-<n>.tmp`: apart for every process and every thread.
fn name_beside(target: &Path) -> io::Result<PathBuf> {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let name = target.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    Ok(folder_of(target).join(format!(".{}.{}-{count}.tmp", name.to_string_lossy(), process::id())))
}
