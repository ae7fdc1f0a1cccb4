//! What was found, in a file that other pages are built from.

use std::path::Path;
use std::process::Command;

use lunoid_tests::breaks::Break;
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
        let today =
            Command::new("date").args(["-u", "+%F"]).output().map_err(|error| format!("date: {error}"))?;
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

    /// Writes all of it as JSON.
    pub fn write(&self, path: &Path) -> Result<(), String> {
        let breaks: Vec<Value> = self.outcomes.iter().map(Outcome::json).collect();
        let whole = json!({
            "date": self.date,
            "commit": self.commit,
            "breaks": self.outcomes.len(),
            "caught": self.caught(),
            "share": self.share(),
            "outcomes": breaks,
        });
        let write = |file: &mut dyn std::io::Write| writeln!(file, "{whole:#}");
        files::write_atomic(path, write).map_err(|error| error.to_string())
    }
}

impl Outcome {
    fn json(&self) -> Value {
        let Break { name, what, file, .. } = &self.of;
        let seconds = (10.0 * self.seconds).round() / 10.0;
        let mut value = json!({ "name": name, "what": what, "file": file, "seconds": seconds });
        match &self.verdict {
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
