//! Loads that take time: when the words of a crater are in its sub-generator, and what becomes of it if they are late.

use hardware_model::Organisation;
use quantities::SweepTime;
use sweep_program::{LoadTiming, MissCause, TimedLoad};

use crate::FeatureLoad;
use crate::schedule::Request;

/// Words of a crater: centre, three radii, height of the rim, depth, type (hardware section 3.7).
pub const CRATER_WORDS: u32 = 8;

/// A crater whose words were not there at its edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeatureMiss {
    /// Index of the crater.
    pub crater: u32,
    /// Its type, 1 to 3.
    pub kind: u32,
    /// Sub-generator of that type that waited for them; none if all were taken.
    pub sub_generator: Option<u32>,
    /// Ground range of the edge at which the sweep meets it (m).
    pub range: f64,
    /// When that was; none if all sub-generators were taken.
    pub due: Option<SweepTime>,
    /// When the words came; none if never.
    pub arrival: Option<SweepTime>,
    /// Why; none if all sub-generators were taken.
    pub cause: Option<MissCause>,
}

/// A crater whose words took time to come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeatureArrival {
    /// Index of the crater.
    pub crater: u32,
    /// Its type, 1 to 3.
    pub kind: u32,
    /// Sub-generator of that type that waited for them.
    pub sub_generator: u32,
    /// Ground range of the edge at which the sweep meets it (m).
    pub range: f64,
    /// When they came; a slack below 0 is late.
    pub load: TimedLoad,
}

impl FeatureMiss {
    /// A crater that found no free sub-generator.
    pub(crate) fn occupied(request: &Request) -> Self {
        Self {
            crater: request.load.crater,
            kind: request.kind as u32 + 1,
            sub_generator: None,
            range: request.entry,
            due: None,
            arrival: None,
            cause: None,
        }
    }
}

/// What became of a load.
pub(crate) struct Brought {
    /// The crater, if it is drawn.
    pub load: Option<FeatureLoad>,
    /// If it is late.
    pub miss: Option<FeatureMiss>,
    /// When its words came.
    pub arrival: FeatureArrival,
}

/// Brings the words of a crater into a sub-generator that is free from ground range `free` on (m). The report's
/// organisation by regions sends them as the sweep enters the region, a schedule as soon as it can.
pub(crate) fn bring(
    timing: &mut LoadTiming<impl Fn(f64) -> SweepTime, impl Fn(SweepTime) -> f64>,
    request: &Request,
    (sub_generator, free): (u32, f64),
    organisation: Organisation,
) -> Brought {
    let free = match organisation {
        Organisation::Scheduled => free,
        Organisation::ByRegion => free.max(request.taken),
    };
    let load = FeatureLoad { sub_generator, ..request.load };
    let timed = timing.load(load.crater, [free, request.entry, request.exit]);
    let arrival = FeatureArrival {
        crater: load.crater,
        kind: request.kind as u32 + 1,
        sub_generator,
        range: request.entry,
        load: timed,
    };
    if timed.slack >= 0 {
        return Brought { load: Some(load), miss: None, arrival };
    }
    let TimedLoad { due, range, cause, .. } = timed;
    let is_drawn = timing.strobes_through && range < request.exit;
    Brought {
        load: is_drawn.then_some(FeatureLoad { from: range, ..load }),
        miss: Some(FeatureMiss {
            due: Some(due),
            arrival: timed.arrival,
            cause: Some(cause),
            sub_generator: Some(sub_generator),
            ..FeatureMiss::occupied(request)
        }),
        arrival,
    }
}
