//! What was found, in a file that other pages are built from.

use std::path::{Path, PathBuf};
use std::process::Command;

use lunoid_tests::breaks::Break;
use serde::{Deserialize, Serialize};

use crate::run::Verdict;

/// What became of one break.
#[derive(Debug, Serialize, Deserialize)]
struct Outcome {
    /// Name of the break.
    name: String,
    /// What is wrong with the machine then.
    what: String,
    /// The file it is in.
    file: PathBuf,
    /// What the tests said.
    #[serde(flatten)]
    verdict: Verdict,
    /// How long it took to compile and run them (s).
    seconds: f64,
}

/// What became of the breaks of one commit.
#[derive(Debug, Serialize, Deserialize)]
pub struct Record {
    /// Day on which it was begun, UTC.
    date: String,
    /// The commit that was broken.
    commit: String,
    /// How many breaks the list of the commit has.
    breaks: usize,
    outcomes: Vec<Outcome>,
}

impl Record {
    /// A record begun today.
    pub fn new(commit: String, breaks: usize) -> Result<Self, String> {
        let today = Command::new("date").args(["-u", "+%F"]).output();
        let today = today.map_err(|error| format!("date: {error}"))?;
        let date = String::from_utf8_lossy(&today.stdout).trim().to_owned();
        Ok(Self { date, commit, breaks, outcomes: Vec::new() })
    }

    /// The record at `path` if it is of this commit; else a new one.
    pub fn resumed(path: &Path, commit: String, breaks: usize) -> Result<Self, String> {
        let new = Self::new(commit, breaks)?;
        if !path.exists() {
            return Ok(new);
        }
        let wrong = |error: String| {
            format!("{}: {error}; expected a record of awake: remove it to begin anew", path.display())
        };
        let text = std::fs::read_to_string(path).map_err(|error| wrong(error.to_string()))?;
        let before: Self = serde_json::from_str(&text).map_err(|error| wrong(error.to_string()))?;
        Ok(if before.commit == new.commit { before } else { new })
    }

    /// Whether it says what became of a break.
    pub fn has(&self, one: &Break) -> bool {
        self.outcomes.iter().any(|outcome| outcome.name == one.name)
    }

    /// Adds what became of a break, and how long that took (s).
    pub fn add(&mut self, one: &Break, verdict: Verdict, seconds: f64) {
        let Break { name, what, file, .. } = one.clone();
        let seconds = (10.0 * seconds).round() / 10.0;
        self.outcomes.push(Outcome { name, what, file, verdict, seconds });
    }

    fn caught(&self) -> usize {
        self.outcomes.iter().filter(|outcome| matches!(outcome.verdict, Verdict::Caught { .. })).count()
    }

    /// Share of its breaks that a test caught, 0..=1.
    pub fn share(&self) -> f64 {
        self.caught() as f64 / self.outcomes.len() as f64
    }

    /// One line for a person.
    pub fn summary(&self) -> String {
        let seconds: f64 = self.outcomes.iter().map(|outcome| outcome.seconds).sum();
        let (caught, all) = (self.caught(), self.outcomes.len());
        format!("{caught} of {all} breaks caught, {:.1} %, in {seconds:.0} s", 100.0 * self.share())
    }

    /// Writes it as JSON.
    pub fn write(&self, path: &Path) -> Result<(), String> {
        let text = serde_json::to_string_pretty(self).map_err(|error| error.to_string())?;
        files::write_atomic(path, |file| writeln!(file, "{text}")).map_err(|error| error.to_string())
    }
}
