//! Which events are listed.

use clap::Args;
use clap::builder::PossibleValuesParser;
use machine::{DigitalEvent, EventWord};
use sweep_program::Colour;

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
    #[arg(long, value_name = "TICK")]
    pub from: Option<u64>,
    /// The tick that ends the listing; it is not listed.
    #[arg(long, value_name = "TICK")]
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
