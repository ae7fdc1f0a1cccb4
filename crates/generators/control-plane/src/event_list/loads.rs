//! Words of craters and of shadow boundaries, as they come to the parts that wait for them (hardware section 3.7).
//!
//! Where the model has no rate for them they take no time: they are there as the sweep meets the crater or the boundary.

use feature_generator::CRATER_WORDS;
use hardware_model::ShadowParts;
use quantities::{SweepTime, Tick};
use shadow_controller::SEGMENT_WORDS;
use sweep_program::{TimedLoad, WordMask};

use crate::digital_event::{DigitalEvent, DigitalUnit, EventWord, LoadedPart};
use crate::frame_sweeps::FrameSweeps;

/// What a load is told by: its unit, its words for in time, late and dropped, and how many words it has.
struct Kind {
    unit: DigitalUnit,
    events: [EventWord; 3],
    words: u32,
}

const CRATER: Kind = Kind {
    unit: DigitalUnit::FeatureGenerator,
    events: [EventWord::CraterLoad, EventWord::CraterLate, EventWord::CraterDropped],
    words: CRATER_WORDS,
};

const SEGMENT: Kind = Kind {
    unit: DigitalUnit::ShadowController,
    events: [EventWord::SegmentLoad, EventWord::SegmentLate, EventWord::SegmentDropped],
    words: SEGMENT_WORDS,
};

/// Loads of one sweep.
pub struct Loads<'a> {
    pub sweeps: &'a FrameSweeps<'a>,
    pub sweep: u32,
}

impl Loads<'_> {
    /// Craters of the sweep up to ground range `end` (m).
    pub fn craters(&self, end: f64) -> Vec<DigitalEvent> {
        let crossings = self.sweeps.crossings();
        let stage = crossings.stage;
        let program = crossings.feature_program([self.sweeps.set_up_of(self.sweep), self.sweep], end);
        let is_timed = stage.settings.feature_words.is_some();
        let came = program.arrivals.iter().map(|arrival| DigitalEvent {
            crater: Some(arrival.crater),
            part: Some(LoadedPart::SubGenerator(arrival.kind, arrival.sub_generator)),
            ..self.timed(&CRATER, arrival.range, &arrival.load)
        });
        let features = stage.landscape.features();
        let at_hand = program.loads.iter().filter(|_| !is_timed).map(|load| {
            let crater = features.crater(load.crater);
            DigitalEvent {
                crater: Some(load.crater),
                part: Some(LoadedPart::SubGenerator(crater.type_number(), load.sub_generator)),
                ..self.at_once(&CRATER, 0, load.edge(&crater))
            }
        });
        let occupied = program
            .misses
            .iter()
            .filter(|miss| miss.sub_generator.is_none())
            .map(|miss| DigitalEvent { crater: Some(miss.crater), ..self.at_once(&CRATER, 2, miss.range) });
        came.chain(at_hand).chain(occupied).collect()
    }

    /// Shadow boundaries of the sweep; none from a scan converter, which takes them all with its map.
    pub fn segments(&self) -> Vec<DigitalEvent> {
        let settings = &self.sweeps.crossings().stage.settings;
        let (Some(gate), ShadowParts::Digital { .. }) =
            (self.sweeps.drawn_gate(self.sweep), settings.shadow_controller)
        else {
            return Vec::new();
        };
        let came = gate.loads.iter().map(|load| DigitalEvent {
            part: Some(LoadedPart::LineGenerator(load.line_generator)),
            ..self.timed(&SEGMENT, load.range, &load.load)
        });
        // The gate has a swing for every boundary; the end of its reach is none.
        let crossed = gate.toggles.iter().take(gate.swings.len());
        let at_hand = crossed.filter(|_| settings.segment_words.is_none());
        let at_hand = at_hand.map(|&range| self.at_once(&SEGMENT, 0, range));
        let occupied = gate.misses.iter().filter(|miss| miss.line_generator.is_none());
        let occupied = occupied.map(|miss| self.at_once(&SEGMENT, 2, miss.range));
        came.chain(at_hand).chain(occupied).collect()
    }

    /// A load over the line, at the tick of its last word; one that never comes at the instant at which it is due.
    fn timed(&self, kind: &Kind, range: f64, load: &TimedLoad) -> DigitalEvent {
        let &TimedLoad { due, arrival, slack, cause, .. } = load;
        let outcome = if arrival.is_none() { 2 } else { usize::from(slack < 0) };
        let tick = arrival.map_or_else(|| self.seen(due), |arrival| self.sweeps.tick_of(self.sweep, arrival));
        DigitalEvent {
            slack: arrival.map(|_| slack),
            cause: (slack < 0).then_some(cause),
            ..self.event(kind, outcome, tick, range)
        }
    }

    /// What takes no time, as the sweep passes `range` (m); what it has passed before its first sample, at that.
    fn at_once(&self, kind: &Kind, outcome: usize, range: f64) -> DigitalEvent {
        let table = self.sweeps.table();
        let passed = range.max(table.ranges()[0]);
        self.event(kind, outcome, self.seen(table.time_of(passed)), range)
    }

    fn event(&self, kind: &Kind, outcome: usize, tick: Tick, range: f64) -> DigitalEvent {
        DigitalEvent {
            sweep: Some(self.sweep),
            mask: WordMask::range(0, kind.words),
            words: kind.words,
            range: Some(range.max(0.0)),
            ..DigitalEvent::new(tick, kind.events[outcome], kind.unit)
        }
    }

    /// When the digital side sees an instant of the sweep.
    fn seen(&self, time: SweepTime) -> Tick {
        self.sweeps.clock(self.sweep).tick_at_or_after(time)
    }
}
