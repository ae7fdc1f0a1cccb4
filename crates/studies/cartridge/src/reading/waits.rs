//! Waits of a drum, and pixels that come back.

use serde::Deserialize;

use super::Deviation;
use crate::scene::drum::{DrumCase, Waits};
use crate::scene::view::Trips;

/// A number of the waits of a drum.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct WaitsReading {
    /// The number that is read from the waits.
    pub measure: WaitMeasure,
    /// What it should be.
    pub value: f64,
}

/// A number of waits, from request to the begin of the record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum WaitMeasure {
    /// Mean wait of a request (turns).
    Mean,
    /// Longest wait of a request (turns).
    Longest,
    /// Share of the requests that were met.
    Met,
}

/// Nothing but the way out and back.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RoundTripReading {}

impl WaitMeasure {
    /// Its word in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Mean => "mean",
            Self::Longest => "longest",
            Self::Met => "met",
        }
    }
}

impl WaitsReading {
    pub(super) fn deviation(&self, meant: &DrumCase, seen: &Waits) -> Result<Deviation, String> {
        let turns: Vec<f64> = seen.seconds.iter().map(|wait| wait / meant.turn()).collect();
        let found = match self.measure {
            WaitMeasure::Mean => turns.iter().sum::<f64>() / turns.len() as f64,
            WaitMeasure::Longest => turns.iter().copied().fold(0.0, f64::max),
            WaitMeasure::Met => turns.len() as f64 / meant.scene.requests as f64,
        };
        Ok(Deviation::of(format!("{} of the waits", self.measure.word()), found, self.value, 1.0))
    }
}

/// The pixel that comes back farthest from where it went out.
pub(super) fn round_trip(seen: &Trips) -> Deviation {
    let axis = |what: &str, k: usize| {
        let [out, back] =
            [&seen.out, &seen.back].map(|ends| ends.iter().map(|end| end[k]).collect::<Vec<_>>());
        Deviation::between(what, &back, &out, 1.0)
    };
    axis("column of pixel", 0).worse(axis("line of pixel", 1))
}
