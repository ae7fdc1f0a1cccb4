//! Ground and vehicle as they stand in the record.

use landscape::relief::Relief;
use landscape::{Landscape, Sun, bank_file};
use quantities::degrees;
use scenario::{Ground, Scenario, Vehicle};
use serde::Serialize;
use serde_json::{Value, json};

/// The ground of a run: where it came from, and the hash of its words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroundRecord {
    source: &'static str,
    title: String,
    content_blake3: String,
    albedo: f64,
    levels: Vec<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    generator: Option<Value>,
}

impl GroundRecord {
    /// The record of `landscape`; `ground` says where it came from.
    pub fn new(ground: &Ground, landscape: &Landscape) -> Self {
        let bank = landscape.bank();
        let (source, generator) = match ground {
            Ground::Bank(_) => ("bank", None),
            Ground::Generated(relief) => ("generated", Some(generated(relief))),
        };
        let level = |level: &landscape::Level| json!({ "region_size_m": level.region_size(), "origin_m": level.origin(), "corners": level.corners() });
        Self {
            source,
            title: bank.title().into(),
            content_blake3: bank_file::content_hash(bank).iter().map(|byte| format!("{byte:02x}")).collect(),
            albedo: landscape.albedo(),
            levels: bank.levels().iter().map(level).collect(),
            generator,
        }
    }
}

/// Parameters of a generated landscape, in the keys of a scenario file.
fn generated(relief: &Relief) -> Value {
    let undulation = relief.undulation.as_ref().map(|part| {
        json!({ "rms_height_m": part.rms_height, "hurst": part.hurst, "longest_m": part.longest,
                "shortest_m": part.shortest, "waves": part.waves })
    });
    let craters = relief.craters.as_ref().map(|part| {
        json!({ "smallest_radius_m": part.smallest_radius, "largest_radius_m": part.largest_radius,
                "density": part.density, "subdued_depth_ratio": part.subdued,
                "fresh_depth_ratio": part.fresh })
    });
    let massifs: Vec<Value> = relief
        .massifs
        .iter()
        .map(|part| {
            json!({ "at_m": part.at, "height_m": part.height, "radius_m": part.radius,
                    "detail_m": part.detail, "ruggedness": part.ruggedness })
        })
        .collect();
    let rilles: Vec<Value> = relief
        .rilles
        .iter()
        .map(|part| {
            let meander =
                part.meander.as_ref().map(|bend| json!({ "swing_m": bend.swing, "length_m": bend.length }));
            json!({ "through_m": part.through, "azimuth_deg": degrees(part.azimuth), "width_m": part.width,
                    "depth_m": part.depth, "meander": meander })
        })
        .collect();
    json!({ "seed": relief.seed, "extent_m": relief.extent, "region_size_m": relief.region_size,
            "tilt_m_per_m": relief.tilt, "undulation": undulation, "craters": craters,
            "massif": massifs, "rille": rilles })
}

/// Direction of the light.
pub(crate) fn sun(sun: &Sun) -> Value {
    json!({ "azimuth_deg": degrees(sun.azimuth), "elevation_deg": degrees(sun.elevation) })
}

/// Size and limits of the vehicle.
pub(crate) fn vehicle(vehicle: &Vehicle) -> Value {
    json!({
        "eye_height_m": vehicle.eye_height,
        "wheelbase_m": vehicle.wheelbase,
        "track_m": vehicle.track,
        "max_speed_m_s": vehicle.max_speed,
        "max_turn_deg_s": degrees(vehicle.max_turn),
        "max_slope_deg": degrees(vehicle.max_slope),
    })
}

/// BLAKE3 of the waypoints: two paths with this hash are the same path.
pub(crate) fn waypoints_hash(scenario: &Scenario) -> String {
    let mut hasher = blake3::Hasher::new();
    for waypoint in scenario.path.waypoints() {
        for value in [waypoint.time, waypoint.at[0], waypoint.at[1]] {
            hasher.update(&value.to_le_bytes());
        }
        for value in [waypoint.heading, waypoint.eye_height, waypoint.pitch, waypoint.roll] {
            // No number is NaN, so NaN can stand for "open".
            hasher.update(&value.unwrap_or(f64::NAN).to_le_bytes());
        }
    }
    hasher.finalize().to_hex().to_string()
}
