//! Light, vehicle and path of a run.

use landscape::Sun;
use quantities::degrees;
use scenario::{HeightOver, Limit, LimitReport, Path, Vehicle};
use serde::{Deserialize, Serialize};

/// Direction of the light.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SunRecord {
    /// Azimuth (deg), clockwise from north.
    pub azimuth_deg: f64,
    /// Elevation above the horizontal (deg).
    pub elevation_deg: f64,
}

impl From<&Sun> for SunRecord {
    fn from(sun: &Sun) -> Self {
        Self { azimuth_deg: degrees(sun.azimuth), elevation_deg: degrees(sun.elevation) }
    }
}

/// Size and limits of the vehicle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct VehicleRecord {
    /// Height of the eye above the ground (m).
    pub eye_height_m: f64,
    /// Distance of the axles (m).
    pub wheelbase_m: f64,
    /// Distance of the wheels of an axle (m).
    pub track_m: f64,
    /// Largest speed of the vehicle (m/s).
    pub max_speed_m_s: f64,
    /// Largest rate of turn (deg/s).
    pub max_turn_deg_s: f64,
    /// Steepest ground that the vehicle can take (deg).
    pub max_slope_deg: f64,
}

impl From<&Vehicle> for VehicleRecord {
    fn from(vehicle: &Vehicle) -> Self {
        Self {
            eye_height_m: vehicle.eye_height,
            wheelbase_m: vehicle.wheelbase,
            track_m: vehicle.track,
            max_speed_m_s: vehicle.max_speed,
            max_turn_deg_s: degrees(vehicle.max_turn),
            max_slope_deg: degrees(vehicle.max_slope),
        }
    }
}

/// The path of the vehicle.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PathRecord {
    /// How many waypoints it has.
    pub waypoints: usize,
    /// BLAKE3 of the waypoints, hexadecimal: two paths with this hash are the same path.
    pub waypoints_blake3: String,
}

impl From<&Path> for PathRecord {
    fn from(path: &Path) -> Self {
        Self { waypoints: path.waypoints().len(), waypoints_blake3: waypoints_hash(path) }
    }
}

fn waypoints_hash(path: &Path) -> String {
    let mut hasher = blake3::Hasher::new();
    for waypoint in path.waypoints() {
        for value in [waypoint.time, waypoint.at[0], waypoint.at[1]] {
            hasher.update(&value.to_le_bytes());
        }
        for value in [waypoint.heading, waypoint.eye_height, waypoint.pitch, waypoint.roll] {
            // No number is NaN, so NaN can stand for "open".
            hasher.update(&value.unwrap_or(f64::NAN).to_le_bytes());
        }
    }
    // Heights over the datum were all there was when the first records were written.
    if path.height_over() == HeightOver::Ground {
        hasher.update(b"over the ground");
    }
    hasher.finalize().to_hex().to_string()
}

/// A stretch of frames in which the vehicle does more than it can.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LimitRecord {
    /// "speed", "turn" or "slope".
    pub limit: String,
    /// Unit of the numbers.
    pub unit: String,
    /// Largest value that is allowed.
    pub allowed: f64,
    /// The largest value found.
    pub found: f64,
    /// Frame of that value.
    pub frame: u64,
    /// Time of that frame (s).
    pub time_s: f64,
    /// First frame of the stretch, and the frame behind its last.
    pub frames: [u64; 2],
}

impl From<&LimitReport> for LimitRecord {
    fn from(report: &LimitReport) -> Self {
        let (limit, unit, scale): (_, _, fn(f64) -> f64) = match report.what {
            Limit::Speed => ("speed", "m/s", |speed| speed),
            Limit::Turn => ("turn", "deg/s", degrees),
            Limit::Slope => ("slope", "deg", degrees),
        };
        Self {
            limit: limit.into(),
            unit: unit.into(),
            allowed: scale(report.allowed),
            found: scale(report.found),
            frame: report.frame,
            time_s: report.time,
            frames: [report.frames.start, report.frames.end],
        }
    }
}
