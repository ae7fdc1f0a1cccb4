//! Which events are listed.

use clap::Args;
use clap::builder::PossibleValuesParser;
use hardware_model::Settings;
use machine::{DigitalEvent, EventWord};
use sweep_program::Colour;

use super::seen::Seen;
use crate::output::tell;
use crate::rehearsing::expect_coarse;
use crate::{Failure, values};

/// Units as the timing record calls them, and the first words of their names.
const UNITS: [&str; 14] = [
    "dpu",
    "loader",
    "loader.yellow",
    "loader.green",
    "loader.black",
    "loader.red",
    "io-processor",
    "cpu",
    "drum",
    "drum.fine",
    "drum.coarse",
    "registers",
    "feature-generator",
    "shadow-controller",
];

const LEVELS: [&str; 2] = ["fine", "coarse"];

/// What an event must be to be listed.
#[derive(Debug, Clone, Default, Args)]
pub struct Filter {
    /// Units, separated by commas: dpu, loader (all colours) or loader.COLOUR, io-processor, cpu, registers, drum or
    /// drum.LEVEL or drum.LEVEL.NUMBER, feature-generator, shadow-controller.
    #[arg(long, value_name = "UNITS", value_delimiter = ',', value_parser = unit)]
    pub unit: Vec<String>,
    /// Events, separated by commas.
    #[arg(long, value_name = "EVENTS", value_delimiter = ',',
          value_parser = PossibleValuesParser::new(EventWord::ALL.iter().map(|word| word.name())))]
    pub event: Vec<String>,
    /// Colours, separated by commas.
    #[arg(long, value_name = "COLOURS", value_delimiter = ',',
          value_parser = PossibleValuesParser::new(Colour::ALL.map(Colour::name)))]
    pub colour: Vec<String>,
    /// Level of terrain.
    #[arg(long, value_name = "LEVEL", value_parser = PossibleValuesParser::new(LEVELS))]
    pub level: Option<String>,
    /// First tick.
    #[arg(long, value_name = "TICK", value_parser = values::at_least(0_u64))]
    pub from: Option<u64>,
    /// The tick that ends the listing; it is not listed.
    #[arg(long, value_name = "TICK", value_parser = values::at_least(0_u64))]
    pub to: Option<u64>,
}

/// A unit, the first words of some, or one drum by its number.
fn unit(text: &str) -> Result<String, String> {
    let text = text.trim();
    let is_drum = text.rsplit_once('.').is_some_and(|(drums, number)| {
        matches!(drums, "drum.fine" | "drum.coarse") && number.parse::<u32>().is_ok()
    });
    match is_drum || UNITS.contains(&text) {
        true => Ok(text.to_owned()),
        false => Err(format!("expected {}, or a drum by its number, as drum.fine.0", UNITS.join(", "))),
    }
}

impl Filter {
    /// Refuses levels and drums that the run does not have.
    pub fn expect_there(&self, settings: &Settings) -> Result<(), Failure> {
        if self.level.as_deref() == Some("coarse") {
            expect_coarse("--level coarse", settings)?;
        }
        let count = settings.data_banks.drum.map_or(0, |drum| drum.count);
        self.unit.iter().try_for_each(|unit| {
            let asked = format!("--unit {unit}");
            let mut parts = unit.split('.');
            if parts.next() != Some("drum") {
                return Ok(());
            }
            let (level, number) = (parts.next(), parts.next().and_then(|number| number.parse().ok()));
            if count == 0 {
                return Err(Failure::usage(format!(
                    "{asked}: the machine has no drums, all words are at hand; leave it out, or give --machine a model with \
                     drums"
                )));
            }
            if level == Some("coarse") {
                expect_coarse(&asked, settings)?;
            }
            match number.is_some_and(|number: u32| number >= count) {
                false => Ok(()),
                true => Err(Failure::usage(format!(
                    "{asked}: each level has drums 0..{count}; expected one of them"
                ))),
            }
        })
    }

    /// Says why none of the events that were seen is listed.
    ///
    /// # Errors
    /// If the ticks asked for are none of theirs.
    pub fn explain_none(&self, seen: &Seen) -> Result<(), Failure> {
        let Some([first, last]) = seen.ticks else {
            tell("nothing found: there is no event in these sweeps\n");
            return Ok(());
        };
        let beyond = [
            self.from.filter(|&from| from > last).map(|from| format!("--from {from}")),
            self.to.filter(|&to| to <= first).map(|to| format!("--to {to}")),
        ];
        match beyond.into_iter().flatten().next() {
            Some(asked) => Err(Failure::usage(format!(
                "{asked}: the events are at ticks {first} to {last}; expected a tick there"
            ))),
            None => {
                let (count, units) = (seen.count, seen.units());
                tell(&format!("nothing found: none of {count} events is such; they are of {units}\n"));
                Ok(())
            }
        }
    }

    /// Whether an event of one of `words` may be listed.
    pub fn may_pass(&self, words: &[EventWord], unit: &str) -> bool {
        words.iter().any(|word| is_among(&self.event, Some(word.name()))) && self.has_unit(unit)
    }

    /// Whether an event is listed.
    pub fn passes(&self, event: &DigitalEvent) -> bool {
        let (ticks, colour) = (event.tick.0, event.colour.map(Colour::name));
        let level = event.level.map(|level| LEVELS[level.min(1)]);
        self.from.is_none_or(|from| ticks >= from)
            && self.to.is_none_or(|to| ticks < to)
            && is_among(&self.event, Some(event.event.name()))
            && is_among(&self.colour, colour)
            && self.level.as_deref().is_none_or(|wanted| level == Some(wanted))
            && self.has_unit(&event.unit.to_string())
    }

    fn has_unit(&self, unit: &str) -> bool {
        let is_it = |wanted: &String| {
            unit == wanted || unit.strip_prefix(wanted.as_str()).is_some_and(|rest| rest.starts_with('.'))
        };
        self.unit.is_empty() || self.unit.iter().any(is_it)
    }
}

/// Whether a word is wanted: all are where none is named.
fn is_among(wanted: &[String], word: Option<&str>) -> bool {
    wanted.is_empty() || word.is_some_and(|word| wanted.iter().any(|wanted| wanted == word))
}
