//! The chain of waits that ends at the worst deadline of each kind.

mod transfer;

use machine::MachineStage;
use scenario::Pose;
use serde::Serialize;
use timing::{Deadline, FrameTiming, Missed, UnitUse};

use self::transfer::worst_transfer;
use crate::{DeadlineError, Rehearsal};

pub use transfer::{colour_word, register_word};

/// From what starts a piece of work to the instant at which it is due.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Chain {
    /// Kind of the deadline that the chain ends at.
    pub deadline: Deadline,
    /// What is due, and where.
    pub what: String,
    /// Unit by unit; the sum of their ticks and of the slack is the time there was.
    pub links: Vec<Link>,
    /// What is left (master ticks); below 0 it is missed, none if it never came.
    pub slack: Option<i64>,
}

/// The part of a chain that one unit does.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Link {
    /// Block first: `loader.red`, `cpu`.
    pub unit: String,
    /// What the unit does, in words.
    pub what: String,
    /// Time it takes (master ticks).
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

/// The chains of one frame, in the order of [`Deadline::HYBRID`].
pub fn chains(rehearsal: &Rehearsal, pose: &Pose, frame: &FrameTiming) -> Result<Vec<Chain>, DeadlineError> {
    let stage = &rehearsal.stage;
    let sweeps = rehearsal.pool.install(|| rehearsal.control.sweeps(frame.frame, pose))?;
    let of = |deadline: &Deadline| match *deadline {
        Deadline::TRANSFER => rehearsal.pool.install(|| worst_transfer(stage, &sweeps, frame.frame)),
        Deadline::SWEEP_SET_UP => set_up(stage, frame),
        Deadline::FRAME_TASKS => frame_tasks(stage, frame),
        Deadline::CORNER => corner(frame),
        Deadline::FEATURE | Deadline::SEGMENT => load(*deadline, frame),
        Deadline::FEATURE_RECORD => record(*deadline, "features", frame),
        Deadline::SHADOW_RECORD => record(*deadline, "shadows", frame),
        Deadline::BODY_RECORD => record(*deadline, "polyhedra", frame),
        _ => None,
    };
    Ok(frame.deadlines.keys().filter_map(of).collect())
}

/// The worst set-up: it begins with the sweep before, behind interrupts and set-ups that run over. One that is not made
/// counts as a sweep too late.
fn set_up(stage: &MachineStage, frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&Deadline::SWEEP_SET_UP)?.least?;
    let settings = &stage.settings;
    let period = (frame.ticks / u64::from(settings.raster.sweeps)) as i64;
    let own = settings.cpu.sweep_setup as i64;
    let worst = latest(Deadline::SWEEP_SET_UP, frame);
    let what =
        worst.map_or("program of a sweep".into(), |missed| format!("program of sweep {}", missed.sweep));
    let is_made = worst.is_none_or(|missed| missed.came.is_some());
    let before = "interrupts and set-ups before it";
    let links = match is_made {
        true => vec![link("cpu", before, period - own - slack), link("cpu", "set-up", own)],
        false => vec![link("cpu", before, period)],
    };
    Some(Chain { deadline: Deadline::SWEEP_SET_UP, what, links, slack: is_made.then_some(slack) })
}

/// The miss of a frame that comes latest after its time; the first of several.
fn latest(deadline: Deadline, frame: &FrameTiming) -> Option<&Missed> {
    let lateness = |missed: &Missed| missed.lateness().unwrap_or(f64::INFINITY);
    let ours = frame.misses.iter().filter(|missed| missed.deadline == deadline);
    ours.reduce(|worst, missed| if lateness(missed) > lateness(worst) { missed } else { worst })
}

/// Tables and polyhedra fill what crossings and set-ups leave.
fn frame_tasks(stage: &MachineStage, frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&Deadline::FRAME_TASKS)?.least?;
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
    Some(Chain { deadline: Deadline::FRAME_TASKS, what, links, slack: Some(slack) })
}

/// A record that the storage buffer does not hold waits for its drum; one that does not come in the frame counts as a
/// sweep too late. There is no chain where every corner was there.
fn corner(frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&Deadline::CORNER)?.least?;
    let worst = latest(Deadline::CORNER, frame)?;
    let [m, n] = worst.region?;
    let what = format!("corner {m} {n} and others, first asked for in sweep {}", worst.sweep);
    let links = ["fine", "coarse"].iter().flat_map(|kind| drums_of(kind, frame)).collect();
    let slack = worst.came.map(|_| slack);
    Some(Chain { deadline: Deadline::CORNER, what, links, slack })
}

/// A record of another kind than terrain waits for the drum and for the I/O processor of its kind.
fn record(deadline: Deadline, kind: &str, frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&deadline)?.least?;
    let worst = latest(deadline, frame)?;
    let [m, n] = worst.region?;
    let name = format!("editor.{kind}");
    let editor = frame.units.iter().filter(|unit| unit.unit == name);
    let editor = editor.map(|unit| link(&unit.unit, "edits in this frame", unit.busy as i64));
    let what = format!("{kind} of the square at region {m} {n}, first wanted in sweep {}", worst.sweep);
    let links = drums_of(kind, frame).into_iter().chain(editor).collect();
    Some(Chain { deadline, what, links, slack: worst.came.map(|_| slack) })
}

/// What the drums do in a frame that hold a kind of data: its own share of drums that several kinds lie on.
fn drums_of(kind: &str, frame: &FrameTiming) -> Vec<Link> {
    let of_kind = |unit: &&UnitUse| match unit.unit.split('.').collect::<Vec<_>>()[..] {
        ["drum", drums, _] => drums == kind && !is_shared(&unit.unit, frame),
        ["drum", _, _, share] => share == kind,
        _ => false,
    };
    let at_work = |unit: &UnitUse| {
        let what = format!("at work for {kind} in this frame, longest queue {}", unit.longest_queue);
        link(&unit.unit, what, unit.busy as i64)
    };
    frame.units.iter().filter(of_kind).map(at_work).collect()
}

/// Whether the use of a drum stands once more, share by share of its kinds.
fn is_shared(drum: &str, frame: &FrameTiming) -> bool {
    let shares = |name: &str| name.strip_prefix(drum).is_some_and(|share| share.starts_with('.'));
    frame.units.iter().any(|unit| shares(&unit.unit))
}

/// Words of a crater or of a shadow boundary wait for their line, and for the part that they go to. There is no chain where
/// all are in time.
fn load(deadline: Deadline, frame: &FrameTiming) -> Option<Chain> {
    let slack = frame.deadlines.get(&deadline)?.least?;
    let worst = latest(deadline, frame)?;
    let unit =
        if deadline == Deadline::FEATURE { "feature-generator.load" } else { "shadow-controller.load" };
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
