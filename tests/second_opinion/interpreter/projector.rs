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
