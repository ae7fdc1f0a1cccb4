//! Where the samples lie: object IMAGE_MAP_PROJECTION.

use landscape::LUNOID_RADIUS;
use quantities::radians;

use super::Label;
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;
use crate::projection::{Method, Projection};
use crate::read::ReadOptions;

const MAP: &str = "IMAGE_MAP_PROJECTION";

/// Place and frame of the samples. The label counts pixels from 1 with centres at whole numbers; its projection
/// offsets count from the first pixel.
pub fn place(
    label: &Label,
    options: &ReadOptions,
    lines: usize,
    notes: &mut Vec<String>,
) -> Result<(Affine, Frame), SurveyError> {
    let Some(kind) = label.find(MAP, "MAP_PROJECTION_TYPE") else {
        let place = options.own_place(lines);
        let expected = "MAP_PROJECTION_TYPE (or give --spacing-m METRES)";
        return place.map(|affine| (affine, Frame::Plane(None))).ok_or_else(|| label.missing(expected));
    };
    options.expect_no_place()?;
    let needed = |keyword: &str| label.number(MAP, keyword)?.ok_or_else(|| label.missing(keyword));
    let offset = [needed("LINE_PROJECTION_OFFSET")?.0, needed("SAMPLE_PROJECTION_OFFSET")?.0];
    let angle = |keyword: &str| Ok::<_, SurveyError>(label.plain_number(MAP, keyword)?.map(radians));
    let longitude = angle("CENTER_LONGITUDE")?.unwrap_or(0.0);
    let latitude = angle("CENTER_LATITUDE")?.unwrap_or(0.0);
    let east_is_positive = label.text(MAP, "POSITIVE_LONGITUDE_DIRECTION").is_none_or(|east| east == "EAST");
    if !east_is_positive {
        let statement = label.find(MAP, "POSITIVE_LONGITUDE_DIRECTION").unwrap_or(kind);
        return Err(label.wrong(statement, "EAST"));
    }
    let radius = radius(label)?;
    let name = label.text(MAP, "MAP_PROJECTION_TYPE").unwrap_or_default().to_ascii_uppercase();
    let method = match name.as_str() {
        "SIMPLE CYLINDRICAL" | "SIMPLE_CYLINDRICAL" => {
            let (resolution, _) = needed("MAP_RESOLUTION")?;
            let step = radians(1.0 / positive(label, "MAP_RESOLUTION", resolution)?);
            let first = [latitude + offset[0] * step, longitude - offset[1] * step];
            let affine = Affine { first, step: [-step, step] };
            compare_edges(label, &affine, notes)?;
            return Ok((affine, Frame::Geographic { radius }));
        }
        "EQUIRECTANGULAR" => Method::Equirectangular { parallel: latitude },
        "POLAR STEREOGRAPHIC" | "POLAR_STEREOGRAPHIC" => Method::PolarStereographic { scale: 1.0 },
        _ => return Err(label.wrong(kind, "SIMPLE CYLINDRICAL, EQUIRECTANGULAR or POLAR STEREOGRAPHIC")),
    };
    let (scale, unit) = needed("MAP_SCALE")?;
    let scale = positive(label, "MAP_SCALE", scale)? * if unit.starts_with("K") { 1000.0 } else { 1.0 };
    // Lines of an equirectangular map count from the equator, whatever parallel is true to scale.
    let latitude = if method == (Method::PolarStereographic { scale: 1.0 }) { latitude } else { 0.0 };
    let projection = Projection { method, latitude, longitude, radius, offset: [0.0; 2] };
    let affine = Affine { first: [offset[0] * scale, -offset[1] * scale], step: [-scale, scale] };
    Ok((affine, Frame::Plane(Some(projection))))
}

fn positive(label: &Label, keyword: &str, value: f64) -> Result<f64, SurveyError> {
    let wrong =
        || label.find(MAP, keyword).map_or_else(|| label.missing(keyword), |s| label.wrong(s, "above 0"));
    if value > 0.0 { Ok(value) } else { Err(wrong()) }
}

/// Radius in metres; labels give kilometres, with or without saying so.
fn radius(label: &Label) -> Result<f64, SurveyError> {
    let Some((radius, unit)) = label.number(MAP, "A_AXIS_RADIUS")? else { return Ok(LUNOID_RADIUS) };
    let in_metres = unit == "M" || unit == "METER" || unit == "METERS";
    positive(label, "A_AXIS_RADIUS", if in_metres { radius } else { 1000.0 * radius })
}

/// Tells if the edges that the label states are not those of the offsets.
fn compare_edges(label: &Label, affine: &Affine, notes: &mut Vec<String>) -> Result<(), SurveyError> {
    let edges = [("MAXIMUM_LATITUDE", 0), ("WESTERNMOST_LONGITUDE", 1)];
    for (keyword, axis) in edges {
        let Some(stated) = label.plain_number(MAP, keyword)? else { continue };
        let found = affine.first[axis] - 0.5 * affine.step[axis];
        let apart = (found - radians(stated)) / affine.step[axis];
        let turn = radians(360.0) / affine.step[axis].abs();
        let apart = apart - turn * (apart / turn).round();
        if apart.abs() > 0.6 {
            notes.push(format!(
                "{keyword} of the label is {apart:.2} samples from its projection offsets, which are used"
            ));
        }
    }
    Ok(())
}
