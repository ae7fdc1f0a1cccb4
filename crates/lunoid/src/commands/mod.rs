//! One file a command.

pub mod bank;
pub mod check;
pub mod compare;
pub mod edges;
pub mod info;
pub mod list;
pub mod model;
pub mod probe;
pub mod replay;
mod scope;
pub mod sizing;
pub mod survey;
pub mod timing;

use crate::cli::{Cli, Command};
use crate::{Failure, Verdict};

/// Does what the command line says.
pub fn run(cli: &Cli) -> Result<Verdict, Failure> {
    match &cli.command {
        Command::Replay(replay) => replay.run(),
        Command::Compare(compare) => compare.run(),
        Command::Check(check) => check.run(cli.color),
        Command::List(list) => list.run(),
        Command::Info(info) => info.run(),
        Command::Probe(probe) => probe.run(),
        Command::Signals(signals) => signals.run(),
        Command::Bank(bank) => bank.run(),
        Command::Survey(survey) => survey.run(),
        Command::Model(model) => model.run(),
        Command::Timing(timing) => timing.run(),
        Command::Sizing(sizing) => sizing.run(),
    }
}
