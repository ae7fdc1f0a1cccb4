//! The chain of waits that ends at the worst deadline of each kind.

use hardware_model::{CrossingServer, IoProcessor, Loader};
use machine::FrameSweeps;
use machine::MachineStage;
use quantities::{SweepClock, SweepTime};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Pose;
use serde::Serialize;
use sweep_program::{Colour, PreloadRegister, RampAxis, SweepProgram};
use timing::{Deadline, FrameTiming, Missed};

use crate::levels::{DrawnLevel, drawn_levels};
use crate::sets::{AskedSet, Crossing, sets_of};
use crate::{DeadlineError, Rehearsal};

/// Words of a set.
const SET: u32 = 9;

/// From what starts a piece of work to the instant at which it is due.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Chain {
    /// Which deadline.
    pub deadline: Deadline,
    /// What is due, and where.
    pub what: String,
    /// Unit by unit; the sum of their ticks and of the slack is the time there was.
    pub links: Vec<Link>,
    /// What is left (master ticks); below 0 it is missed, none if it never came.
    pub slack: Option<i64>,
}

/// One unit's part.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Link {
    /// Block first: `loader.red`, `cpu`.
    pub unit: String,
    /// What it does.
    pub what: String,
    /// Master ticks.
    pub ticks: i64,
}

fn link(unit: impl Into<String>, what: impl Into<String>, ticks: i64) -> Link {
    Link { unit: unit.into(), what: what.into(), ticks }
}

impl Chain {
    /// Lines of text; `ns` is the length of a tick (ns).
    pub fn text(&self, ns: f64) -> String {
        let line = |unit: &str, what: &str, ticks: i64| {
            format!("  {unit:<16} {ticks:>9} ticks {:>12.1} ns  {what}\n", ticks as f64 * ns)
        };
        let links: String = self.links.iter().map(|link| line(&link.unit, &link.what, link.ticks)).collect();
        let last = match self.slack {
            Some(slack) if slack < 0 => line("= late", "", -slack),
            Some(slack) => line("= slack", "", slack),
            None => "  = never\n".into(),
        };
        format!("{}: {}\n{links}{last}", self.deadline, self.what)
    }
}

/// The chains of one frame, in the order of [`Deadline::ALL`].
pub fn chains(rehearsal: &Rehearsal, pose: &Pose, frame: &FrameTiming) -> Result<Vec<Chain>, DeadlineError> {
    let stage = &rehearsal.stage;
    let sweeps = rehearsal.pool.install(|| rehearsal.control.sweeps(frame.frame, pose))?;
    let of = |deadline: &Deadline| match deadline {
        Deadline::Transfer => rehearsal.pool.install(|| worst_transfer(stage, &sweeps, frame.frame)),
        Deadline::SweepSetUp => set_up(stage, frame),
        Deadline::FrameTasks => frame_tasks(stage, frame),
        Deadline::Corner => corner(frame),
        Deadline::Feature | Deadline::Segment => load(*deadline, frame),
    };
    let all = Deadline::ALL.iter().filter(|deadline| frame.deadlines.contains_key(deadline));
    Ok(all.filter_map(of).collect())
}

/// A set and where it is.
struct Found<'a> {
    slack: f64,
    of: DrawnLevel<'a>,
    sweep: u32,
    index: usize,
}

/// The set that comes latest for its use, of all sweeps and levels; the first of several.
fn worst_transfer(stage: &MachineStage, sweeps: &FrameSweeps<'_>, frame: u64) -> Option<Chain> {
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
            deadline: Deadline::Transfer,
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

/// The worst set-up: it begins with the sweep before, behind interrupts and set-ups that run over. One that is not made
/// counts as a sweep too late.
fn set_up(stage: &MachineStage, frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&Deadline::SweepSetUp)?.least?;
    let settings = &stage.settings;
    let period = (frame.ticks / u64::from(settings.raster.sweeps)) as i64;
    let own = settings.cpu.sweep_setup as i64;
    let worst = latest(Deadline::SweepSetUp, frame);
    let what =
        worst.map_or("program of a sweep".into(), |missed| format!("program of sweep {}", missed.sweep));
    let is_made = worst.is_none_or(|missed| missed.came.is_some());
    let before = "interrupts and set-ups before it";
    let links = match is_made {
        true => vec![link("cpu", before, period - own - slack), link("cpu", "set-up", own)],
        false => vec![link("cpu", before, period)],
    };
    Some(Chain { deadline: Deadline::SweepSetUp, what, links, slack: is_made.then_some(slack) })
}

/// The miss of a frame that comes latest after its time; the first of several.
fn latest(deadline: Deadline, frame: &FrameTiming) -> Option<&Missed> {
    let lateness = |missed: &Missed| missed.lateness().unwrap_or(f64::INFINITY);
    let ours = frame.misses.iter().filter(|missed| missed.deadline == deadline);
    ours.reduce(|worst, missed| if lateness(missed) > lateness(worst) { missed } else { worst })
}

/// Tables and polyhedra fill what crossings and set-ups leave.
fn frame_tasks(stage: &MachineStage, frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&Deadline::FrameTasks)?.least?;
    let busy =
        |unit: &str| frame.units.iter().find(|found| found.unit == unit).map(|found| found.busy as i64);
    let all = busy("cpu.tables")? + busy("cpu.vertices")? + (-slack).max(0);
    let tables = (stage.settings.cpu.frame_tables as i64).min(all);
    let links = vec![
        link("cpu", "crossings, set-ups of sweeps, idle", frame.ticks as i64 - slack - all),
        link("cpu", "visibility and tables", tables),
        link("cpu", format!("vertices of polyhedra: {}", frame.vertices.asked), all - tables),
    ];
    let what = "tables and polyhedra of the next frame".into();
    Some(Chain { deadline: Deadline::FrameTasks, what, links, slack: Some(slack) })
}

/// A record that the storage buffer does not hold waits for its drum; one that does not come in the frame counts as a
/// sweep too late. There is no chain where every corner was there.
fn corner(frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&Deadline::Corner)?.least?;
    let worst = latest(Deadline::Corner, frame)?;
    let [m, n] = worst.region?;
    let drums = frame.units.iter().filter(|unit| unit.unit.starts_with("drum."));
    let links = drums.map(|unit| {
        let what = format!("at work in this frame, longest queue {}", unit.longest_queue);
        link(&unit.unit, what, unit.busy as i64)
    });
    let what = format!("corner {m} {n} and others, first asked for in sweep {}", worst.sweep);
    let slack = worst.came.map(|_| slack);
    Some(Chain { deadline: Deadline::Corner, what, links: links.collect(), slack })
}

/// Words of a crater or of a shadow boundary wait for their line, and for the part that they go to. There is no chain where
/// all are in time.
fn load(deadline: Deadline, frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&deadline)?.least?;
    let worst = latest(deadline, frame)?;
    let unit =
        if deadline == Deadline::Feature { "feature-generator.load" } else { "shadow-controller.load" };
    let busy = frame.units.iter().find(|found| found.unit == unit);
    let links = busy.map(|found| link(unit, "at work in this frame, all loads together", found.busy as i64));
    let crater = worst.crater.map_or("shadow boundary".into(), |crater| format!("crater {crater}"));
    let part = worst.part.as_ref().map_or(", no part free".into(), |part| format!(", {part}"));
    let range = worst.range_m.map_or(String::new(), |range| format!(" at {range:.1} m"));
    Some(Chain {
        deadline,
        what: format!("sweep {}: {crater}{range}{part}", worst.sweep),
        links: links.into_iter().collect(),
        slack: worst.came.map(|_| slack),
    })
}
