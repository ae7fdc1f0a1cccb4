//! One frame of a scenario, as a command is told of it.

use clap::Args;
use deadlines::Rehearsal;
use front_door::Opened;

use crate::rehearsing::rehearse_opened;
use command_line::loading::{StageArgs, Threads};
use command_line::of_run::{load_of, stage_of};
use command_line::{Failure, values};

/// Which frame of which scenario, drawn by what. A run folder stands for the scenario and the options that made the run.
#[derive(Debug, Args)]
pub struct FrameArgs {
    #[command(flatten)]
    pub stage: StageArgs,
    #[command(flatten)]
    pub threads: Threads,
    /// Frame, from 0, counted at the update rate.
    #[arg(long, value_parser = values::at_least(0_u64))]
    pub frame: u64,
}

impl FrameArgs {
    /// Sees that the scenario has the frame.
    pub fn expect_in(&self, opened: &Opened) -> Result<(), Failure> {
        let (frame, end) = (self.frame, opened.frames());
        match frame < end {
            true => Ok(()),
            false => Err(Failure::usage(format!(
                "--frame {frame}: the scenario has frames 0..{end}; expected one of them"
            ))),
        }
    }

    /// The stage that is asked for; in place of a run folder that with which the run was made.
    pub fn stage(&self) -> Result<StageArgs, Failure> {
        stage_of(&self.stage)
    }

    /// What [the stage](Self::stage) comes to.
    pub fn load(&self, stage: &StageArgs) -> Result<Opened, Failure> {
        load_of(&self.stage, stage)
    }

    /// Everything but the frame of what is `opened`; `check` sees the scenario before any ground is made.
    pub fn rehearse(
        &self,
        opened: Opened,
        check: impl FnOnce(&Opened) -> Result<(), Failure>,
    ) -> Result<Rehearsal, Failure> {
        let (rehearsal, _) = rehearse_opened(opened, &self.threads, |opened| {
            check(opened)?;
            self.expect_in(opened)?;
            Ok(vec![self.frame])
        })?;
        Ok(rehearsal)
    }
}
