//! What a turn on the spot asks of the drums.

use serde::Deserialize;

use super::Deviation;
use crate::scene::turn::{TurnCase, Turned};

/// A number of a turn.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TurnedReading {
    /// The number that is read.
    pub measure: TurnMeasure,
    /// What it should be.
    pub value: f64,
}

/// A number that says what a turn asks of the drums.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum TurnMeasure {
    /// Records of terrain that are asked for anew (1/s).
    TerrainRequests,
    /// Requests of all kinds times one turn of a drum: the share that they take if each waits for a whole turn.
    WholeTurns,
    /// Share of the time in which the drums are at work.
    Busy,
    /// Share of the requests that are given up before they are met.
    GivenUp,
}

impl TurnMeasure {
    /// Its word in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::TerrainRequests => "terrain-requests",
            Self::WholeTurns => "whole-turns",
            Self::Busy => "busy",
            Self::GivenUp => "given-up",
        }
    }
}

impl TurnedReading {
    pub(super) fn deviation(&self, meant: &TurnCase, seen: &Turned) -> Result<Deviation, String> {
        let found = match self.measure {
            TurnMeasure::TerrainRequests => seen.terrain_requests,
            TurnMeasure::WholeTurns => seen.requests * meant.turn(),
            TurnMeasure::Busy => seen.busy,
            TurnMeasure::GivenUp => seen.given_up,
        };
        Ok(Deviation::of(format!("{} of the turn", self.measure.word()), found, self.value, 1.0))
    }
}
