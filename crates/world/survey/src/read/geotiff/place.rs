//! Where the samples of a TIFF lie and in which projection (OGC GeoTIFF 1.1).

use std::path::Path;

use landscape::LUNOID_RADIUS;

use super::grid::{GeoTags, grid};
use super::keys::{self, Keys};
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;
use crate::read::earth;
use crate::read::map::{self, Map};
use crate::read::refusal::field;
use landscape::projection::{Method, Projection};

const MODEL_TYPE: u16 = 1024;
const RASTER_TYPE: u16 = 1025;
const SYSTEM: u16 = 2048;
const PRIME_MERIDIAN: u16 = 2051;
const SEMI_MAJOR_AXIS: u16 = 2057;
const SEMI_MINOR_AXIS: u16 = 2058;
const INVERSE_FLATTENING: u16 = 2059;
const MERIDIAN_LONGITUDE: u16 = 2061;
const PROJECTED: u16 = 3072;
const METHOD: u16 = 3075;
const LINEAR_UNIT: u16 = 3076;
const PARALLEL: u16 = 3078;
const SECOND_PARALLEL: u16 = 3079;
const EASTINGS: [u16; 3] = [3082, 3090, 3086];
const NORTHINGS: [u16; 3] = [3083, 3091, 3087];
const SCALES: [u16; 2] = [3092, 3093];
const LATITUDES: [u16; 3] = [3081, 3089, 3085];
const LONGITUDES: [u16; 4] = [3095, 3080, 3088, 3084];
/// Codes of systems, data and ellipsoids that EPSG gives: all of the Earth.
const BODIES: [u16; 4] = [SYSTEM, 2050, 2056, PROJECTED];

/// Place and frame; `None` if the file has no place at all. Remarks go to `notes`.
pub fn place(
    path: &Path,
    tags: &GeoTags,
    keys: &Keys,
    notes: &mut Vec<String>,
) -> Result<Option<(Affine, Frame)>, SurveyError> {
    let Some(mut affine) = grid(path, tags)? else { return Ok(None) };
    // PixelIsPoint: the tie point names a centre; else a corner, and centres lie half a step inside.
    match keys.get(RASTER_TYPE) {
        None | Some(0.0 | 1.0) => affine.first = [0, 1].map(|k| affine.first[k] + 0.5 * affine.step[k]),
        Some(2.0) => {}
        Some(other) => return Err(unknown(path, RASTER_TYPE, other, "1 (area) or 2 (point)")),
    }
    let scaled = |affine: Affine, unit: f64| Affine {
        first: affine.first.map(|value| value * unit),
        step: affine.step.map(|value| value * unit),
    };
    let body = Body { path, keys };
    match keys.get(MODEL_TYPE) {
        Some(2.0) => {
            let mut affine = scaled(affine, keys.unit_of_angles(path)?);
            affine.first[1] += body.meridian()?;
            body.tell(notes)?;
            Ok(Some((affine, Frame::Geographic { radius: body.radius()? })))
        }
        None | Some(0.0 | 1.0 | 32767.0) => {
            let unit = body.unit_of_map(notes)?;
            let projection = body.projection(unit)?;
            match projection {
                Some(_) => body.tell(notes)?,
                None => body.tell_unknown(notes),
            }
            Ok(Some((scaled(affine, unit), Frame::Plane(projection))))
        }
        Some(other) => Err(unknown(path, MODEL_TYPE, other, "1 (projected) or 2 (latitude and longitude)")),
    }
}

fn unknown(path: &Path, key: u16, found: f64, expected: &str) -> SurveyError {
    field(path, keys::place(key), found.to_string(), expected, "convert the file with gdalwarp -t_srs")
}

/// The body and the projection that the keys describe.
struct Body<'a> {
    path: &'a Path,
    keys: &'a Keys,
}

impl Body<'_> {
    /// A key whose code is one of EPSG's, which are all of the Earth.
    fn of_earth(&self) -> Option<u16> {
        BODIES.into_iter().find(|key| self.keys.code(*key).is_some_and(|code| code < 32767))
    }

    fn stated_radius(&self) -> Result<Option<f64>, SurveyError> {
        let unit = self.keys.unit_of_axes(self.path)?;
        match self.keys.get(SEMI_MAJOR_AXIS) {
            Some(axis) if axis > 0.0 => Ok(Some(axis * unit)),
            Some(axis) => Err(unknown(self.path, SEMI_MAJOR_AXIS, axis, "a radius above 0")),
            None => Ok(None),
        }
    }

    fn radius(&self) -> Result<f64, SurveyError> {
        let usual = if self.of_earth().is_some() { earth::RADIUS } else { LUNOID_RADIUS };
        Ok(self.stated_radius()?.unwrap_or(usual))
    }

    /// Longitude of the prime meridian, east of the body's own (rad).
    fn meridian(&self) -> Result<f64, SurveyError> {
        if let Some(longitude) = self.keys.get(MERIDIAN_LONGITUDE) {
            return Ok(longitude * self.keys.unit_of_angles(self.path)?);
        }
        // Systems of these codes count from Paris, Rome and the like (EPSG registry).
        let system = self.keys.code(SYSTEM).filter(|code| (4801..=4904).contains(code));
        let meridian = self.keys.code(PRIME_MERIDIAN).filter(|code| *code != 8901);
        match meridian.map(|code| (PRIME_MERIDIAN, code)).or(system.map(|code| (SYSTEM, code))) {
            Some((key, code)) => Err(unknown(self.path, key, code.into(), "longitudes from Greenwich")),
            None => Ok(0.0),
        }
    }

    /// Notes on a body whose radius is assumed, or that is no sphere.
    fn tell(&self, notes: &mut Vec<String>) -> Result<(), SurveyError> {
        let (stated, radius) = (self.stated_radius()?, self.radius()?);
        match (stated, self.of_earth()) {
            (None, None) => {
                notes.push(format!("the file does not name the radius of its body: {radius} m is assumed"));
            }
            (None, Some(_)) => self.tell_earth(notes),
            (Some(stated), Some(_)) if (stated / earth::RADIUS - 1.0).abs() > 0.01 => self.tell_earth(notes),
            (Some(_), _) => {}
        }
        let minor = self
            .keys
            .get(SEMI_MINOR_AXIS)
            .map(|minor| minor / self.keys.get(SEMI_MAJOR_AXIS).unwrap_or(minor));
        let flattening = self.keys.get(INVERSE_FLATTENING).filter(|inverse| *inverse != 0.0).map(f64::recip);
        let flattened = minor.map(|minor| 1.0 - minor).or(flattening).unwrap_or(0.0);
        notes.extend(map::flattened(radius, radius * (1.0 - flattened)));
        Ok(())
    }

    fn tell_earth(&self, notes: &mut Vec<String>) {
        let Some(key) = self.of_earth() else { return };
        let code = self.keys.code(key).unwrap_or_default();
        notes.push(format!("{} is {code}, a code of the Earth, not of the Moon", keys::place(key)));
    }

    /// Notes on a projection that is not known here.
    fn tell_unknown(&self, notes: &mut Vec<String>) {
        self.tell_earth(notes);
        notes.push(match self.keys.get(METHOD) {
            Some(method) => format!(
                "{} is {method}, a projection that is not known here: its metres are taken as they are",
                keys::place(METHOD)
            ),
            None => {
                "the file does not name a projection that is known here: its metres are taken as they are"
                    .into()
            }
        });
    }

    /// Metres of a unit of the map. Codes of the Earth imply a unit, which not every code has as the metre.
    fn unit_of_map(&self, notes: &mut Vec<String>) -> Result<f64, SurveyError> {
        if let Some(metres) = self.keys.unit_of_map(self.path)? {
            return Ok(metres);
        }
        match self.keys.code(PROJECTED) {
            // Universal transverse and web Mercator, and the zones of ETRS89: metres (EPSG registry).
            Some(3857 | 25828..=25838 | 32601..=32660 | 32701..=32760) => Ok(1.0),
            Some(code) => {
                let expected = format!("{} beside it", keys::place(LINEAR_UNIT));
                let advice = "write it again with gdal_translate, which adds the unit of the map";
                Err(field(self.path, keys::place(PROJECTED), code.to_string(), expected, advice))
            }
            None => {
                notes.push("the file does not name the unit of its map: metres are assumed".into());
                Ok(1.0)
            }
        }
    }

    fn projection(&self, unit: f64) -> Result<Option<Projection>, SurveyError> {
        let angle = self.keys.unit_of_angles(self.path)?;
        let one = |keys: &[u16]| Ok::<_, SurveyError>(self.keys.one(self.path, keys)?.unwrap_or(0.0));
        let kind = match self.keys.get(METHOD).map(|number| number as u16) {
            Some(14) => map::Kind::Stereographic,
            Some(15) => map::Kind::Polar,
            Some(17) => map::Kind::Equirectangular,
            Some(21) => map::Kind::Orthographic,
            _ => return Ok(None),
        };
        let map = Map {
            latitude: Some(one(&LATITUDES)? * angle),
            longitude: one(&LONGITUDES)? * angle + self.meridian()?,
            parallel: self.keys.get(PARALLEL).map(|parallel| parallel * angle),
            scale: self.keys.one(self.path, &SCALES)?.unwrap_or(1.0),
            radius: self.radius()?,
            offset: [one(&NORTHINGS)? * unit, one(&EASTINGS)? * unit],
        };
        let projection = map.projection(kind);
        if let Some(projection) = projection {
            self.expect_no_more(projection.method, map.parallel, angle)?;
        }
        Ok(projection)
    }

    /// Refuses figures that a known projection does not have.
    fn expect_no_more(&self, method: Method, parallel: Option<f64>, angle: f64) -> Result<(), SurveyError> {
        let is_polar = matches!(method, Method::PolarStereographic { .. });
        for key in SCALES.into_iter().filter(|_| !is_polar) {
            if let Some(scale) = self.keys.get(key).filter(|scale| *scale != 1.0) {
                return Err(unknown(self.path, key, scale, "1 in this projection"));
            }
        }
        let second = self.keys.get(SECOND_PARALLEL).filter(|second| {
            *second != 0.0 && parallel.is_none_or(|parallel| (second * angle - parallel).abs() > 1e-9)
        });
        match second {
            Some(second) => Err(unknown(self.path, SECOND_PARALLEL, second, "0, or key 3078")),
            None => Ok(()),
        }
    }
}
