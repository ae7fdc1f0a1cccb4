//! A cell of the matrix: one case by one method, what theory allows, what was found.

use serde::Serialize;

/// A number in the name of a case: far powers of ten as such, all else as it is written.
pub(crate) fn plain(value: f64) -> String {
    let is_ordinary = value == 0.0 || (1e-3..1e5).contains(&value.abs());
    if is_ordinary { format!("{value}") } else { format!("{value:e}") }
}

/// What theory allows of a case by a method of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Theory {
    /// An answer whose error is at most this (full scales).
    Answers(f64),
    /// An answer that is finite and bounded; of its error nothing is said.
    Bounded,
    /// A refusal with a message.
    Refuses,
}

/// What the method did.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "did", content = "detail")]
pub enum Action {
    /// Solved it in one piece.
    Exact,
    /// Split it at the instants at which its law changes.
    Split,
    /// Clamped something, and counted how often.
    Clamped(u64),
    /// Stepped through it, with steps of finite length.
    Stepped,
    /// Refused it, with this message.
    Refused(String),
    /// Stopped with a panic: no method of the machine may.
    Panicked(String),
}

impl Action {
    /// In a word or two.
    pub fn words(&self) -> String {
        match self {
            Self::Exact => "exact".into(),
            Self::Split => "split".into(),
            Self::Clamped(count) => format!("clamped, {count} counted"),
            Self::Stepped => "stepped".into(),
            Self::Refused(_) => "refused".into(),
            Self::Panicked(_) => "panicked".into(),
        }
    }
}

/// What was found of a case by a method.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// No NaN and no infinity came out.
    pub finite: bool,
    /// Trust section 4: a linear part within its input and its overshoot, others within their saturation.
    pub bounded: bool,
    /// Largest error (full scales), where there is something to hold it against.
    pub error: Option<f64>,
    /// What the method did.
    pub action: Action,
    /// Seconds that it took.
    pub time_s: f64,
}

impl Found {
    /// Returns what is found of a case that is refused with `message`.
    pub fn refused(message: String) -> Self {
        Self { finite: true, bounded: true, error: None, action: Action::Refused(message), time_s: 0.0 }
    }
}

/// One case by one method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cell {
    /// Dimension of the case.
    pub row: &'static str,
    /// Name of the case.
    pub case: String,
    /// Name of the method.
    pub method: &'static str,
    /// Whether it is the machine's own; others are there for comparison.
    pub own: bool,
    /// No NaN and no infinity.
    pub finite: bool,
    /// Whether all values stayed within their bounds.
    pub bounded: bool,
    /// Largest error (full scales).
    pub error: Option<f64>,
    /// What theory allows of it; `None` where theory refuses the case or says nothing.
    pub allowed: Option<f64>,
    /// What the method did.
    pub action: Action,
    /// Seconds that it took.
    pub time_s: f64,
    /// Why the cell does not hold; only of the machine's own methods.
    pub fault: Option<&'static str>,
}

impl Cell {
    /// The cell of a method of the machine.
    pub fn own(row: &'static str, case: &str, method: &'static str, theory: Theory, found: Found) -> Self {
        let fault = fault(theory, &found);
        Self { own: true, fault, ..Self::comparison(row, case, method, theory, found) }
    }

    /// The cell of a method that the machine does not use.
    pub fn comparison(
        row: &'static str,
        case: &str,
        method: &'static str,
        theory: Theory,
        found: Found,
    ) -> Self {
        let Found { finite, bounded, error, action, time_s } = found;
        let allowed = match theory {
            Theory::Answers(allowed) => Some(allowed),
            Theory::Bounded | Theory::Refuses => None,
        };
        Self {
            row,
            case: case.to_owned(),
            method,
            own: false,
            finite,
            bounded,
            error,
            allowed,
            action,
            time_s,
            fault: None,
        }
    }

    /// Whether the answer, if there is one, is finite, bounded and no worse than theory allows.
    pub fn is_sound(&self) -> bool {
        let within = |(error, allowed): (f64, f64)| error <= allowed;
        let is_right = self.error.zip(self.allowed).is_none_or(within);
        self.finite && self.bounded && is_right && !matches!(self.action, Action::Panicked(_))
    }
}

fn fault(theory: Theory, found: &Found) -> Option<&'static str> {
    match (&found.action, theory) {
        (Action::Panicked(_), _) => Some("panicked"),
        (Action::Refused(_), Theory::Answers(_) | Theory::Bounded) => {
            Some("refused, though theory has an answer")
        }
        (Action::Refused(message), Theory::Refuses) => message.is_empty().then_some("refused without a word"),
        (_, Theory::Refuses) => Some("silent: answered what it should refuse"),
        (_, Theory::Answers(_) | Theory::Bounded) => {
            let beyond = |error: f64| matches!(theory, Theory::Answers(allowed) if error > allowed);
            if !found.finite {
                Some("not finite")
            } else if !found.bounded {
                Some("unbounded")
            } else if found.error.is_some_and(|error| error.is_nan() || beyond(error)) {
                Some("silent: error beyond theory")
            } else {
                None
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Action, Cell, Found, Theory, plain};

    #[test]
    fn ordinary_numbers_stand_as_they_are() {
        let said = [90.0, 0.0, -1.0, 0.001, 1e-6, 1e6, -1e6].map(plain);
        assert_eq!(said, ["90", "0", "-1", "0.001", "1e-6", "1e6", "-1e6"]);
    }

    fn fault(theory: Theory, found: Found) -> Option<&'static str> {
        Cell::own("row", "case", "method", theory, found).fault
    }

    #[test]
    fn every_way_to_fail_is_told() {
        let good =
            Found { finite: true, bounded: true, error: Some(1e-9), action: Action::Exact, time_s: 0.0 };
        let answers = Theory::Answers(1e-6);
        assert_eq!(fault(answers, good.clone()), None);
        assert_eq!(fault(Theory::Bounded, Found { error: Some(1e9), ..good.clone() }), None);
        assert_eq!(fault(Theory::Bounded, Found { bounded: false, ..good.clone() }), Some("unbounded"));
        assert_eq!(fault(Theory::Answers(1e-12), good.clone()), Some("silent: error beyond theory"));
        assert!(fault(answers, Found { error: Some(f64::NAN), ..good.clone() }).is_some());
        assert_eq!(fault(answers, Found { finite: false, ..good.clone() }), Some("not finite"));
        assert_eq!(fault(answers, Found { bounded: false, ..good.clone() }), Some("unbounded"));
        assert!(fault(Theory::Refuses, good).is_some());
        assert!(fault(answers, Found::refused("key".into())).is_some());
        assert_eq!(fault(Theory::Refuses, Found::refused("key".into())), None);
        assert!(fault(Theory::Refuses, Found::refused(String::new())).is_some());
    }
}
