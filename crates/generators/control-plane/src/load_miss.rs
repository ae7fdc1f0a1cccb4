//! Loads of craters and shadow boundaries whose words came late, one by one.

use feature_generator::{CRATER_WORDS, FeatureArrival};
use shadow_controller::{SEGMENT_WORDS, SegmentLoad};
use sweep_program::{MissCause, TimedLoad};

use crate::digital_event::LoadedPart;
use crate::frame_sweeps::FrameSweeps;
use crate::late_words::LateOf;

/// A load whose words were not there when the sweep met what they draw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadMiss {
    /// What waited for the words.
    pub of: LateOf,
    /// Part into which they are loaded.
    pub part: LoadedPart,
    /// Ground range at which the sweep meets the crater's edge, or crosses the boundary (m).
    pub range: f64,
    /// When they were due (samples of the sweep).
    pub due: f64,
    /// When the last one came; none if never.
    pub came: Option<f64>,
    /// Number of words that it has.
    pub words: u32,
    /// What held them up.
    pub cause: MissCause,
}

impl FrameSweeps<'_> {
    /// Loads of craters, then of shadow boundaries, that come late or never in a sweep; of boundaries only if the frame has its gates
    /// ([`sweeps_with_gates`](crate::ControlPlane::sweeps_with_gates)). What found no part free was no load.
    pub fn load_misses(&self, sweep: u32) -> Vec<LoadMiss> {
        let ends = self.programs(sweep).into_iter().map(|program| program.end_range);
        let end = ends.fold(0.0, f64::max);
        let features = self.crossings().feature_program([self.set_up_of(sweep), sweep], end);
        let boundaries = self.drawn_gate(sweep).into_iter().flat_map(|gate| gate.loads.iter().zip(0..));
        let craters = features.arrivals.iter().filter_map(of_crater);
        craters.chain(boundaries.filter_map(of_boundary)).collect()
    }
}

fn of_crater(arrival: &FeatureArrival) -> Option<LoadMiss> {
    let part = LoadedPart::SubGenerator(arrival.kind, arrival.sub_generator);
    missed(LateOf::Crater(arrival.crater), part, arrival.range, CRATER_WORDS, &arrival.load)
}

fn of_boundary((load, number): (&SegmentLoad, u32)) -> Option<LoadMiss> {
    let part = LoadedPart::LineGenerator(load.line_generator);
    missed(LateOf::Boundary(number), part, load.range, SEGMENT_WORDS, &load.load)
}

fn missed(of: LateOf, part: LoadedPart, range: f64, words: u32, load: &TimedLoad) -> Option<LoadMiss> {
    let &TimedLoad { due, arrival, cause, .. } = load;
    let miss = LoadMiss { of, part, range, due: due.0, came: arrival.map(|time| time.0), words, cause };
    (load.slack < 0).then_some(miss)
}
