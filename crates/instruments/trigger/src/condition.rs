//! What is waited for, as it is written: names are looked up, wires are not known yet.

use std::ops::Range;

use signal::{Axis, Signal};

use crate::ConditionError;
use crate::parser::Parser;

/// A condition that can be searched for on a machine that has its wires.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    pub(crate) text: String,
    pub(crate) clauses: Vec<Clause>,
    pub(crate) axis: Axis,
}

/// A signal and where it stands in the text.
#[derive(Debug, Clone, PartialEq)]
pub struct Named {
    pub signal: Signal,
    pub place: Range<usize>,
}

/// What the value of a sample is held against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Test {
    Above(f64),
    AtLeast(f64),
    Below(f64),
    AtMost(f64),
    Is(f64),
    IsNot(f64),
    Inside([f64; 2]),
    Outside([f64; 2]),
}

/// By what a slope is taken, or a width is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Per {
    Sample,
    Metre,
    Microsecond,
}

/// One clause of a condition; `and` joins several.
#[derive(Debug, Clone, PartialEq)]
pub enum Clause {
    /// State: the value, or its slope, passes a test.
    Level { of: Named, slope: Option<Per>, test: Test },
    /// State: a voltage is at its end; any of them without a name.
    Saturated(Option<Named>, Range<usize>),
    /// Moment: the value comes to `level` from below, or from above, having been farther away than `by`.
    Edge { of: Named, rising: bool, level: f64, by: f64 },
    /// Moment: a test that did not pass passes.
    Becomes { of: Named, test: Test },
    /// Moment: a gate was high for less than a width, or has been for more.
    Pulse { of: Named, longer: bool, width: f64, per: Per },
    /// Moment: any of the events, with a value that passes the test.
    Event { any: Vec<Named>, test: Option<Test> },
}

impl Clause {
    /// The signals that it names.
    pub fn named(&self) -> &[Named] {
        match self {
            Self::Level { of, .. }
            | Self::Edge { of, .. }
            | Self::Becomes { of, .. }
            | Self::Pulse { of, .. } => std::slice::from_ref(of),
            Self::Saturated(of, _) => of.as_slice(),
            Self::Event { any, .. } => any,
        }
    }
}

impl Condition {
    /// Reads a condition over the signals of `table`; the grammar stands in `docs/trigger-and-trace.md`.
    ///
    /// # Errors
    /// If it is none, with the place.
    pub fn parse(text: &str, table: &[Signal]) -> Result<Self, ConditionError> {
        Parser::new(text, table).condition()
    }

    /// The condition as written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether its samples are lines of the display and not samples of the sweep clock.
    pub fn is_of_display(&self) -> bool {
        self.axis == Axis::Display
    }
}

impl Test {
    /// Whether `value` passes; what is not there never does.
    pub fn holds(&self, value: f64) -> bool {
        match *self {
            Self::Above(level) => value > level,
            Self::AtLeast(level) => value >= level,
            Self::Below(level) => value < level,
            Self::AtMost(level) => value <= level,
            Self::Is(level) => value == level,
            Self::IsNot(level) => value != level && !value.is_nan(),
            Self::Inside([from, until]) => from <= value && value <= until,
            Self::Outside([from, until]) => value < from || value > until,
        }
    }

    /// The level that is passed on the way from `before`, where it did not hold, to `now`, where it does.
    pub fn border(&self, before: f64, now: f64) -> Option<f64> {
        match *self {
            Self::Above(level) | Self::AtLeast(level) | Self::Below(level) | Self::AtMost(level) => {
                Some(level)
            }
            Self::Is(_) | Self::IsNot(_) => None,
            Self::Inside([from, until]) => Some(if before < from { from } else { until }),
            Self::Outside([from, until]) => Some(if now > until { until } else { from }),
        }
    }
}
