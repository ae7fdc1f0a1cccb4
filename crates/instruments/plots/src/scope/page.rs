//! What is on a page of the scope, and how it is to look.

use crate::colour::{DARK, LIGHT, Palette};

use super::Clock;

/// One sweep: everything that was recorded of it. Instants are in samples from its start.
#[derive(Debug, Clone, PartialEq)]
pub struct Scope<'a> {
    /// Clock of the sweep: its sample period and ground ranges.
    pub clock: Clock<'a>,
    /// Analog signals, from top to bottom.
    pub panels: Vec<Curves<'a>>,
    /// Digital signals below them.
    pub lanes: Vec<LogicLane<'a>>,
    /// Where the sweep passes from region to region, in any order.
    pub crossings: Vec<Crossing>,
    /// The same of the coarse level, where there is one.
    pub coarse: Vec<Crossing>,
    /// Stretches that are not written, as begin and end.
    pub blanked: Vec<[f64; 2]>,
    /// What the sweep leaves in the picture.
    pub column: Option<PictureColumn<'a>>,
}

/// Analog signals of one unit, drawn over each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Curves<'a> {
    /// What they are, with unit: `height (m)`.
    pub label: String,
    /// Symbol of their unit in readouts; empty for plain numbers.
    pub unit: String,
    /// How values stand in the panel.
    pub upright: Upright,
    /// What the values are as voltages.
    pub volts: Option<Volts>,
    /// In the order of the legend.
    pub curves: Vec<Curve<'a>>,
}

/// How values stand in a panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Upright {
    /// Upwards, over all that is drawn.
    Values,
    /// Lines of the picture, downwards from 0 to this many; the picture column stands beside them.
    Lines(u32),
}

/// The voltage of a value: `volts * (value - datum) / full_scale`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Volts {
    /// Value at full scale, above the datum.
    pub full_scale: f64,
    /// Voltage at full scale (V).
    pub volts: f64,
    /// Value at 0 V.
    pub datum: f64,
}

impl Volts {
    /// The voltage of `value` (V).
    pub fn of(&self, value: f64) -> f64 {
        self.volts * ((value - self.datum) / self.full_scale)
    }
}

/// One analog signal: a value a sample; it breaks where a value is not finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve<'a> {
    /// Name in the legend and in the readouts.
    pub name: &'a str,
    /// As many as the clock has samples.
    pub values: &'a [f64],
}

/// One digital signal and its name.
#[derive(Debug, Clone, PartialEq)]
pub struct LogicLane<'a> {
    /// Name, at its left and in the readouts.
    pub name: &'a str,
    /// What is on it.
    pub logic: Logic,
}

/// What is on a digital line, in order of time.
#[derive(Debug, Clone, PartialEq)]
pub enum Logic {
    /// From an instant on it is high or low.
    Levels(Vec<(f64, bool)>),
    /// From an instant on wires carry a word; without text there is none, and none was delivered.
    Words(Vec<(f64, Option<String>)>, Option<RegisterColour>),
    /// At an instant something happens.
    Pulses(Vec<(f64, String)>),
}

impl Logic {
    /// A gate that was seen at every sample: high above a half.
    pub fn sampled(values: &[f64]) -> Self {
        let levels = values.iter().map(|&value| value > 0.5).enumerate();
        let mut changes: Vec<(f64, bool)> = Vec::new();
        for (sample, high) in levels {
            if changes.last().is_none_or(|&(_, before)| before != high) {
                changes.push((sample as f64, high));
            }
        }
        Self::Levels(changes)
    }
}

/// Colour of a set of registers, and of the corner that it holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RegisterColour {
    /// Corner of even, even index.
    Yellow,
    /// Corner of odd north index and even east index.
    Green,
    /// Corner of even north index and odd east index.
    Black,
    /// Corner of odd, odd index.
    Red,
}

impl RegisterColour {
    /// All of them, in the order of the report.
    pub const ALL: [Self; 4] = [Self::Yellow, Self::Green, Self::Black, Self::Red];

    pub(crate) fn of(self, palette: &Palette) -> [u8; 3] {
        palette.registers[self as usize]
    }

    pub(crate) fn letter(self) -> &'static str {
        ["Y", "G", "B", "R"][self as usize]
    }

    pub(crate) fn word(self) -> &'static str {
        ["yellow", "green", "black", "red"][self as usize]
    }
}

/// A boundary of regions that the sweep passes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// Instant of the crossing (samples from the start of the sweep).
    pub at: f64,
    /// The registers that take a new corner there.
    pub loads: [RegisterColour; 2],
}

/// The column of the picture that a sweep leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PictureColumn<'a> {
    /// Grey of its lines from the top, 0 black to 1 white.
    pub grey: &'a [f64],
    /// Line of the picture at each sample, if that is known: the cursors point at it.
    pub line: Option<&'a [f64]>,
}

/// What samples follow one another along.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Line {
    /// A sweep: ground range, and time.
    #[default]
    Sweep,
    /// A row of a ground grid: places to the right of the line of sight, and points counted from the left. Its period is 1.
    Row,
    /// A scan line of a raster: places and samples are both counted from its start. Its period is 1.
    ScanLine,
}

impl Line {
    /// What a place on it is called, in full, and in few letters.
    pub(crate) fn place(self) -> [&'static str; 2] {
        match self {
            Self::Sweep => ["ground range", "range"],
            Self::Row => ["across the line of sight", "across"],
            Self::ScanLine => ["place on the scan line", "place"],
        }
    }

    /// Unit of places; those on a scan line are counted.
    pub(crate) fn place_unit(self) -> &'static str {
        match self {
            Self::Sweep | Self::Row => "m",
            Self::ScanLine => "",
        }
    }

    /// The word of a place with its unit.
    pub(crate) fn place_with_unit(self, word: &str) -> String {
        with_unit(word, self.place_unit())
    }

    /// Whether instants are times.
    pub fn has_time(self) -> bool {
        self == Self::Sweep
    }

    /// What an instant on it is called, in full, and in few letters.
    pub(crate) fn instant(self) -> [&'static str; 2] {
        match self {
            Self::Sweep => ["sweep time", "time"],
            Self::Row => ["point of the row", "point"],
            Self::ScanLine => ["sample of the scan line", "sample"],
        }
    }

    /// Unit of instants; points have none.
    pub(crate) fn unit(self) -> &'static str {
        match self {
            Self::Sweep => "µs",
            Self::Row | Self::ScanLine => "",
        }
    }

    /// The word of an instant with its unit.
    pub(crate) fn instant_with_unit(self, word: &str) -> String {
        with_unit(word, self.unit())
    }
}

fn with_unit(word: &str, unit: &str) -> String {
    if unit.is_empty() { word.into() } else { format!("{word} ({unit})") }
}

/// Along what the page runs; the other one stands at the top.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Along {
    /// Decades of ground range evenly, as a range programme of constant ratio spends its samples.
    #[default]
    LogRange,
    /// Ground range, with equal steps evenly spaced.
    Range,
    /// Sweep time, with equal steps evenly spaced.
    Time,
}

/// A place in the sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// At a ground range, or across the line of sight (m); on a scan line, at a place that is counted.
    Range(f64),
    /// At a time from the start of the sweep (µs); on a row, at a point; on a scan line, at a sample.
    Time(f64),
}

/// Colours of a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Theme {
    /// Dark ink on white paper.
    #[default]
    Light,
    /// Bright phosphor on dark glass.
    Dark,
}

impl Theme {
    pub(crate) fn palette(self) -> &'static Palette {
        match self {
            Self::Light => &LIGHT,
            Self::Dark => &DARK,
        }
    }
}

/// How a page is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct ScopeLook {
    /// Title at the top of the page.
    pub title: String,
    /// Lines below the title.
    pub facts: Vec<String>,
    /// Width of the page, 600 to 8000 pixels.
    pub width: u32,
    /// Height of each panel of curves, 120 to 8000 pixels.
    pub height: u32,
    /// Colours of the page.
    pub theme: Theme,
    /// Along what it runs.
    pub along: Along,
    /// Where it begins; at the first sample if not said.
    pub from: Option<Place>,
    /// Where it ends; at the last sample if not said.
    pub to: Option<Place>,
    /// Up to two cursors, A and B, with readouts below.
    pub cursors: Vec<Place>,
}

impl ScopeLook {
    /// A page of 1200 pixels over the whole sweep, without cursors.
    pub fn titled(title: impl Into<String>) -> Self {
        let (facts, cursors) = (Vec::new(), Vec::new());
        let (theme, along) = (Theme::Light, Along::LogRange);
        let title = title.into();
        Self { title, facts, width: 1200, height: 180, theme, along, from: None, to: None, cursors }
    }
}
