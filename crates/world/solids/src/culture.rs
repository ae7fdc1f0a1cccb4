//! Man-made things by name, made of convex parts.
//!
//! Body axes: x forward, y starboard, z up (m); the foot point is on the ground below the middle. Proportions
//! follow the vehicles and instruments of Apollo; shapes are simplified and our own. Parts may touch and sink
//! into one another.

mod flag;
mod lander;
mod marker;
mod package;
mod rover;

use glam::DVec3;

use crate::{Solid, SolidError};

/// Names of all models.
pub const NAMES: [&str; 5] = ["lander", "rover", "flag", "package", "marker"];

/// Convex parts of the model of that name, all in its body axes; nothing if there is none.
///
/// - `lander`: 7 m tall, 9.4 m across the pads, ladder forward.
/// - `rover`: 3.1 m long, wheels of 0.82 m, 2.3 m apart along and 1.83 m across.
/// - `flag`: on a pole of 2.4 m, the cloth to starboard.
/// - `package`: instruments with a mast and panels, within 3 m of the middle.
/// - `marker`: a pyramid of 1.6 m, light and dark sides.
pub fn model(name: &str) -> Option<Vec<Solid>> {
    let parts = match name {
        "lander" => lander::parts(),
        "rover" => rover::parts(),
        "flag" => flag::parts(),
        "package" => package::parts(),
        "marker" => marker::parts(),
        _ => return None,
    };
    parts.ok()
}

/// Parts, or why one of them is no solid.
type Parts = Result<Vec<Solid>, SolidError>;

fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// The box between two corners.
fn boxed(low: [f64; 3], high: [f64; 3], albedo: f64) -> Result<Solid, SolidError> {
    Solid::boxed(DVec3::from_array(low), DVec3::from_array(high), albedo)
}

/// A square strut between two points.
fn strut(from: [f64; 3], to: [f64; 3], width: f64, albedo: f64) -> Result<Solid, SolidError> {
    Solid::strut(DVec3::from_array(from), DVec3::from_array(to), width, albedo)
}

/// A prism or frustum about the axis between two points.
fn drum(ends: [[f64; 3]; 2], radii: [f64; 2], sides: u32, albedo: f64) -> Result<Solid, SolidError> {
    let axis = DVec3::from_array(ends[1]) - DVec3::from_array(ends[0]);
    let up = if axis.truncate().length() > 0.5 * axis.z.abs() { DVec3::Z } else { DVec3::X };
    Solid::prism(ends.map(DVec3::from_array), radii, up, sides, albedo)
}

/// A plate of some thickness (m) around a polygon.
fn plate(corners: &[[f64; 3]], thickness: f64, albedo: f64) -> Result<Solid, SolidError> {
    let corners = corners.iter().map(|&corner| DVec3::from_array(corner));
    let places: Vec<DVec3> = corners.collect();
    let normal = (places[1] - places[0]).cross(places[2] - places[0]).normalize_or_zero();
    let sides = [-0.5, 0.5].map(|side| normal * (side * thickness));
    let points: Vec<DVec3> =
        sides.iter().flat_map(|side| places.iter().map(move |place| *place + *side)).collect();
    Solid::hull(&points, albedo)
}

#[cfg(test)]
mod tests {
    use super::{NAMES, model};

    fn extent(name: &str) -> [[f64; 2]; 3] {
        let parts = model(name).unwrap();
        [0, 1, 2].map(|axis| {
            let along = parts.iter().flat_map(|part| part.vertices()).map(|vertex| vertex[axis]);
            [along.clone().fold(f64::INFINITY, f64::min), along.fold(f64::NEG_INFINITY, f64::max)]
        })
    }

    #[test]
    fn every_name_has_a_model_that_stands_on_the_ground() {
        for name in NAMES {
            let parts = model(name).unwrap_or_else(|| panic!("{name} has a part that is no solid"));
            assert!(parts.len() >= 2, "{name}");
            let [_, _, z] = extent(name);
            assert!((-0.3..=0.02).contains(&z[0]), "{name} stands at {}", z[0]);
        }
        assert_eq!(model("Lander"), None);
    }

    #[test]
    fn dimensions_are_those_of_the_real_things() {
        let length = |[low, high]: [f64; 2]| high - low;
        let near =
            |found: f64, expected: f64| assert!((found - expected).abs() < 0.03, "{found}, not {expected}");
        let [x, y, z] = extent("lander");
        near(length(x), 9.4);
        near(length(y), 9.4);
        near(z[1], 7.0);
        let [x, y, _] = extent("rover");
        near(length(x), 3.1);
        near(length(y), 1.83 + 0.3);
        near(extent("flag")[2][1], 2.4);
        near(extent("marker")[2][1], 1.6);
    }
}
