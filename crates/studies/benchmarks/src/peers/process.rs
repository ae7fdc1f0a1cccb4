//! A peer as a process that answers each line of its input with one line.

use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Output, Stdio};

/// A running peer. It ends when it is dropped.
#[derive(Debug)]
pub(super) struct Process {
    name: &'static str,
    child: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
}

impl Process {
    /// Starts the program `name` of `folder` over `input`, a file of that folder, and its first line.
    ///
    /// # Errors
    /// If it cannot be started or ends early.
    pub fn start(name: &'static str, folder: &Path, input: &str) -> Result<(Self, String), String> {
        let mut command = Command::new(folder.join(name));
        command.arg(input).current_dir(folder).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().map_err(|error| format!("{name}: {error}"))?;
        let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(format!("{name}: no pipes"));
        };
        let mut process = Self { name, child, input: Some(input), output: BufReader::new(output) };
        let said = process.answer()?;
        Ok((process, said))
    }

    /// The line that the peer answers to `question`, without its end.
    ///
    /// # Errors
    /// If it has ended, or ends instead.
    pub fn ask(&mut self, question: &str) -> Result<String, String> {
        let input = self.input.as_mut().ok_or_else(|| format!("{} has ended", self.name))?;
        writeln!(input, "{question}").map_err(|error| format!("{}: {error}", self.name))?;
        self.answer()
    }

    /// The error for an answer that nobody expects.
    pub fn unexpected(&self, expected: &str, found: &str) -> String {
        format!("{} said '{found}': expected {expected}", self.name)
    }

    fn answer(&mut self) -> Result<String, String> {
        let mut line = String::new();
        match self.output.read_line(&mut line) {
            Err(error) => Err(format!("{}: {error}", self.name)),
            Ok(0) => Err(format!("{} ended without an answer", self.name)),
            Ok(_) => Ok(line.trim_end().to_owned()),
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        drop(self.input.take());
        // It reads the end of its input and ends; nothing is left to be told if it does not.
        let _ = self.child.wait();
    }
}

/// Runs a tool in a folder; `None` where the system does not have it.
///
/// # Errors
/// If it cannot be started for another reason.
pub(super) fn run_tool(name: &str, arguments: &[&str], folder: &Path) -> Result<Option<Output>, String> {
    match Command::new(name).args(arguments).current_dir(folder).output() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(format!("{name}: {error}")),
        Ok(ended) => Ok(Some(ended)),
    }
}

/// The line for a package that is missing.
pub(super) fn skipped(what: &str, package: &str) -> String {
    format!("skipped: {what} is not here; install the package {package}")
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Process, run_tool};

    #[test]
    fn a_tool_that_is_not_here_is_no_error() {
        assert!(run_tool("no-tool-of-this-name", &[], Path::new(".")).unwrap().is_none());
    }

    #[test]
    fn a_program_that_is_not_here_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = Process::start("no-peer", folder.path(), "scene").map(|_| ()).unwrap_err();
        assert!(error.starts_with("no-peer: "), "{error}");
    }
}
