//! The grid of a TIFF in the units of its map: pixel scale, tie points, matrix.

use std::path::Path;

use tiff::TiffResult;
use tiff::decoder::ifd::Value;
use tiff::tags::Tag;

use super::file::Tiff;
use super::tags;
use crate::elevation::Affine;
use crate::error::SurveyError;
use crate::read::options::ReadOptions;
use crate::read::refusal::field;

const SCALE: u16 = 33550;
const TIE_POINT: u16 = 33922;
const MATRIX: u16 = 34264;

/// The geo tags as they stand in the file.
#[derive(Debug, Default, Clone)]
pub struct GeoTags {
    /// Values of the tag ModelPixelScaleTag, if it is there.
    pub pixel_scale: Option<Vec<f64>>,
    /// Values of the tag ModelTiepointTag, if it is there.
    pub tie_point: Option<Vec<f64>>,
    /// Values of the tag ModelTransformationTag, if it is there.
    pub transformation: Option<Vec<f64>>,
    /// Values of the tag GeoKeyDirectoryTag: a header of four words, then four words a key.
    pub directory: Vec<u16>,
    /// Values of the tag GeoDoubleParamsTag, to which keys point.
    pub numbers: Vec<f64>,
}

impl GeoTags {
    /// Reads the tags of the first directory.
    pub fn of(tiff: &mut Tiff) -> TiffResult<Self> {
        let mut numbers = |tag| tiff.find_tag(tag)?.map(Value::into_f64_vec).transpose();
        let (pixel_scale, tie_point) = (numbers(Tag::ModelPixelScaleTag)?, numbers(Tag::ModelTiepointTag)?);
        let transformation = numbers(Tag::ModelTransformationTag)?;
        let numbers = numbers(Tag::GeoDoubleParamsTag)?.unwrap_or_default();
        let directory = tiff.find_tag_unsigned_vec::<u16>(Tag::GeoKeyDirectoryTag)?.unwrap_or_default();
        Ok(Self { pixel_scale, tie_point, transformation, directory, numbers })
    }

    /// Refuses a scale or an offset of heights among the geo tags, which the user did not replace.
    pub fn expect_no_heights(&self, path: &Path, options: &ReadOptions) -> Result<(), SurveyError> {
        let scale = self.pixel_scale.as_ref().and_then(|scale| scale.get(2)).copied();
        let scale = scale.filter(|scale| ![0.0, 1.0].contains(scale) && options.scale.is_none());
        if let Some(scale) = scale {
            let found = format!("{scale} in the third place");
            return Err(field(path, tags::place(SCALE), found, "0 or 1", "give --scale METRES"));
        }
        let levels = self.tie_point.as_ref().map(|tie| tie.iter().skip(2).step_by(3).copied());
        let level = levels.and_then(|mut levels| levels.find(|level| *level != 0.0));
        if let Some(level) = level.filter(|_| options.offset.is_none()) {
            let found = format!("{level} in the place of a height");
            return Err(field(path, tags::place(TIE_POINT), found, "0", "give --offset METRES"));
        }
        match self.transformation.as_ref().and_then(|matrix| matrix.get(8..12)) {
            Some(&[east, north, scale, level]) => {
                let of_matrix = |found: String, expected: &str, advice: &str| {
                    Err(field(path, tags::place(MATRIX), found, expected, advice))
                };
                if [east, north] != [0.0; 2] {
                    let found = format!("heights that go by the place ({east}, {north})");
                    return of_matrix(found, "0 and 0", "write it again with gdal_translate");
                }
                if ![0.0, 1.0].contains(&scale) && options.scale.is_none() {
                    return of_matrix(
                        format!("{scale} in the place of a scale"),
                        "0 or 1",
                        "give --scale METRES",
                    );
                }
                if level != 0.0 && options.offset.is_none() {
                    return of_matrix(
                        format!("{level} in the place of a height"),
                        "0",
                        "give --offset METRES",
                    );
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }
}

/// Corner (or centre) of the first sample and steps, in the file's units: north, east.
pub fn grid(path: &Path, geo: &GeoTags) -> Result<Option<Affine>, SurveyError> {
    let of_matrix = geo.transformation.as_ref().map(|matrix| from_matrix(path, matrix)).transpose()?;
    let Some(affine) = one(path, of_matrix, from_scale(path, geo)?)? else { return Ok(None) };
    let sane = affine.first.iter().chain(&affine.step).all(|v| v.is_finite());
    if sane && affine.step[0] != 0.0 && affine.step[1] > 0.0 {
        return Ok(Some(affine));
    }
    let found = format!("first {:?}, step {:?}", affine.first, affine.step);
    Err(field(path, "place of the samples", found, "finite steps, columns going east", "use gdalwarp"))
}

/// Two ways to say a place must say the same.
fn one(path: &Path, matrix: Option<Affine>, scale: Option<Affine>) -> Result<Option<Affine>, SurveyError> {
    match (matrix, scale) {
        (Some(matrix), Some(scale)) if !alike(&matrix, &scale) => {
            let found = format!("first {:?}, step {:?}", matrix.first, matrix.step);
            let expected = format!("{:?} and {:?}, as the pixel scale says", scale.first, scale.step);
            Err(field(path, tags::place(MATRIX), found, expected, "write it again with gdal_translate"))
        }
        (matrix, scale) => Ok(matrix.or(scale)),
    }
}

fn alike(a: &Affine, b: &Affine) -> bool {
    let step = b.step.map(f64::abs);
    (0..2).all(|k| {
        (a.first[k] - b.first[k]).abs() <= 1e-6 * step[k] && (a.step[k] - b.step[k]).abs() <= 1e-9 * step[k]
    })
}

/// From the pixel scale and the first tie point, on whose grid all others must lie.
fn from_scale(path: &Path, geo: &GeoTags) -> Result<Option<Affine>, SurveyError> {
    let Some(ties) = &geo.tie_point else { return Ok(None) };
    let tie_points = |found: String, expected: &str| {
        let advice = "lay it on a regular grid with gdalwarp";
        field(path, tags::place(TIE_POINT), found, expected, advice)
    };
    let Some(scale) = geo.pixel_scale.as_ref().filter(|scale| scale.len() >= 2) else {
        let found = format!("{} tie points without a pixel scale", ties.len() / 6);
        return if geo.transformation.is_some() {
            Ok(None)
        } else {
            Err(tie_points(found, "ModelPixelScaleTag"))
        };
    };
    if scale[0] < 0.0 || scale[1] < 0.0 {
        // Some programs mean lines that go south all the same, by their own custom.
        let found = format!("{} and {}", scale[0], scale[1]);
        return Err(field(
            path,
            tags::place(SCALE),
            found,
            "two lengths above 0",
            "write it again with gdal_translate",
        ));
    }
    let at = |tie: &[f64]| [tie[4] + tie[1] * scale[1], tie[3] - tie[0] * scale[0]];
    let mut all = ties.chunks_exact(6).map(|tie| Affine { first: at(tie), step: [-scale[1], scale[0]] });
    let Some(first) = all.next() else {
        return Err(tie_points(format!("{} numbers", ties.len()), "six numbers a tie point"));
    };
    match all.find(|other| !alike(other, &first)) {
        Some(other) => {
            let found =
                format!("tie points that place the first sample at {:?} and {:?}", first.first, other.first);
            Err(tie_points(found, "tie points on one grid"))
        }
        None => Ok(Some(first)),
    }
}

/// Row-major 4 x 4: x = a column + b line + d, y = e column + f line + h.
fn from_matrix(path: &Path, m: &[f64]) -> Result<Affine, SurveyError> {
    let place = tags::place(MATRIX);
    let &[a, b, _, d, e, f, _, h, ..] = m else {
        return Err(field(path, place, format!("{} numbers", m.len()), "16 numbers", "write the file again"));
    };
    if b.abs() > 1e-9 * a.abs() || e.abs() > 1e-9 * f.abs() {
        let found = format!("a rotated grid ({b} along lines, {e} along columns)");
        return Err(field(path, place, found, "lines along east", "turn it north up with gdalwarp"));
    }
    if let Some(last) = m.get(12..16).filter(|last| *last != [0.0, 0.0, 0.0, 1.0]) {
        return Err(field(
            path,
            place,
            format!("a last row of {last:?}"),
            "0, 0, 0, 1",
            "write the file again",
        ));
    }
    Ok(Affine { first: [h, d], step: [f, a] })
}
