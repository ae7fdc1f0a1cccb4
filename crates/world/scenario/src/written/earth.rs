//! `[earth]`: the Earth in the sky.

use diagnostics::Reader;
use glam::DVec3;
use landscape::Sun;
use quantities::radians;

use super::effect_keys::has_none;
use crate::{EarthSeen, EarthWish};

/// Share of red, green and blue light that the Earth returns. Chosen: a blue tint about its geometric albedo of 0.43
/// (unsourced).
const ALBEDO: [f64; 3] = [0.38, 0.43, 0.54];

/// How wide the Earth is seen (degrees). Derived: 1.899 at its mean distance of 384 400 km, in two digits.
const DIAMETER: f64 = 1.9;

/// The Earth; of a mission that `is_dated` the date says where it is and how large.
pub(super) fn earth(table: &Reader, is_dated: bool) -> Option<EarthWish> {
    let albedo = table.f64_array::<3>("albedo").between(0.0, 1.0).default(ALBEDO);
    let keys = ["azimuth_deg", "elevation_deg", "diameter_deg"];
    if is_dated {
        keys.into_iter().for_each(|key| table.know(key));
        let reason = "beside `sun.at`: the date says where the Earth is, and how large";
        let is_alone = has_none(table, &keys, reason, "a date, or angles, and not both");
        return is_alone.then_some(EarthWish { seen: None, albedo: albedo? });
    }
    let degrees = |key: &str, most: f64| table.f64(key).between(-most, most).unit("degrees").map(radians);
    let (azimuth, elevation) =
        (degrees("azimuth_deg", 360.0).required(), degrees("elevation_deg", 90.0).required());
    let diameter = table.f64("diameter_deg").above(0.0).at_most(90.0).unit("degrees").default(DIAMETER);
    let direction = DVec3::from_array(Sun { azimuth: azimuth?, elevation: elevation? }.direction());
    let seen = Some(EarthSeen { direction, angular_diameter: radians(diameter?) });
    Some(EarthWish { seen, albedo: albedo? })
}
