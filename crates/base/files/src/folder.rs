//! A folder that one process writes into, and nothing outside it.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::error::{Action, FileError};
use crate::kind::{Kind, itself};
use crate::leftovers::remove_leftovers;
use crate::lock::{LOCK, Lock};

/// Why a folder cannot be written into.
#[derive(Debug, thiserror::Error)]
pub enum FolderError {
    /// A file in it that cannot be read or written, or that is none.
    #[error(transparent)]
    File(#[from] FileError),
    /// Something else stands where the folder should be.
    #[error("{path}: this is {}, expected a folder or a new name; choose another --out{}", kind.phrase(), link_words(*kind))]
    NoFolder {
        /// The path as given.
        path: PathBuf,
        /// What stands there instead.
        kind: Kind,
    },
    /// Another process writes into the folder.
    #[error("{path}: process {holder} is drawing into this folder; wait for it or choose another --out")]
    Locked {
        /// Path of the folder.
        path: PathBuf,
        /// Number of the process that writes into the folder.
        holder: String,
    },
    /// A failure of the system.
    #[error("{path}: cannot {doing}: {source}")]
    System {
        /// The folder or a file in it.
        path: PathBuf,
        /// What was tried, as words after `cannot`.
        doing: &'static str,
        /// What the system says.
        source: io::Error,
    },
}

fn link_words(kind: Kind) -> &'static str {
    if kind == Kind::Link { ", or name what the link leads to" } else { "" }
}

/// A folder that this process, and no other, writes into. Neither the folder nor anything in it that the program writes is a link,
/// a pipe or a device.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    /// Folders in it that the program makes.
    below: &'static [&'static str],
    /// Folders that did not exist, the deepest first: they go again if nothing comes into them.
    made: Vec<PathBuf>,
    lock: Option<Lock>,
}

impl Folder {
    /// Makes the folder if need be, and locks it. `below` names the folders in it that the program makes; `is_ours` knows
    /// the files that the program writes, by their names from the folder on, with `/`.
    ///
    /// # Errors
    /// If the folder cannot be made, another process writes into it, or something of these names is a link, a pipe or a device.
    pub fn claim(
        path: &Path,
        below: &'static [&'static str],
        is_ours: impl Fn(&str) -> bool,
    ) -> Result<Self, FolderError> {
        let made = make_folder(path)?;
        let mut folder = Self { path: path.to_owned(), below, made, lock: None };
        folder.expect_files(&is_ours)?;
        folder.lock = Some(Lock::take(path)?);
        // What came between the look and the lock is not ours to write through either.
        folder.expect_files(&is_ours)?;
        Ok(folder)
    }

    /// Returns the path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// A file in it.
    pub fn join(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Makes a folder in it.
    ///
    /// # Errors
    /// If the system refuses, or something else of this name is there.
    pub fn make(&self, name: &str) -> Result<(), FolderError> {
        make_folder(&self.join(name)).map(drop)
    }

    /// Removes a file in it.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn remove(&self, name: &str) -> Result<(), FolderError> {
        let path = self.join(name);
        fs::remove_file(&path).map_err(|source| FolderError::System { path, doing: "remove", source })
    }

    /// Removes a folder in it, if it is empty.
    pub fn remove_empty(&self, name: &str) {
        // Files of somebody else keep it.
        let _ = fs::remove_dir(self.join(name));
    }

    /// Names of what is in it, or in the folder `below` of it, in alphabetical order; none where that folder is not there.
    ///
    /// # Errors
    /// If the system refuses, or `below` is no folder.
    pub fn names(&self, below: &str) -> Result<Vec<String>, FolderError> {
        let listed = self.list(below)?;
        Ok(listed.into_iter().map(|(name, _)| name).filter(|name| name != LOCK).collect())
    }

    /// Removes what killed runs have left of files whose names are such that `is_ours`.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn remove_leftovers(&self, is_ours: impl Fn(&str) -> bool) -> Result<(), FolderError> {
        remove_leftovers(&self.path, &is_ours)?;
        for below in self.below.iter().filter(|below| self.join(below).is_dir()) {
            remove_leftovers(&self.join(below), |name| is_ours(&format!("{below}/{name}")))?;
        }
        Ok(())
    }

    /// Whatever the program would write is a file, or is not there.
    fn expect_files(&self, is_ours: impl Fn(&str) -> bool) -> Result<(), FolderError> {
        let here = self.list("")?.into_iter().filter(|(name, _)| !self.below.contains(&name.as_str()));
        let mut found: Vec<_> = here.collect();
        for below in self.below {
            let listed = self.list(below)?.into_iter();
            found.extend(listed.map(|(name, kind)| (format!("{below}/{name}"), kind)));
        }
        // A folder in the way of a file is refused by who writes the file.
        let is_wrong = |(name, kind): &(String, Kind)| {
            (is_ours(name) || name == LOCK) && !matches!(kind, Kind::File | Kind::Folder)
        };
        match found.into_iter().find(is_wrong) {
            None => Ok(()),
            Some((name, kind)) => {
                Err(FileError::NoFile { path: self.join(&name), action: Action::Write, kind }.into())
            }
        }
    }

    fn list(&self, below: &str) -> Result<Vec<(String, Kind)>, FolderError> {
        let path = if below.is_empty() { self.path.clone() } else { self.join(below) };
        let failed = |source| FolderError::System { path: path.clone(), doing: "list", source };
        match Kind::of(&path).map_err(failed)? {
            Kind::Folder => {}
            Kind::Nothing => return Ok(Vec::new()),
            kind => return Err(FolderError::NoFolder { path, kind }),
        }
        let entry = |entry: io::Result<fs::DirEntry>| {
            let entry = entry?;
            let kind = Kind::of_type(entry.file_type()?);
            Ok((entry.file_name().to_string_lossy().into_owned(), kind))
        };
        let entries = fs::read_dir(&path).map_err(failed)?;
        let mut names = entries.map(entry).collect::<io::Result<Vec<_>>>().map_err(failed)?;
        names.sort_by(|a: &(String, Kind), b| a.0.cmp(&b.0));
        Ok(names)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // Without the lock the folders in it are those of whoever holds it, also while they are empty.
        if let Some(lock) = self.lock.take() {
            for name in self.below {
                self.remove_empty(name);
            }
            drop(lock);
        }
        for folder in &self.made {
            // A folder with anything in it stays.
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Makes the folder at `path`, with those above it, if it is not there; tells which were not there, the deepest first. Those above
/// may be links, which whoever names the path means; the folder itself is none.
///
/// # Errors
/// If something else stands there, or the system refuses.
pub fn make_folder(path: &Path) -> Result<Vec<PathBuf>, FolderError> {
    let failed = |source| FolderError::System { path: path.to_owned(), doing: "make this folder", source };
    match Kind::of(path).map_err(failed)? {
        Kind::Folder => return Ok(Vec::new()),
        Kind::Nothing => {}
        kind => return Err(FolderError::NoFolder { path: path.to_owned(), kind }),
    }
    let clean = itself(path);
    let missing = clean.ancestors().take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists());
    let made = missing.map(Path::to_owned).collect();
    fs::create_dir_all(&clean).map_err(failed)?;
    Ok(made)
}

/// Gives what stands at `from` the name `to`, which nothing has.
///
/// # Errors
/// If the system refuses.
pub fn rename(from: &Path, to: &Path) -> Result<(), FolderError> {
    let failed =
        |source| FolderError::System { path: to.to_owned(), doing: "give the folder this name", source };
    fs::rename(from, to).map_err(failed)
}
