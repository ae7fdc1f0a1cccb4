//! Numbers that say how far one picture is from another.

use picture::{Depth, GreyPicture, Picture, PictureError};

use crate::ssim::ssim;

/// Pictures or planes that cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// The two pictures have different sizes.
    #[error("a picture of {}x{} against one of {}x{} (columns x lines): draw both on the same raster",
        found.0, found.1, expected.0, expected.1)]
    Size {
        /// Columns and lines of the first.
        found: (usize, usize),
        /// Columns and lines of the second.
        expected: (usize, usize),
    },
    /// A mask or a plane does not fill the picture.
    #[error("a {what} of {found} values, expected {expected}")]
    Plane {
        /// Name of the mask or plane.
        what: &'static str,
        /// Number of values found.
        found: usize,
        /// Number of values expected.
        expected: usize,
    },
    /// A frame lacks a plane.
    #[error("there is no plane `{kind}`; ask the generator for it")]
    MissingPlane {
        /// Name of the plane.
        kind: &'static str,
    },
    /// Nothing is left to compare.
    #[error("the mask covers all {pixels} pixels, so there is nothing to compare")]
    AllMasked {
        /// Pixels of the picture.
        pixels: usize,
    },
    /// A range that is neither a distance nor the sky's infinity.
    #[error("range {value} at pixel {column}, {line}, expected 0 or more, infinity for the sky")]
    Range {
        /// Column of the pixel, from 0.
        column: usize,
        /// Line of the pixel, from 0.
        line: usize,
        /// The wrong range that was found (m).
        value: f32,
    },
    /// Pictures that cannot stand side by side.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

/// How one picture differs from another. Grey is 0 (black) to 1 (white) on the codes as they are displayed.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Pixels compared: those outside the mask.
    pub compared: usize,
    /// Number of pixels left out by the mask.
    pub masked: usize,
    /// Pixels compared that differ at all.
    pub differing: usize,
    /// Root of the mean squared difference of grey.
    pub rmse: f64,
    /// `-20 log10 rmse`; nothing where no pixel differs.
    pub psnr_db: Option<f64>,
    /// Structural similarity of the whole picture, masked or not; nothing below 11 columns or lines.
    pub ssim: Option<f64>,
    /// The pixel that differs most, the first of several.
    pub worst: WorstPixel,
    /// For each number of levels asked for, how many pixels lie beyond.
    pub beyond: Vec<Beyond>,
}

/// Where two pictures differ most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstPixel {
    /// Column of the pixel, from 0.
    pub column: usize,
    /// Line of the pixel, from 0.
    pub line: usize,
    /// Grey of the picture under test.
    pub test: f64,
    /// Grey of the reference.
    pub reference: f64,
}

/// Pixels that differ by more than some levels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beyond {
    /// Levels of 255; a pixel that differs by exactly so much is not counted.
    pub levels: u32,
    /// Number of pixels that differ by more.
    pub count: usize,
    /// Their share of the pixels compared, 0 to 1.
    pub share: f64,
}

/// Compares two pictures of one size, of the same or of different depth. Pixels where `mask` is true are
/// left out of everything but the SSIM.
///
/// # Errors
/// [`CompareError::Size`], [`CompareError::Plane`], [`CompareError::AllMasked`].
pub fn compare(
    test: &GreyPicture,
    reference: &GreyPicture,
    mask: Option<&[bool]>,
    levels: &[u32],
) -> Result<Comparison, CompareError> {
    same_size(test, reference)?;
    let kept = kept_pixels(test.codes().len(), mask)?;
    let scale = Scale::new(test.depth(), reference.depth());
    let steps: Vec<u64> = kept.iter().map(|at| scale.steps(test, reference, *at).unsigned_abs()).collect();
    let rmse = rmse(&steps, scale);
    Ok(Comparison {
        compared: kept.len(),
        masked: test.codes().len() - kept.len(),
        differing: steps.iter().filter(|steps| **steps > 0).count(),
        rmse,
        psnr_db: (rmse > 0.0).then(|| -20.0 * libm::log10(rmse)),
        ssim: ssim(test, reference),
        worst: worst(test, reference, &kept, &steps),
        beyond: levels.iter().map(|levels| beyond(*levels, &steps, scale)).collect(),
    })
}

pub(crate) fn same_size<const CHANNELS: usize>(
    test: &Picture<CHANNELS>,
    reference: &Picture<CHANNELS>,
) -> Result<(), CompareError> {
    let found = (test.columns(), test.lines());
    let expected = (reference.columns(), reference.lines());
    if found == expected { Ok(()) } else { Err(CompareError::Size { found, expected }) }
}

/// Indices of the pixels that the mask leaves.
pub(crate) fn kept_pixels(pixels: usize, mask: Option<&[bool]>) -> Result<Vec<usize>, CompareError> {
    let Some(mask) = mask else { return Ok((0..pixels).collect()) };
    if mask.len() != pixels {
        return Err(CompareError::Plane { what: "mask", found: mask.len(), expected: pixels });
    }
    let kept: Vec<usize> = (0..pixels).filter(|at| !mask[*at]).collect();
    if kept.is_empty() { Err(CompareError::AllMasked { pixels }) } else { Ok(kept) }
}

/// Differences as whole steps of the finest grid that holds the codes of both depths, so that "more than two
/// levels" is exact.
#[derive(Clone, Copy)]
pub(crate) struct Scale {
    test: i64,
    reference: i64,
    /// Steps from black to white.
    pub white: i64,
}

impl Scale {
    pub fn new(test: Depth, reference: Depth) -> Self {
        // 65 535 = 255 * 257: the finer depth holds both.
        let white = i64::from(test.white().max(reference.white()));
        let steps = |depth: Depth| white / i64::from(depth.white());
        Self { test: steps(test), reference: steps(reference), white }
    }

    /// Test minus reference, of the codes at `at`.
    pub fn steps<const CHANNELS: usize>(
        self,
        test: &Picture<CHANNELS>,
        reference: &Picture<CHANNELS>,
        at: usize,
    ) -> i64 {
        i64::from(test.codes()[at]) * self.test - i64::from(reference.codes()[at]) * self.reference
    }
}

fn rmse(steps: &[u64], scale: Scale) -> f64 {
    // At most 2^32 a pixel and 2^26 pixels: the sum is exact.
    let sum: u64 = steps.iter().map(|steps| steps * steps).sum();
    (sum as f64 / steps.len() as f64).sqrt() / scale.white as f64
}

fn beyond(levels: u32, steps: &[u64], scale: Scale) -> Beyond {
    let bound = u64::from(levels) * scale.white as u64;
    let count = steps.iter().filter(|steps| **steps * 255 > bound).count();
    Beyond { levels, count, share: count as f64 / steps.len() as f64 }
}

fn worst(test: &GreyPicture, reference: &GreyPicture, kept: &[usize], steps: &[u64]) -> WorstPixel {
    let mut most = 0;
    for index in 1..steps.len() {
        if steps[index] > steps[most] {
            most = index;
        }
    }
    let (at, columns) = (kept[most], test.columns());
    let grey = |picture: &GreyPicture| f64::from(picture.codes()[at]) / f64::from(picture.depth().white());
    WorstPixel { column: at % columns, line: at / columns, test: grey(test), reference: grey(reference) }
}
