//! The horizon of a plane and of the lunoid.

use landscape::LUNOID_RADIUS;
use quantities::{radians, sin_cos};
use serde::Deserialize;

use crate::scene::machine::MachineCase;

/// Line of the horizon in a column.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Horizon {
    /// Edge of a plane that ends at the range programme's end.
    Plane,
    /// `tan eta = -sqrt(2 H / R)` at every azimuth, at level pitch.
    Lunoid,
}

impl Horizon {
    /// View-plane coordinate Y (over the plane's distance, positive down) at the column coordinate X.
    pub fn at(self, of: &MachineCase, x: f64) -> f64 {
        match self {
            Self::Plane => plane_edge(of, x),
            Self::Lunoid => {
                let [height, ..] = below(of);
                (2.0 * (of.scene.eye_m[2] - height) / LUNOID_RADIUS).sqrt() * (1.0 + x * x).sqrt()
            }
        }
    }
}

/// Height and slopes of the ground below the eye.
fn below(of: &MachineCase) -> [f64; 3] {
    let [north, east, _] = of.scene.eye_m;
    of.surface([north, east])
}

/// The ray `(1, x, y)` turned up by the pitch goes `F = cos th + y sin th` forward, x to the right and
/// `sin th - y cos th` up. It meets the edge of the ground, seen `H` lower at range `end`, where
/// `up = hf F + hs x - H / end sqrt(F^2 + x^2)`. The last term is small: four rounds of inserting y are enough.
fn plane_edge(of: &MachineCase, x: f64) -> f64 {
    let [height, north, east] = below(of);
    let (sin_h, cos_h) = sin_cos(of.heading);
    let (forward, starboard) = (north * cos_h + east * sin_h, east * cos_h - north * sin_h);
    let (sin, cos) = sin_cos(radians(of.scene.pitch_deg));
    let drop = (of.scene.eye_m[2] - height) / of.settings.range.end;
    let mut y = 0.0;
    for _ in 0..4 {
        let ahead = cos + y * sin;
        let length = (ahead * ahead + x * x).sqrt();
        y = (sin - forward * cos - starboard * x + drop * length) / (cos + forward * sin);
    }
    y
}
