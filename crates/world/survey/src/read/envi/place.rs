//! Where the samples of an ENVI file lie: `map info`, and the coordinate system as well-known text.

use landscape::LUNOID_RADIUS;

use super::header::Header;
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;
use crate::read::earth;
use crate::read::options::ReadOptions;
use crate::read::unit;
use crate::read::wkt::System;
use crate::read::words::Decider;

/// Key of the place.
const MAP_INFO: &str = "map info";
/// Key of the coordinate system.
const SYSTEM: &str = "coordinate system string";

/// Place and frame of samples in so many lines and columns.
pub fn place(
    header: &Header,
    options: &ReadOptions,
    size: [usize; 2],
    decider: &mut Decider,
    notes: &mut Vec<String>,
) -> Result<(Affine, Frame), SurveyError> {
    let system = match header.get(SYSTEM).filter(|text| !text.is_empty()) {
        Some(text) => Some(System::of(header.path, SYSTEM, text, decider)?),
        None => None,
    };
    let Some(info) = header.list(MAP_INFO) else {
        let affine = options.own_place(size[0]);
        let missing = "map info (or give --spacing-m METRES)";
        return affine.map(|affine| (affine, Frame::Plane(None))).ok_or_else(|| header.missing(missing));
    };
    options.expect_no_place()?;
    let grid = grid(header, &info)?;
    let unit = words_behind(header, &info)?;
    let is_geographic = info[0].eq_ignore_ascii_case("Geographic Lat/Lon");
    if let Some(system) = system {
        let (affine, frame) = system.place(grid, notes)?;
        if is_geographic != matches!(frame, Frame::Geographic { .. }) {
            return Err(header.wrong(MAP_INFO, "the kind of coordinates that coordinate system string has"));
        }
        let own = system.unit_of_map()?;
        if let (Some(unit), Some(own)) = (unit, own)
            && (unit / own - 1.0).abs() > unit::ALIKE
        {
            return Err(header.wrong(MAP_INFO, "the unit that coordinate system string has"));
        }
        return Ok((affine, frame));
    }
    if is_geographic {
        let radius = radius(header, &info, notes)?;
        let degree = |value: f64| quantities::radians(value);
        let affine = Affine { first: grid.first.map(degree), step: grid.step.map(degree) };
        return Ok((affine, Frame::Geographic { radius }));
    }
    if unit.is_none() {
        notes.push("the header does not name the unit of its map: metres are assumed".into());
    }
    notes.push(format!("{} without a coordinate system: its metres are taken as they are", info[0]));
    let scaled = |value: f64| value * unit.unwrap_or(1.0);
    Ok((Affine { first: grid.first.map(scaled), step: grid.step.map(scaled) }, Frame::Plane(None)))
}

/// Centre of the first sample and steps in units of the map. The reference is a place in the image that counts from 1, at the
/// corner of the first sample.
fn grid(header: &Header, info: &[&str]) -> Result<Affine, SurveyError> {
    let expected = "a name, a place in the image, easting, northing, and two sizes of a sample above 0";
    let number = |at: usize| {
        let number =
            info.get(at).and_then(|text| text.parse::<f64>().ok()).filter(|number| number.is_finite());
        number.ok_or_else(|| header.wrong(MAP_INFO, expected))
    };
    let (reference, corner) = ([number(2)?, number(1)?], [number(4)?, number(3)?]);
    let (north, east) = (number(6)?, number(5)?);
    if !(north > 0.0 && east > 0.0) {
        return Err(header.wrong(MAP_INFO, expected));
    }
    let step = [-north, east];
    Ok(Affine { first: [0, 1].map(|k| corner[k] + (1.5 - reference[k]) * step[k]), step })
}

/// Radius of the body (m): of the Earth for its data, as the word behind the numbers of `map info` names them; else of the Moon.
fn radius(header: &Header, info: &[&str], notes: &mut Vec<String>) -> Result<f64, SurveyError> {
    let datum = info.iter().skip(7).find(|word| !word.contains('=')).map_or("", |word| word.trim());
    let letters: String = datum.chars().filter(char::is_ascii_alphabetic).collect();
    let begins = |names: &[&str]| names.iter().any(|name| letters.to_ascii_lowercase().starts_with(name));
    if begins(&["wgs", "nad", "northamerica", "etrs", "itrf", "european", "ed"]) {
        notes.push(format!("{datum} is a datum of the Earth, not of the Moon"));
        notes.push(earth::note());
        return Ok(earth::RADIUS);
    }
    if !(datum.is_empty() || begins(&["moon", "dmoon", "lunar", "unknown", "dunknown", "arbitrary"])) {
        let expected = "WGS-84 or another datum of the Earth, one of the Moon, or none, beside a coordinate system string";
        return Err(header.wrong(MAP_INFO, expected));
    }
    notes.push(format!("the header does not name the radius of its body: {LUNOID_RADIUS} m is assumed"));
    Ok(LUNOID_RADIUS)
}

/// Metres of the unit that stands behind the numbers of `map info`, if there is one; a rotation is refused.
fn words_behind(header: &Header, info: &[&str]) -> Result<Option<f64>, SurveyError> {
    let mut metres = None;
    for word in info.iter().skip(7) {
        let Some((key, value)) = word.split_once('=') else { continue };
        match key.trim().to_ascii_lowercase().as_str() {
            "units" if value.trim().eq_ignore_ascii_case("degrees") => {}
            "units" => {
                let found = unit::length(value);
                metres = Some(found.ok_or_else(|| header.wrong(MAP_INFO, "units that are known here"))?);
            }
            "rotation" if value.trim().parse() == Ok(0.0) => {}
            "rotation" => return Err(header.wrong(MAP_INFO, "rotation=0: turn it north up with gdalwarp")),
            _ => return Err(header.wrong(MAP_INFO, "units= and rotation= only")),
        }
    }
    Ok(metres)
}
