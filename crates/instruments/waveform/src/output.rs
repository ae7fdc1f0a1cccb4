//! Where bytes go: a file under a temporary name, or nowhere, to be counted.

use std::cell::Cell;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use files::{Action, FileError, Kind, Temporary, expect_output, open_stream};

use crate::error::file_error;

/// What a format is written to.
pub trait Output: Write + Seek {}

impl<T: Write + Seek> Output for T {}

/// Where a format that must wait keeps its values.
pub trait Store: Read + Write + Seek {}

impl<T: Read + Write + Seek> Store for T {}

/// A file that is written: unless it is kept, nothing of it stays.
#[derive(Debug)]
pub struct Destination {
    target: PathBuf,
    /// `None` for a device or a pipe, which is written directly: renaming would replace it.
    temporary: Option<Temporary>,
    file: File,
}

impl Destination {
    /// Beside `target`.
    ///
    /// # Errors
    /// If no file can be made there.
    pub fn new(target: &Path) -> Result<Self, FileError> {
        let owned = target.to_owned();
        match expect_output(target)? {
            Kind::Stream => Ok(Self { target: owned, temporary: None, file: open_stream(target)? }),
            _ => {
                let made = Temporary::beside(target);
                let (temporary, file) = made.map_err(|source| file_error(target, Action::Create, source))?;
                Ok(Self { target: owned, temporary: Some(temporary), file })
            }
        }
    }

    /// A file of its own for values that wait: beside the target, or where the system has its temporary files.
    ///
    /// # Errors
    /// If no file can be made there.
    pub fn waiting(target: &Path) -> Result<Self, FileError> {
        let is_file = !matches!(Kind::of(target), Ok(Kind::Stream));
        let name = target.with_added_extension("values");
        if is_file {
            return Self::new(&name);
        }
        Self::new(&std::env::temp_dir().join(name.file_name().unwrap_or_default()))
    }

    /// Another hand on the same file.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn handle(&self) -> Result<File, FileError> {
        self.file.try_clone().map_err(|source| file_error(&self.target, Action::Create, source))
    }

    /// Whether it is a device or a pipe.
    pub fn is_device(&self) -> bool {
        self.temporary.is_none()
    }

    /// Brings it to the disk and gives it its name.
    ///
    /// # Errors
    /// If the system refuses; then nothing stays.
    pub fn keep(self) -> Result<(), FileError> {
        let Some(temporary) = self.temporary else { return Ok(()) };
        self.file.sync_all().map_err(|source| file_error(&self.target, Action::Sync, source))?;
        temporary.rename(&self.target).map_err(|source| file_error(&self.target, Action::Rename, source))
    }
}

/// Takes bytes and keeps how many there are.
#[derive(Debug, Clone, Default)]
pub struct Counter {
    at: u64,
    end: Rc<Cell<u64>>,
}

impl Counter {
    /// Where the file would end.
    pub fn end(&self) -> u64 {
        self.end.get()
    }
}

impl Write for Counter {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.at += bytes.len() as u64;
        self.end.set(self.end.get().max(self.at));
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Counter {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let at = match to {
            SeekFrom::Start(at) => Some(at),
            SeekFrom::End(by) => self.end.get().checked_add_signed(by),
            SeekFrom::Current(by) => self.at.checked_add_signed(by),
        };
        self.at = at.ok_or(io::ErrorKind::InvalidInput)?;
        Ok(self.at)
    }
}
