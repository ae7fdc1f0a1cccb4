//! Bounds on the totals of a record: what a check lets pass.

use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

use serde::Serialize;

use crate::deadline::Deadline;
use crate::totals::Totals;

/// A bound on one total, as `late-words<=200` or `slack.transfer>=-3`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Allowance {
    measure: Measure,
    /// Of which deadline; of all if `None`.
    deadline: Option<Deadline>,
    bound: Bound,
    number: i64,
}

/// Total that an allowance bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Measure {
    LateWords,
    LateSets,
    Missed,
    Slack,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Bound {
    AtMost,
    AtLeast,
}

/// A bound, and what was found.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Allowed {
    /// The bound as written.
    pub bound: String,
    /// The total; none where the record has no such deadline.
    pub found: Option<i64>,
    /// Whether the bound holds. A deadline of the hybrid machine that this one does not have is within every bound.
    pub is_met: bool,
}

impl Allowed {
    /// What was found, in words.
    pub(crate) fn told(&self) -> String {
        self.found.map_or_else(|| "no such deadline".to_owned(), |found| format!("found {found}"))
    }
}

/// A text that is no bound.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "found `{0}`, expected late-words<=N, late-sets<=N, missed<=N or slack>=N, the last two for one deadline as slack.transfer>=N"
)]
pub struct AllowanceError(String);

/// A bound of a deadline that nobody has: neither of the two records nor the hybrid machine.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{bound}`: no such deadline; expected one of {}", .known.iter().map(Deadline::word).collect::<Vec<_>>().join(", "))]
pub struct NoSuchDeadline {
    bound: String,
    known: BTreeSet<Deadline>,
}

const MEASURES: [(&str, Measure); 4] = [
    ("late-words", Measure::LateWords),
    ("late-sets", Measure::LateSets),
    ("missed", Measure::Missed),
    ("slack", Measure::Slack),
];

const BOUNDS: [(&str, Bound); 2] = [("<=", Bound::AtMost), (">=", Bound::AtLeast)];

impl FromStr for Allowance {
    type Err = AllowanceError;

    fn from_str(text: &str) -> Result<Self, AllowanceError> {
        Self::read(text).ok_or_else(|| AllowanceError(text.to_owned()))
    }
}

impl Allowance {
    fn read(text: &str) -> Option<Self> {
        let (sign, bound) = BOUNDS.into_iter().find(|(sign, _)| text.contains(sign))?;
        let (total, number) = text.split_once(sign)?;
        let (name, deadline) = match total.trim().split_once('.') {
            None => (total.trim(), None),
            Some((name, deadline)) => (name, Some(Deadline::named(deadline)?)),
        };
        let (_, measure) = MEASURES.into_iter().find(|(known, _)| *known == name)?;
        // Less is better of what is counted, more of slack.
        let is_right = matches!(measure, Measure::Slack) == matches!(bound, Bound::AtLeast);
        let has_deadlines = matches!(measure, Measure::Missed | Measure::Slack);
        let number = number.trim().parse().ok()?;
        (is_right && (has_deadlines || deadline.is_none())).then_some(Self {
            measure,
            deadline,
            bound,
            number,
        })
    }

    /// Whether the totals are within the bound.
    pub fn of(&self, totals: &Totals) -> Allowed {
        let found = self.found(totals);
        let is_met = match (found, self.bound) {
            (Some(found), Bound::AtMost) => found <= self.number,
            (Some(found), Bound::AtLeast) => found >= self.number,
            // A machine without drums has no corners to wait for; a deadline that went with the change is within no bound.
            (None, _) => self.deadline.is_none_or(|deadline| Deadline::HYBRID.contains(&deadline)),
        };
        Allowed { bound: self.to_string(), found, is_met }
    }

    /// Whether the deadline of this bound, if it has one, is of one of the records or of the hybrid machine.
    ///
    /// # Errors
    /// The names that are known, if its name is not among them.
    pub(crate) fn known_to(&self, records: [&Totals; 2]) -> Result<(), NoSuchDeadline> {
        let recorded = records.into_iter().flat_map(|totals| totals.deadlines.keys().copied());
        let known: BTreeSet<Deadline> = Deadline::HYBRID.into_iter().chain(recorded).collect();
        match self.deadline {
            Some(own) if !known.contains(&own) => Err(NoSuchDeadline { bound: self.to_string(), known }),
            _ => Ok(()),
        }
    }

    fn found(&self, totals: &Totals) -> Option<i64> {
        let counted = |count: u64| Some(i64::try_from(count).unwrap_or(i64::MAX));
        let deadlines = || {
            let ours =
                totals.deadlines.iter().filter(|(name, _)| self.deadline.is_none_or(|own| own == **name));
            ours.map(|(_, deadline)| &deadline.slack)
        };
        match self.measure {
            Measure::LateWords => counted(totals.late_words),
            Measure::LateSets => counted(totals.sets.late),
            Measure::Missed if deadlines().next().is_none() => None,
            Measure::Missed => counted(deadlines().map(|slack| slack.missed).sum()),
            Measure::Slack => deadlines().filter_map(|slack| slack.least).min(),
        }
    }
}

impl fmt::Display for Allowance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = MEASURES.iter().find(|(_, measure)| *measure == self.measure).map_or("", |(name, _)| name);
        let sign = BOUNDS.iter().find(|(_, bound)| *bound == self.bound).map_or("", |(sign, _)| sign);
        let deadline = self.deadline.map_or(String::new(), |deadline| format!(".{deadline}"));
        write!(f, "{name}{deadline}{sign}{}", self.number)
    }
}
