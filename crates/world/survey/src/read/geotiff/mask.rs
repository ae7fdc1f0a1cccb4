//! Samples that a TIFF masks: by a picture of its own, by an alpha band, or by a file beside it.

use std::path::{Path, PathBuf};

use tiff::tags::Tag;

use super::file::{Tiff, limits, open};
use super::items::Items;
use super::layout::Layout;
use super::tags;
use crate::error::SurveyError;
use crate::read::beside::going_on;
use crate::read::refusal::field;
use crate::read::stretch::Window;

/// Bit of NewSubfileType: a copy of less detail.
const SMALLER: u32 = 1;
/// Bit of NewSubfileType: a mask.
const MASK: u32 = 4;

/// A picture whose zeros are voids.
pub struct Mask {
    path: PathBuf,
    tiff: Tiff,
    layout: Layout,
}

impl Mask {
    /// Of the directory that `tiff` stands at, which must have as many lines and columns as the heights.
    fn of(
        path: &Path,
        mut tiff: Tiff,
        bytes: u64,
        size: [usize; 2],
        place: &str,
    ) -> Result<Self, SurveyError> {
        let failed = |source| SurveyError::Tiff { path: path.to_path_buf(), place: place.to_owned(), source };
        let layout = Layout::of(&mut tiff, limits(bytes)).map_err(failed)?;
        if [layout.lines, layout.columns] != size {
            let found = format!("a mask of {} x {} samples", layout.lines, layout.columns);
            let expected = format!("{} x {}, as the heights have", size[0], size[1]);
            return Err(field(path, place, found, expected, "write it again with gdal_translate"));
        }
        layout.check_samples(path)?;
        Ok(Self { path: path.to_path_buf(), tiff, layout })
    }

    /// Marks samples of a window void where the mask is 0.
    pub fn apply(&mut self, window: &Window, samples: &mut [f64]) -> Result<(), SurveyError> {
        hide(samples, &self.layout.read(&self.path, &mut self.tiff, 0, window)?.samples);
        Ok(())
    }
}

/// The masks of a file: later directories of it, and a file beside it. Notes tell of pictures that are not read.
pub fn masks(
    path: &Path,
    tiff: &mut Tiff,
    bytes: u64,
    size: [usize; 2],
    notes: &mut Vec<String>,
) -> Result<Vec<Mask>, SurveyError> {
    let (mut directory, mut masks) = (1, Vec::new());
    while tiff.more_images() {
        directory += 1;
        let place = format!("directory {directory}");
        let failed = |source| SurveyError::Tiff { path: path.to_path_buf(), place: place.clone(), source };
        tiff.next_image().map_err(failed)?;
        let kind = tiff.find_tag_unsigned::<u32>(Tag::NewSubfileType).map_err(failed)?.unwrap_or(0);
        let shown = tiff.find_tag_unsigned::<u16>(Tag::PhotometricInterpretation).map_err(failed)?;
        match kind {
            kind if kind & SMALLER != 0 => {}
            kind if kind & MASK != 0 || shown == Some(4) => {
                let (mut own, _) = open(path)?;
                own.seek_to_image(directory - 1).map_err(failed)?;
                masks.push(Mask::of(path, own, bytes, size, &place)?);
            }
            _ => notes.push(format!("{place} of the file is another picture, which is not read")),
        }
    }
    masks.extend(beside(path, size, notes)?);
    Ok(masks)
}

/// Marks samples void that are masked.
fn hide(samples: &mut [f64], mask: &[f64]) {
    let masked = samples.iter_mut().zip(mask).filter(|(_, mask)| **mask == 0.0);
    masked.for_each(|(sample, _)| *sample = f64::NAN);
}

/// A mask of GDAL's beside the file.
fn beside(path: &Path, size: [usize; 2], notes: &mut Vec<String>) -> Result<Option<Mask>, SurveyError> {
    let file = going_on(path, ".msk");
    if !file.is_file() {
        return Ok(None);
    }
    let (tiff, bytes) = open(&file)?;
    notes.push(format!("{} masks samples, which are voids", file.display()));
    Mask::of(&file, tiff, bytes, size, "mask").map(Some)
}

/// Which bands are alpha, with whether heights are multiplied by it (TIFF 6.0, ExtraSamples 1).
pub fn alpha_bands(extra: &[u16], items: &Items, bands: usize) -> Vec<(usize, bool)> {
    let first = bands.saturating_sub(extra.len());
    let of_tag = |band: usize| band.checked_sub(first).and_then(|k| extra.get(k)).copied();
    let named = items.bands_with("COLORINTERP", "alpha");
    let is_alpha = |band: &usize| matches!(of_tag(*band), Some(1 | 2)) || named.contains(band);
    (0..bands).filter(is_alpha).map(|band| (band, of_tag(band) == Some(1))).collect()
}

/// Marks samples void where an alpha band is 0. Heights that are multiplied by a fraction of it are refused.
pub fn apply_alpha(
    path: &Path,
    samples: &mut [f64],
    alpha: &[f64],
    is_multiplied: bool,
) -> Result<(), SurveyError> {
    let most = alpha.iter().copied().fold(0.0, f64::max);
    let is_partial = |alpha: &f64| *alpha != 0.0 && *alpha != most;
    if let Some(found) = alpha.iter().copied().find(is_partial).filter(|_| is_multiplied) {
        let found = format!("heights multiplied by an alpha of {found} of {most}");
        let advice = "write the file again without its alpha band";
        return Err(field(path, tags::place(338), found, "0 or full alpha", advice));
    }
    hide(samples, alpha);
    Ok(())
}
