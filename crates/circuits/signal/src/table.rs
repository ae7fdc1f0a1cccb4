//! What a signal is: one definition for probes, exporters and docs.

use std::fmt;

/// Unit of a signal's physical value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// A length in metres.
    Metre,
    /// A slope: metres of height a metre of ground.
    Slope,
    /// Share of the sun's light, 0..=1.
    Reflectivity,
    /// Fraction of a region, 0..=1.
    Region,
    /// Tangent of the elevation angle.
    Tangent,
    /// Tangent of the elevation angle a microsecond.
    TangentRate,
    /// Display lines from the top of the picture.
    Line,
    /// An angle in radians.
    Radian,
    /// A gate: 0 or 1.
    Gate,
    /// Index of a corner in the storage buffer of its level; -1 where the data bank has not delivered.
    Corner,
    /// Plain number: what is meant stands in the signal's meaning.
    Number,
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
            Self::TangentRate => "change of elevation (1/µs)",
            Self::Line => "display line",
            Self::Radian => "angle (rad)",
            Self::Gate => "gate",
            Self::Corner => "corner",
            Self::Number => "number",
        }
    }

    /// Whether a bus of this unit carries whole numbers.
    pub fn is_counted(self) -> bool {
        matches!(self, Self::Corner | Self::Number | Self::Gate)
    }

    /// As it stands in a table.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Slope => "m/m",
            Self::Reflectivity | Self::Tangent | Self::Gate | Self::Number => "1",
            Self::TangentRate => "1/us",
            Self::Corner => "corner",
            Self::Region => "d",
            Self::Line => "line",
            Self::Radian => "rad",
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
    /// The sweep clock: a value whenever there is a new one, at its own instant.
    Changes,
    /// The clock of a line that the read beam scans: one value a column.
    Line,
}

impl Axis {
    /// Word in tables and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ground => "ground",
            Self::Display => "display",
            Self::Changes => "changes",
            Self::Line => "line",
        }
    }
}

/// What kind of wire carries a signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A wire with an analog voltage.
    Analog,
    /// A wire with two levels.
    Gate,
    /// Wires that carry a number together: a whole one, or one in the unit of the signal.
    Bus,
    /// A pulse, with what is told at it.
    Event,
}

impl Kind {
    /// Word in tables and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Analog => "analog",
            Self::Gate => "gate",
            Self::Bus => "bus",
            Self::Event => "event",
        }
    }
}

/// One wire of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Signal {
    /// Dotted name, prefix of the block first.
    pub name: &'static str,
    /// Unit of its value.
    pub unit: Unit,
    /// What kind of wire it is.
    pub kind: Kind,
    /// Against what it is sampled.
    pub axis: Axis,
    /// Meaning of the signal, in words.
    pub meaning: &'static str,
    /// Figure or section of the report that has it.
    pub figure: &'static str,
}

impl Signal {
    /// A signal on the sweep clock: a gate if its unit is that of a gate, a voltage otherwise.
    pub const fn ground(name: &'static str, unit: Unit, meaning: &'static str, figure: &'static str) -> Self {
        Self { name, unit, kind: Self::kind_of(unit), axis: Axis::Ground, meaning, figure }
    }

    /// A signal against display lines.
    pub const fn display(
        name: &'static str,
        unit: Unit,
        meaning: &'static str,
        figure: &'static str,
    ) -> Self {
        Self { name, unit, kind: Self::kind_of(unit), axis: Axis::Display, meaning, figure }
    }

    /// A digital signal: told when it changes, or when it happens.
    pub const fn digital(
        name: &'static str,
        unit: Unit,
        kind: Kind,
        meaning: &'static str,
        figure: &'static str,
    ) -> Self {
        Self { name, unit, kind, axis: Axis::Changes, meaning, figure }
    }

    /// A signal along the lines that the read beam scans.
    pub const fn line(name: &'static str, unit: Unit, meaning: &'static str, figure: &'static str) -> Self {
        Self { name, unit, kind: Self::kind_of(unit), axis: Axis::Line, meaning, figure }
    }

    const fn kind_of(unit: Unit) -> Kind {
        if matches!(unit, Unit::Gate) { Kind::Gate } else { Kind::Analog }
    }

    /// The part of the name before the first dot.
    pub fn prefix(&self) -> &'static str {
        self.name.split_once('.').map_or(self.name, |(prefix, _)| prefix)
    }

    /// Crate of the block that drives the wire: the block of the report's figures by its name.
    pub fn block(&self) -> &'static str {
        match self.prefix() {
            "sweep" => "sweep-generator",
            "dpu" | "cpu" | "loader" => "dpu",
            "tg" => "terrain-generator",
            "fg" => "feature-generator",
            "sc" => "shadow-controller",
            "txg" => "texture-generator",
            "mu" => "mixing-unit",
            "dpp" => "display-projection-processor",
            "pg" => "polyhedron-generator",
            "drum" | "channel" | "editor" | "buffer" => "data-bank",
            "vs" => "vehicle-shadow",
            "sm" | "yoke" => "sweep-memory",
            "tube" => "picture-tube",
            // Other generators have their own name before the dot.
            generator => generator,
        }
    }

    /// Whether `pattern` names this signal: exact, or with `*` for any run of characters.
    pub fn matches(&self, pattern: &str) -> bool {
        name_matches(pattern, self.name)
    }
}

/// A signal as it is in an elaborated machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wire {
    /// Signal that the wire carries.
    pub signal: Signal,
    /// Value at full scale, in the unit of the signal; 1 for what is digital.
    pub full_scale: f64,
    /// Voltage at full scale (V); 0 for buses and events, which have none.
    pub volts: f64,
    /// Value at 0 V, in the unit of the signal.
    pub datum: f64,
}

impl Wire {
    /// The wire of a video signal that is 1 for white: 1 V there (our choice), 0 V for black.
    pub fn of_video(signal: Signal) -> Self {
        Self { signal, full_scale: 1.0, volts: 1.0, datum: 0.0 }
    }
}

/// Whether `pattern` names `name`: exact, or with `*` for any run of characters.
pub fn name_matches(pattern: &str, name: &str) -> bool {
    matches(pattern.as_bytes(), name.as_bytes())
}

/// Between two stars the first place that fits will do, so the time goes with the product of both lengths.
fn matches(mut pattern: &[u8], mut name: &[u8]) -> bool {
    // What is behind the last star, and what of the name that star has not taken yet.
    let mut star: Option<(&[u8], &[u8])> = None;
    loop {
        match (pattern, name) {
            ([], []) => return true,
            ([b'*', rest @ ..], _) => {
                star = Some((rest, name));
                pattern = rest;
            }
            ([c, rest @ ..], [n, tail @ ..]) if c == n => (pattern, name) = (rest, tail),
            _ => match star {
                Some((rest, [_, tail @ ..])) => {
                    star = Some((rest, tail));
                    (pattern, name) = (rest, tail);
                }
                _ => return false,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Signal, Unit, name_matches};

    #[test]
    fn patterns() {
        let signal = Signal::ground("tg.slope.u", Unit::Slope, "", "");
        for yes in ["tg.slope.u", "tg.*", "*", "*.u", "tg.*.u"] {
            assert!(signal.matches(yes), "{yes}");
        }
        for no in ["", "tg", "tg.slope", "dpp.*", "*.v", "tg.slope.uu"] {
            assert!(!signal.matches(no), "{no}");
        }
        for (pattern, name, fits) in [
            ("*a*ab", "aaab", true),
            ("*ab*ab", "xabyab", true),
            ("*ab*ab", "xabyabz", false),
            ("**", "", true),
            ("a*a", "a", false),
            ("a*", "a", true),
        ] {
            assert_eq!(name_matches(pattern, name), fits, "{pattern}, {name}");
        }
    }

    /// So many stars have more ways to fit than there is time to try them.
    #[test]
    fn many_stars_take_no_time() {
        let (pattern, name) = ("*a".repeat(500) + "b", "a".repeat(5000));
        assert!(!name_matches(&pattern, &name));
        assert!(name_matches(&pattern, &(name + "b")));
    }
}
