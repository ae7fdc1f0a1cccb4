//! Differences to look at.

use picture::{Depth, Picture, beside};

use crate::metrics::{CompareError, Scale, same_size};

/// The code that stands for "equal".
const EQUAL: i64 = 128;

/// Test minus reference in 8 bits: 128 where they are equal, brighter where the test is brighter, each level
/// of 255 shown as `factor` levels, cut at black and white; of colour pictures channel by channel.
///
/// # Errors
/// [`CompareError::Size`].
pub fn difference_picture<const CHANNELS: usize>(
    test: &Picture<CHANNELS>,
    reference: &Picture<CHANNELS>,
    factor: u32,
) -> Result<Picture<CHANNELS>, CompareError> {
    same_size(test, reference)?;
    let scale = Scale::new(test.depth(), reference.depth());
    let shown = |at: usize| {
        let levels = rounded(scale.steps(test, reference, at) * 255 * i64::from(factor), scale.white);
        (EQUAL + levels).clamp(0, 255) as u16
    };
    let codes = (0..test.codes().len()).map(shown).collect();
    Ok(Picture::new(test.columns(), test.lines(), Depth::Eight, codes)?)
}

/// Quotient rounded to the nearest, halves away from zero.
fn rounded(numerator: i64, denominator: i64) -> i64 {
    (numerator + numerator.signum() * (denominator / 2)) / denominator
}

/// Test, reference and [`difference_picture`] side by side in 8 bits.
///
/// # Errors
/// [`CompareError::Size`].
pub fn triptych<const CHANNELS: usize>(
    test: &Picture<CHANNELS>,
    reference: &Picture<CHANNELS>,
    factor: u32,
) -> Result<Picture<CHANNELS>, CompareError> {
    let difference = difference_picture(test, reference, factor)?;
    Ok(beside(&[&test.to_eight_bits(), &reference.to_eight_bits(), &difference])?)
}
