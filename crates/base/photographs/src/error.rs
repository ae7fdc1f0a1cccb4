//! What can be wrong with a picture that somebody brings.

use std::path::PathBuf;

use files::FileError;
use image::ImageError;
use limits::Limit;
use picture::PictureError;

/// Bytes that are no picture, or none that is read here.
#[derive(Debug, thiserror::Error)]
pub enum PhotographError {
    /// None of the three formats.
    #[error("not a whole PNG, JPEG or TIFF: it begins with {found}; save the picture as one of these")]
    Unknown {
        /// First bytes of the file, for the message.
        found: String,
    },
    /// More pixels than the limit.
    #[error(
        "the {format} has {columns} columns and {lines} lines, expected at most {limit} pixels; {}",
        Limit::Pixels
    )]
    TooManyPixels {
        /// Name of the format.
        format: &'static str,
        /// Number of columns of the picture.
        columns: u32,
        /// Number of lines of the picture.
        lines: u32,
        /// Most pixels that are allowed.
        limit: u64,
    },
    /// More pixels than the bytes can hold.
    #[error(
        "the {format} claims {columns} columns and {lines} lines, but its {bytes} bytes cannot hold them; fetch it again"
    )]
    Hollow {
        /// Name of the format.
        format: &'static str,
        /// Number of columns of the picture.
        columns: u32,
        /// Number of lines of the picture.
        lines: u32,
        /// Size of the file.
        bytes: u64,
    },
    /// A PNG of several pictures.
    #[error("an animated PNG, expected one picture; save the frame that is meant as a PNG of its own")]
    Animated,
    /// Codes that are not light.
    #[error(
        "the {format} is in the inks of print (CMYK), expected grey or RGB; convert it to sRGB by its profile"
    )]
    Inks {
        /// Name of the format.
        format: &'static str,
    },
    /// Codes that mean another light than sRGB.
    #[error(
        "the {format} has {found}, expected sRGB, or no word of it; convert it to sRGB, or state the curve where the file is named"
    )]
    Light {
        /// Name of the format.
        format: &'static str,
        /// What the file says of its codes.
        found: String,
    },
    /// Values over the ground that are none.
    #[error(
        "the {format} has pixels that let light through, expected a value in each; fill them, and save it without alpha"
    )]
    Clear {
        /// Name of the format.
        format: &'static str,
    },
    /// Samples of another kind.
    #[error(
        "the {format} is {found}, expected grey or RGB of 8 or 16 bits, with or without alpha; convert it"
    )]
    Kind {
        /// Name of the format.
        format: &'static str,
        /// What the decoder says of its samples.
        found: String,
    },
    /// A JPEG that was cut off: decoders fill the rest with grey.
    #[error("not a whole JPEG: its last scan has no end; fetch the file again")]
    Cut,
    /// Bytes that end early, or do not fit each other.
    #[error("not a whole {format}: {source}; fetch the file again, or save it again")]
    Damaged {
        /// Name of the format.
        format: &'static str,
        /// What the decoder says.
        source: ImageError,
    },
    /// Codes that fill no picture.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// A picture file that somebody brings and that cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum PhotographFileError {
    /// The file could not be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// What is in it.
    #[error("{path}: {source}")]
    Picture {
        /// The path as given.
        path: PathBuf,
        /// Fault in the contents of the file.
        source: PhotographError,
    },
}
