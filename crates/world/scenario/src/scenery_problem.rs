//! Why something of a scenario has no place on its ground.

use std::fmt;

use limits::Limit;
use solids::{RockFieldError, SolidError};

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
