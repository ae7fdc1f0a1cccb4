//! All registers at one instant.

use landscape::Level;
use machine::{RegisterState, RegisterWords};
use serde_json::{Value, json};
use sweep_program::{Colour, NO_CORNER, WordMask};

use crate::frame::Instant;
use crate::{At, DigitalFrame, EventListError};
use text::table;

const REGISTERS: [&str; 3] = ["hold", "x-first", "y-first"];

/// The registers of both levels at an instant.
pub struct Registers<'a> {
    frame: &'a DigitalFrame<'a>,
    at: Instant,
    /// State of the registers of each level.
    states: Vec<RegisterState>,
}

impl<'a> Registers<'a> {
    /// The registers of `frame` at `at`.
    ///
    /// # Errors
    /// If the frame does not have the instant.
    pub fn new(frame: &'a DigitalFrame<'a>, at: At) -> Result<Self, EventListError> {
        let at = frame.instant(at)?;
        let states = frame.sweeps.registers(at.sweep, at.time).into_iter().collect();
        Ok(Self { frame, at, states })
    }

    fn levels(&self) -> impl Iterator<Item = (&RegisterState, &Level, &'static str)> {
        let named = self.states.iter().zip(self.frame.levels).zip(["fine", "coarse"]);
        named.map(|((state, level), name)| (state, level, name))
    }

    /// A document of schema `lunoid.trace.at/1`.
    pub fn json(&self) -> Value {
        let (frame, at) = (self.frame, &self.at);
        let levels: Vec<Value> =
            self.levels().map(|(state, level, name)| document(state, level, name)).collect();
        json!({
            "schema": "lunoid.trace.at/1",
            "frame": frame.number,
            "sweep": at.sweep,
            "drawn_with": frame.sweeps.set_up_of(at.sweep),
            "sample": at.time.0,
            "tick": at.tick.0,
            "time_us": frame.microseconds(at.tick),
            "levels": levels,
        })
    }

    /// A table a level.
    pub fn text(&self) -> String {
        let (frame, at) = (self.frame, &self.at);
        let time = frame.microseconds(at.tick);
        let head = format!(
            "frame {}, sweep {}, sample {:.3}, tick {}, {time:.3} µs\n",
            frame.number, at.sweep, at.time.0, at.tick.0
        );
        let drawn = match frame.sweeps.set_up_of(at.sweep) {
            own if own == at.sweep => String::new(),
            other => format!("drawn with the set-up of sweep {other}\n"),
        };
        self.levels().fold(head + &drawn, |text, (state, level, name)| text + &told(state, level, name))
    }
}

/// North and east index of a corner.
fn place(corner: u32, level: &Level) -> Option<[usize; 2]> {
    let columns = level.corners()[1];
    (corner != NO_CORNER).then_some([corner as usize / columns, corner as usize % columns])
}

fn place_text(corner: Option<u32>, level: &Level) -> String {
    match corner.and_then(|corner| place(corner, level)) {
        Some([m, n]) => format!("{m} {n}"),
        None => "none".into(),
    }
}

fn told(state: &RegisterState, level: &Level, name: &str) -> String {
    let RegisterState { ramps, polarity, folds, range, .. } = state;
    let head = format!(
        "\n{name} level at {range:.2} m: ramps {:.4} {:.4}, s_x {:+}, s_y {:+}, folds {} {}\n",
        ramps[0], ramps[1], polarity[0], polarity[1], folds[0], folds[1]
    );
    let mut rows = vec![["register", "corner", "asked for", "stale words"].map(String::from).to_vec()];
    for (colour, registers) in Colour::ALL.into_iter().zip(&state.colours) {
        rows.extend(REGISTERS.into_iter().zip(registers).map(|(register, words)| {
            vec![
                format!("{} {register}", colour.name()),
                place_text(words.corner(), level),
                place_text(Some(words.wanted), level),
                stale_text(words.stale()),
            ]
        }));
    }
    head + &table(&rows)
}

fn stale_text(stale: WordMask) -> String {
    match stale {
        WordMask(0) => "-".into(),
        WordMask::ALL => "all".into(),
        WordMask(mask) => format!("{} of 9, mask {mask:#05x}", mask.count_ones()),
    }
}

fn document(state: &RegisterState, level: &Level, name: &str) -> Value {
    let register = |colour: Colour, register: &str, words: &RegisterWords| {
        json!({
            "colour": colour.name(),
            "register": register,
            "corner": words.corner().and_then(|corner| place(corner, level)),
            "asked_for": place(words.wanted, level),
            "stale": words.stale().0,
            "words": words.corners.map(|corner| place(corner, level)),
        })
    };
    let registers: Vec<Value> = Colour::ALL
        .into_iter()
        .zip(&state.colours)
        .flat_map(|(colour, words)| {
            REGISTERS.into_iter().zip(words).map(move |(name, words)| register(colour, name, words))
        })
        .collect();
    json!({
        "level": name,
        "range_m": state.range,
        "ramps": state.ramps,
        "polarity": state.polarity,
        "folds": state.folds,
        "registers": registers,
    })
}
