//! Pictures that people bring: PNG, JPEG and TIFF, decoded by the crate `image` under the program's limits.
//!
//! | in the file | in the program |
//! |---|---|
//! | grey, RGB, palette (PNG), with or without alpha; 1 to 8 bits a code | 8 bits |
//! | grey or RGB of 16 bits a code, with or without alpha | 16 bits |
//! | orientation (EXIF, or a TIFF's tag) | the picture is turned upright, as viewers show it |
//! | alpha | the light of the pixel times its share, nothing behind it: black, as the sky is; refused in a map of the ground |
//! | gamma, code points, colour profile | those of sRGB, or refused by name; not looked at in a map whose reader states another curve |
//! | primaries without a profile, rendering intent, text, other metadata | not looked at |
//! | several pages of a TIFF | the first |
//! | CMYK, floating point, palettes of a TIFF, more than 16 bits, animated PNG, a JPEG without its end | refused by name |
//!
//! The contents of a file decide what it is, not its name. Colour becomes grey ([`AnyPicture::to_grey`]) by its luminance: codes
//! become light under the curve of sRGB, the light is weighted as ITU-R BT.709 has it (0.2126 red, 0.7152 green,
//! 0.0722 blue), and the sum becomes a code under the same curve. A pixel without colour keeps its code.
//!
//! Frames of a run are read by [`picture::read_any_png`], which checks that they are as the program wrote them.

mod alpha;
mod decoding;
mod error;
mod jpeg;
mod light;

use std::path::Path;

use files::{Most, read_all};
use limits::Limit;
use picture::{AnyPicture, Curve, Limits};

pub use decoding::{Use, decode, decode_for};
pub use error::{PhotographError, PhotographFileError};

/// The display curve of pictures that people bring.
pub const CURVE: Curve = Curve::Srgb;

/// Reads a picture file.
///
/// # Errors
/// [`PhotographFileError`], which names the file.
pub fn read(path: impl AsRef<Path>) -> Result<AnyPicture, PhotographFileError> {
    read_for(Use::Picture, path)
}

/// Reads a picture file whose codes are values over the ground. They become light, or another quantity, by `curve`.
///
/// # Errors
/// As [`read`], or if a pixel lets light through: it is no value.
pub fn read_map(path: impl AsRef<Path>, curve: Curve) -> Result<AnyPicture, PhotographFileError> {
    read_for(Use::Map(curve), path)
}

fn read_for(wanted: Use, path: impl AsRef<Path>) -> Result<AnyPicture, PhotographFileError> {
    let (path, limits) = (path.as_ref(), Limits::default());
    let most = Most { bytes: limits.file_bytes, raised_by: Some(Limit::PictureBytes) };
    let bytes = read_all(path, most)?;
    decode_for(wanted, &bytes, &limits)
        .map_err(|source| PhotographFileError::Picture { path: path.to_owned(), source })
}
