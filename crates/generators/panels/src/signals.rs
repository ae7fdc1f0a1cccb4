//! Waveforms along a row of the picture: panel, depth, grey, source, writes, voids.

use generator::Scan;
use scenario::View;
use scene_sampler::{pixel_scan, record_pixel_rows};
use signal::{Probe, Signal, Unit, Wire};

const SOURCE: &str = "none: ours, of the thesis's program";

/// Place of a pixel in its row.
const COLUMN: &str = "panels.column";

/// How often a pixel was written: only the program of the thesis counts that.
const WRITES: &str = "panels.writes";

/// Whether a panel touches a void: only the program of the thesis has posts that may be void.
const VOID: &str = "panels.void";

/// What can be looked at; a row stands for a sweep, its pixels for samples.
pub static SIGNALS: [Signal; 8] = [
    Signal::ground(COLUMN, Unit::Number, "column of the pixel, from 0", SOURCE),
    Signal::ground(
        "panels.panel",
        Unit::Number,
        "number of the panel that the pixel shows; -1 where none",
        SOURCE,
    ),
    Signal::ground("panels.depth", Unit::Metre, "distance from the eye to the panel; 0 where none", SOURCE),
    Signal::ground(
        "panels.grey",
        Unit::Reflectivity,
        "light that photographs give the pixel's ground",
        SOURCE,
    ),
    Signal::ground(
        "panels.source_i",
        Unit::Number,
        "column I in the photograph of what gave the grey; -1 where none",
        SOURCE,
    ),
    Signal::ground("panels.source_j", Unit::Number, "line J in the photograph of the same", SOURCE),
    Signal::ground(WRITES, Unit::Number, "how often the pixel was written", SOURCE),
    Signal::ground(VOID, Unit::Gate, "high where a post of the panel was void", SOURCE),
];

/// What a pixel of a row shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Number of the panel; none where no panel is seen.
    pub panel: Option<u32>,
    /// Distance (m) from the eye.
    pub depth: f64,
    /// Light that photographs give.
    pub grey: f64,
    /// Pixel I, J of a photograph; none where none shows the ground.
    pub source: Option<[f64; 2]>,
    /// How often it was written.
    pub writes: f64,
    /// Whether a post of the panel was void.
    pub touches_void: bool,
}

impl Sample {
    /// A pixel that shows no panel.
    pub const NONE: Self =
        Self { panel: None, depth: 0.0, grey: 0.0, source: None, writes: 0.0, touches_void: false };

    fn value(&self, name: &str) -> f64 {
        let source = |axis: usize| self.source.map_or(-1.0, |pixel| pixel[axis]);
        match name {
            "panels.panel" => self.panel.map_or(-1.0, f64::from),
            "panels.depth" => self.depth,
            "panels.grey" => self.grey,
            "panels.source_i" => source(0),
            "panels.source_j" => source(1),
            WRITES => self.writes,
            _ => f64::from(u8::from(self.touches_void)),
        }
    }
}

/// How the signals run: row by row from the top.
pub fn scan(view: &View) -> Option<Scan> {
    pixel_scan(view, COLUMN)
}

/// The wires of a view. `is_program` says that the program of the thesis draws. Numbers of a program have no voltage.
pub fn wires(view: &View, is_program: bool) -> Vec<Wire> {
    let wire = |signal: &Signal| {
        let full_scale = match signal.unit {
            Unit::Metre => view.ranges[1],
            Unit::Number if signal.name == COLUMN => f64::from(view.columns),
            Unit::Number => 1000.0,
            _ => 1.0,
        };
        Wire { signal: *signal, full_scale, volts: 0.0, datum: 0.0 }
    };
    recorded(is_program).map(wire).collect()
}

fn recorded(is_program: bool) -> impl Iterator<Item = &'static Signal> {
    SIGNALS.iter().filter(move |signal| is_program || ![WRITES, VOID].contains(&signal.name))
}

/// Records the rows that `probe` wants. `sample` tells what pixel `[column, line]` shows.
pub fn record(of: (u64, &View), is_program: bool, probe: &mut Probe, sample: impl Fn([usize; 2]) -> Sample) {
    let signals: Vec<_> = recorded(is_program).collect();
    record_pixel_rows(of, signals.into_iter(), COLUMN, probe, sample, |sample, name| sample.value(name));
}
