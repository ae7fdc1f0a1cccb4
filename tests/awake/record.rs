//! What was found, in a file that other pages are built from.

use std::path::Path;
use std::process::Command;

use lunoid_tests::breaks::{Break, breaks};
use serde_json::{Value, json};

use crate::checkout::Checkout;
use crate::run::Verdict;

/// What became of one break.
#[derive(Debug)]
pub struct Outcome {
    /// The break.
    pub of: Break,
    /// What the tests said.
    pub verdict: Verdict,
    /// How long it took to compile and run them (s).
    pub seconds: f64,
}

/// All outcomes of a run.
#[derive(Debug)]
pub struct Record {
    date: String,
    commit: String,
    outcomes: Vec<Outcome>,
}

impl Record {
    /// Outcomes of today.
    pub fn new(checkout: &Checkout, outcomes: Vec<Outcome>) -> Result<Self, String> {
        let today = Command::new("date").args(["-u", "+%F"]).output();
        let today = today.map_err(|error| format!("date: {error}"))?;
        let date = String::from_utf8_lossy(&today.stdout).trim().to_owned();
        Ok(Self { date, commit: checkout.commit()?, outcomes })
    }

    fn caught(&self) -> usize {
        self.outcomes.iter().filter(|outcome| matches!(outcome.verdict, Verdict::Caught { .. })).count()
    }

    /// Share of the breaks that a test caught, 0..=1.
    pub fn share(&self) -> f64 {
        self.caught() as f64 / self.outcomes.len() as f64
    }

    /// One line for a person.
    pub fn summary(&self) -> String {
        let seconds: f64 = self.outcomes.iter().map(|outcome| outcome.seconds).sum();
        let (caught, all) = (self.caught(), self.outcomes.len());
        format!("{caught} of {all} breaks caught, {:.1} %, in {seconds:.0} s", 100.0 * self.share())
    }

    /// Writes the outcomes as JSON. Of breaks that were not run this time, the outcomes that stand in the file stay:
    /// each has its own date and commit.
    pub fn write(&self, path: &Path) -> Result<(), String> {
        let before = before(path)?;
        let outcome = |one: &Break| {
            let found =
                self.outcomes.iter().find(|outcome| outcome.of == *one).map(|outcome| self.json(outcome));
            found.or_else(|| before.iter().find(|outcome| outcome["name"] == one.name.as_str()).cloned())
        };
        let outcomes: Vec<Value> = breaks()?.iter().filter_map(outcome).collect();
        let caught = outcomes.iter().filter(|outcome| outcome["caught_by"].is_string()).count();
        let share = caught as f64 / outcomes.len() as f64;
        let whole =
            json!({ "breaks": outcomes.len(), "caught": caught, "share": share, "outcomes": outcomes });
        let write = |file: &mut dyn std::io::Write| writeln!(file, "{whole:#}");
        files::write_atomic(path, write).map_err(|error| error.to_string())
    }

    fn json(&self, outcome: &Outcome) -> Value {
        let Break { name, what, file, .. } = &outcome.of;
        let seconds = (10.0 * outcome.seconds).round() / 10.0;
        let mut value = json!({
            "name": name, "what": what, "file": file, "seconds": seconds, "date": self.date, "commit": self.commit,
        });
        match &outcome.verdict {
            Verdict::Caught { test, arguments } => {
                value["caught_by"] = json!(test);
                value["tests"] = json!(arguments);
            }
            Verdict::NotCaught => value["caught_by"] = Value::Null,
            Verdict::Fault(what) => value["fault"] = json!(what),
        }
        value
    }
}

/// The outcomes that stand in a file; none if there is no such file.
fn before(path: &Path) -> Result<Vec<Value>, String> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    let at = path.display();
    let text = std::fs::read_to_string(path).map_err(|error| format!("{at}: {error}"))?;
    let whole: Value = serde_json::from_str(&text).map_err(|error| format!("{at}: {error}"))?;
    let outcomes = whole["outcomes"].as_array().cloned();
    outcomes.ok_or_else(|| format!("{at}: expected a file that awake wrote; give another name"))
}
