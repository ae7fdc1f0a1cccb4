//! The container of a bank, its text sidecar, and plain coefficients as NPY; docs/bank-format.md has the tables.
//!
//! A bank file is a table of aligned little-endian sections, each with its own checksum, so that other tools can
//! map it and later kinds (features, index, shadows) can be added: a reader skips kinds that it does not know.
//!
//! ```
//! use landscape::{Bank, Level, bank_file};
//! let level = Level::new(250.0, [0.0, 0.0], [2, 2], vec![[0.0; 9]; 4])?;
//! let bank = Bank::new("a plate", vec![level], None)?;
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("plate.bank");
//! bank_file::write(&path, &bank)?;
//! assert_eq!(bank_file::read(&path)?, bank);
//! assert!(folder.path().join("plate.bank.toml").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod corners;
mod decode;
mod encode;
mod error;
mod layout;
mod map;
mod sidecar;

pub use corners::{CornersError, export_corners, import_corners};
pub use decode::decode;
pub use encode::{content_hash, encode};
pub use error::{BankFileError, BankFormatError, SectionName};
pub use layout::FORMAT;
pub use sidecar::{describe, sidecar_path};

use std::io::Write;
use std::path::Path;

use files::{FileError, FilePieces, PiecesError};
use limits::Limit;

use crate::{Bank, BankError, MapFrame};
use decode::{decode_outline, decode_pieces};

/// Writes `bank` to `path` and its description to [`sidecar_path`], each whole or not at all.
///
/// # Errors
/// If a file cannot be written.
pub fn write(path: impl AsRef<Path>, bank: &Bank) -> Result<(), BankFileError> {
    let path = path.as_ref();
    let bytes = encode(bank);
    files::write_atomic(path, |out: &mut dyn Write| out.write_all(&bytes))?;
    let text = describe(bank);
    files::write_atomic(sidecar_path(path), |out: &mut dyn Write| out.write_all(text.as_bytes()))?;
    Ok(())
}

/// Whether a bank may have a map like this: a file with another one could not be read again.
///
/// # Errors
/// If a number of it is out of its range.
pub fn check_map(map: &MapFrame) -> Result<(), BankError> {
    map::check(map)
}

/// Reads the bank in the file `path`; the sidecar is for people and is not read.
///
/// # Errors
/// If the file cannot be read, or is damaged: which section, at which byte, what was found and expected.
pub fn read(path: impl AsRef<Path>) -> Result<Bank, BankFileError> {
    let path = path.as_ref();
    decode_pieces(&mut FilePieces::open(path, Limit::BankBytes)?).map_err(|fault| of_file(path, fault))
}

/// What a bank file says of its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outline {
    /// How its axes lie in the map of its elevation file, if it says.
    pub map: Option<MapFrame>,
    /// South, west, north, east edge of its finest level (m).
    pub extent: [f64; 4],
}

/// Reads the place of the bank in the file `path`, and nothing of the ground.
///
/// # Errors
/// If the file cannot be read, or its table or its section `map` is damaged.
pub fn read_outline(path: impl AsRef<Path>) -> Result<Outline, BankFileError> {
    let path = path.as_ref();
    decode_outline(&mut FilePieces::open(path, Limit::BankBytes)?).map_err(|fault| of_file(path, fault))
}

fn of_file(path: &Path, fault: PiecesError<FileError, BankFormatError>) -> BankFileError {
    match fault {
        PiecesError::Read(error) => BankFileError::File(error),
        PiecesError::Format(source) => BankFileError::Format { path: path.to_owned(), source },
    }
}

#[cfg(test)]
mod tests;
