//! Where the samples lie: object IMAGE_MAP_PROJECTION.

use landscape::LUNOID_RADIUS;
use quantities::radians;

use super::MAP;
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;
use crate::read::label::{Label, angles, kilometres, length_of_sample, pieces, samples_of_angle};
use crate::read::map::contradict;
use crate::read::options::ReadOptions;
use landscape::projection::{Method, Projection};

/// Place and frame of the samples. The label counts pixels from 1 with centres at whole numbers; its projection
/// offsets count from the first pixel.
pub fn place(
    label: &Label,
    options: &ReadOptions,
    size: [usize; 2],
    notes: &mut Vec<String>,
) -> Result<(Affine, Frame), SurveyError> {
    let Some(kind) = label.find(MAP, "MAP_PROJECTION_TYPE") else {
        let place = options.own_place(size[0]);
        let expected = "MAP_PROJECTION_TYPE (or give --spacing-m METRES)";
        return place.map(|affine| (affine, Frame::Plane(None))).ok_or_else(|| label.missing(expected));
    };
    options.expect_no_place()?;
    let map = Map::of(label)?;
    map.tell(label, size, notes)?;
    let name = label.text(MAP, "MAP_PROJECTION_TYPE")?.unwrap_or_default().to_ascii_uppercase();
    match name.replace('_', " ").as_str() {
        "SIMPLE CYLINDRICAL" => map.geographic(label, notes),
        "EQUIRECTANGULAR" => {
            // Lines of an equirectangular map count from the equator, whatever parallel is true to scale.
            map.plane(label, Method::Equirectangular { parallel: map.latitude }, 0.0)
        }
        "POLAR STEREOGRAPHIC" => {
            map.at_a_pole(label)?;
            map.plane(label, Method::PolarStereographic { scale: 1.0 }, map.latitude)
        }
        _ => Err(label.wrong(kind, "SIMPLE CYLINDRICAL, EQUIRECTANGULAR or POLAR STEREOGRAPHIC")),
    }
}

/// What a label says about its map, in metres and radians.
struct Map {
    /// Lines and samples from the first to the origin.
    offset: [f64; 2],
    latitude: f64,
    longitude: f64,
    radius: f64,
    /// Length of a sample (m).
    scale: Option<f64>,
    /// Number of samples a radian.
    resolution: Option<f64>,
}

impl Map {
    fn of(label: &Label) -> Result<Self, SurveyError> {
        let offset =
            |keyword: &str| label.number(MAP, keyword, pieces)?.ok_or_else(|| label.missing(keyword));
        let angle = |keyword: &str| Ok::<_, SurveyError>(label.number(MAP, keyword, angles)?.unwrap_or(0.0));
        let map = Self {
            offset: [offset("LINE_PROJECTION_OFFSET")?, offset("SAMPLE_PROJECTION_OFFSET")?],
            latitude: angle("CENTER_LATITUDE")?,
            longitude: angle("CENTER_LONGITUDE")?,
            radius: label.positive(MAP, "A_AXIS_RADIUS", kilometres)?.unwrap_or(LUNOID_RADIUS),
            scale: label.positive(MAP, "MAP_SCALE", length_of_sample)?,
            resolution: label.positive(MAP, "MAP_RESOLUTION", samples_of_angle)?,
        };
        map.expect_one_parallel(label)?;
        map.expect_one_length(label)?;
        Ok(map)
    }

    /// A sample has one length by its scale and by its resolution.
    fn expect_one_length(&self, label: &Label) -> Result<(), SurveyError> {
        let (Some(scale), Some(resolution)) = (self.scale, self.resolution) else { return Ok(()) };
        let length = self.radius / resolution;
        match label.find(MAP, "MAP_SCALE").filter(|_| contradict(scale, length)) {
            Some(statement) => {
                Err(label.wrong(statement, &format!("{length:.3} <M/PIXEL>, as MAP_RESOLUTION says")))
            }
            None => Ok(()),
        }
    }

    /// The parallel that is true to scale has one latitude.
    fn expect_one_parallel(&self, label: &Label) -> Result<(), SurveyError> {
        for keyword in ["FIRST_STANDARD_PARALLEL", "SECOND_STANDARD_PARALLEL"] {
            let parallel = label.number(MAP, keyword, angles)?;
            let differs = parallel.is_some_and(|parallel| (parallel - self.latitude).abs() > 1e-9);
            if let Some(statement) = label.find(MAP, keyword).filter(|_| differs) {
                return Err(label.wrong(statement, "N/A, or CENTER_LATITUDE"));
            }
        }
        Ok(())
    }

    fn at_a_pole(&self, label: &Label) -> Result<(), SurveyError> {
        match label.find(MAP, "CENTER_LATITUDE") {
            Some(_) if (self.latitude.abs() - radians(90.0)).abs() < 1e-9 => Ok(()),
            Some(statement) => Err(label.wrong(statement, "90 or -90 <DEG> in a polar projection")),
            None => Err(label.missing("CENTER_LATITUDE")),
        }
    }

    fn geographic(&self, label: &Label, notes: &mut Vec<String>) -> Result<(Affine, Frame), SurveyError> {
        let step = 1.0 / self.resolution.ok_or_else(|| label.missing("MAP_RESOLUTION"))?;
        let first = [self.latitude + self.offset[0] * step, self.longitude - self.offset[1] * step];
        let affine = Affine { first, step: [-step, step] };
        compare_edges(label, &affine, notes)?;
        Ok((affine, Frame::Geographic { radius: self.radius }))
    }

    fn plane(&self, label: &Label, method: Method, latitude: f64) -> Result<(Affine, Frame), SurveyError> {
        let scale = self.scale.ok_or_else(|| label.missing("MAP_SCALE"))?;
        let projection =
            Projection { method, latitude, longitude: self.longitude, radius: self.radius, offset: [0.0; 2] };
        let affine =
            Affine { first: [self.offset[0] * scale, -self.offset[1] * scale], step: [-scale, scale] };
        Ok((affine, Frame::Plane(Some(projection))))
    }

    /// Notes on statements that do not go with the others, or that say more than is used.
    fn tell(&self, label: &Label, size: [usize; 2], notes: &mut Vec<String>) -> Result<(), SurveyError> {
        if label.find(MAP, "A_AXIS_RADIUS").is_none() {
            notes.push(format!(
                "the label does not name the radius of its body: {LUNOID_RADIUS} m is assumed"
            ));
        }
        for keyword in ["B_AXIS_RADIUS", "C_AXIS_RADIUS"] {
            let axis = label.positive(MAP, keyword, kilometres)?;
            if let Some(axis) = axis.filter(|axis| (axis / self.radius - 1.0).abs() > 1e-6) {
                let radius = self.radius;
                notes.push(format!("{keyword} is {axis} m: a sphere of {radius} m stands for the ellipsoid"));
            }
        }
        for (keyword, held) in [("LINE_LAST_PIXEL", size[0]), ("SAMPLE_LAST_PIXEL", size[1])] {
            let last = label.count(MAP, keyword)?;
            if let Some(last) = last.filter(|last| *last != held as u64) {
                notes.push(format!("{keyword} is {last}, but the image has {held}"));
            }
        }
        let system = label.text(MAP, "COORDINATE_SYSTEM_NAME")?.unwrap_or("PLANETOCENTRIC");
        if !["MEAN EARTH", "PLANETOCENTRIC", "PLANETOGRAPHIC"].iter().any(|known| has(system, known)) {
            notes.push(format!(
                "COORDINATE_SYSTEM_NAME is {system}: its places are taken as those of the mean Earth system"
            ));
        }
        Ok(())
    }
}

fn has(text: &str, part: &str) -> bool {
    text.to_ascii_uppercase().contains(part)
}

/// Tells if the edges that the label states are not those of the offsets.
fn compare_edges(label: &Label, affine: &Affine, notes: &mut Vec<String>) -> Result<(), SurveyError> {
    let edges = [("MAXIMUM_LATITUDE", 0), ("WESTERNMOST_LONGITUDE", 1)];
    for (keyword, axis) in edges {
        let Some(stated) = label.number(MAP, keyword, angles)? else { continue };
        let found = affine.first[axis] - 0.5 * affine.step[axis];
        let apart = (found - stated) / affine.step[axis];
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
