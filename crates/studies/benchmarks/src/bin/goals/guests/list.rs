//! What is compared, as `peers/guests.toml` lists it.

use std::collections::BTreeMap;

use serde::Deserialize;

/// Everything that is measured of guests.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Guests {
    /// Two sides, or one side on two threads and on one, or a side and a program of other people.
    pub comparison: Vec<Comparison>,
    /// Two sides whose instructions are counted.
    pub counted: Vec<CountedRow>,
    /// Peak memory of sides.
    pub memory: Vec<MemoryRow>,
}

/// A row of the table of times.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Comparison {
    /// Issue that set the figures.
    pub issue: u32,
    /// What is compared, in words.
    pub quantity: String,
    /// Which way the figures count.
    pub sense: Sense,
    /// Figure that must be reached.
    pub must: f64,
    /// Figure that is aimed at.
    pub aim: f64,
    /// Frames of each side.
    pub turns: usize,
    /// Whether sides have one thread in place of two.
    #[serde(default)]
    pub alone: bool,
    /// Side that the row is about.
    pub first: SideChoice,
    /// What it is held against.
    pub against: Against,
}

/// Which way the figure of a row counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// So many times as fast as the other at least.
    AsFast,
    /// So many times the other's time at most.
    TimesTheTime,
}

impl Sense {
    /// The figure of the times of both sides (s), and whether it meets `must`.
    pub fn figure(self, [first, second]: [f64; 2], must: f64) -> (f64, bool) {
        match self {
            Self::AsFast => (second / first, second / first >= must),
            Self::TimesTheTime => (first / second, first / second <= must),
        }
    }

    /// Words behind the figure.
    pub fn words(self) -> &'static str {
        match self {
            Self::AsFast => "times as fast",
            Self::TimesTheTime => "times its time",
        }
    }
}

/// What a side is held against.
#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Against {
    /// Another scenario or another generator.
    Side(SideChoice),
    /// The same side on one thread.
    OneThread,
    /// The time that a frame is shown for, at so many frames a second.
    RealTime(f64),
    /// Embree over the same faces; so many rays in place of a pixel across and upright.
    Embree {
        /// Rays in place of a pixel, across and upright.
        fineness: u32,
        /// Whether its structure is made anew for each frame.
        anew: bool,
    },
    /// OSMesa over the same faces, one sample a pixel.
    Osmesa {
        /// Whether its vertex buffer is filled anew for each frame.
        anew: bool,
    },
}

/// A row of the table of counts.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CountedRow {
    /// Issue that set the figures.
    pub issue: u32,
    /// What is compared, in words.
    pub quantity: String,
    /// Times the instructions of the other side that must not be passed.
    pub must: f64,
    /// Times that are aimed at.
    pub aim: f64,
    /// Side that the row is about.
    pub first: SideChoice,
    /// Side that it is held against.
    pub against: SideChoice,
}

/// A row of the table of memory.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MemoryRow {
    /// Issue that set the figures.
    pub issue: u32,
    /// What is measured, in words.
    pub quantity: String,
    /// Megabytes that it must stay below.
    pub must_mb: f64,
    /// Megabytes that are aimed at.
    pub aim_mb: f64,
    /// Sides, of which the largest counts.
    pub of: Vec<SideChoice>,
    /// Side whose peak is taken off, if one is named.
    pub less: Option<SideChoice>,
}

/// A scenario under a generator.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SideChoice {
    /// Name of a shipped scenario.
    pub scenario: String,
    /// Name of the generator; the scenario's own if left out.
    pub machine: Option<String>,
    /// Keys with their values, as `--set` takes them.
    #[serde(default)]
    pub set: BTreeMap<String, String>,
    /// Whether its frames are spread over the whole mission; the first ones otherwise.
    #[serde(default)]
    pub whole: bool,
}

impl Guests {
    /// The list of this crate.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn read() -> Result<Self, String> {
        toml::from_str(include_str!("../../../../peers/guests.toml"))
            .map_err(|error| format!("peers/guests.toml: {error}"))
    }
}

impl Comparison {
    /// The figure of both medians (s), and whether it is what must be.
    pub fn figure(&self, first: f64, second: f64) -> (f64, bool) {
        self.sense.figure([first, second], self.must)
    }
}

#[cfg(test)]
mod tests {
    use super::{Guests, Sense};

    #[test]
    fn the_list_is_read_and_figures_count_both_ways() {
        let guests = Guests::read().unwrap();
        assert!(guests.comparison.len() >= 6 && guests.memory.len() >= 2 && guests.counted.len() >= 3);
        let row = |sense| guests.comparison.iter().find(|row| row.sense == sense).unwrap();
        let faster = row(Sense::AsFast);
        assert_eq!(faster.figure(1.0, 2.0 * faster.must), (2.0 * faster.must, true));
        assert!(!faster.figure(1.0, 0.5 * faster.must).1);
        let dearer = row(Sense::TimesTheTime);
        assert!(dearer.figure(0.5 * dearer.must, 1.0).1 && !dearer.figure(2.0 * dearer.must, 1.0).1);
    }
}
