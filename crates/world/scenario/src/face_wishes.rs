//! What a scenario asks of lists of faces: a sea, ships, effects, plumes.

use std::path::PathBuf;

use faces::ship::{Hiding, Ship};
use faces::{BowWake, Detail, Flight, Mean, Pattern, SeaState};
use wind_waves::Wind;

/// Everything of a scenario that is made of lists of faces.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FaceWishes {
    /// A flat sea that moves by false normals.
    pub sea: Option<SeaWish>,
    /// Ships on the sea.
    pub ships: Vec<ShipWish>,
    /// Effects that files describe.
    pub effects: Vec<EffectFileWish>,
    /// Plumes of dust, in order.
    pub plumes: Vec<PlumeWish>,
}

/// A flat sea that a scenario asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeaWish {
    /// Side of its squares (m).
    pub square: f64,
    /// South, west, north, east edge (m); those of the finest level if open.
    pub area: Option<[f64; 4]>,
    /// Height of its surface (m).
    pub height: f64,
    /// Rule of its normals.
    pub pattern: Pattern,
    /// Number of normals in the table.
    pub normals: u32,
    /// Angle of the normals above the horizontal (rad).
    pub normal_elevation: f64,
    /// Its state, from 0 to 3.
    pub state: SeaState,
    /// What happens to its mean brightness.
    pub mean: Mean,
    /// Linear red, green, blue of full brightness.
    pub colour: [f64; 3],
    /// Wind over the sea of true waves that `exact` draws in its place, where the scenario has one.
    pub waves: Option<Wind>,
}

/// A ship on a straight course.
#[derive(Debug, Clone, PartialEq)]
pub struct ShipWish {
    /// What it is called.
    pub id: String,
    /// Type of the ship.
    pub kind: &'static Ship,
    /// Place amidships at the start: north, east (m).
    pub at: [f64; 2],
    /// Course, clockwise from north (rad).
    pub heading: f64,
    /// Speed (m/s), 0 or more.
    pub speed: f64,
    /// Waves of pitch, roll (rad), heave and sway (m).
    pub motion: [Vec<WaveWish>; 4],
    /// How its hull below the water is hidden.
    pub hiding: Hiding,
    /// Its bow wake with the frames of a face, where it has one.
    pub bow_wake: Option<(BowWake, u64)>,
    /// Its stern wake, where it has one.
    pub stern_wake: Option<SternWakeWish>,
}

/// One sine of a ship's motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveWish {
    /// Amplitude (rad or m).
    pub amplitude: f64,
    /// Period of the sine (ms).
    pub period_ms: u64,
    /// Phase in frame 0 (rad).
    pub phase: f64,
}

/// Churned water behind a ship.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SternWakeWish {
    /// Length and width (m).
    pub size: [f64; 2],
    /// How it meets the sea below it.
    pub detail: Detail,
    /// Linear red, green, blue of full brightness.
    pub colour: [f64; 3],
}

/// What carries a list of faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FacePlace {
    /// A place on the ground: north, east (m), height above the ground (m), heading (rad).
    Ground([f64; 3], f64),
    /// The vehicle: forward, starboard (m) from its centre, on the ground below.
    Vehicle([f64; 2]),
    /// The object of a number in the scenario: forward, starboard, up (m) from its foot point.
    Object(usize, [f64; 3]),
}

/// An effect of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct EffectFileWish {
    /// The effect file, in the scenario's folder or below.
    pub file: PathBuf,
    /// Where the effect stands.
    pub place: FacePlace,
}

/// A plume of dust: faces of one flight after another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlumeWish {
    /// Where the plume begins.
    pub place: FacePlace,
    /// Flight of its middle.
    pub flight: Flight,
    /// Flights on both sides of the middle (rad).
    pub spread: f64,
    /// Direction, clockwise from forward (rad).
    pub azimuth: f64,
    /// Faces of one flight.
    pub faces: usize,
    /// Frames that a face is shown.
    pub frames: u64,
    /// How many copies follow one another.
    pub copies: u64,
    /// Linear red, green, blue of the dust.
    pub colour: [f64; 3],
}
