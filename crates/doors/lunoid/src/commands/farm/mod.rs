//! `lunoid farm`: shards that many workers draw.

mod status;

use clap::{Args, Subcommand};

use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid farm status runs
  lunoid farm status data/full-drive-farm --watch

docs/shards.md says how shards are drawn and joined; docs/farm.md how Python drives them.";

/// Look at the shards that many workers draw.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct FarmCommand {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Say how far the shards in a folder are.
    Status(status::Status),
}

impl FarmCommand {
    /// Does what the command line says.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.action {
            Action::Status(status) => status.run(),
        }
    }
}
