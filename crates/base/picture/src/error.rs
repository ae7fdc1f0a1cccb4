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
        /// Columns.
        columns: usize,
        /// Lines.
        lines: usize,
        /// Pixels there.
        codes: usize,
    },
    /// A code is larger than the depth allows.
    #[error("pixel {column}, {line} has code {code}, expected at most {}", depth.white())]
    Code {
        /// Column from 0.
        column: usize,
        /// Line from 0.
        line: usize,
        /// The code found.
        code: u16,
        /// The picture's depth.
        depth: Depth,
    },
    /// An intensity that is no number.
    #[error("pixel {column}, {line} has intensity {value}, expected a finite number")]
    NotFinite {
        /// Column from 0.
        column: usize,
        /// Line from 0.
        line: usize,
        /// The intensity found.
        value: f32,
    },
    /// A transfer law that cannot be.
    #[error("{name} is {found}, expected {low} to {high}")]
    Transfer {
        /// Which figure of the law.
        name: &'static str,
        /// What was given.
        found: f32,
        /// Smallest allowed.
        low: f32,
        /// Largest allowed.
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
        /// Columns.
        columns: u32,
        /// Lines.
        lines: u32,
        /// Most pixels allowed.
        limit: u64,
    },
    /// A PNG with more pixels than its bytes can hold.
    #[error("the PNG claims {columns} columns and {lines} lines, but its {bytes} bytes cannot hold them")]
    Hollow {
        /// Columns.
        columns: u32,
        /// Lines.
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
    /// The file.
    #[error(transparent)]
    File(#[from] FileError),
    /// What is in it, or should be.
    #[error("{path}: {source}")]
    Picture {
        /// The path as given.
        path: PathBuf,
        /// What is wrong.
        source: PictureError,
    },
}
