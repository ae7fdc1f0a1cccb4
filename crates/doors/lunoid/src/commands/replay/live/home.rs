//! Who answers the page of a run: the scenario of the command, once the run is finished.

use std::sync::Arc;

use diagnostics::Problem;
use drive::{Drive, DriveError, Program};
use loop_protocol::{Home, Opening};

use super::LiveRun;
use crate::served::Served;

/// The home of a page of a run.
#[derive(Clone)]
pub struct LiveHome {
    served: Served,
    run: Arc<LiveRun>,
}

impl LiveHome {
    /// `served` is what the run draws.
    pub fn new(served: Served, run: Arc<LiveRun>) -> Self {
        Self { served, run }
    }
}

impl Home for LiveHome {
    fn program(&self) -> Program {
        self.served.program()
    }

    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError> {
        if !self.run.is_finished() {
            let problem = Problem::of_file("request", "the run is being drawn");
            let problem = problem.expected("a run that is finished");
            return Err(problem
                .help("wait for the page of the run; the processors are the run's until then")
                .into());
        }
        self.served.open(asked)
    }
}
