//! What a generator says of a pixel.

use serde::Serialize;

/// One line of an explanation.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Fact {
    /// A step, a signal or a place.
    pub what: String,
    /// Its value, with the unit.
    pub value: String,
}

impl Fact {
    /// Makes a fact: the name of a quantity, and its value with the unit.
    pub fn new(what: impl Into<String>, value: impl Into<String>) -> Self {
        Self { what: what.into(), value: value.into() }
    }
}
