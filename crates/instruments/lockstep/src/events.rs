//! The event lists of both, in one form.

use std::collections::BTreeMap;

use control_plane::{DigitalEvent, DigitalUnit, EventWord, LoadedPart};
use interpreter::{AskedFor, Event, FromDrum, Happening, Outcome, Part, Register};
use sweep_program::{PreloadRegister, RampAxis, Stop};

/// What the machine's digital side did, in the interpreter's words.
pub fn of_machine(events: &[DigitalEvent]) -> Vec<Event> {
    events.iter().filter_map(translated).collect()
}

fn translated(event: &DigitalEvent) -> Option<Event> {
    Some(Event { tick: event.tick.0 as i64, level: event.level, what: happening(event)? })
}

/// What it is for the interpreter; none if the machine tells less of it than such an event has.
fn happening(event: &DigitalEvent) -> Option<Happening> {
    let colour = || event.colour.map(|colour| colour as usize);
    let words = event.mask.0;
    Some(match event.event {
        EventWord::Home => {
            Happening::Home { colour: colour()?, register: register(event)?, corner: event.corner? }
        }
        EventWord::Stop => {
            let fold = event.fold?;
            let axis = usize::from(fold.axis == RampAxis::Y);
            Happening::Stop { axis, at_one: fold.stop == Stop::One, crossing: event.crossing? }
        }
        EventWord::Transfer => {
            let (colour, register) = (colour()?, register(event)?);
            Happening::Transfer { colour, register, crossing: event.crossing?, corner: event.corner }
        }
        EventWord::Wasted => {
            Happening::Wasted { colour: colour()?, register: register(event)?, corner: event.corner }
        }
        EventWord::Wanted => Happening::Wanted(set(event)?),
        EventWord::Cancelled => Happening::Cancelled(set(event)?),
        EventWord::Diagonal => Happening::Diagonal { set: set(event)?, corner: event.corner? },
        EventWord::Access => Happening::Access { set: set(event)?, corner: event.corner? },
        EventWord::Load => {
            Happening::Load { colour: colour()?, register: register(event)?, corner: event.corner, words }
        }
        EventWord::Late => Happening::Late {
            colour: colour()?,
            register: register(event)?,
            crossing: event.crossing?,
            words,
        },
        EventWord::Absent => Happening::Absent {
            colour: colour()?,
            register: register(event)?,
            crossing: event.crossing,
            corner: event.corner?,
        },
        EventWord::CraterLoad | EventWord::SegmentLoad => words_of(event, Outcome::InTime),
        EventWord::CraterLate | EventWord::SegmentLate => words_of(event, Outcome::Late),
        EventWord::CraterDropped | EventWord::SegmentDropped => words_of(event, Outcome::Dropped),
        EventWord::SetUpBegins => Happening::SetUpBegins { sweep: event.sweep? },
        EventWord::SetUp | EventWord::SetUpLate => {
            Happening::SetUp { sweep: event.sweep?, slack: event.slack? }
        }
        EventWord::OldSetUp => Happening::OldSetUp { sweep: event.sweep?, drawn: event.other? },
        EventWord::Tables | EventWord::TablesLate => Happening::Tables { slack: event.slack? },
        EventWord::Record => Happening::Record(from_drum(event)?),
        EventWord::FeatureRecord => Happening::Square { kind: 2, record: from_drum(event)? },
        EventWord::ShadowRecord => Happening::Square { kind: 3, record: from_drum(event)? },
        EventWord::BodyRecord => Happening::Square { kind: 4, record: from_drum(event)? },
    })
}

/// What became of the words of a crater, or of a shadow boundary.
fn words_of(event: &DigitalEvent, outcome: Outcome) -> Happening {
    let number = event.part.map(|part| match part {
        LoadedPart::SubGenerator(_, number) | LoadedPart::LineGenerator(number) => number,
    });
    let part = match event.crater {
        Some(crater) => Part::Crater { crater, sub_generator: number },
        None => Part::Segment { line_generator: number },
    };
    Happening::Words { part, outcome, slack: event.slack }
}

fn from_drum(event: &DigitalEvent) -> Option<FromDrum> {
    let DigitalUnit::Drum(_, drum) = event.unit else { return None };
    Some(FromDrum { drum, corner: event.corner?, words: event.words })
}

fn register(event: &DigitalEvent) -> Option<Register> {
    Some(match event.register? {
        control_plane::Register::Hold => Register::Hold,
        control_plane::Register::Preload(PreloadRegister::XFirst) => Register::XFirst,
        control_plane::Register::Preload(PreloadRegister::YFirst) => Register::YFirst,
        control_plane::Register::Diagonal => Register::Diagonal,
    })
}

fn set(event: &DigitalEvent) -> Option<AskedFor> {
    Some(AskedFor { colour: event.colour? as usize, register: register(event)?, crossing: event.crossing? })
}

/// The events up to the last tick of each level, in one order, those that are one but for their words joined.
pub fn in_order(events: &[Event], last_ticks: [i64; 2]) -> Vec<Event> {
    let mut joined: BTreeMap<Event, u16> = BTreeMap::new();
    let is_in_time = |event: &&Event| event.level.is_none_or(|level| event.tick <= last_ticks[level]);
    for event in events.iter().filter(is_in_time) {
        let (mut key, mut words) = (*event, 0);
        if let Happening::Load { words: some, .. } | Happening::Late { words: some, .. } = &mut key.what {
            words = std::mem::take(some);
        }
        *joined.entry(key).or_default() |= words;
    }
    let restored = |(mut event, all): (Event, u16)| {
        if let Happening::Load { words, .. } | Happening::Late { words, .. } = &mut event.what {
            *words = all;
        }
        event
    };
    joined.into_iter().map(restored).collect()
}
