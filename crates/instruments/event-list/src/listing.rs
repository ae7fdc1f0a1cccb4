//! The listing as text, CSV or JSON, made as it comes.

use std::fmt::Write;

use machine::{DigitalEvent, EventWord};
use serde_json::{Value, json};
use sweep_program::{Colour, MissCause, RampAxis, Stop};

use crate::DigitalFrame;

/// What a listing is written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Text in columns, for people.
    Text,
    /// A row an event.
    Csv,
    /// A document of schema `lunoid.trace/1`.
    Json,
}

/// Names of the columns of a listing as CSV, a line.
pub(crate) const CSV: &str = "tick,time_us,sweep,unit,event,level,crossing,axis,stop,colour,register,corner_north,corner_east,\
                   words,mask,slack_ticks,cause,comes_sample,set_up_of,part,crater,range_m\n";

/// A listing in the making; what it returns is to be written in that order.
pub struct Listing<'a> {
    frame: &'a DigitalFrame<'a>,
    form: Form,
    limit: u64,
    listed: u64,
    /// The tick of the last event that is listed.
    last: Option<u64>,
    /// The tick of the first event that the limit has kept out.
    next: Option<u64>,
}

impl<'a> Listing<'a> {
    /// Writes nothing yet: whoever finds no event may have another thing to say.
    pub fn new(frame: &'a DigitalFrame<'a>, form: Form, limit: Option<u64>) -> Self {
        Self { frame, form, limit: limit.unwrap_or(u64::MAX), listed: 0, last: None, next: None }
    }

    /// What comes before the first event.
    fn begin(&self) -> String {
        let frame = self.frame;
        let [start, end] = frame.ticks().map(|tick| tick.0);
        match self.form {
            Form::Text => format!(
                "frame {}: ticks {start}..{end} of {}\n{:>12} {:>11} {:>5}  {:<22} {}\n",
                frame.number, frame.timebase.master, "tick", "µs", "sweep", "unit", "event"
            ),
            Form::Csv => CSV.into(),
            Form::Json => format!(
                "{{\n  \"schema\": \"lunoid.trace/1\",\n  \"frame\": {},\n  \"ticks\": [{start}, {end}],\n  \"events\": [",
                frame.number
            ),
        }
    }

    /// Whether no event is listed.
    pub fn is_empty(&self) -> bool {
        self.listed == 0
    }

    /// Whether no more is listed.
    pub fn is_full(&self) -> bool {
        self.next.is_some()
    }

    /// Adds the events that follow and returns their text.
    pub fn add(&mut self, events: impl Iterator<Item = DigitalEvent>) -> String {
        let (mut text, was_empty) = (String::new(), self.is_empty());
        for event in events {
            // A tick is listed whole: who goes on at the next meets each event once.
            if self.listed >= self.limit && self.last != Some(event.tick.0) {
                self.next = self.next.or(Some(event.tick.0));
                break;
            }
            self.write(&event, &mut text);
            self.last = Some(event.tick.0);
            self.listed += 1;
        }
        if was_empty && !self.is_empty() { self.begin() + &text } else { text }
    }

    /// What is to be said of events that the limit has kept out.
    pub fn more(&self) -> Option<String> {
        self.next.map(|next| format!("{} events, and more: --from {next} goes on", self.listed))
    }

    /// What comes after the last.
    pub fn end(self) -> String {
        let begin = if self.is_empty() { self.begin() } else { String::new() };
        let end = match self.form {
            Form::Text => format!("events: {}\n", self.listed),
            Form::Csv => String::new(),
            Form::Json => format!(
                "\n  ],\n  \"listed\": {},\n  \"is_all\": {},\n  \"next\": {}\n}}\n",
                self.listed,
                self.next.is_none(),
                json!(self.next)
            ),
        };
        begin + &end
    }

    fn write(&self, event: &DigitalEvent, text: &mut String) {
        let time = self.frame.microseconds(event.tick);
        // Text that grows in memory takes everything.
        let _ = match self.form {
            Form::Text => writeln!(
                text,
                "{:>12} {time:>11.3} {:>5}  {:<22} {:<15} {}",
                event.tick.0,
                or_empty(event.sweep),
                event.unit.to_string(),
                event.event.name(),
                details(event)
            ),
            Form::Csv => writeln!(text, "{}", row(event, time)),
            Form::Json => {
                let comma = if self.listed == 0 { "" } else { "," };
                write!(text, "{comma}\n    {}", document(event, time))
            }
        };
    }
}

/// One event in a line: its tick, who does it, and what.
pub fn told(event: &DigitalEvent) -> String {
    let (tick, unit, word) = (event.tick.0, event.unit, event.event.name());
    format!("tick {tick}: {unit} {word} {}", details(event)).trim_end().to_owned()
}

fn or_empty(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn axis_word(axis: RampAxis) -> &'static str {
    if axis == RampAxis::X { "x" } else { "y" }
}

fn stop_number(stop: Stop) -> u8 {
    u8::from(stop == Stop::One)
}

fn cause_word(cause: MissCause) -> &'static str {
    match cause {
        MissCause::Access => "access",
        MissCause::Queue => "queue",
        MissCause::HeldBack => "held-back",
    }
}

fn level_word(level: usize) -> &'static str {
    if level == 0 { "fine" } else { "coarse" }
}

/// What a person wants to know of an event beside its head.
fn details(event: &DigitalEvent) -> String {
    let mut words: Vec<String> = Vec::new();
    words.extend(event.level.filter(|level| *level > 0).map(|level| level_word(level).to_owned()));
    words.extend(event.fold.map(|fold| format!("{} at {}", axis_word(fold.axis), stop_number(fold.stop))));
    words.extend(event.colour.map(|colour| colour.name().to_owned()));
    words.extend(event.register.map(|register| register.name().to_owned()));
    words.extend(event.crater.map(|crater| format!("crater {crater}")));
    words.extend(event.part.map(|part| part.to_string()));
    words.extend(event.range.map(|range| format!("at {range:.2} m")));
    let place = if event.event.is_of_square() { "square at region" } else { "corner" };
    words.extend(event.corner.map(|[m, n]| format!("{place} {m} {n}")));
    words.extend(Some(event.words).filter(|words| *words > 0).map(|count| format!("words {count}")));
    // All nine words of a set need no mask; what is loaded into other parts comes whole.
    words.extend(
        Some(event.mask.0)
            .filter(|mask| *mask != 0 && *mask != 0x1ff && event.range.is_none())
            .map(|mask| format!("mask {mask:#05x}")),
    );
    words.extend(event.crossing.map(|crossing| format!("crossing {crossing}")));
    words.extend(event.slack.map(|slack| match slack < 0 {
        true => format!("{} ticks late", -slack),
        false => format!("{slack} ticks left"),
    }));
    words.extend(event.cause.map(|cause| format!("cause {}", cause_word(cause))));
    if event.event == EventWord::Late && event.comes.is_none() {
        words.push("never comes".into());
    }
    words.extend(event.other.map(|sweep| format!("set-up of sweep {sweep}")));
    words.join(", ")
}

fn row(event: &DigitalEvent, time: f64) -> String {
    let [north, east] = [0, 1].map(|axis| or_empty(event.corner.map(|corner| corner[axis])));
    [
        event.tick.0.to_string(),
        format!("{time:.3}"),
        or_empty(event.sweep),
        event.unit.to_string(),
        event.event.name().to_owned(),
        or_empty(event.level.map(level_word)),
        or_empty(event.crossing),
        or_empty(event.fold.map(|fold| axis_word(fold.axis))),
        or_empty(event.fold.map(|fold| stop_number(fold.stop))),
        or_empty(event.colour.map(Colour::name)),
        or_empty(event.register.map(|register| register.name())),
        north,
        east,
        event.words.to_string(),
        event.mask.0.to_string(),
        or_empty(event.slack),
        or_empty(event.cause.map(cause_word)),
        or_empty(event.comes.map(|comes| comes.0)),
        or_empty(event.other),
        or_empty(event.part),
        or_empty(event.crater),
        or_empty(event.range),
    ]
    .join(",")
}

/// One event as an object; `time` from the start of its frame (µs).
pub(crate) fn document(event: &DigitalEvent, time: f64) -> Value {
    json!({
        "tick": event.tick.0,
        "time_us": time,
        "sweep": event.sweep,
        "unit": event.unit.to_string(),
        "event": event.event.name(),
        "level": event.level.map(level_word),
        "crossing": event.crossing,
        "axis": event.fold.map(|fold| axis_word(fold.axis)),
        "stop": event.fold.map(|fold| stop_number(fold.stop)),
        "colour": event.colour.map(Colour::name),
        "register": event.register.map(|register| register.name()),
        "corner": event.corner,
        "words": event.words,
        "mask": event.mask.0,
        "slack_ticks": event.slack,
        "cause": event.cause.map(cause_word),
        "comes_sample": event.comes.map(|comes| comes.0),
        "set_up_of": event.other,
        "part": event.part.map(|part| part.to_string()),
        "crater": event.crater,
        "range_m": event.range,
    })
}
