//! Error on linear intensity: what the video signal is off by, before white point and gamma.

use picture::{AnyPicture, ColourPicture, Depth, GreyPicture, Transfer};

use crate::metrics::{CompareError, kept_pixels};

/// How one plane of linear intensity differs from another, in its unit (reflectivity: 0 black, 1 all light returned).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearComparison {
    /// Pixels compared: those outside the mask.
    pub compared: usize,
    /// Number of pixels left out by the mask.
    pub masked: usize,
    /// Root of the mean squared difference.
    pub rmse: f64,
    /// `-20 log10 rmse`, of a peak of 1; nothing where no pixel differs.
    pub psnr_db: Option<f64>,
    /// Mean of test minus reference.
    pub bias: f64,
    /// Largest absolute difference of any pixel.
    pub maximum: f64,
}

/// Compares two planes, value by value; pixels where `mask` is true are left out.
///
/// # Errors
/// [`CompareError::Plane`] for planes or masks of different sizes, [`CompareError::AllMasked`].
pub fn compare_linear(
    test: &[f32],
    reference: &[f32],
    mask: Option<&[bool]>,
) -> Result<LinearComparison, CompareError> {
    let (found, expected) = (test.len(), reference.len());
    if found != expected {
        return Err(CompareError::Plane { what: "plane of intensity", found, expected });
    }
    let kept = kept_pixels(expected, mask)?;
    let (mut sum, mut squares, mut maximum) = (0.0, 0.0, 0.0_f64);
    for at in &kept {
        let difference = f64::from(test[*at]) - f64::from(reference[*at]);
        sum += difference;
        squares += difference * difference;
        maximum = maximum.max(difference.abs());
    }
    let (compared, count) = (kept.len(), kept.len() as f64);
    let rmse = (squares / count).sqrt();
    Ok(LinearComparison {
        compared,
        masked: expected - compared,
        rmse,
        psnr_db: (rmse > 0.0).then(|| -20.0 * libm::log10(rmse)),
        bias: sum / count,
        maximum,
    })
}

/// The linear intensity that the codes of a picture stand for under the display law that made them. It is as fine as
/// the codes: half a step off at most, and never above the white point.
pub fn linear_intensity(picture: &GreyPicture, transfer: &Transfer) -> Vec<f32> {
    let lights = lights(picture.depth(), transfer);
    picture.codes().iter().map(|code| lights[usize::from(*code)]).collect()
}

/// The same of a picture in colour: the luminance of its linear red, green and blue.
pub fn linear_luminance(picture: &AnyPicture, transfer: &Transfer) -> Vec<f32> {
    match picture {
        AnyPicture::Grey(picture) => linear_intensity(picture, transfer),
        AnyPicture::Colour(picture) => luminances(picture, &lights(picture.depth(), transfer)),
    }
}

fn luminances(picture: &ColourPicture, lights: &[f32]) -> Vec<f32> {
    let luminance =
        |pixel: &[u16; 3]| quantities::luminance(pixel.map(|code| lights[usize::from(code)].into())) as f32;
    picture.pixels().iter().map(luminance).collect()
}

/// The intensity of every code.
fn lights(depth: Depth, transfer: &Transfer) -> Vec<f32> {
    (0..=depth.white()).map(|code| transfer.intensity(code, depth)).collect()
}
