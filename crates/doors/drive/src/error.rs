//! What is wrong with what was asked, as fields and as text.

use std::fmt;

use diagnostics::{Problem, ProblemList, ProblemRecord};
use front_door::OpenError;

/// One fault: file, line, found, expected, help.
pub type Fault = ProblemRecord;

/// Why something cannot be opened, drawn or told; never without a fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DriveError(ProblemList);

impl DriveError {
    /// A fault of what was asked of `file`, the scenario: what is wrong, and what was expected instead.
    pub(crate) fn asked(file: &str, title: impl Into<String>, expected: impl Into<String>) -> Self {
        Problem::of_file(file, title).expected(expected).into()
    }

    /// What `error` says of `file`.
    pub(crate) fn of(file: &str, error: &impl fmt::Display) -> Self {
        Problem::of_file(file, error.to_string()).into()
    }

    /// What opening `file` came to.
    pub(crate) fn opening(file: &str, error: OpenError) -> Self {
        match error {
            OpenError::Problems(list) => list.into(),
            other => Self::of(file, &other),
        }
    }

    /// The faults as a list of problems, for a program that tells of its own in the same way.
    pub fn into_problems(self) -> ProblemList {
        self.0
    }

    /// All faults, in the order of the files.
    pub fn faults(&self) -> Vec<Fault> {
        self.0.records()
    }
}

impl From<Problem> for DriveError {
    fn from(problem: Problem) -> Self {
        Self(problem.into())
    }
}

impl From<ProblemList> for DriveError {
    fn from(list: ProblemList) -> Self {
        Self(list)
    }
}

impl fmt::Display for DriveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl std::error::Error for DriveError {}
