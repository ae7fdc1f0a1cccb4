//! Motion of a ship: pitch, roll, heave and sway as sums of sines.

use std::f64::consts::TAU;

use glam::{DMat3, DVec3};
use quantities::{radians, sin_cos};

use crate::sun::Turn;
use crate::warning::Warning;

/// One sine of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Amplitude (radians or m).
    pub amplitude: f64,
    /// Waves of one frame.
    pub turn: Turn,
    /// Phase in frame 0 (radians).
    pub phase: f64,
}

/// Sums of sines for each motion; empty sums stand still.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Motion {
    /// Pitch, bow upwards (radians).
    pub pitch: Vec<Wave>,
    /// Starboard side downwards (radians).
    pub roll: Vec<Wave>,
    /// Whole ship upwards (m).
    pub heave: Vec<Wave>,
    /// Whole ship to starboard (m).
    pub sway: Vec<Wave>,
}

/// How a ship lies.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Attitude {
    /// Pitch, bow upwards (radians).
    pub pitch: f64,
    /// Starboard side downwards (radians).
    pub roll: f64,
    /// Whole ship upwards (m).
    pub heave: f64,
    /// Whole ship to starboard (m).
    pub sway: f64,
}

impl Motion {
    /// Largest pitch of the study for landing and take-off: 5 deg (reported).
    pub const PITCH_LIMIT_DEG: f64 = 5.0;
    /// Largest roll of the study for landing and take-off: 8 deg (reported).
    pub const ROLL_LIMIT_DEG: f64 = 8.0;

    /// How the ship lies in `frame`.
    pub fn at(&self, frame: u64) -> Attitude {
        let sum = |waves: &[Wave]| -> f64 {
            waves.iter().map(|wave| wave.amplitude * sin_cos(TAU * wave.turn.at(frame) + wave.phase).0).sum()
        };
        let [pitch, roll, heave, sway] =
            [&self.pitch, &self.roll, &self.heave, &self.sway].map(|waves| sum(waves));
        Attitude { pitch, roll, heave, sway }
    }

    /// Motions that can go beyond the limits of the study.
    pub fn warnings(&self) -> Vec<Warning> {
        let beyond = |(motion, waves, limit): (&'static str, &[Wave], f64)| {
            let reaches: f64 = waves.iter().map(|wave| wave.amplitude.abs()).sum();
            let limit = radians(limit);
            (reaches > limit * (1.0 + 1e-12)).then_some(Warning::Beyond { motion, reaches, limit })
        };
        let motions = [
            ("pitch", &self.pitch[..], Self::PITCH_LIMIT_DEG),
            ("roll", &self.roll[..], Self::ROLL_LIMIT_DEG),
        ];
        motions.into_iter().filter_map(beyond).collect()
    }
}

impl Attitude {
    /// What turns ship axes (forward, starboard, up) into north, east, up, at `heading` (radians, from north towards east).
    pub fn turn(&self, heading: f64) -> DMat3 {
        let ((sin_h, cos_h), (sin_p, cos_p)) = (sin_cos(heading), sin_cos(self.pitch));
        let (sin_r, cos_r) = sin_cos(self.roll);
        let forward = DVec3::new(cos_p * cos_h, cos_p * sin_h, sin_p);
        let level = DVec3::new(-sin_h, cos_h, 0.0);
        let upright = DVec3::new(-sin_p * cos_h, -sin_p * sin_h, cos_p);
        DMat3::from_cols(forward, level * cos_r - upright * sin_r, level * sin_r + upright * cos_r)
    }

    /// Where the waterline amidships stands (north, east, up; m) for a ship at `place` without motion.
    pub fn origin(&self, place: DVec3, heading: f64) -> DVec3 {
        let (sin, cos) = sin_cos(heading);
        place + DVec3::new(-sin * self.sway, cos * self.sway, self.heave)
    }
}
