//! Why something of a scenario has no place on its ground.

use std::fmt;

use ephemeris::{FIRST, Instant, LAST};
use limits::Limit;
use solids::{RockFieldError, SolidError};

use crate::PolygonFault;

/// One thing that does not fit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SceneryProblem {
    /// An object stands outside the problem area.
    #[error(
        "object \"{id}\" at t = {time} s: x = {x:.2} m, y = {y:.2} m is outside the problem area, expected \
         x {}..{} m, y {}..{} m; move it or enlarge the landscape",
        extent[0], extent[2], extent[1], extent[3]
    )]
    ObjectOutside {
        /// Name (`id`) of the object.
        id: String,
        /// Time from which on it stands there (s).
        time: f64,
        /// Place of the object, north (m).
        x: f64,
        /// Place of the object, east (m).
        y: f64,
        /// South, west, north, east edge of the area (m).
        extent: [f64; 4],
    },
    /// A light or a sheet has no ground under it.
    #[error(
        "{what} \"{id}\" at t = {time} s: x = {x:.2} m, y = {y:.2} m is outside the problem area, expected \
         x {}..{} m, y {}..{} m; move it or enlarge the landscape",
        extent[0], extent[2], extent[1], extent[3]
    )]
    EffectOutside {
        /// What it is, in a word.
        what: &'static str,
        /// Name (`id`) of it.
        id: String,
        /// Time at which it is there (s).
        time: f64,
        /// Its place, north (m).
        x: f64,
        /// Its place, east (m).
        y: f64,
        /// South, west, north, east edge of the area (m).
        extent: [f64; 4],
    },
    /// A sheet whose corners follow the ground and are then no flat convex polygon.
    #[error(
        "sheet \"{id}\" on its ground: {fault}; expected a flat convex polygon; take three corners, or height = \"foot\""
    )]
    SheetShape {
        /// Name (`id`) of the sheet.
        id: String,
        /// What is wrong with its corners.
        fault: PolygonFault,
    },
    /// More rocks than can be drawn.
    #[error(
        "[rocks]: {found:.0} rocks: expected at most {limit}; raise smallest_m, or lower density_per_m2 or radius_m; {advice}",
        limit = Limit::Rocks.value(),
        advice = Limit::Rocks
    )]
    TooManyRocks {
        /// How many there would be.
        found: f64,
    },
    /// Rocks that cannot be strewn.
    #[error("[rocks]: {0}")]
    Rocks(#[from] RockFieldError),
    /// The seed makes a rock that is no solid.
    #[error("[rocks]: a shape of this seed is no solid: {0}; choose another seed")]
    RockShape(SolidError),
    /// More track patches than can be kept.
    #[error(
        "[tracks]: more than {limit} patches every {spacing} m; raise spacing_m; {advice}",
        limit = Limit::Patches.value(),
        advice = Limit::Patches
    )]
    TooManyPatches {
        /// Spacing of the patches that was asked for (m).
        spacing: f64,
    },
    /// A date or a sub-solar point without a place on the Moon.
    #[error(
        "[sun]: `{key}` needs a place on the Moon, and the bank knows none (imported words, a file without a projection, or ground \
         of another body); add place = {{ longitude_deg = ..., latitude_deg = ... }} to [sun]"
    )]
    SunWithoutPlace {
        /// Key of `[sun]` that needs it.
        key: &'static str,
    },
    /// A bank that was made before banks had their true north.
    #[error(
        "[sun]: `{key}` needs the direction of true north, and the bank was made without it; make it again with `lunoid survey`"
    )]
    SunWithoutNorth {
        /// Key of `[sun]` that needs it.
        key: &'static str,
    },
    /// The sun that stands overhead elsewhere is below the horizon here.
    #[error(
        "[sun]: over latitude {:.4}, longitude {:.4} deg the sun of `sub_solar_deg` = [{:.4}, {:.4}] stands at an elevation of \
         {elevation_deg:.2} deg, expected above 0; choose a sub-solar point less than 90 deg away",
        place_deg[0], place_deg[1], sub_solar_deg[0], sub_solar_deg[1]
    )]
    SunOverTheEdge {
        /// Latitude and longitude that have the sun overhead (deg).
        sub_solar_deg: [f64; 2],
        /// Latitude and longitude that are lit (deg).
        place_deg: [f64; 2],
        /// Elevation of the sun (deg).
        elevation_deg: f64,
    },
    /// The sun of a date is below the horizon.
    #[error(
        "[sun]: at {at}, t = {time} s, the sun stands at an elevation of {elevation_deg:.2} deg, expected above 0; choose \
         another time: `lunoid sun` with --until and --step lists the elevations of a span"
    )]
    SunDown {
        /// Date and time with the sun down.
        at: Instant,
        /// The same from the start of the mission (s).
        time: f64,
        /// Elevation of the sun (deg).
        elevation_deg: f64,
    },
    /// A mission that goes on beyond the years for which the sun is known.
    #[error(
        "[sun]: at {at}, t = {time} s, the error of the sun is not measured, expected years from {FIRST} to {LAST}; shorten \
         the mission, or begin it earlier"
    )]
    SunUnmeasured {
        /// Date and time beyond these years.
        at: Instant,
        /// The same from the start of the mission (s).
        time: f64,
    },
    /// More suns than can be kept.
    #[error(
        "[sun]: {found:.0} steps of {step} s, expected at most {limit}; raise step_s; {advice}",
        limit = Limit::SunSteps.value(),
        advice = Limit::SunSteps
    )]
    TooManySuns {
        /// How many there would be.
        found: f64,
        /// Time from one to the next (s).
        step: f64,
    },
    /// A path too long to be walked along.
    #[error(
        "[path]: too long for [rocks] or [tracks], which walk along it in steps of {spacing} m; shorten it, or raise \
         spacing_m or radius_m"
    )]
    LongPath {
        /// Of the steps (m).
        spacing: f64,
    },
}

/// All that does not fit; never empty.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneryProblems(pub Vec<SceneryProblem>);

impl fmt::Display for SceneryProblems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = self.0.iter().map(SceneryProblem::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for SceneryProblems {}
