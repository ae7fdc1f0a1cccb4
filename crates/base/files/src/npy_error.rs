//! Why bytes are no array.

use std::path::PathBuf;

use crate::error::FileError;

/// Bytes that are not the NPY file they should be.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
pub enum NpyError {
    /// The magic bytes are missing.
    #[error("not an NPY file: it does not begin with the bytes 93 4E 55 4D 50 59")]
    NotNpy,
    /// The bytes are no archive of arrays.
    #[error("not an NPZ file: {reason}; expected a zip archive of NPY files without compression")]
    NotNpz {
        /// What the reader of the archive says.
        reason: String,
    },
    /// A version of the format that does not exist yet.
    #[error("NPY version {major}.{minor}, expected 1.0, 2.0 or 3.0")]
    Version {
        /// First number of the version.
        major: u8,
        /// Second number of the version.
        minor: u8,
    },
    /// The header is not the dictionary it should be.
    #[error("NPY header at byte {offset}: expected {expected}")]
    Header {
        /// Byte of the file.
        offset: usize,
        /// What should stand there.
        expected: &'static str,
    },
    /// Values of a type that is not read.
    #[error("NPY values of type '{found}', expected whole numbers or floats of 1 to 8 bytes, such as '<f8'")]
    Type {
        /// As in the header.
        found: String,
    },
    /// The file ends too early.
    #[error("NPY file ends after {found} bytes, expected {expected}; copy it again")]
    Truncated {
        /// Number of bytes that the reader needs.
        expected: u64,
        /// Number of bytes in the file.
        found: u64,
    },
    /// Shape and number of bytes do not agree.
    #[error("NPY shape {shape:?} needs {expected} bytes of values from byte {offset} on, found {found}")]
    Size {
        /// The shape of the header.
        shape: Vec<usize>,
        /// Where the values begin.
        offset: usize,
        /// Bytes that the shape needs.
        expected: u64,
        /// Number of bytes of values that are there.
        found: u64,
    },
    /// The product of the shape does not fit.
    #[error("NPY shape {shape:?} has more values than this machine can count")]
    Overflow {
        /// The shape of the header.
        shape: Vec<usize>,
    },
    /// An array was put together with a shape that does not fit its values.
    #[error("shape {shape:?} does not hold {values} values")]
    Shape {
        /// Shape that was given for the array.
        shape: Vec<usize>,
        /// How many values there are.
        values: usize,
    },
}

/// An NPY file that could not be read.
#[derive(Debug, thiserror::Error)]
pub enum NpyFileError {
    /// The file could not be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// What is in it.
    #[error("{path}: {source}")]
    Format {
        /// The path as given.
        path: PathBuf,
        /// Fault in the contents of the file.
        source: NpyError,
    },
}
