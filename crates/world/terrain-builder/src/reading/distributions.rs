//! `kind = "craters"` and `kind = "boulders"`: items by density.

use diagnostics::Reader;

use super::features::{look, seed};
use super::{checked, range};
use crate::boulder::Boulder;
use crate::description::Kind;
use crate::distribution::Distribution;
use crate::frame::Frame;
use crate::refused::{Refused, expect};
use crate::size_law::SizeLaw;

/// Walls of craters of a distribution unless the file says otherwise, per cent of the radius (chosen).
const USUAL_WALL: [f64; 2] = [2.0, 6.0];
/// Depths of craters of a distribution unless the file says otherwise, per cent of the radius (chosen).
const USUAL_DEPTH: [f64; 2] = [10.0, 30.0];

/// Craters over a range.
pub fn craters(table: &Reader, frame: &Frame) -> Option<Kind> {
    let distribution = distribution(table, frame);
    let (wall, depth) =
        (shares(table, "wall_percent", USUAL_WALL), shares(table, "depth_percent", USUAL_DEPTH));
    Some(Kind::Craters { distribution: distribution?, wall: wall?, depth: depth? })
}

/// Boulders over a range.
pub fn boulders(table: &Reader, frame: &Frame) -> Option<Kind> {
    let (distribution, look) = (distribution(table, frame), look(table));
    let (distribution, look) = (distribution?, look?);
    checked(table, Boulder::new([0.0; 2], distribution.radius[1], look.shape, look.burial, [0, 0]))?;
    Some(Kind::Boulders { distribution, look })
}

fn distribution(table: &Reader, frame: &Frame) -> Option<Distribution> {
    let (longitude, latitude) = (range(table, "longitude_deg"), range(table, "latitude_deg"));
    let radius = table.f64_array::<2>("radius_m").required();
    let density = table.f64("density_per_km2").map(|per_km2| 1e-6 * per_km2).required();
    let power = table.f64("power").default(2.0);
    let is_power = table.one_of("sizes", &[("chi-squared", false), ("power-law", true)]).default(false);
    let (separation, seed) = (table.f64("min_separation_m").default(0.0), seed(table));
    let [west, east] = longitude?;
    let distribution = Distribution {
        seed: seed?,
        longitude: [west, if east < west { east + std::f64::consts::TAU } else { east }],
        latitude: latitude?,
        radius: radius?,
        sizes: if is_power? { SizeLaw::PowerLaw(power?) } else { SizeLaw::ChiSquared },
        density: density?,
        separation: separation?,
        is_even_in_angle: false,
    };
    checked(table, distribution.count(frame))?;
    Some(distribution)
}

/// Two shares of the radius from two numbers of per cent.
fn shares(table: &Reader, key: &'static str, usual: [f64; 2]) -> Option<[f64; 2]> {
    let [low, high] = table.f64_array::<2>(key).default(usual)?;
    let is_range = low >= 0.0 && high <= 100.0 && low <= high;
    let result: Result<(), Refused> =
        expect(is_range, key, format!("[{low}, {high}]"), "two numbers in ascending order, 0 to 100 %");
    checked(table, result)?;
    Some([0.01 * low, 0.01 * high])
}
