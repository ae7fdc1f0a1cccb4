//! Which events are listed.

use hardware_model::Settings;
use machine::{DigitalEvent, EventWord};
use sweep_program::Colour;

use crate::EventListError;
use crate::seen::Seen;

/// Units as the timing record calls them, and the first words of their names.
const UNITS: [&str; 17] = [
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
    "drum.features",
    "drum.shadows",
    "drum.polyhedra",
    "registers",
    "feature-generator",
    "shadow-controller",
];

/// Names of the levels of terrain, the finest first.
pub const LEVELS: [&str; 2] = ["fine", "coarse"];

/// Events that need the shadow gates of the frame.
const SEGMENTS: [EventWord; 3] = [EventWord::SegmentLoad, EventWord::SegmentLate, EventWord::SegmentDropped];

/// What an event must be to be listed. Where nothing is named, anything is listed.
#[derive(Debug, Clone, Default)]
pub struct Filter {
    /// Units by their names, or by the first words of their names ([`unit()`]).
    pub unit: Vec<String>,
    /// Names of the events to list.
    pub event: Vec<String>,
    /// Names of the colours to list.
    pub colour: Vec<String>,
    /// Level of terrain to list: one of [`LEVELS`].
    pub level: Option<String>,
    /// First tick to be listed.
    pub from: Option<u64>,
    /// The tick that ends the listing; it is not listed.
    pub to: Option<u64>,
}

/// Reads a unit: its name, the first words of some, or one drum by its number.
///
/// # Errors
/// In words what is expected, if there is no such unit.
pub fn unit(text: &str) -> Result<String, String> {
    let text = text.trim();
    let block = text.split('.').next().unwrap_or_default();
    if matches!(block, "editor" | "channel") {
        return Err(format!(
            "no event of {text} is listed, only its use (lunoid timing); its records are those of drum"
        ));
    }
    let is_drum = text.rsplit_once('.').is_some_and(|(drums, number)| {
        drums.starts_with("drum.") && UNITS.contains(&drums) && number.parse::<u32>().is_ok()
    });
    match is_drum || UNITS.contains(&text) {
        true => Ok(text.to_owned()),
        false => Err(format!("expected {}, or a drum by its number, as drum.fine.0", UNITS.join(", "))),
    }
}

impl Filter {
    /// Refuses levels and drums that the run does not have.
    ///
    /// # Errors
    /// If there is no such level or drum.
    pub fn expect_there(&self, settings: &Settings) -> Result<(), EventListError> {
        if self.level.as_deref() == Some("coarse") {
            expect_coarse("--level coarse".into(), settings)?;
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
                return Err(EventListError::NoDrums { asked });
            }
            if level == Some("coarse") {
                expect_coarse(asked.clone(), settings)?;
            }
            match number.is_some_and(|number: u32| number >= count) {
                false => Ok(()),
                true => Err(EventListError::NoSuchDrum { asked, count }),
            }
        })
    }

    /// Why none of the events that were seen is listed.
    ///
    /// # Errors
    /// If the ticks asked for are none of theirs.
    pub(crate) fn explain_none(&self, seen: &Seen) -> Result<String, EventListError> {
        let Some([first, last]) = seen.ticks else {
            return Ok("nothing found: there is no event in these sweeps".into());
        };
        let beyond = [
            self.from.filter(|&from| from > last).map(|from| format!("--from {from}")),
            self.to.filter(|&to| to <= first).map(|to| format!("--to {to}")),
        ];
        match beyond.into_iter().flatten().next() {
            Some(asked) => Err(EventListError::BeyondEvents { asked, first, last }),
            None => {
                let (count, units) = (seen.count, seen.units());
                Ok(format!("nothing found: none of {count} events is such; they are of {units}"))
            }
        }
    }

    /// Whether an event may be listed that needs the shadow gates of the frame.
    pub fn needs_gates(&self) -> bool {
        self.may_pass(&SEGMENTS, "shadow-controller.load")
    }

    /// Whether an event of one of `words` may be listed.
    fn may_pass(&self, words: &[EventWord], unit: &str) -> bool {
        words.iter().any(|word| is_among(&self.event, Some(word.name()))) && self.has_unit(unit)
    }

    /// Whether an event is listed.
    pub(crate) fn passes(&self, event: &DigitalEvent) -> bool {
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

/// Refuses the coarse level, as it was `asked` for, where there is none.
fn expect_coarse(asked: String, settings: &Settings) -> Result<(), EventListError> {
    if settings.levels.is_some() { Ok(()) } else { Err(EventListError::OneLevel { asked }) }
}

/// Whether a word is wanted: all are where none is named.
fn is_among(wanted: &[String], word: Option<&str>) -> bool {
    wanted.is_empty() || word.is_some_and(|word| wanted.iter().any(|wanted| wanted == word))
}
