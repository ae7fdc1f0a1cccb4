//! Reading piece by piece: each goes straight to where it stays, and nothing is there twice.

use std::convert::Infallible;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::error::{Action, FileError};
use crate::given;
use crate::read::{Most, bytes_of, open};

/// Bytes of which any piece can be read: of a file, or at hand.
pub trait Pieces {
    /// Why a piece cannot be read.
    type Error;

    /// How many bytes there are.
    fn length(&self) -> u64;

    /// Fills `piece` with the bytes from `offset` on.
    ///
    /// # Errors
    /// Those of the system, and a file that has become shorter.
    ///
    /// # Panics
    /// If bytes at hand do not reach as far.
    fn fill(&mut self, offset: u64, piece: &mut [u8]) -> Result<(), Self::Error>;

    /// So many bytes from `offset` on.
    ///
    /// # Errors
    /// As [`fill`](Self::fill).
    fn take(&mut self, offset: u64, length: usize) -> Result<Vec<u8>, Self::Error> {
        let mut bytes = vec![0; length];
        self.fill(offset, &mut bytes)?;
        Ok(bytes)
    }
}

/// Why there is nothing in the pieces.
#[derive(Debug, PartialEq, Eq)]
pub enum PiecesError<R, F> {
    /// They cannot be read.
    Read(R),
    /// They are not what they should be.
    Format(F),
}

impl<F> PiecesError<Infallible, F> {
    /// What is wrong with bytes at hand.
    pub fn of_format(self) -> F {
        match self {
            Self::Read(never) => match never {},
            Self::Format(error) => error,
        }
    }
}

impl Pieces for &[u8] {
    type Error = Infallible;

    fn length(&self) -> u64 {
        self.len() as u64
    }

    fn fill(&mut self, offset: u64, piece: &mut [u8]) -> Result<(), Infallible> {
        piece.copy_from_slice(&self[offset as usize..][..piece.len()]);
        Ok(())
    }
}

/// A file that is read piece by piece.
#[derive(Debug)]
pub struct FilePieces {
    path: PathBuf,
    length: u64,
    source: Source,
}

#[derive(Debug)]
enum Source {
    File(File),
    /// A pipe that this process has open (`/dev/stdin`), which has no places to go to.
    Whole(Vec<u8>),
    /// A file in memory.
    Given(Arc<[u8]>),
}

impl FilePieces {
    /// A file of at most so many bytes.
    ///
    /// # Errors
    /// As [`read_all`](crate::read_all).
    pub fn open(path: impl AsRef<Path>, most: impl Into<Most>) -> Result<Self, FileError> {
        let (path, most) = (path.as_ref(), most.into());
        if let Some(bytes) = given::read(path, most).transpose()? {
            let length = bytes.len() as u64;
            return Ok(Self { path: path.to_owned(), length, source: Source::Given(bytes) });
        }
        let (file, metadata) = open(path, most)?;
        let (source, length) = if metadata.is_file() {
            (Source::File(file), metadata.len())
        } else {
            let bytes = bytes_of(file, &metadata, path, most)?;
            let length = bytes.len() as u64;
            (Source::Whole(bytes), length)
        };
        Ok(Self { path: path.to_owned(), length, source })
    }
}

impl Pieces for FilePieces {
    type Error = FileError;

    fn length(&self) -> u64 {
        self.length
    }

    fn fill(&mut self, offset: u64, piece: &mut [u8]) -> Result<(), FileError> {
        let Self { path, source, .. } = self;
        match source {
            Source::File(file) => file
                .seek(SeekFrom::Start(offset))
                .and_then(|_| file.read_exact(piece))
                .map_err(|error| FileError::new(path, Action::Read, error)),
            Source::Whole(bytes) => {
                let Ok(()) = bytes.as_slice().fill(offset, piece);
                Ok(())
            }
            Source::Given(bytes) => {
                let Ok(()) = (&**bytes).fill(offset, piece);
                Ok(())
            }
        }
    }
}
