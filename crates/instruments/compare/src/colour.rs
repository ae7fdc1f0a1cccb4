//! Error of one colour picture against another: of its luminance, and of red, green and blue by themselves.

use picture::{AnyPicture, ColourPicture, Curve, GreyPicture};

use crate::difference::{difference_picture, triptych};
use crate::metrics::{CompareError, Comparison, compare};

/// How one picture differs from another, whatever their layouts.
#[derive(Clone, Debug, PartialEq)]
pub struct AnyComparison {
    /// Of two grey pictures their difference; if one is in colour, that of the luminance.
    pub luminance: Comparison,
    /// Of two colour pictures the difference of red, green and blue.
    pub channels: Option<[Comparison; 3]>,
}

impl AnyComparison {
    /// The luminance, and the channels if there are any: what a tolerance holds for.
    pub fn all(&self) -> impl Iterator<Item = &Comparison> {
        [&self.luminance].into_iter().chain(self.channels.iter().flatten())
    }
}

/// Compares two pictures of one size: grey with grey, colour with colour by luminance and by channel, grey with colour by
/// luminance. `curves` are the display curves by which colour of each becomes grey. Pixels where `mask` is true are left
/// out of everything but the SSIM.
///
/// # Errors
/// [`CompareError::Size`], [`CompareError::Plane`], [`CompareError::AllMasked`].
pub fn compare_any(
    [test, reference]: [&AnyPicture; 2],
    curves: [Curve; 2],
    mask: Option<&[bool]>,
    levels: &[u32],
) -> Result<AnyComparison, CompareError> {
    let greys = (test.to_grey(curves[0]), reference.to_grey(curves[1]));
    let luminance = compare(&greys.0, &greys.1, mask, levels)?;
    let channels = match (test, reference) {
        (AnyPicture::Colour(test), AnyPicture::Colour(reference)) => {
            let of = |channel| compare(&alone(test, channel)?, &alone(reference, channel)?, mask, levels);
            Some([of(0)?, of(1)?, of(2)?])
        }
        _ => None,
    };
    Ok(AnyComparison { luminance, channels })
}

/// [`difference_picture`] of two pictures of one layout; if one is in colour, of both in colour.
///
/// # Errors
/// [`CompareError::Size`].
pub fn difference_any(
    test: &AnyPicture,
    reference: &AnyPicture,
    factor: u32,
) -> Result<AnyPicture, CompareError> {
    match (test, reference) {
        (AnyPicture::Grey(test), AnyPicture::Grey(reference)) => {
            Ok(difference_picture(test, reference, factor)?.into())
        }
        _ => Ok(difference_picture(&test.to_colour(), &reference.to_colour(), factor)?.into()),
    }
}

/// [`triptych`] of the same.
///
/// # Errors
/// [`CompareError::Size`].
pub fn triptych_any(
    test: &AnyPicture,
    reference: &AnyPicture,
    factor: u32,
) -> Result<AnyPicture, CompareError> {
    match (test, reference) {
        (AnyPicture::Grey(test), AnyPicture::Grey(reference)) => {
            Ok(triptych(test, reference, factor)?.into())
        }
        _ => Ok(triptych(&test.to_colour(), &reference.to_colour(), factor)?.into()),
    }
}

/// One channel of a colour picture as a grey one.
fn alone(picture: &ColourPicture, channel: usize) -> Result<GreyPicture, CompareError> {
    let codes = picture.pixels().iter().map(|pixel| pixel[channel]).collect();
    Ok(GreyPicture::new(picture.columns(), picture.lines(), picture.depth(), codes)?)
}
