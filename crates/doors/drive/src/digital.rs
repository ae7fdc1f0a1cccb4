//! The digital events of a frame.

use std::ops::Range;

use diagnostics::Problem;
use event_list::{DigitalFrame, EventListError, Filter, Form, Order, list, unit};
use machine::EventWord;
use serde_json::Value;
use sweep_program::Colour;

use crate::{DriveError, Viewpoint};

/// Which events are listed.
#[derive(Debug, Clone, Default)]
pub struct EventWishes {
    /// Sweeps whose events are listed; all of them, and events of no sweep, if left out.
    pub sweeps: Option<Range<u32>>,
    /// What an event must be.
    pub filter: Filter,
    /// Most events that are listed, and those of the same tick as the last.
    pub limit: Option<u64>,
}

/// Digital events of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Events {
    /// The document of `lunoid trace --json`: schema `lunoid.trace/1`.
    pub document: Value,
    /// Why the list is empty, or at which tick it goes on.
    pub note: Option<String>,
    /// Length of a tick (µs).
    pub tick_us: f64,
}

impl Viewpoint<'_> {
    /// Lists digital events in the order of their ticks.
    ///
    /// # Errors
    /// If the hybrid machine does not draw, there is no such sweep, unit, event or colour, or the pose cannot be drawn.
    pub fn events(&self, wishes: &EventWishes) -> Result<Events, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let file = drive.file();
        if !drive.opened.is_machine() {
            let title = format!("{} has no digital events", drive.drawn_by());
            let problem = Problem::of_file(file, title).expected("a hardware model");
            return Err(match drive.opened.generator.has_deadlines() {
                true => problem.help("its deadlines are counted by `timing`").into(),
                false => problem.into(),
            });
        }
        let settings = &bench.machine.settings;
        self.expect_words(&wishes.filter)?;
        wishes.filter.expect_there(settings).map_err(|error| DriveError::of(file, &error))?;
        let all = 0..settings.raster.sweeps;
        let sweeps = wishes.sweeps.clone().unwrap_or(all.clone());
        self.expect_sweeps(&sweeps, all.end)?;
        let order = Order {
            sweeps,
            is_whole: wishes.sweeps.is_none(),
            filter: &wishes.filter,
            form: Form::Json,
            limit: wishes.limit,
        };
        let (mut text, gates) = (String::new(), wishes.filter.needs_gates());
        let note = drive.pool.install(|| {
            let frame = DigitalFrame::new(bench.control(), &bench.machine, (*frame, pose), gates);
            let frame = frame.map_err(|error| DriveError::of(file, &error))?;
            let mut write = |piece: &str| {
                text.push_str(piece);
                Ok::<(), EventListError>(())
            };
            list(&frame, &order, &mut write).map_err(|error| DriveError::of(file, &error))
        })?;
        let document = serde_json::from_str(&text).map_err(|error| DriveError::of(file, &error))?;
        Ok(Events { document, note, tick_us: 1e6 / settings.timebase.master.hertz() })
    }

    /// Sees that units, events and colours are known.
    fn expect_words(&self, filter: &Filter) -> Result<(), DriveError> {
        let no_unit = filter.unit.iter().find_map(|name| Some((name, unit(name).err()?)));
        let events = EventWord::ALL.iter().map(|word| word.name()).collect();
        let colours = Colour::ALL.map(Colour::name).to_vec();
        let wrong = no_unit.map(|(name, said)| ("unit", name, said));
        let wrong = wrong.or_else(|| stranger("event", &filter.event, events));
        match wrong.or_else(|| stranger("colour", &filter.colour, colours)) {
            None => Ok(()),
            Some((what, name, said)) => {
                let problem = Problem::of_file(self.drive.file(), format!("no {what} `{name}`"));
                Err(problem.key(what).found(name).expected(said.trim_start_matches("expected ")).into())
            }
        }
    }
}

/// The first of `names` that is not among `known`, with what `what` may be.
fn stranger<'a>(
    what: &'static str,
    names: &'a [String],
    known: Vec<&str>,
) -> Option<(&'static str, &'a String, String)> {
    let name = names.iter().find(|name| !known.contains(&name.as_str()))?;
    Some((what, name, format!("one of {}", known.join(", "))))
}
