//! A picture whose layout is known only when it is read.

use crate::error::PictureError;
use crate::luminance::Curve;
use crate::pixels::{ColourPicture, Depth, GreyPicture};
use crate::png_file::encode_png;

/// A grey picture or a colour picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AnyPicture {
    /// One code a pixel.
    Grey(GreyPicture),
    /// Three codes a pixel.
    Colour(ColourPicture),
}

impl From<GreyPicture> for AnyPicture {
    fn from(picture: GreyPicture) -> Self {
        Self::Grey(picture)
    }
}

impl From<ColourPicture> for AnyPicture {
    fn from(picture: ColourPicture) -> Self {
        Self::Colour(picture)
    }
}

/// Asks whichever picture it is.
macro_rules! either {
    ($any:expr, $picture:ident => $answer:expr) => {
        match $any {
            AnyPicture::Grey($picture) => $answer,
            AnyPicture::Colour($picture) => $answer,
        }
    };
}

impl AnyPicture {
    /// Pixels in a line.
    pub fn columns(&self) -> usize {
        either!(self, picture => picture.columns())
    }

    /// Returns the number of lines.
    pub fn lines(&self) -> usize {
        either!(self, picture => picture.lines())
    }

    /// Bits of a code.
    pub fn depth(&self) -> Depth {
        either!(self, picture => picture.depth())
    }

    /// The picture, if it is grey.
    pub fn grey(&self) -> Option<&GreyPicture> {
        match self {
            Self::Grey(picture) => Some(picture),
            Self::Colour(_) => None,
        }
    }

    /// Whether a pixel has three codes.
    pub fn is_colour(&self) -> bool {
        matches!(self, Self::Colour(_))
    }

    /// Returns the hash of the pixels; see [`Picture::pixel_hash`](crate::Picture::pixel_hash).
    pub fn pixel_hash(&self) -> String {
        either!(self, picture => picture.pixel_hash())
    }

    /// The same picture in 8 bits, each code rounded to the nearest.
    pub fn to_eight_bits(&self) -> Self {
        either!(self, picture => picture.to_eight_bits().into())
    }

    /// The same picture at another size, by [`shrink`](crate::shrink).
    ///
    /// # Errors
    /// [`PictureError::Size`] when there would be no pixel.
    pub fn shrink(&self, columns: usize, lines: usize) -> Result<Self, PictureError> {
        Ok(either!(self, picture => crate::compose::shrink(picture, columns, lines)?.into()))
    }

    /// The bytes of a PNG, by [`encode_png`].
    ///
    /// # Errors
    /// [`PictureError::Encode`] for a text that PNG cannot hold.
    pub fn encode_png(&self, texts: &[(&str, &str)]) -> Result<Vec<u8>, PictureError> {
        either!(self, picture => encode_png(picture, texts))
    }

    /// Grey as it is; colour by its luminance under the display curve `curve`.
    pub fn to_grey(&self, curve: Curve) -> GreyPicture {
        match self {
            Self::Grey(picture) => picture.clone(),
            Self::Colour(picture) => picture.to_grey(curve),
        }
    }

    /// Colour as it is; grey with red, green and blue alike.
    pub fn to_colour(&self) -> ColourPicture {
        match self {
            Self::Grey(picture) => picture.to_colour(),
            Self::Colour(picture) => picture.clone(),
        }
    }

    /// Whether each pixel has any code above black.
    pub fn is_lit(&self) -> Vec<bool> {
        either!(self, picture => picture.pixels().iter().map(|pixel| pixel.iter().any(|code| *code > 0)).collect())
    }
}
