//! Which wires are looked at.

use std::collections::HashMap;

use signal::{Kind, Signal, Wire};

use crate::ScopeError;

/// Wires that were chosen, in the order of the signal table.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// With those that are not there, and so are 0 throughout.
    pub wires: Vec<Wire>,
    /// Names of those that are not there.
    pub left_out: Vec<&'static str>,
}

/// Sees that every pattern names a signal of `table`, the signals of `generator`.
///
/// # Errors
/// If the generator has no signals, or a pattern names none.
pub fn expect_known(table: &[Signal], patterns: &[String], generator: &str) -> Result<(), ScopeError> {
    if table.is_empty() {
        return Err(ScopeError::NoSignals(generator.to_owned()));
    }
    let is_known = |pattern: &String| table.iter().any(|signal| signal.matches(pattern));
    match patterns.iter().find(|pattern| !is_known(pattern)) {
        None => Ok(()),
        Some(pattern) => Err(ScopeError::Unknown(pattern.clone())),
    }
}

impl Choice {
    /// What `patterns` choose among the `there` of a machine: of each the wires that are there; where there are none,
    /// the signals of the table, which are then 0.
    pub fn of(table: &[Signal], there: &[Wire], patterns: &[String]) -> Self {
        let finds = |pattern: &String| there.iter().any(|wire| wire.signal.matches(pattern));
        let (found, empty): (Vec<&String>, Vec<&String>) =
            patterns.iter().partition(|pattern| finds(pattern));
        let mut choice = Self { wires: Vec::new(), left_out: Vec::new() };
        let there: HashMap<&str, &Wire> = there.iter().map(|wire| (wire.signal.name, wire)).collect();
        for signal in table {
            let is_of = |patterns: &[&String]| patterns.iter().any(|pattern| signal.matches(pattern));
            match there.get(signal.name) {
                Some(wire) if is_of(&found) => choice.wires.push(**wire),
                None if is_of(&empty) => {
                    choice.wires.push(absent(signal));
                    choice.left_out.push(signal.name);
                }
                _ => {}
            }
        }
        choice
    }

    /// Names of all wires.
    pub fn names(&self) -> Vec<&'static str> {
        self.wires.iter().map(|wire| wire.signal.name).collect()
    }
}

/// A wire that is not there: no voltage, and a scale that changes nothing.
fn absent(signal: &Signal) -> Wire {
    let volts = if signal.kind == Kind::Gate { 1.0 } else { 0.0 };
    Wire { signal: *signal, full_scale: 1.0, volts, datum: 0.0 }
}

#[cfg(test)]
mod tests {
    use signal::{Signal, Unit, Wire};

    use super::{Choice, expect_known};

    const TABLE: [Signal; 3] = [
        Signal::ground("tg.height", Unit::Metre, "", ""),
        Signal::ground("fg.height", Unit::Metre, "", ""),
        Signal::ground("fg.present", Unit::Gate, "", ""),
    ];

    fn choose(patterns: &[&str]) -> Choice {
        let there = [Wire { signal: TABLE[0], full_scale: 2.0, volts: 10.0, datum: 1.0 }];
        Choice::of(&TABLE, &there, &patterns.iter().map(|pattern| (*pattern).into()).collect::<Vec<_>>())
    }

    /// A star means what is there; a name means the signal, there or not.
    #[test]
    fn wires_that_are_left_out() {
        assert_eq!(choose(&["*"]).names(), ["tg.height"]);
        assert_eq!(choose(&["*", "fg.present"]).names(), ["tg.height", "fg.present"]);
        assert_eq!(choose(&["fg.*"]).left_out, ["fg.height", "fg.present"]);
        assert_eq!(choose(&["*.height"]).names(), ["tg.height"]);
    }

    #[test]
    fn a_pattern_without_a_signal() {
        let refused = |patterns: &[&str]| {
            let patterns: Vec<String> = patterns.iter().map(|pattern| (*pattern).into()).collect();
            expect_known(&TABLE, &patterns, "machine").is_err()
        };
        assert!(refused(&["tg.*", "zz"]) && !refused(&["tg.*", "fg.present"]));
    }
}
