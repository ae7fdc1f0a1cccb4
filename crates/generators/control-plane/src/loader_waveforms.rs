//! Digital wires of what serves the crossings over a sweep, folded from the events of the service.

use std::sync::LazyLock;

use dpu::{ServiceEvent, Watch};
use quantities::Tick;
use signal::{Kind, Signal, Unit};
use sweep_program::{Colour, SweepProgram};

use crate::crossings::Crossings;
use crate::stretches::SweepTicks;
use crate::waveforms::Changes;

/// Wires of the service of the crossings, colour by colour on both levels.
pub(crate) static LOADER_WIRES: LazyLock<Vec<Signal>> = LazyLock::new(|| {
    let of_colour = |(level, colour): (&str, Colour)| {
        let wire = |word: &str, meaning: &'static str| {
            // Names of wires live as long as the program: the table is made once.
            let name = format!("loader.{level}{}.{word}", colour.name()).leak();
            Signal::digital(name, Unit::Number, Kind::Bus, meaning, "fig. 22")
        };
        [
            wire(
                "waiting",
                "sets of nine words that the crossings have asked for and nobody has begun to fetch",
            ),
            wire(
                "crossing",
                "crossing of the sweep that asked for the set whose fetch began last; -1: none yet",
            ),
        ]
    };
    let levels = ["", "coarse."].into_iter();
    levels.flat_map(|level| Colour::ALL.map(|colour| (level, colour))).flat_map(of_colour).collect()
});

/// What happens to the sets of a colour at a tick.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SetEvent {
    Asked,
    /// Its colour has moved on before anyone fetched it.
    Cancelled,
    /// Its first access begins, for this crossing.
    Begun(u32),
}

/// Hears of the sets of one colour.
#[derive(Debug)]
struct Sets {
    colour: Colour,
    heard: Vec<(Tick, SetEvent)>,
}

impl Watch for Sets {
    fn tell(&mut self, tick: Tick, event: ServiceEvent) {
        let heard = match event {
            ServiceEvent::Wanted(set) if set.colour == self.colour => Some(SetEvent::Asked),
            ServiceEvent::Cancelled(set) if set.colour == self.colour => Some(SetEvent::Cancelled),
            ServiceEvent::Access(asked) if asked.colour == self.colour => asked.crossing.map(SetEvent::Begun),
            _ => None,
        };
        self.heard.extend(heard.map(|event| (tick, event)));
    }
}

/// What the wire of this name does in a sweep that is drawn with the set-up of sweep `drawn`. Nothing on a level that is not there.
pub(crate) fn loader_changes(
    name: &str,
    crossings: &Crossings<'_>,
    [drawn, number]: [u32; 2],
    sweep: &SweepTicks,
) -> Changes {
    let is_coarse = name.contains(".coarse.");
    let mut words = name.trim_start_matches("loader.").trim_start_matches("coarse.").split('.');
    let colour = words.next().and_then(|word| Colour::ALL.into_iter().find(|colour| colour.name() == word));
    let Some(colour) = colour else { return Changes::default() };
    let (mut sets, mut program) = (Sets { colour, heard: Vec::new() }, SweepProgram::idle());
    match (is_coarse, crossings.coarse) {
        (false, _) => crossings.write_fine([drawn, number], &mut program, &mut sets),
        (true, Some(coarse)) => crossings.write_coarse(coarse, [drawn, number], &mut program, &mut sets),
        (true, None) => return Changes::default(),
    }
    // What waits on a line is told when it is served.
    sets.heard.sort_by_key(|(tick, _)| *tick);
    let at = |tick: Tick| sweep.at(tick.0).max(0.0);
    let is_waiting = words.next() == Some("waiting");
    let (mut changes, mut waiting) = (Changes::default(), 0.0);
    changes.becomes(0.0, if is_waiting { 0.0 } else { -1.0 });
    // What is served when the sweep is over is the next one's time.
    for (tick, event) in sets.heard.into_iter().take_while(|(tick, _)| tick.0 < sweep.ticks.end) {
        waiting += if event == SetEvent::Asked { 1.0 } else { -1.0 };
        match event {
            _ if is_waiting => changes.becomes(at(tick), waiting),
            SetEvent::Begun(crossing) => changes.becomes(at(tick), f64::from(crossing)),
            SetEvent::Asked | SetEvent::Cancelled => {}
        }
    }
    changes
}
