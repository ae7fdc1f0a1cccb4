//! What a signal is: one definition for probes, exporters and docs.

use std::fmt;

/// Unit of a signal's physical value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Metres.
    Metre,
    /// Metres a metre.
    Slope,
    /// Share of the sun's light, 0..=1.
    Reflectivity,
    /// Fraction of a region, 0..=1.
    Region,
    /// Tangent of the elevation angle.
    Tangent,
    /// Display lines from the top of the picture.
    Line,
    /// A gate: 0 or 1.
    Gate,
}

impl Unit {
    /// What it measures, with its symbol: the label of an axis.
    pub fn quantity(self) -> &'static str {
        match self {
            Self::Metre => "height (m)",
            Self::Slope => "slope (m/m)",
            Self::Reflectivity => "reflectivity",
            Self::Region => "folded ramp (regions)",
            Self::Tangent => "tangent of elevation",
            Self::Line => "display line",
            Self::Gate => "gate",
        }
    }

    /// As it stands in a table.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Slope => "m/m",
            Self::Reflectivity | Self::Tangent | Self::Gate => "1",
            Self::Region => "d",
            Self::Line => "line",
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.symbol())
    }
}

/// Against what a signal is sampled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// The sweep clock: one value a sample, that is, against ground range.
    Ground,
    /// One value a display line.
    Display,
}

/// One wire of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Signal {
    /// Dotted name, block first.
    pub name: &'static str,
    /// Unit of its value.
    pub unit: Unit,
    /// Against what it is sampled.
    pub axis: Axis,
    /// What it is, with the figure of the report that shows it.
    pub meaning: &'static str,
}

impl Signal {
    /// A signal on the sweep clock.
    pub const fn ground(name: &'static str, unit: Unit, meaning: &'static str) -> Self {
        Self { name, unit, axis: Axis::Ground, meaning }
    }

    /// A signal against display lines.
    pub const fn display(name: &'static str, unit: Unit, meaning: &'static str) -> Self {
        Self { name, unit, axis: Axis::Display, meaning }
    }

    /// Whether `pattern` names this signal: exact, or with `*` for any run of characters.
    pub fn matches(&self, pattern: &str) -> bool {
        matches(pattern.as_bytes(), self.name.as_bytes())
    }
}

fn matches(pattern: &[u8], name: &[u8]) -> bool {
    match pattern.split_first() {
        None => name.is_empty(),
        Some((b'*', rest)) => (0..=name.len()).any(|skip| matches(rest, &name[skip..])),
        Some((c, rest)) => name.split_first().is_some_and(|(n, tail)| n == c && matches(rest, tail)),
    }
}

#[cfg(test)]
mod tests {
    use super::{Signal, Unit};

    #[test]
    fn patterns() {
        let signal = Signal::ground("tg.slope.u", Unit::Slope, "");
        for yes in ["tg.slope.u", "tg.*", "*", "*.u", "tg.*.u"] {
            assert!(signal.matches(yes), "{yes}");
        }
        for no in ["", "tg", "tg.slope", "dpp.*", "*.v", "tg.slope.uu"] {
            assert!(!signal.matches(no), "{no}");
        }
    }
}
