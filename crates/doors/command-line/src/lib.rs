//! What the commands of `lunoid` share: options that choose a scenario and who draws it, values of options, printing, progress, failures with
//! their exit codes.
//!
//! ```text
//! arguments ─▶ values, StageArgs, Sharing, Saying ─▶ a command ─▶ Verdict or Failure ─▶ exit code
//!                                                       └─▶ output, progress
//! ```
//!
//! # Law
//! - Results go to standard output, everything else to standard error.
//! - A [`Failure`] has one exit code, and [`failure`] alone says which errors of libraries become which failure.
//!
//! # See also
//! `ground-commands`, `study-commands`: commands in libraries of their own. `lunoid`: the program, and all other commands.

pub mod failure;
pub mod interrupt;
pub mod loading;
pub mod of_run;
pub mod output;
pub mod program;
pub mod progress;
pub mod sharing;
pub mod values;
pub mod words;

pub use failure::Failure;

/// What a command comes to when nothing went wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The command is done; the answer, if any, is yes.
    Yes,
    /// Done, and the answer is no.
    No,
    /// Told to end; the same command goes on.
    Interrupted,
}
