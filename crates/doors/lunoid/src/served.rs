//! The home of a served session: one scenario, and a folder for what was driven.

use std::path::PathBuf;

use clap::Args;
use diagnostics::Problem;
use drive::{Drive, DriveError, Loop, SavedFile, Wishes};
use front_door::Opened;
use loop_protocol::{Home, Opening};

use crate::Failure;
use crate::loading::{QualityArgs, StageArgs, Threads};

/// What is served, and where records of it go.
#[derive(Debug, Args)]
pub struct ServedArgs {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    quality: QualityArgs,
    #[command(flatten)]
    threads: Threads,
    /// Folder into which the request `record` writes what was driven; the client gets the files if left out.
    #[arg(long, value_name = "FOLDER")]
    record: Option<PathBuf>,
}

impl ServedArgs {
    /// The home of these arguments, and its scenario. What is wrong is told before any ground is made.
    pub fn home(&self) -> Result<(Served, Opened), Failure> {
        let stage = self.stage.clone().drawn_by(self.quality);
        let opened = stage.load()?;
        let served = Served {
            scenario: stage.scenario.clone(),
            wishes: stage.wishes(),
            threads: self.threads.count()?,
            record: self.record.clone(),
        };
        Ok((served, opened))
    }
}

/// The scenario of the command line, with its wishes.
#[derive(Debug, Clone)]
pub struct Served {
    scenario: PathBuf,
    wishes: Wishes,
    /// Number of threads that draw; as many as there are processors if 0.
    threads: usize,
    /// Folder of what was driven.
    record: Option<PathBuf>,
}

impl Served {
    /// The word that a request `open` has for the scenario.
    pub fn scenario(&self) -> String {
        self.scenario.display().to_string()
    }

    /// The scenario with the wishes of the command line.
    ///
    /// # Errors
    /// Every fault of the files and the wishes.
    pub fn drive(&self) -> Result<Drive, DriveError> {
        self.open_over(&self.wishes)
    }

    fn open_over(&self, wishes: &Wishes) -> Result<Drive, DriveError> {
        Drive::open(&self.scenario, wishes, self.threads)
    }
}

impl Home for Served {
    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError> {
        let own = self.scenario();
        if let Some(other) = asked.scenario.as_ref().filter(|other| **other != own) {
            let problem = Problem::of_file("request", "another scenario is not opened here").key("scenario");
            let problem = problem.found(format!("`{other}`")).expected(format!("`{own}`, or no scenario"));
            return Err(problem.help("start the command on that scenario").into());
        }
        self.open_over(&asked.over(&self.wishes))
    }

    fn keep(&mut self, driven: &Loop, name: &str, more: &[SavedFile]) -> Result<Option<String>, DriveError> {
        let Some(folder) = &self.record else { return Ok(None) };
        let folder = folder.join(name);
        driven.save_with(&folder, more)?;
        Ok(Some(folder.display().to_string()))
    }
}
