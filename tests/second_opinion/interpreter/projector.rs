//! Elevation, and the report's occlusion circuit (sections 15.1, 15.2, 15.4).

use scenario::{Curvature, Occlusion};

const MOON_RADIUS: f64 = 1_737_400.0;

/// Tangent of the elevation of ground at height `h` and range `z` for an eye at `eye` (m).
pub fn elevation(h: f64, eye: f64, z: f64, curvature: Curvature) -> f64 {
    let drop = match curvature {
        Curvature::None => 0.0,
        Curvature::Parabolic => z * z / (2.0 * MOON_RADIUS),
    };
    (h - drop - eye) / z
}

/// What the circuit is shown at each sample: the elevation, or the summit of the curve between its neighbours, which
/// a real derivative circuit would see pass. The curve is the quadratic `y0 + b s + c s^2` through three samples.
pub fn summits(elevations: &[f64]) -> Vec<f64> {
    let mut shown = elevations.to_vec();
    for k in 1..elevations.len().saturating_sub(1) {
        let [left, y0, right] = [elevations[k - 1], elevations[k], elevations[k + 1]];
        // A drop beyond a quarter is the end of the stored ground.
        if left < y0 && right <= y0 && y0 - right < 0.25 {
            let (b, c) = ((right - left) / 2.0, (right + left) / 2.0 - y0);
            let summit = -b / (2.0 * c);
            shown[k] = y0 + b * summit + c * summit * summit;
        }
    }
    shown
}

/// What the circuit remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circuit {
    law: Occlusion,
    before: Option<f64>,
    /// Sample-and-hold.
    pub held: f64,
    /// Video is blanked.
    pub blank: bool,
}

impl Circuit {
    /// Nothing has been seen.
    pub fn at_start(law: Occlusion) -> Self {
        Self { law, before: None, held: f64::NEG_INFINITY, blank: false }
    }

    /// Shows the circuit the elevation of the next sample.
    pub fn step(&mut self, eta: f64) {
        let falls = self.before.is_some_and(|before| eta < before);
        match self.law {
            // While blanked the derivative is ignored: only the return to the held elevation counts.
            Occlusion::Derivative if self.blank => self.blank = eta < self.held,
            Occlusion::Derivative => self.blank = falls,
            Occlusion::PeakHold => self.blank = eta < self.held,
        }
        if !self.blank {
            self.held = eta;
        }
        self.before = Some(eta);
    }
}
