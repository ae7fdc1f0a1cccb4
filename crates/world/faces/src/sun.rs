//! The sun of one group of faces: the scenario's, or one that turns about the vertical, frame by frame.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;
use quantities::{Rate, sin_cos};

use crate::error::{FaceError, within};
use crate::warning::Warning;

/// Largest number of frames in which a film may close; beyond it fractions of a turn are no longer exact.
const LONGEST: u128 = 1 << 53;

/// Step of one frame above which stepping shows (radians, chosen).
const SMOOTH_STEP: f64 = TAU / 16.0;

/// Turns of a sun in one frame, as a ratio of whole numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Turn {
    /// Turns in `below` frames, negative for the opposite sense.
    above: i64,
    below: u64,
}

impl Turn {
    /// A sun that stands still.
    pub const STILL: Self = Self { above: 0, below: 1 };

    /// Turns `rate[0] / rate[1]` times a second (either sense) at `frames` frames a second.
    ///
    /// # Errors
    /// If `rate[1]` is 0, the sun turns more than half a turn a frame, or the fractions are too long to be exact.
    pub fn new(rate: [i64; 2], frames: Rate) -> Result<Self, FaceError> {
        let [above, below] = rate;
        within("denominator of the sun's rate", below as f64, below > 0, "1 or more")?;
        let Some(speed) = Rate::new(above.unsigned_abs(), below.unsigned_abs()) else {
            return Ok(Self::STILL);
        };
        let ([p, q], [frames_p, frames_q]) = (speed.fraction(), frames.fraction());
        // Lowest terms crosswise, so that the products are in lowest terms too.
        let [p, frames_p] = lowest(p, frames_p);
        let [frames_q, q] = lowest(frames_q, q);
        let (turns, in_frames) = (u128::from(p) * u128::from(frames_q), u128::from(q) * u128::from(frames_p));
        if 2 * turns > in_frames {
            let [p, q] = frames.fraction();
            let highest = q.checked_mul(2).and_then(|q| Rate::new(p, q)).unwrap_or(frames);
            return Err(FaceError::Aliased { found: above as f64 / below as f64, highest });
        }
        let exact = in_frames <= LONGEST;
        within(
            "frames until the sun's turns repeat",
            in_frames as f64,
            exact,
            "2^53 or fewer: use a rounder rate",
        )?;
        Ok(Self { above: turns as i64 * above.signum(), below: in_frames as u64 })
    }

    /// Part of a turn at `frame`, in [0, 1); the same bits after each whole number of turns.
    pub fn at(&self, frame: u64) -> f64 {
        let below = u128::from(self.below);
        let above = i128::from(self.above).rem_euclid(i128::from(self.below)) as u128;
        let part = u128::from(frame) % below * above % below;
        part as f64 / self.below as f64
    }

    /// Frames after which the turns repeat.
    pub fn period(&self) -> u64 {
        self.below
    }

    /// Turn of one frame (radians, either sense), from -pi to pi.
    pub fn step(&self) -> f64 {
        TAU * (self.above as f64 / self.below as f64)
    }
}

/// Two numbers without their common factors.
fn lowest(a: u64, b: u64) -> [u64; 2] {
    Rate::new(a, b).map_or([a, b], Rate::fraction)
}

/// A sun that turns about the vertical; [`Turn::STILL`] holds it fixed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningSun {
    elevation: f64,
    azimuth: f64,
    turn: Turn,
}

impl TurningSun {
    /// A sun at `elevation`, at `azimuth` in frame 0 (radians, the phase included; from north towards east).
    ///
    /// # Errors
    /// If an angle is not finite, or the elevation is beyond a quarter turn.
    pub fn new(elevation: f64, azimuth: f64, turn: Turn) -> Result<Self, FaceError> {
        let allowed = elevation.abs() <= FRAC_PI_2;
        within("elevation of the sun (rad)", elevation, allowed, "from -pi / 2 to pi / 2")?;
        within("azimuth of the sun (rad)", azimuth, true, "a finite number")?;
        Ok(Self { elevation, azimuth, turn })
    }

    /// Elevation above the horizon (radians).
    pub fn elevation(&self) -> f64 {
        self.elevation
    }

    /// Turns of one frame, as given.
    pub fn turn(&self) -> Turn {
        self.turn
    }

    /// The same sun, held as it stands in frame 0.
    pub fn still(&self) -> Self {
        Self { turn: Turn::STILL, ..*self }
    }

    /// Unit vector to the sun in `frame`: north, east, up.
    pub fn vector(&self, frame: u64) -> DVec3 {
        sun_vector(self.azimuth + TAU * self.turn.at(frame), self.elevation)
    }

    /// Steps that show, and a sun below the horizon.
    pub fn warnings(&self) -> Vec<Warning> {
        let step = self.turn.step().abs();
        let stepping = (step > SMOOTH_STEP * (1.0 + 1e-12)).then_some(Warning::Stepping { step });
        let below = (self.elevation < 0.0).then_some(Warning::SunBelow { elevation: self.elevation });
        stepping.into_iter().chain(below).collect()
    }
}

/// Which sun lights a group.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SunProgramme {
    /// The sun of the scenario.
    Scenario,
    /// A sun of its own.
    Turning(TurningSun),
}

impl SunProgramme {
    /// Unit vector to the group's sun in `frame`; `scenario` is that of the scenario.
    pub fn vector(&self, frame: u64, scenario: DVec3) -> DVec3 {
        match self {
            Self::Scenario => scenario,
            Self::Turning(sun) => sun.vector(frame),
        }
    }
}

/// Unit vector to a sun at `azimuth` (from north towards east) and `elevation` (radians): north, east, up.
pub fn sun_vector(azimuth: f64, elevation: f64) -> DVec3 {
    let (sin, cos) = sin_cos(azimuth);
    let (up, out) = sin_cos(elevation);
    DVec3::new(cos * out, sin * out, up)
}
