//! Runs of `cargo test`, and what they say.

use std::collections::BTreeSet;
use std::fmt;
use std::process::Command;

use lunoid_tests::breaks::Break;
use serde::{Deserialize, Serialize};

use crate::checkout::Checkout;
use crate::go_on;

/// What became of a break.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Verdict {
    /// The first test that failed, and the arguments of cargo that ran it.
    Caught { caught_by: String, tests: String },
    /// The fault is in the break: the compiler or the end of a test program, no test, has stopped it.
    Fault { fault: String },
    /// All tests passed, so nothing noticed the break.
    NotCaught {},
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Caught { caught_by, tests } => write!(f, "{caught_by} ({tests})"),
            Self::Fault { fault } => write!(f, "{}", fault.to_uppercase()),
            Self::NotCaught {} => f.write_str("NOT CAUGHT"),
        }
    }
}

/// One run of `cargo test`.
struct Run {
    passed: usize,
    failed: Option<String>,
    fault: Option<String>,
}

/// That all tests of the breaks pass before anything is broken, and that there are such tests.
pub fn check_unbroken(checkout: &Checkout, breaks: &[Break]) -> Result<(), String> {
    let lines: BTreeSet<&String> = breaks.iter().flat_map(|one| &one.tests).collect();
    eprintln!("{} runs of tests before anything is broken", lines.len());
    for line in lines {
        let Run { passed, failed, fault } = run(checkout, line)?;
        if let Some(what) = failed.or(fault) {
            return Err(format!("cargo test {line}: {what} fails although nothing is broken; mend it first"));
        }
        if passed == 0 {
            return Err(format!("cargo test {line}: no test runs; mend the list tests/awake/breaks.toml"));
        }
    }
    Ok(())
}

/// What the tests say of a break that is applied.
pub fn verdict(checkout: &Checkout, one: &Break) -> Result<Verdict, String> {
    for arguments in &one.tests {
        let Run { failed, fault, .. } = run(checkout, arguments)?;
        if let Some(caught_by) = failed {
            return Ok(Verdict::Caught { caught_by, tests: arguments.clone() });
        }
        if let Some(fault) = fault {
            return Ok(Verdict::Fault { fault });
        }
    }
    Ok(Verdict::NotCaught {})
}

fn run(checkout: &Checkout, arguments: &str) -> Result<Run, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["test", "--locked", "--profile", &checkout.profile])
        .args(arguments.split_whitespace())
        .current_dir(&checkout.root)
        .env("CARGO_TARGET_DIR", &checkout.target)
        // What fails on a break is no regression to keep.
        .env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "1")
        .output()
        .map_err(|error| format!("cargo: {error}"))?;
    go_on()?;
    let (said, errors) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let tests = || said.lines().filter_map(|line| line.strip_prefix("test ")?.rsplit_once(" ... "));
    let failed = tests().find(|(_, end)| *end == "FAILED").map(|(name, _)| name.to_owned());
    let fault = (!output.status.success() && failed.is_none()).then(|| fault(&errors));
    Ok(Run { passed: tests().filter(|(_, end)| *end == "ok").count(), failed, fault })
}

fn fault(errors: &str) -> String {
    if errors.contains("could not compile") {
        return "does not compile".into();
    }
    errors.lines().rfind(|line| !line.trim().is_empty()).unwrap_or("cargo said nothing").to_owned()
}
