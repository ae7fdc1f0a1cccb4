//! The chain of the set that comes latest for its use.

use hardware_model::{CrossingServer, IoProcessor, Loader};
use machine::{FrameSweeps, MachineStage};
use quantities::{SweepClock, SweepTime};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use sweep_program::{Colour, PreloadRegister, RampAxis, SweepProgram};
use timing::Deadline;

use super::{Chain, Link, link};
use crate::levels::{DrawnLevel, drawn_levels};
use crate::sets::{AskedSet, Crossing, sets_of};

/// Words of a set.
const SET: u32 = 9;

/// A set and where it is.
struct Found<'a> {
    slack: f64,
    of: DrawnLevel<'a>,
    sweep: u32,
    index: usize,
}

/// The set that comes latest for its use, of all sweeps and levels; the first of several.
pub fn worst_transfer(stage: &MachineStage, sweeps: &FrameSweeps<'_>, frame: u64) -> Option<Chain> {
    let levels = drawn_levels(stage);
    let worst_of = |sweep: u32| {
        let programs = sweeps.programs(sweep);
        let found = levels.iter().filter_map(|of| worst_of_sweep(sweeps, &programs[of.number], *of, sweep));
        found.reduce(worse)
    };
    let all: Vec<_> = (0..stage.settings.raster.sweeps).into_par_iter().filter_map(worst_of).collect();
    let Found { of, sweep, index, .. } = all.into_iter().reduce(worse)?;
    let sets = sets(sweeps, &sweeps.programs(sweep)[of.number]);
    let timebase = stage.settings.timebase;
    let explained = Explained {
        loader: sweeps.loader(),
        clock: timebase.sweep_clock(frame, sweep),
        ticks_per_sample: timebase.ticks_per_sample(),
        of,
        sweep,
    };
    Some(explained.chain(&sets, index))
}

fn worse<'a>(a: Found<'a>, b: Found<'a>) -> Found<'a> {
    if b.slack < a.slack { b } else { a }
}

fn sets(sweeps: &FrameSweeps<'_>, program: &SweepProgram) -> Vec<AskedSet> {
    let mut sets = Vec::new();
    sets_of(program, sweeps.loader().is_wired_through(), &mut sets);
    sets
}

fn worst_of_sweep<'a>(
    sweeps: &FrameSweeps<'_>,
    program: &SweepProgram,
    of: DrawnLevel<'a>,
    sweep: u32,
) -> Option<Found<'a>> {
    let used = sets(sweeps, program).into_iter().enumerate().filter(|(_, set)| set.used.is_some());
    let found = used.map(|(index, set)| {
        let slack = set.slack().unwrap_or(f64::NEG_INFINITY);
        Found { slack, of, sweep, index }
    });
    found.reduce(worse)
}

/// A sweep whose sets are being explained.
struct Explained<'a> {
    loader: &'a Loader,
    clock: SweepClock,
    ticks_per_sample: f64,
    of: DrawnLevel<'a>,
    sweep: u32,
}

impl Explained<'_> {
    fn chain(&self, sets: &[AskedSet], index: usize) -> Chain {
        let set = &sets[index];
        let (asked, came) = match set.came {
            // Words that come with the fold itself are there at the last tick before it, as in the record.
            Some(came) if came == set.asked.time => (self.last_before(came), Some(self.last_before(came))),
            came => (self.seen(set.asked.time), came.map(|came| self.arrival(came))),
        };
        let due = set.used.map_or(asked, |used| self.last_before(used.time));
        let links = match came {
            Some(came) => self.links(sets, index, asked, came),
            None => vec![self.wait(sets, index, asked, due)],
        };
        Chain {
            deadline: Deadline::TRANSFER,
            what: self.what(set),
            links,
            slack: came.map(|came| due - came),
        }
    }

    fn what(&self, set: &AskedSet) -> String {
        let Self { of, sweep, .. } = self;
        let used = set.used.map_or(String::new(), |used| format!(", due at {}", crossing_text(&used)));
        let asked = crossing_text(&set.asked);
        format!("{} level, sweep {sweep}: {}, asked for at {asked}{used}", of.name, name(set))
    }

    fn links(&self, sets: &[AskedSet], index: usize, asked: i64, came: i64) -> Vec<Link> {
        let loader = self.loader;
        let unit = unit_of(loader, sets[index].colour);
        let IoProcessor { chain, edit, .. } = loader.channel_programme();
        let access = accesses(loader) * loader.access as i64;
        let [chain, edit] = [chain as i64, i64::from(SET) * edit as i64];
        let begin = came - loader.strobe as i64 - access - edit - loader.pointer as i64 - chain;
        let words = loader.words_per_access.min(SET);
        [
            self.wait(sets, index, asked, begin),
            link(&unit, "command of the chain", chain),
            link(&unit, "pointer arithmetic", loader.pointer as i64),
            link(&unit, format!("accesses: {}, of {words} words each", accesses(loader)), access),
            link(&unit, "words edited", edit),
            link(&unit, "strobe", loader.strobe as i64),
        ]
        .into_iter()
        .filter(|link| link.ticks != 0)
        .collect()
    }

    /// What the line of the loader does from `asked` until it takes this set up, or until it is given up.
    fn wait(&self, sets: &[AskedSet], index: usize, asked: i64, until: i64) -> Link {
        let loader = self.loader;
        let strobe = loader.strobe as i64;
        let unit = unit_of(loader, sets[index].colour);
        let is_before = |set: &&AskedSet| {
            let done = set.came.map(|came| self.arrival(came) - strobe);
            unit_of(loader, set.colour) == unit && done.is_some_and(|done| done > asked && done <= until)
        };
        let mut before: Vec<&AskedSet> = sets.iter().filter(is_before).collect();
        before.sort_by_key(|set| set.came.map(|came| self.arrival(came)));
        let names: Vec<String> =
            before.iter().map(|set| format!("{} of crossing {}", name(set), set.asked.number)).collect();
        let what = match (names.is_empty(), loader.served_by) {
            (true, CrossingServer::WiredPointers) => "waits".to_owned(),
            (true, CrossingServer::IoProcessor) => "order that starts the chain".to_owned(),
            (true, CrossingServer::CpuInterrupt) => "interrupt recognised".to_owned(),
            (false, _) => format!("waits behind {}", names.join(", ")),
        };
        link(unit, what, until - asked)
    }

    fn seen(&self, time: SweepTime) -> i64 {
        self.clock.tick_at_or_after(time).0 as i64
    }

    /// The last tick not after `time`: what is there then is in time.
    fn last_before(&self, time: SweepTime) -> i64 {
        let seen = self.clock.tick_at_or_after(time);
        seen.0 as i64 - i64::from(self.clock.instant_of(seen) > time)
    }

    /// An instant that a tick was turned into, as that tick.
    fn arrival(&self, time: SweepTime) -> i64 {
        let half = 0.5 / self.ticks_per_sample;
        self.seen(SweepTime(time.0 - half))
    }
}

fn accesses(loader: &Loader) -> i64 {
    i64::from(SET.div_ceil(loader.words_per_access))
}

/// The unit whose line a colour waits in; the same words as in the record.
fn unit_of(loader: &Loader, colour: Colour) -> String {
    match loader.served_by {
        CrossingServer::WiredPointers => format!("loader.{}", colour_word(colour)),
        CrossingServer::IoProcessor => "io-processor".into(),
        CrossingServer::CpuInterrupt => "cpu".into(),
    }
}

/// Colour and register, as in the record.
pub fn name(set: &AskedSet) -> String {
    format!("{} {}", colour_word(set.colour), register_word(set.register))
}

/// As in the record.
pub fn colour_word(colour: Colour) -> &'static str {
    match colour {
        Colour::Yellow => "yellow",
        Colour::Green => "green",
        Colour::Black => "black",
        Colour::Red => "red",
    }
}

/// As in the record.
pub fn register_word(register: PreloadRegister) -> &'static str {
    match register {
        PreloadRegister::XFirst => "x-first",
        PreloadRegister::YFirst => "y-first",
    }
}

fn crossing_text(crossing: &Crossing) -> String {
    let axis = if crossing.fold.axis == RampAxis::X { "X" } else { "Y" };
    format!("crossing {} ({axis} stop, {:.1} m)", crossing.number, crossing.range)
}
