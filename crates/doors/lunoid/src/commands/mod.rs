//! One file a command.

mod again;
pub mod augment;
pub mod beam;
mod changed;
pub mod check;
pub mod compare;
pub mod completions;
pub mod dataset;
pub mod drive;
pub mod explain;
pub mod farm;
pub mod info;
pub mod list;
pub mod man;
pub mod merge;
pub mod model;
pub mod netlist;
pub mod page;
pub mod probe;
pub mod replay;
pub mod schema;
mod scope;
pub mod serve;
pub mod sizing;
pub mod state;
pub mod timing;
pub mod trace;
pub mod trigger;

use std::time::Instant;

use crate::cli::{Cli, Command, command};
use command_line::{Failure, Verdict};

/// Does what the command line says. `start` is when the program began.
pub fn run(cli: &Cli, start: Instant) -> Result<Verdict, Failure> {
    for assignment in &cli.raise {
        limits::raise(assignment).map_err(|said| Failure::Usage(format!("--raise {said}")))?;
    }
    match &cli.command {
        Command::Replay(replay) => replay.run(start),
        Command::Page(page) => page.run(),
        Command::Merge(merge) => merge.run(),
        Command::Farm(farm) => farm.run(),
        Command::Dataset(dataset) => dataset.run(),
        Command::Augment(augment) => augment.run(),
        Command::Compare(compare) => compare.run(),
        Command::Check(check) => check.run(cli.color),
        Command::List(list) => list.run(),
        Command::Info(info) => info.run(),
        Command::Probe(probe) => probe.run(),
        Command::Signals(signals) => signals.run(),
        Command::Explain(explain) => explain.run(),
        Command::Serve(serve) => serve.run(),
        Command::Drive(drive) => drive.run(),
        Command::Beam(beam) => beam.run(),
        Command::Trigger(trigger) => trigger.run(),
        Command::Trace(trace) => trace.run(),
        Command::Bank(bank) => bank.run(),
        Command::Survey(survey) => survey.run(),
        Command::Sight(sight) => sight.run(),
        Command::Terrain(terrain) => terrain.run(),
        Command::Sun(sun) => sun.run(),
        Command::Photo(photo) => photo.run(),
        Command::Model(model) => model.run(),
        Command::Timing(timing) => timing.run(),
        Command::Sizing(sizing) => sizing.run(),
        Command::Study(study) => study.run(),
        Command::Cartridge(cartridge) => cartridge.run(),
        Command::Lockstep(lockstep) => lockstep.run(),
        Command::Netlist(netlist) => netlist.run(),
        Command::State(state) => state.run(),
        Command::Schema(schema) => schema.run(),
        Command::Completions(completions) => completions.run(command()),
        Command::Man(man) => man.run(&command()),
    }
}
