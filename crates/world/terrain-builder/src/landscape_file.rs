//! Edits of a landscape file on the disk, with its journal beside it.

use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use diagnostics::ProblemList;
use files::{FileError, FolderError, Lock, expect_output, read_all, write_atomic};
use limits::Limit;

use crate::description::Description;
use crate::edit::{EditError, add, import, remove};
use crate::journal::{Journal, JournalError};

/// How often, and how long apart, an edit asks for the folder of its file while another process edits there. Chosen: ten seconds.
const LOCK_TRIES: u32 = 200;
const LOCK_PAUSE: Duration = Duration::from_millis(50);

/// A landscape file and its journal, `NAME.toml.journal`.
#[derive(Debug, Clone)]
pub struct LandscapeFile {
    path: PathBuf,
}

/// Why an edit of a file fails; the file then stays as it was.
#[derive(Debug, thiserror::Error)]
pub enum LandscapeFileError {
    /// A file that cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A file that is there already.
    #[error("{path}: is there already; expected a new name; remove it first, or choose another", path = .path.display())]
    Exists {
        /// Path of the file.
        path: PathBuf,
    },
    /// A file that is no text.
    #[error("{path}: byte {byte} is not UTF-8; save the file as UTF-8", path = .path.display())]
    Text {
        /// Path of the file.
        path: PathBuf,
        /// First byte that is no part of a character.
        byte: usize,
    },
    /// An edit that cannot be.
    #[error("{path}: {error}", path = .path.display())]
    Edit {
        /// Path of the landscape file.
        path: PathBuf,
        /// What is wrong with the edit.
        error: EditError,
    },
    /// A journal that cannot be read, or does not fit the landscape.
    #[error("{path}: {error}", path = .path.display())]
    Journal {
        /// Path of the journal.
        path: PathBuf,
        /// What is wrong with the journal.
        error: JournalError,
    },
    /// Another process edits a landscape of the same folder, or the folder takes no lock.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// An edit after which the file would be no landscape.
    #[error("{0}")]
    Problems(ProblemList),
}

impl LandscapeFile {
    /// The landscape at a path; nothing is read yet.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self { path: path.into() }
    }

    /// Writes a new landscape. Nothing is replaced, neither a landscape nor a journal.
    ///
    /// # Errors
    /// If a file of the name is there, the text is no landscape, or the file cannot be written.
    pub fn create(&self, text: &str) -> Result<(), LandscapeFileError> {
        if let Some(path) = [self.path.clone(), self.journal_path()].into_iter().find(|path| path.exists()) {
            return Err(LandscapeFileError::Exists { path });
        }
        self.check(text)?;
        write_atomic(&self.path, |file| file.write_all(text.as_bytes()))?;
        Ok(())
    }

    /// Path of the journal: that of the landscape with `.journal` behind it.
    pub fn journal_path(&self) -> PathBuf {
        let mut name = self.path.clone().into_os_string();
        name.push(".journal");
        name.into()
    }

    /// Adds a block of `[[feature]]` tables. What comes out must be a landscape, or nothing is written.
    ///
    /// # Errors
    /// If a file cannot be read or written, the block is not made of features, a name is taken, or a feature has a fault.
    pub fn add(&self, block: &str) -> Result<(), LandscapeFileError> {
        self.edit("add", |text| add(text, block))
    }

    /// Removes a feature by its name.
    ///
    /// # Errors
    /// If a file cannot be read or written, or no feature has the name.
    pub fn remove(&self, id: &str) -> Result<(), LandscapeFileError> {
        self.edit(&format!("remove {id}"), |text| remove(text, id))
    }

    /// Lays an elevation file below the features. `file` is its path from the folder of the landscape.
    ///
    /// # Errors
    /// If a file cannot be read or written, or the text would be no landscape.
    pub fn import(&self, file: &str, band: Option<usize>) -> Result<(), LandscapeFileError> {
        self.edit(&format!("import {file}"), |text| import(text, file, band))
    }

    /// Text of the landscape.
    ///
    /// # Errors
    /// If the file cannot be read, or is no text.
    pub fn text(&self) -> Result<String, LandscapeFileError> {
        text_of(&self.path)
    }

    /// Undoes the last edit, and says what it was.
    ///
    /// # Errors
    /// If a file cannot be read or written, there is nothing to undo, or the file was changed by hand since.
    pub fn undo(&self) -> Result<String, LandscapeFileError> {
        let _lock = self.lock()?;
        let (text, mut journal) = (text_of(&self.path)?, self.journal()?);
        let (text, what) = journal.undo(&text).map_err(|error| self.of_journal(error))?;
        self.write(&text, &journal)?;
        Ok(what)
    }

    /// Edits so far, the first one first.
    ///
    /// # Errors
    /// If the journal cannot be read, or a line of it is no edit.
    pub fn journal(&self) -> Result<Journal, LandscapeFileError> {
        let path = self.journal_path();
        if !path.exists() {
            return Ok(Journal::default());
        }
        Journal::parse(&text_of(&path)?).map_err(|error| self.of_journal(error))
    }

    fn of_journal(&self, error: JournalError) -> LandscapeFileError {
        LandscapeFileError::Journal { path: self.journal_path(), error }
    }

    fn edit(
        &self,
        what: &str,
        edited: impl FnOnce(&str) -> Result<String, EditError>,
    ) -> Result<(), LandscapeFileError> {
        let _lock = self.lock()?;
        let (text, mut journal) = (text_of(&self.path)?, self.journal()?);
        let to =
            edited(&text).map_err(|error| LandscapeFileError::Edit { path: self.path.clone(), error })?;
        self.check(&to)?;
        journal.push(what, &text, &to);
        self.write(&to, &journal)
    }

    /// Keeps other processes from editing until it is dropped; waits for one that edits.
    fn lock(&self) -> Result<Lock, LandscapeFileError> {
        let folder = match self.path.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        for _ in 0..LOCK_TRIES {
            match Lock::take(folder) {
                Err(FolderError::Locked { .. }) => thread::sleep(LOCK_PAUSE),
                taken => return Ok(taken?),
            }
        }
        Ok(Lock::take(folder)?)
    }

    /// Whether a text is a landscape.
    fn check(&self, text: &str) -> Result<Description, LandscapeFileError> {
        let folder = self.path.parent().unwrap_or(Path::new(""));
        let name = self.path.display().to_string();
        Description::parse(&name, text, folder).map_err(LandscapeFileError::Problems)
    }

    /// The journal comes second: cut off in between, undo says that the text is not as the last edit left it.
    fn write(&self, text: &str, journal: &Journal) -> Result<(), LandscapeFileError> {
        // Where the journal cannot be written, the landscape stays as it was.
        expect_output(&self.journal_path())?;
        write_atomic(&self.path, |file| file.write_all(text.as_bytes()))?;
        write_atomic(self.journal_path(), |file| file.write_all(journal.text().as_bytes()))?;
        Ok(())
    }
}

fn text_of(path: &Path) -> Result<String, LandscapeFileError> {
    let bytes = read_all(path, Limit::TextBytes)?;
    String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to();
        LandscapeFileError::Text { path: path.to_owned(), byte }
    })
}
