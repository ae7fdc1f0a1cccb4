//! Where the samples lie: the discipline dictionary for cartography.

use landscape::LUNOID_RADIUS;
use roxmltree::Node;

use super::label::{Label, text};
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;
use crate::read::label::{angles, length_of_sample, samples_of_angle};
use crate::read::map::{self, Kind, Map};
use crate::read::options::ReadOptions;
use crate::read::unit;

/// Longitudes of the origin, by the names that projections have for it.
const LONGITUDES: [&str; 2] = ["longitude_of_central_meridian", "straight_vertical_longitude_from_pole"];

/// Place and frame of samples in so many lines and columns.
pub fn place(
    label: &Label,
    options: &ReadOptions,
    size: [usize; 2],
    notes: &mut Vec<String>,
) -> Result<(Affine, Frame), SurveyError> {
    let Some(node) = label.cartography else {
        let affine = options.own_place(size[0]);
        let expected = "Cartography (or give --spacing-m METRES)";
        return affine.map(|affine| (affine, Frame::Plane(None))).ok_or_else(|| label.missing(expected));
    };
    options.expect_no_place()?;
    let cartography = Cartography { label, node, radius: radius(label, node, notes)? };
    match label.one(node, "map_projection_name")? {
        Some(name) => cartography.plane(name, notes),
        None => cartography.geographic(),
    }
}

/// The element of the place, and the radius of the body (m).
struct Cartography<'a, 'l> {
    label: &'l Label<'a>,
    node: Node<'a, 'a>,
    radius: f64,
}

impl Cartography<'_, '_> {
    /// A number above 0 that must be there.
    fn positive(&self, names: &[&str], factor: impl Fn(&str) -> Option<f64>) -> Result<f64, SurveyError> {
        let found = self.label.number_of(self.node, names, factor)?;
        found
            .filter(|number| *number > 0.0)
            .ok_or_else(|| self.label.missing(&format!("{} above 0", names[0])))
    }

    /// A grid of degrees, whose corner stands in the outline.
    fn geographic(&self) -> Result<(Affine, Frame), SurveyError> {
        let step = [
            self.positive(&["latitude_resolution"], any_case(angles))?,
            self.positive(&["longitude_resolution"], any_case(angles))?,
        ];
        let edge = |name: &'static str| {
            let found = self.label.number_of(self.node, &[name], any_case(angles))?;
            found.ok_or_else(|| self.label.missing(name))
        };
        let corner = [edge("north_bounding_coordinate")?, edge("west_bounding_coordinate")?];
        let first = [corner[0] - 0.5 * step[0], corner[1] + 0.5 * step[1]];
        Ok((Affine { first, step: [-step[0], step[1]] }, Frame::Geographic { radius: self.radius }))
    }

    /// A grid of metres on a map.
    fn plane(&self, name: Node, notes: &mut Vec<String>) -> Result<(Affine, Frame), SurveyError> {
        let step = [self.step("y")?, self.step("x")?];
        let corner = |name: &'static str| {
            let found = self.label.number_of(self.node, &[name], length)?;
            found.ok_or_else(|| self.label.missing(name))
        };
        let corner = [corner("upperleft_corner_y")?, corner("upperleft_corner_x")?];
        let affine = Affine {
            first: [corner[0] - 0.5 * step[0], corner[1] + 0.5 * step[1]],
            step: [-step[0], step[1]],
        };
        let kind = Kind::named(text(name));
        let map = kind.map(|kind| Ok::<_, SurveyError>((self.map()?, kind))).transpose()?;
        let projection = map.and_then(|(map, kind)| map.projection(kind));
        if projection.is_none() {
            notes.push(map::unknown(text(name)));
        }
        Ok((affine, Frame::Plane(projection)))
    }

    /// Length of a sample along an axis (m); samples a degree are those along a great circle.
    fn step(&self, axis: &str) -> Result<f64, SurveyError> {
        let (resolution, scale) = (format!("pixel_resolution_{axis}"), format!("pixel_scale_{axis}"));
        let length = |unit: &str| any_case(length_of_sample)(if unit.is_empty() { "m/pixel" } else { unit });
        let (resolution, scale) =
            ([resolution.as_str(), "pixel_resolution"], [scale.as_str(), "pixel_scale", resolution.as_str()]);
        let Some(found) = self.label.any(self.node, &resolution)? else {
            return Ok(self.radius / self.positive(&scale, any_case(samples_of_angle))?);
        };
        let step = Some(self.label.number(found, length)?).filter(|step| *step > 0.0);
        let step = step.ok_or_else(|| self.label.wrong(found, "a length above 0"))?;
        let by_scale = self.label.number_of(self.node, &scale[..2], any_case(samples_of_angle))?;
        match by_scale.filter(|scale| map::contradict(self.radius / scale, step)) {
            Some(_) => Err(self.label.wrong(found, "the length of a sample that pixel_scale says")),
            None => Ok(step),
        }
    }

    fn map(&self) -> Result<Map, SurveyError> {
        let number = |names: &[&str], unit: fn(&str) -> Option<f64>| {
            self.label.number_of(self.node, names, any_case(unit))
        };
        let parallel = number(&["standard_parallel_1"], angles)?;
        if let Some(second) = self.label.one(self.node, "standard_parallel_2")? {
            let angle = self.label.number(second, any_case(angles))?;
            if parallel.is_none_or(|first| (first - angle).abs() > 1e-9) {
                return Err(self.label.wrong(second, "standard_parallel_1"));
            }
        }
        if let Some(along) = self.label.one(self.node, "scale_factor_at_central_meridian")?
            && self.label.number(along, pure)? != 1.0
        {
            return Err(self.label.wrong(along, "1 in this projection"));
        }
        Ok(Map {
            latitude: number(&["latitude_of_projection_origin"], angles)?,
            longitude: number(&LONGITUDES, angles)?.unwrap_or(0.0),
            parallel,
            scale: number(&["scale_factor_at_projection_origin"], pure)?.unwrap_or(1.0),
            radius: self.radius,
            offset: [
                self.label.number_of(self.node, &["false_northing"], length)?.unwrap_or(0.0),
                self.label.number_of(self.node, &["false_easting"], length)?.unwrap_or(0.0),
            ],
        })
    }
}

/// A unit of the dictionary in any case.
fn any_case(factor: impl Fn(&str) -> Option<f64>) -> impl Fn(&str) -> Option<f64> {
    move |unit| factor(&unit.to_ascii_uppercase())
}

/// Metres of a unit of length; metres without a unit.
fn length(unit: &str) -> Option<f64> {
    if unit.is_empty() { Some(1.0) } else { unit::length(unit) }
}

/// A number without a unit.
fn pure(unit: &str) -> Option<f64> {
    unit.is_empty().then_some(1.0)
}

/// Radius of the sphere (m): the longest axis. Notes tell of an ellipsoid, and of a radius that is assumed.
fn radius<'a>(label: &Label<'a>, node: Node<'a, 'a>, notes: &mut Vec<String>) -> Result<f64, SurveyError> {
    let axis = |names: [&str; 2]| label.number_of(node, &names, length);
    let Some(radius) = axis(["a_axis_radius", "semi_major_radius"])? else {
        notes.push(format!("the label does not name the radius of its body: {LUNOID_RADIUS} m is assumed"));
        return Ok(LUNOID_RADIUS);
    };
    if radius <= 0.0 {
        return Err(label.missing("a_axis_radius above 0"));
    }
    for names in [["b_axis_radius", "semi_minor_radius"], ["c_axis_radius", "polar_radius"]] {
        let note = axis(names)?.and_then(|other| map::flattened(radius, other));
        notes.extend(note.filter(|note| !notes.contains(note)));
    }
    Ok(radius)
}
