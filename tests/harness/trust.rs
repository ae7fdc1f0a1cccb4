//! What the page of trust rests on, and the page.

mod coverage;
mod evidence;
mod page;

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use serde::{Deserialize, Serialize};

pub use evidence::{EVIDENCE, Evidence, Form};
pub use page::page;

/// What a command printed, as it is kept in `docs/trust/NAME.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Kept {
    /// Day on which it ran (UTC).
    pub date: String,
    /// Commit of the tree that was measured.
    pub commit: String,
    /// The command that was run.
    pub command: String,
    /// How long it took (s), on whatever else the computer had to do.
    pub seconds: u64,
    /// Whether it ended well.
    pub passed: bool,
    /// What it printed, line by line; of tests only what they say themselves.
    pub said: Vec<String>,
}

/// Runs the command of `evidence` in the folder `house` and keeps what it prints; a command that ends badly is kept as well.
///
/// # Errors
/// If it cannot be started, or its result not be written.
pub fn measure(house: &Path, evidence: &Evidence) -> Result<(), String> {
    let begin = Instant::now();
    // Of before: whoever commits while it runs changes nothing of what is measured.
    let commit = line_of(house, "git", &["rev-parse", "--short=12", "HEAD"])?;
    let mut words = evidence.command.split_whitespace();
    let program = words.next().unwrap_or_default();
    let ended = Command::new(program).args(words).current_dir(house).output();
    let ended = ended.map_err(|error| format!("{program}: {error}"))?;
    let mut said = String::from_utf8_lossy(&ended.stdout).into_owned();
    if evidence.form == Form::Coverage {
        let found = coverage::coverage(&said, house)?;
        said = serde_json::to_string_pretty(&found).map_err(|error| error.to_string())?;
    }
    let kept = Kept {
        date: line_of(house, "date", &["-u", "+%F"])?,
        commit,
        command: evidence.command.into(),
        seconds: begin.elapsed().as_secs(),
        passed: ended.status.success(),
        said: said.lines().filter(|line| is_kept(evidence.form, line)).map(str::to_owned).collect(),
    };
    if evidence.form == Form::Awake {
        // It writes its own file.
        return Ok(());
    }
    let text = serde_json::to_string_pretty(&kept).map_err(|error| error.to_string())? + "\n";
    let path = house.join("docs/trust").join(evidence.name).with_extension("json");
    files::write_atomic(path, |out| out.write_all(text.as_bytes())).map_err(|error| error.to_string())
}

/// Whether a line that a command prints is evidence of this form.
fn is_kept(form: Form, line: &str) -> bool {
    match form {
        Form::Tests => line.starts_with("test ") && line.contains(" ... "),
        _ => !is_of_the_harness(line),
    }
}

/// The only line that a command prints.
fn line_of(folder: &Path, program: &str, arguments: &[&str]) -> Result<String, String> {
    let ended = Command::new(program).args(arguments).current_dir(folder).output();
    let ended = ended.map_err(|error| format!("{program}: {error}"))?;
    Ok(String::from_utf8_lossy(&ended.stdout).trim().to_owned())
}

/// What `cargo test` prints around what the tests say.
fn is_of_the_harness(line: &str) -> bool {
    let line = line.trim();
    line.is_empty()
        || line.starts_with("running ")
        || line.starts_with("test ")
        || line.chars().all(|mark| ".i".contains(mark))
}

/// What is kept of `name` in `folder`; `None` if it was never measured.
///
/// # Errors
/// If the file cannot be read or is no result.
pub fn kept<T: for<'a> Deserialize<'a>>(folder: &Path, name: &str) -> Result<Option<T>, String> {
    let path = folder.join(name).with_extension("json");
    if !path.exists() {
        return Ok(None);
    }
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    serde_json::from_str(&text).map(Some).map_err(|error| format!("{}: {error}", path.display()))
}
