//! What is at a place, as text and as a document.

use event_list::{At, Registers};
use serde_json::{Value, json};
use signal::Unit as SignalUnit;
use text::table;

use crate::events::Events;
use crate::{Bench, Block, Gone, Place, State, StateError, Unit};

/// The main signals of a sweep, in the order of the figure.
const SIGNALS: [&str; 12] = [
    "sweep.range",
    "sweep.x",
    "sweep.y",
    "tg.height",
    "tg.slope.u",
    "tg.slope.v",
    "tg.reflectivity",
    "mu.height",
    "mu.reflectivity",
    "dpp.blank",
    "dpp.y",
    "sm.video",
];

/// What is at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    place: Place,
    tick: u64,
    time_s: f64,
    sample: f64,
    /// Each as a line, and as a document; none where nobody asked.
    events: Option<Vec<(String, Value)>>,
    /// The same of the registers.
    registers: Option<(String, Value)>,
    signals: Vec<(&'static str, SignalUnit, f64)>,
}

impl Bench<'_> {
    /// What is at `place` for whoever steps by `unit`: events of a tick, signals and registers of a sample, registers of a start.
    ///
    /// # Errors
    /// If the frame cannot be drawn.
    pub fn look(&self, place: Place, unit: Unit) -> Result<Look, StateError> {
        let clock = self.clock();
        let mut look = Look {
            place,
            tick: clock.tick(place).0,
            time_s: clock.seconds(place),
            sample: clock.time(place).0,
            events: None,
            registers: None,
            signals: Vec::new(),
        };
        match unit {
            Unit::Tick | Unit::Event => look.events = Some(Events::new(self).at(place)?),
            Unit::Sample => {
                look.signals = self.signals(place)?;
                look.registers = Some(self.registers(place)?);
            }
            Unit::Sweep | Unit::Frame => look.registers = Some(self.registers(place)?),
        }
        Ok(look)
    }

    /// The last samples at or before a place.
    fn signals(&self, place: Place) -> Result<Vec<(&'static str, SignalUnit, f64)>, StateError> {
        let sample = self.clock().time(place).0 as usize;
        let probe = self.probe(place, &SIGNALS)?;
        let at_sample = |waveform: &signal::Waveform| {
            let value = waveform.values.get(sample).or(waveform.values.last())?;
            Some((waveform.signal.name, waveform.signal.unit, *value))
        };
        Ok(probe.waveforms.iter().filter_map(at_sample).collect())
    }

    fn registers(&self, place: Place) -> Result<(String, Value), StateError> {
        let frame = self.digital_frame(place.frame, false)?;
        let at = match place.gone {
            Gone::Nothing => At::Sample(place.sweep, 0.0),
            Gone::Ticks(_) => At::Tick(self.clock().tick(place)),
            Gone::Samples(sample) => At::Sample(place.sweep, sample.into()),
        };
        let registers = Registers::new(&frame, at)?;
        Ok((registers.text(), registers.json()))
    }
}

impl Look {
    /// The same in lines for people.
    pub fn text(&self) -> String {
        let Self { place, tick, time_s, sample, .. } = self;
        let mut text = format!("{place}: tick {tick}, sample {sample:.3}, {time_s:.9} s\n");
        for (line, _) in self.events.iter().flatten() {
            text += &format!("  {line}\n");
        }
        if self.events.as_ref().is_some_and(Vec::is_empty) {
            text += "  no event\n";
        }
        if !self.signals.is_empty() {
            let row = |(name, unit, value): &(&str, SignalUnit, f64)| {
                vec![(*name).to_owned(), format!("{value:.6}"), unit.symbol().to_owned()]
            };
            text += &format!("\n{}", table(&self.signals.iter().map(row).collect::<Vec<_>>()));
        }
        if let Some((registers, _)) = &self.registers {
            // The first line of them says the place again.
            let tables = registers.split_once('\n').map_or("", |(_, tables)| tables);
            text += tables;
        }
        text
    }

    /// The same as a document.
    pub fn json(&self) -> Value {
        let signals = self.signals.iter();
        let signals = signals
            .map(|(name, unit, value)| json!({ "signal": name, "unit": unit.symbol(), "value": value }));
        json!({
            "place": self.place,
            "tick": self.tick,
            "time_s": self.time_s,
            "sample": self.sample,
            "events": self.events.as_ref().map(|all| all.iter().map(|(_, event)| event).collect::<Vec<_>>()),
            "signals": (!self.signals.is_empty()).then(|| signals.collect::<Vec<_>>()),
            "registers": self.registers.as_ref().map(|(_, document)| &document["levels"]),
        })
    }
}

impl State {
    /// What it holds, in lines for people.
    pub fn text(&self) -> String {
        let head = &self.head;
        let mut text = format!(
            "{} on {}: {}\n  tick {}, {:.9} s\n",
            head.identity.scenario, head.identity.machine, head.place, head.tick, head.time_s
        );
        for block in &self.blocks {
            text += &format!("  {}\n", block.header());
        }
        text
    }

    /// The same as a document.
    pub fn json(&self) -> Value {
        let head = &self.head;
        json!({
            "saved_by": head.identity,
            "words": head.words,
            "place": head.place,
            "tick": head.tick,
            "time_s": head.time_s,
            "digital": serde_json::from_str::<Value>(&self.digital).ok(),
            "blocks": self.blocks.iter().map(Block::header).collect::<Vec<_>>(),
        })
    }
}
