//! The deflection of a sample.

use quantities::{radians, sin_cos};
use serde::Deserialize;

use super::Deviation;
use super::signal::worst;
use crate::scene::machine::{Drawn, MachineCase};

/// `dpp.y` of every sample that is written, against the perspective of `dpp.elevation` (15.3): with tan eta = t at the azimuth beta of the sweep,
/// `Y = (sin th cos b - cos th t) / (cos th cos b + sin th t)`.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DisplayLineReading {}

impl DisplayLineReading {
    pub(super) fn deviation(&self, meant: &MachineCase, seen: &Drawn) -> Result<Deviation, String> {
        let (sin, cos) = sin_cos(radians(meant.scene.pitch_deg));
        let (sin_h, cos_h) = sin_cos(meant.heading);
        let raster = meant.settings.raster;
        let lines = f64::from(raster.lines);
        worst(meant.sweeps().map(|sweep| {
            let [north, east] = meant.direction(sweep).ok_or("no fan covers the pitch")?;
            let ahead = north * cos_h + east * sin_h;
            let line = |&tangent: &f64| {
                let y = (sin * ahead - cos * tangent) / (cos * ahead + sin * tangent);
                0.5 * lines * (1.0 + y / raster.field.tan_half_height)
            };
            let [elevation, blank] = ["dpp.elevation", "dpp.blank"].map(|name| seen.wave(name, sweep));
            let written = elevation?.iter().zip(seen.wave("dpp.y", sweep)?).zip(blank?);
            let written = written.filter(|(_, blank)| **blank == 0.0);
            let pairs = written.map(|((tangent, &found), _)| (found, line(tangent)));
            let (found, expected): (Vec<f64>, Vec<f64>) = pairs.unzip();
            Ok(Deviation::between(&format!("dpp.y of sweep {sweep}"), &found, &expected, 1.0))
        }))
    }
}
