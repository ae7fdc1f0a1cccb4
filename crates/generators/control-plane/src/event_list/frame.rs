//! Events of the frame beside the crossings.

use std::collections::BTreeMap;

use data_bank::Missing;
use quantities::{SweepTime, Tick};
use sweep_program::WordMask;

use crate::banks::Supplied;
use crate::data_kind::DataKind;
use crate::digital_event::{DigitalEvent, DigitalUnit, EventWord};
use crate::frame_sweeps::FrameSweeps;
use crate::ticks::frame_ticks;

/// Set-ups of sweeps as the processor makes them, and its tables.
pub fn processor(sweeps: &FrameSweeps<'_>) -> Vec<DigitalEvent> {
    let Some(cpu) = &sweeps.digital().cpu else { return Vec::new() };
    let stage = sweeps.crossings().stage;
    let frame = sweeps.plan().frame;
    let clock = |sweep| stage.settings.timebase.sweep_clock(frame, sweep);
    let [first, end] = frame_ticks(stage, frame);
    let start = |sweep: u32| clock(sweep).tick_at_or_after(SweepTime(0.0));
    let begun = cpu.begun.iter().map(|&(sweep, since)| DigitalEvent {
        sweep: Some(sweep),
        ..DigitalEvent::new(
            Tick(first.0.saturating_add_signed(since)),
            EventWord::SetUpBegins,
            DigitalUnit::Cpu,
        )
    });
    let made = cpu.set_ups.iter().map(|&(sweep, slack)| {
        let word = if slack < 0 { EventWord::SetUpLate } else { EventWord::SetUp };
        let ready = Tick(start(sweep).0.saturating_add_signed(-slack));
        DigitalEvent {
            sweep: Some(sweep),
            slack: Some(slack),
            ..DigitalEvent::new(ready, word, DigitalUnit::Cpu)
        }
    });
    let old = (0u32..).zip(&cpu.drawn).filter(|(sweep, drawn)| sweep != *drawn).map(|(sweep, &drawn)| {
        let event = DigitalEvent::new(start(sweep), EventWord::OldSetUp, DigitalUnit::Cpu);
        DigitalEvent { sweep: Some(sweep), other: Some(drawn), ..event }
    });
    let slack = cpu.frame_slack;
    // Left-over work has no end in this frame.
    let (word, tick) = match slack < 0 {
        true => (EventWord::TablesLate, end),
        false => (EventWord::Tables, Tick(end.0.saturating_add_signed(-slack))),
    };
    let tables = DigitalEvent { slack: Some(slack), ..DigitalEvent::new(tick, word, DigitalUnit::Cpu) };
    begun.chain(made).chain(old).chain([tables]).collect()
}

/// Records that the drums bring while the frame runs: of terrain each with the corners that the frame asks of it, of other
/// kinds the last of each square.
pub fn records(sweeps: &FrameSweeps<'_>) -> Vec<DigitalEvent> {
    let mut all: Vec<DigitalEvent> = Vec::new();
    for supplied in &sweeps.digital().supplies {
        match supplied.kind.level() {
            Some(level) => all.extend(records_of_level(sweeps, supplied, level)),
            None => all.extend(last_records(sweeps, supplied)),
        }
    }
    all.sort_by_key(|event| event.tick);
    all
}

/// Records of a level of terrain, by tick and drum.
fn records_of_level(sweeps: &FrameSweeps<'_>, supplied: &Supplied, level: usize) -> Vec<DigitalEvent> {
    let columns = sweeps.crossings().stage.landscape.bank().levels()[level].corners()[1];
    let mut arrived: BTreeMap<(Tick, u32), Vec<u32>> = BTreeMap::new();
    for missing in &supplied.supply().missing {
        if let Some(tick) = missing.arrival {
            arrived.entry((tick, missing.drum)).or_default().push(missing.item);
        }
    }
    let record = |((tick, drum), corners): ((Tick, u32), Vec<u32>)| {
        let corner = corners.first().map(|&first| first as usize);
        DigitalEvent {
            level: Some(level),
            corner: corner.map(|first| [(first / columns) as i64, (first % columns) as i64]),
            mask: WordMask::ALL,
            words: WordMask::ALL.0.count_ones() * corners.len() as u32,
            ..DigitalEvent::new(tick, EventWord::Record, DigitalUnit::Drum(supplied.drums, drum))
        }
    };
    arrived.into_iter().map(record).collect()
}

/// Squares that become whole in the storage buffer.
fn last_records(sweeps: &FrameSweeps<'_>, supplied: &Supplied) -> Vec<DigitalEvent> {
    let Some(grid) = sweeps.grid(supplied.kind) else { return Vec::new() };
    let word = match supplied.kind {
        DataKind::Shadows => EventWord::ShadowRecord,
        DataKind::Polyhedra => EventWord::BodyRecord,
        _ => EventWord::FeatureRecord,
    };
    let square = |missing: &Missing| {
        let unit = DigitalUnit::Drum(supplied.drums, missing.drum);
        let event = DigitalEvent::new(missing.arrival?, word, unit);
        Some(DigitalEvent { corner: Some(grid.region_of(missing.item)), ..event })
    };
    supplied.supply().missing.iter().filter_map(square).collect()
}
