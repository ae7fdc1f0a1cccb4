//! Grey and colour pictures, PNG, animated PNG, Y4M, contact sheets, changed pixels.
//!
//! A [`Picture`] holds codes of 8 or 16 bits, line by line from the top, one a pixel ([`GreyPicture`]) or three
//! ([`ColourPicture`]); [`AnyPicture`] is one of both. [`Encoder`] turns a plane of linear intensity, or three of linear
//! colour, into codes by a [`Transfer`] law; everything else here takes codes. Colour becomes grey by its luminance,
//! reckoned in linear light under a display [`Curve`].
//!
//! ```
//! use picture::{Depth, Encoder, Transfer};
//! let encoder = Encoder::new(Transfer::new(1.0, 2.2)?, Depth::Eight);
//! let picture = encoder.encode(&[0.0, 0.18, 0.5, 1.0], 2, 2)?;
//! assert_eq!(picture.codes(), [0, 117, 186, 255]);
//! let png = picture::encode_png(&picture, &[("Title", "four pixels")])?;
//! assert_eq!(picture::decode_png(&png, &picture::Limits::default())?, picture);
//! # Ok::<(), picture::PictureError>(())
//! ```

mod any;
mod apng;
mod changed;
mod compose;
mod error;
mod luminance;
mod pixels;
mod png_file;
mod transfer;
mod y4m;

pub use any::AnyPicture;
pub use apng::Apng;
pub use changed::{ChangedPixel, ChangedPixels};
pub use compose::{GAP, beside, contact_sheet, shrink};
pub use error::{PictureError, PictureFileError};
pub use luminance::Curve;
pub use pixels::{ColourPicture, Depth, GreyPicture, Picture};
pub use png_file::{
    Limits, SOFTWARE, decode_any_png, decode_png, encode_png, png_texts, read_any_png, read_png, write_png,
};
pub use transfer::{Encoder, Transfer};
pub use y4m::{Y4m, Y4mColour};
