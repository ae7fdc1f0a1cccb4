//! What can be wrong with a picture.

use std::path::PathBuf;

use files::FileError;
use limits::Limit;

use crate::pixels::Depth;

/// A picture that cannot be made, read or put together.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// No picture has this size, or the codes do not fill it.
    #[error("a picture of {columns} columns and {lines} lines does not hold {codes} pixels")]
    Size {
        /// Number of columns that was given.
        columns: usize,
        /// Number of lines that was given.
        lines: usize,
        /// Number of pixels that were given.
        codes: usize,
    },
    /// A code is larger than the depth allows.
    #[error("pixel {column}, {line} has code {code}, expected at most {}", depth.white())]
    Code {
        /// Column of the pixel, from 0.
        column: usize,
        /// Line of the pixel, from 0.
        line: usize,
        /// Code of the pixel that was found.
        code: u16,
        /// Depth of the picture's codes.
        depth: Depth,
    },
    /// An intensity that is no number.
    #[error("pixel {column}, {line} has intensity {value}, expected a finite number")]
    NotFinite {
        /// Column of the pixel, from 0.
        column: usize,
        /// Line of the pixel, from 0.
        line: usize,
        /// Intensity of the pixel that was found.
        value: f32,
    },
    /// A transfer law that cannot be.
    #[error("{name} is {found}, expected {low} to {high}")]
    Transfer {
        /// Which figure of the law.
        name: &'static str,
        /// Value that was given for the figure.
        found: f32,
        /// Smallest value that is allowed.
        low: f32,
        /// Largest value that is allowed.
        high: f32,
    },
    /// Pictures that should be alike are not.
    #[error("{found}, expected {expected} as the first picture")]
    Unlike {
        /// Size and depth found.
        found: String,
        /// Size and depth of the first picture.
        expected: String,
    },
    /// Nothing to put together.
    #[error("a sheet needs at least one picture and at least one column")]
    NoPictures,
    /// A PNG that is not grey.
    #[error("the PNG is {found}, expected grey of 8 or 16 bits; convert it to grey without alpha")]
    NotGrey {
        /// Colour type and depth found.
        found: String,
    },
    /// A PNG of a layout that no frame has.
    #[error("the PNG is {found}, expected grey or RGB of 8 or 16 bits without alpha")]
    NotAFrame {
        /// Colour type and depth found.
        found: String,
    },
    /// A PNG with more pixels than the limit.
    #[error(
        "the PNG has {columns} columns and {lines} lines, expected at most {limit} pixels; {}",
        Limit::Pixels
    )]
    TooManyPixels {
        /// Number of columns of the picture.
        columns: u32,
        /// Number of lines of the picture.
        lines: u32,
        /// Most pixels that are allowed.
        limit: u64,
    },
    /// A PNG with more pixels than its bytes can hold.
    #[error("the PNG claims {columns} columns and {lines} lines, but its {bytes} bytes cannot hold them")]
    Hollow {
        /// Number of columns of the picture.
        columns: u32,
        /// Number of lines of the picture.
        lines: u32,
        /// Size of the file.
        bytes: usize,
    },
    /// Bytes that are no PNG.
    #[error("not a whole PNG: {0}")]
    Decode(#[from] png::DecodingError),
    /// A picture that PNG cannot hold.
    #[error("PNG cannot hold it: {0}")]
    Encode(#[from] png::EncodingError),
}

/// A picture file that cannot be read or written.
#[derive(Debug, thiserror::Error)]
pub enum PictureFileError {
    /// The file could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// What is in it, or should be.
    #[error("{path}: {source}")]
    Picture {
        /// The path as given.
        path: PathBuf,
        /// Fault in the contents of the file.
        source: PictureError,
    },
}
