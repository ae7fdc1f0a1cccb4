//! The geo tags of a TIFF: where its samples lie and in which projection (OGC GeoTIFF 1.1).

use std::collections::BTreeMap;
use std::path::Path;

use landscape::LUNOID_RADIUS;
use quantities::radians;

use super::field;
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;
use crate::projection::{Method, Projection};

/// The tags as they stand in the file.
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

const MODEL_TYPE: u16 = 1024;
const RASTER_TYPE: u16 = 1025;
const ANGULAR_UNIT: u16 = 2054;
const SEMI_MAJOR_AXIS: u16 = 2057;
const TRANSFORMATION: u16 = 3075;
const LINEAR_UNIT: u16 = 3076;
const PARALLEL: u16 = 3078;
const FALSE_EASTING: u16 = 3082;
const FALSE_NORTHING: u16 = 3083;
const SCALE: u16 = 3092;
const LATITUDES: [u16; 2] = [3081, 3089];
const LONGITUDES: [u16; 3] = [3095, 3080, 3088];

impl GeoTags {
    /// Place and frame; `None` if the file has no place at all. Remarks go to `notes`.
    pub fn place(
        &self,
        path: &Path,
        notes: &mut Vec<String>,
    ) -> Result<Option<(Affine, Frame)>, SurveyError> {
        let keys = self.keys(path)?;
        let Some(mut affine) = self.affine(path)? else { return Ok(None) };
        // PixelIsPoint: the tie point names a centre; else a corner, and centres lie half a step inside.
        if keys.get(&RASTER_TYPE) != Some(&2.0) {
            affine.first = [0, 1].map(|k| affine.first[k] + 0.5 * affine.step[k]);
        }
        if keys.get(&MODEL_TYPE) == Some(&2.0) {
            only(path, &keys, ANGULAR_UNIT, 9102.0, "9102 (degrees)", "gdalwarp -t_srs")?;
            let angles = |pair: [f64; 2]| pair.map(radians);
            let affine = Affine { first: angles(affine.first), step: angles(affine.step) };
            return Ok(Some((affine, Frame::Geographic { radius: radius(&keys) })));
        }
        only(path, &keys, LINEAR_UNIT, 9001.0, "9001 (metres)", "gdalwarp -t_srs")?;
        let projection = projection(&keys);
        if projection.is_none() {
            notes.push(
                "the projection of the file is not one known here: its metres are taken as they are".into(),
            );
        }
        Ok(Some((affine, Frame::Plane(projection))))
    }

    /// Values of the keys that are numbers.
    fn keys(&self, path: &Path) -> Result<BTreeMap<u16, f64>, SurveyError> {
        let mut keys = BTreeMap::new();
        for entry in self.directory.get(4..).unwrap_or_default().chunks_exact(4) {
            let [key, location, _, value] = [entry[0], entry[1], entry[2], entry[3]];
            match location {
                0 => drop(keys.insert(key, f64::from(value))),
                34736 => {
                    let number = self.numbers.get(usize::from(value)).copied().filter(|v| v.is_finite());
                    let count = self.numbers.len();
                    let missing = || {
                        let found = format!("a reference to number {value} of {count}");
                        let advice = "the geo tags are damaged: write the file again with gdal_translate";
                        field(path, format!("geo key {key}"), found, "a finite number that is there", advice)
                    };
                    keys.insert(key, number.ok_or_else(missing)?);
                }
                _ => {}
            }
        }
        Ok(keys)
    }

    /// Corner (or centre) of the first sample and steps, in the file's units: north, east.
    fn affine(&self, path: &Path) -> Result<Option<Affine>, SurveyError> {
        let affine = match (&self.transformation, &self.pixel_scale, &self.tie_point) {
            (Some(m), _, _) => from_matrix(path, m)?,
            (None, Some(scale), Some(tie)) if scale.len() >= 2 && tie.len() >= 6 => Affine {
                first: [tie[4] + tie[1] * scale[1], tie[3] - tie[0] * scale[0]],
                step: [-scale[1], scale[0]],
            },
            _ => return Ok(None),
        };
        let sane = affine.first.iter().chain(&affine.step).all(|v| v.is_finite());
        if sane && affine.step[0] != 0.0 && affine.step[1] > 0.0 {
            return Ok(Some(affine));
        }
        let found = format!("first {:?}, step {:?}", affine.first, affine.step);
        Err(field(path, "place of the samples", found, "finite steps, columns going east", "use gdalwarp"))
    }
}

/// Row-major 4 x 4: x = a column + b line + d, y = e column + f line + h.
fn from_matrix(path: &Path, m: &[f64]) -> Result<Affine, SurveyError> {
    let &[a, b, _, d, e, f, _, h, ..] = m else {
        let found = format!("{} numbers", m.len());
        return Err(field(path, "ModelTransformationTag", found, "16 numbers", "write the file again"));
    };
    if b.abs() > 1e-9 * a.abs() || e.abs() > 1e-9 * f.abs() {
        let found = format!("a rotated grid ({b} along lines, {e} along columns)");
        return Err(field(
            path,
            "ModelTransformationTag",
            found,
            "lines along east",
            "turn it north up with gdalwarp",
        ));
    }
    Ok(Affine { first: [h, d], step: [f, a] })
}

fn only(
    path: &Path,
    keys: &BTreeMap<u16, f64>,
    key: u16,
    wanted: f64,
    expected: &str,
    tool: &str,
) -> Result<(), SurveyError> {
    match keys.get(&key) {
        Some(&found) if found != wanted => {
            let advice = format!("convert the file with {tool}");
            Err(field(path, format!("geo key {key}"), found.to_string(), expected, advice))
        }
        _ => Ok(()),
    }
}

fn radius(keys: &BTreeMap<u16, f64>) -> f64 {
    keys.get(&SEMI_MAJOR_AXIS).copied().filter(|radius| *radius > 0.0).unwrap_or(LUNOID_RADIUS)
}

fn projection(keys: &BTreeMap<u16, f64>) -> Option<Projection> {
    let number = |key: u16| keys.get(&key).copied();
    let first = |keys: &[u16]| keys.iter().find_map(|&key| number(key)).unwrap_or(0.0);
    let latitude = radians(first(&LATITUDES));
    let pole = radians(90.0_f64.copysign(latitude));
    let (method, latitude) = match number(TRANSFORMATION)? as u16 {
        14 if (latitude.abs() - pole.abs()).abs() > 1e-9 => return None,
        14 | 15 => {
            // A latitude other than the pole names the parallel of true scale.
            let scale = number(SCALE).unwrap_or(1.0) * 0.5 * (1.0 + libm::sin(latitude.abs()));
            (Method::PolarStereographic { scale }, pole)
        }
        17 => {
            let parallel = radians(number(PARALLEL).unwrap_or(0.0));
            (Method::Equirectangular { parallel }, latitude)
        }
        21 => (Method::Orthographic, latitude),
        _ => return None,
    };
    let longitude = radians(first(&LONGITUDES));
    let offset = [FALSE_NORTHING, FALSE_EASTING].map(|key| number(key).unwrap_or(0.0));
    Some(Projection { method, latitude, longitude, radius: radius(keys), offset })
}
