//! From a command line to a rehearsal: the frames are chosen before any ground is made.

use deadlines::{Rehearsal, Rehearsed};
use front_door::Opened;
use replay::Progress;
use timing::TimingRecord;

use command_line::Failure;
use command_line::loading::{StageArgs, Threads, choose_frames, expect_machine};
use command_line::output::warn;
use command_line::progress::Display;
use text::Span;

/// What only the hybrid machine has.
const LACK: &str = "it has no sweeps and no deadlines";

/// The mission on the hybrid machine; `frames` is asked of the scenario before any ground is made.
pub fn rehearse(
    stage: &StageArgs,
    threads: &Threads,
    frames: impl FnOnce(&Opened) -> Result<Vec<u64>, Failure>,
) -> Result<(Rehearsal, Vec<u64>), Failure> {
    rehearse_opened(stage.load()?, threads, frames)
}

/// The same of what is read already.
pub fn rehearse_opened(
    opened: Opened,
    threads: &Threads,
    frames: impl FnOnce(&Opened) -> Result<Vec<u64>, Failure>,
) -> Result<(Rehearsal, Vec<u64>), Failure> {
    expect_machine(&opened, LACK)?;
    let chosen = frames(&opened)?;
    let rehearsal = Rehearsal::new(opened, threads.pool()?)?;
    warn_of_idle_delays(&rehearsal, &chosen)?;
    Ok((rehearsal, chosen))
}

/// Says which delays of the model hold nothing back in `frames`.
fn warn_of_idle_delays(rehearsal: &Rehearsal, frames: &[u64]) -> Result<(), Failure> {
    rehearsal.idle_delays(frames)?.iter().for_each(|idle| warn(idle));
    Ok(())
}

/// Refuses a generator whose frames have no deadlines.
pub fn expect_deadlines(opened: &Opened) -> Result<(), Failure> {
    if opened.generator.has_deadlines() { Ok(()) } else { expect_machine(opened, LACK) }
}

/// The same on any generator whose frames take time.
pub fn rehearse_timed(
    stage: &StageArgs,
    threads: &Threads,
    frames: impl FnOnce(&Opened) -> Result<Vec<u64>, Failure>,
) -> Result<(Rehearsed, Vec<u64>), Failure> {
    let opened = stage.load()?;
    if opened.row.is_none_or(|row| !row.timed) {
        expect_machine(&opened, LACK)?;
    }
    let chosen = frames(&opened)?;
    let rehearsed = Rehearsed::new(opened, threads.pool()?)?;
    if let Rehearsed::Machine(rehearsal) = &rehearsed {
        warn_of_idle_delays(rehearsal, &chosen)?;
    }
    Ok((rehearsed, chosen))
}

/// The timing record that `make` makes, its progress shown if that is `wanted`.
pub fn record<E>(
    wanted: bool,
    make: impl FnOnce(&dyn Fn(Progress)) -> Result<TimingRecord, E>,
) -> Result<TimingRecord, E> {
    let display = Display::new(wanted);
    let made = make(&|progress| display.hear(progress));
    display.end();
    made
}

/// The frames asked for, or `usual` of the whole mission.
pub fn choose(
    opened: &Opened,
    asked: Option<Span>,
    usual: impl FnOnce(u64) -> Vec<u64>,
) -> Result<Vec<u64>, Failure> {
    match asked {
        Some(_) => Ok(choose_frames(opened, asked)?.collect()),
        None => Ok(usual(opened.frames())),
    }
}

/// Refuses the coarse level, as `asked` for, where there is none.
pub fn expect_coarse(asked: &str, settings: &hardware_model::Settings) -> Result<(), Failure> {
    match settings.levels {
        Some(_) => Ok(()),
        None => Err(Failure::usage(format!("{asked}: the scenario has one level of terrain; expected fine"))),
    }
}
