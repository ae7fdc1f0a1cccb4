//! The home of a served session: one scenario, and a folder for what was driven.

use std::path::PathBuf;

use diagnostics::Problem;
use drive::{Drive, DriveError, Loop, SavedFile, Wishes};
use loop_protocol::{Home, Opening};

/// The scenario of the command line, with its wishes.
#[derive(Debug, Clone)]
pub struct Served {
    pub scenario: PathBuf,
    pub wishes: Wishes,
    /// Number of threads that draw; as many as there are processors if 0.
    pub threads: usize,
    /// Folder of what was driven.
    pub record: Option<PathBuf>,
}

impl Home for Served {
    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError> {
        let own = self.scenario.display().to_string();
        if let Some(other) = asked.scenario.as_ref().filter(|other| **other != own) {
            let problem = Problem::of_file("request", "another scenario is not opened here").key("scenario");
            let problem = problem.found(format!("`{other}`")).expected(format!("`{own}`, or no scenario"));
            return Err(problem.help("start `lunoid serve` on that scenario").into());
        }
        Drive::open(&self.scenario, &asked.over(&self.wishes), self.threads)
    }

    fn keep(&mut self, driven: &Loop, name: &str, more: &[SavedFile]) -> Result<Option<String>, DriveError> {
        let Some(folder) = &self.record else { return Ok(None) };
        let folder = folder.join(name);
        driven.save_with(&folder, more)?;
        Ok(Some(folder.display().to_string()))
    }
}
