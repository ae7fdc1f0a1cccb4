//! What is wrong with a condition, and where in its text.

use std::fmt;
use std::ops::Range;

/// What is wrong with the text of a condition.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Fault {
    /// Something else was expected here.
    #[error("found {found}, expected {expected}")]
    Unexpected {
        /// Text that was found there.
        found: String,
        /// What may stand there.
        expected: &'static str,
    },
    /// No signal has this name.
    #[error("no signal is called `{name}`{}; `lunoid signals` lists them", suggestion(*.nearest))]
    UnknownSignal {
        /// Name that no signal has.
        name: String,
        /// The name most like it.
        nearest: Option<&'static str>,
    },
    /// The signal is of another kind.
    #[error("`{name}` is {found}, expected {expected}")]
    WrongKind {
        /// Name of the signal.
        name: &'static str,
        /// Kind of the signal, in words.
        found: &'static str,
        /// What is asked for here.
        expected: &'static str,
    },
    /// Two signals have no common samples.
    #[error(
        "`{name}` runs down the display and `{other}` along the ground: they have no sample in common; \
         expected signals of one axis"
    )]
    TwoAxes {
        /// The signal of the display.
        name: &'static str,
        /// The signal along the ground.
        other: &'static str,
    },
    /// The block of the signal is not there.
    #[error("this machine has no `{name}`: its {block} is left out; --everything keeps what has a source")]
    LeftOut {
        /// Name of the missing signal.
        name: &'static str,
        /// Name of its block.
        block: &'static str,
    },
    /// A window ends before it begins.
    #[error("the window {from}..{until} is empty, expected the lower end first")]
    EmptyWindow {
        /// Lower end as written.
        from: f64,
        /// Upper end as written.
        until: f64,
    },
    /// A size below 0.
    #[error("found {value}, expected {expected}")]
    Negative {
        /// Number that was found there.
        value: f64,
        /// What may stand there.
        expected: &'static str,
    },
}

fn suggestion(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |nearest| format!(", did you mean `{nearest}`?"))
}

/// A fault and its place. As text it is three lines: the fault, the condition, and what is meant underlined.
#[derive(Debug, Clone, PartialEq)]
pub struct ConditionError {
    /// The condition as written.
    pub text: String,
    /// The part of it that is meant, in bytes.
    pub place: Range<usize>,
    /// What is wrong with that.
    pub fault: Fault,
}

impl fmt::Display for ConditionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { text, place, fault } = self;
        let before = text[..place.start].chars().count();
        let width = text[place.clone()].chars().count().max(1);
        write!(f, "{fault}\n  {text}\n  {:before$}{:^<width$}", "", "")
    }
}

impl std::error::Error for ConditionError {}
