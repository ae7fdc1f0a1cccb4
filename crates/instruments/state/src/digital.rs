//! The digital side at the start of a sweep, as lines of JSON.

use data_bank::{BankState, DrumState, Heads, HeldRecord, StoreState};
use generator::FrameError;
use landscape::{Level, WORDS};
use machine::{
    ControlPlane, DataKind, DigitalUnit, EventWord, FrameSweeps, MachineStage, RegisterState, RegisterWords,
};
use quantities::{SweepTime, Tick};
use scenario::Pose;
use serde_json::{Map, Value, json};
use sweep_program::{Colour, NO_CORNER, SweepProgram};

use crate::Fault;

const LEVELS: [&str; 2] = ["fine", "coarse"];
const REGISTERS: [&str; 3] = ["hold", "x-first", "y-first"];

/// Registers, processor and data banks of a machine at the start of a sweep.
pub(crate) struct Digital<'a> {
    pub control: &'a ControlPlane,
    pub stage: &'a MachineStage,
    pub frame: u64,
    pub sweep: u32,
    /// Tick that sees the start.
    pub tick: Tick,
}

impl Digital<'_> {
    /// The lines, of which each ends.
    pub(crate) fn text(&self, pose: &Pose) -> Result<String, FrameError> {
        let sweeps = self.control.sweeps(self.frame, pose)?;
        let states = sweeps.registers(self.sweep, SweepTime(0.0));
        let programs = sweeps.programs(self.sweep);
        let levels = self.stage.landscape.bank().levels();
        let levels = states.iter().zip(&programs).zip(levels).zip(LEVELS);
        let raster = &self.stage.settings.raster;
        let banks = self.control.banks_before(self.frame);
        let banks: Vec<Value> = banks.iter().map(|(kinds, bank)| bank_value(kinds, bank)).collect();
        let document = json!({
            "levels": levels.map(|(((state, program), level), name)| level_value(name, state, program, level))
                .collect::<Vec<_>>(),
            "processor": self.processor(&sweeps),
            "banks_as_the_frame_begins": banks,
            "noise_address": self.frame * u64::from(raster.sweeps) + u64::from(self.sweep),
        });
        Ok(serde_json::to_string_pretty(&document).expect("plain values") + "\n")
    }

    /// What the processor has made by now, and what it is at.
    fn processor(&self, sweeps: &FrameSweeps<'_>) -> Value {
        let mut in_work: Vec<(u32, u64)> = Vec::new();
        let mut last_made = None;
        let events = sweeps.frame_events();
        let events = events.iter().filter(|event| event.unit == DigitalUnit::Cpu && event.tick <= self.tick);
        for event in events {
            let Some(sweep) = event.sweep else { continue };
            match event.event {
                EventWord::SetUpBegins => in_work.push((sweep, event.tick.0)),
                EventWord::SetUp | EventWord::SetUpLate => {
                    in_work.retain(|(begun, _)| *begun != sweep);
                    last_made = Some(json!({ "sweep": sweep, "tick": event.tick.0 }));
                }
                _ => {}
            }
        }
        let in_work = in_work.last().map(|(sweep, tick)| json!({ "sweep": sweep, "since_tick": tick }));
        json!({
            "set_up_of": sweeps.set_up_of(self.sweep),
            "last_set_up": last_made,
            "in_work": in_work,
            "vertices_asked": sweeps.vertices_asked(),
        })
    }
}

/// Refuses lines that are not `expected`.
pub(crate) fn expect(found: &str, expected: &str) -> Result<(), Fault> {
    if found == expected {
        return Ok(());
    }
    let (mut left, mut right) = (found.lines(), expected.lines());
    for line in 1.. {
        let (found, expected) = (left.next(), right.next());
        if found != expected || found.is_none() {
            let [found, expected] =
                [found, expected].map(|line| line.map_or("the end", str::trim).to_owned());
            return Err(Fault::Digital { line, found, expected });
        }
    }
    Ok(())
}

fn level_value(name: &str, state: &RegisterState, program: &SweepProgram, level: &Level) -> Value {
    let mut registers = Map::new();
    for (colour, sets) in Colour::ALL.into_iter().zip(&state.colours) {
        for (register, words) in REGISTERS.into_iter().zip(sets) {
            registers.insert(format!("{} {register}", colour.name()), register_value(words, level));
        }
    }
    let start = &program.start;
    json!({
        "level": name,
        "direction": start.direction,
        "region": start.region,
        "accumulators": state.ramps,
        "rates": start.ramps.map(|ramp| ramp.rate),
        "polarity": state.polarity,
        "folds": state.folds,
        "registers": registers,
    })
}

/// Words of a corner that no drum has brought are 0.
fn register_value(words: &RegisterWords, level: &Level) -> Value {
    let word = |index: usize| match words.corners[index] {
        NO_CORNER => 0.0,
        corner => level.words()[corner as usize][index],
    };
    let place = |corner: u32| {
        let columns = level.corners()[1];
        (corner != NO_CORNER).then(|| [corner as usize / columns, corner as usize % columns])
    };
    json!({
        "corner": words.corner().and_then(place),
        "asked_for": place(words.wanted),
        "stale": words.stale().0,
        "words": (0..WORDS).map(word).collect::<Vec<f64>>(),
    })
}

/// A bank of drums with the stores of its kinds of data.
fn bank_value(kinds: &[DataKind], bank: &BankState) -> Value {
    let stores =
        kinds.iter().zip(&bank.stores).map(|(kind, store)| (kind.name().to_owned(), store_value(store)));
    json!({
        "stores": stores.collect::<Map<String, Value>>(),
        "drums": bank.drums.iter().map(|drum| drum_value(kinds, drum)).collect::<Vec<_>>(),
    })
}

fn store_value(store: &StoreState) -> Value {
    let order = |order: &data_bank::OrderedRecord| {
        format!("{}, ordered at tick {}", held(&order.wanted), order.requested)
    };
    let edited = |&(record, done): &(u32, u64)| format!("record {record}, done at tick {done}");
    json!({
        "is_loaded": store.loaded,
        "buffer": store.held.iter().map(held).collect::<Vec<_>>(),
        "orders": store.orders.iter().map(order).collect::<Vec<_>>(),
        "editing": store.editing.iter().map(edited).collect::<Vec<_>>(),
    })
}

fn held(held: &HeldRecord) -> String {
    format!("record {}, rank {} of frame {}", held.record, held.rank, held.frame)
}

fn drum_value(kinds: &[DataKind], drum: &DrumState) -> Value {
    let name = |store: u32| kinds[store as usize].name();
    let at = |what: &str, (store, record): (u32, u32), begun: u64, under: u64| {
        let kind = name(store);
        format!("{what} {kind} record {record} since tick {begun}, under the heads at tick {under}")
    };
    let heads = match drum.heads {
        Heads::Idle => "idle".to_owned(),
        Heads::Turning { store, record, begun, under } => at("turning to", (store, record), begun, under),
        Heads::Reading { store, record, begun, under } => at("reading", (store, record), begun, under),
    };
    let waiting = drum.waiting.iter().map(|&(store, record)| format!("{} record {record}", name(store)));
    json!({ "heads": heads, "waiting": waiting.collect::<Vec<_>>() })
}
