//! Where the samples of a cube lie: group Mapping.

use landscape::LUNOID_RADIUS;

use super::MAPPING;
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;
use crate::read::label::{Label, angles, length_of_sample, plain, samples_of_angle};
use crate::read::map::{self, Kind, Map};
use crate::read::options::ReadOptions;
use crate::read::unit;

/// Place and frame of samples in so many lines. The corner is that of the first sample, in metres of the map.
pub fn place(
    label: &Label,
    options: &ReadOptions,
    lines: usize,
    notes: &mut Vec<String>,
) -> Result<(Affine, Frame), SurveyError> {
    let Some(name) = label.text(MAPPING, "PROJECTIONNAME")? else {
        let affine = options.own_place(lines);
        let missing = "PROJECTIONNAME (or give --spacing-m METRES)";
        return affine.map(|affine| (affine, Frame::Plane(None))).ok_or_else(|| label.missing(missing));
    };
    options.expect_no_place()?;
    let radius = radius(label, notes)?;
    let corner = |keyword: &str| {
        let found = label.number(MAPPING, keyword, metres)?;
        found.ok_or_else(|| label.missing(keyword))
    };
    let corner = [corner("UPPERLEFTCORNERY")?, corner("UPPERLEFTCORNERX")?];
    let step = step(label, radius)?;
    let affine = Affine { first: [corner[0] - 0.5 * step, corner[1] + 0.5 * step], step: [-step, step] };
    let map = match Kind::named(name) {
        Some(kind) => map(label, kind, name, radius)?.projection(kind),
        None => None,
    };
    if map.is_none() {
        notes.push(map::unknown(name));
    }
    Ok((affine, Frame::Plane(map)))
}

/// Metres of a unit of length; metres without a unit.
fn metres(unit: &str) -> Option<f64> {
    if unit.is_empty() { Some(1.0) } else { unit::length(unit) }
}

/// Length of a sample (m). Samples a degree, where the label has them, must go with it.
fn step(label: &Label, radius: f64) -> Result<f64, SurveyError> {
    let length = |unit: &str| length_of_sample(if unit.is_empty() { "M/PIXEL" } else { unit });
    let by_scale = label.positive(MAPPING, "SCALE", samples_of_angle)?.map(|scale| radius / scale);
    let step = label.positive(MAPPING, "PIXELRESOLUTION", length)?.or(by_scale);
    let step = step.ok_or_else(|| label.missing("PIXELRESOLUTION"))?;
    match label.find(MAPPING, "SCALE").filter(|_| by_scale.is_some_and(|other| map::contradict(other, step)))
    {
        Some(statement) => {
            let scale = radius / step * quantities::radians(1.0);
            Err(label.wrong(statement, &format!("{scale:.3} <PIXEL/DEGREE>, as PixelResolution says")))
        }
        None => Ok(step),
    }
}

/// Radius of the sphere (m): that at the centre of the map where the label gives it. Notes tell of an ellipsoid.
fn radius(label: &Label, notes: &mut Vec<String>) -> Result<f64, SurveyError> {
    let equatorial = label.positive(MAPPING, "EQUATORIALRADIUS", metres)?;
    let central = label.positive(MAPPING, "CENTERLATITUDERADIUS", metres)?;
    let Some(radius) = equatorial.or(central) else {
        notes.push(format!("the label does not name the radius of its body: {LUNOID_RADIUS} m is assumed"));
        return Ok(LUNOID_RADIUS);
    };
    let polar = label.positive(MAPPING, "POLARRADIUS", metres)?;
    notes.extend(polar.and_then(|polar| map::flattened(radius, polar)));
    Ok(central.unwrap_or(radius))
}

/// The map of a known kind. Those of ISIS have their origin at the equator, at a pole, or in the centre.
fn map(label: &Label, kind: Kind, name: &str, radius: f64) -> Result<Map, SurveyError> {
    let angle = |keyword: &str| label.number(MAPPING, keyword, angles);
    let centre = angle("CENTERLATITUDE")?.unwrap_or(0.0);
    let is_simple = name.replace(' ', "").eq_ignore_ascii_case("SimpleCylindrical");
    let [latitude, parallel] = match kind {
        Kind::Equirectangular if is_simple => [0.0, 0.0],
        Kind::Equirectangular => [0.0, centre],
        _ => [centre, centre],
    };
    let scale = label.positive(MAPPING, "SCALEFACTOR", plain)?.unwrap_or(1.0);
    if let Some(statement) = label.find(MAPPING, "SCALEFACTOR")
        && scale != 1.0
        && kind != Kind::Polar
    {
        return Err(label.wrong(statement, "1 in this map"));
    }
    Ok(Map {
        latitude: Some(latitude),
        longitude: angle("CENTERLONGITUDE")?.unwrap_or(0.0),
        parallel: Some(parallel),
        scale,
        radius,
        offset: [0.0; 2],
    })
}
