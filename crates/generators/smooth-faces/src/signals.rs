//! Waveforms of a scan line: brightness, level, priority, crossings, ramp.

use faces::Scan as Direction;
use generator::{Along, Scan};
use quantities::Timebase;
use scenario::View;
use signal::{Probe, Signal, Unit, Waveform, Wire};

use crate::parameters::Parameters;
use crate::scan_line::{Sample, ScanLine, entries};
use crate::scene::Scene;

const SOURCE: &str = "none: ours, of Link's study";

/// Place of a sample on its scan line.
const LINE: &str = "faces.line";

/// Signal that counts crossings along the line.
const EDGES: &str = "faces.edges";

/// What can be looked at; a scan line stands for a sweep, its pixels for samples.
pub static SIGNALS: [Signal; 7] = [
    Signal::ground(LINE, Unit::Line, "place of the sample on its scan line", SOURCE),
    Signal::ground("faces.intensity", Unit::Reflectivity, "luminance of the sample", SOURCE),
    Signal::ground("faces.level", Unit::Reflectivity, "brightness of the level laid upon it", SOURCE),
    Signal::ground("faces.present", Unit::Gate, "high where a face is seen", SOURCE),
    Signal::ground(
        "faces.priority",
        Unit::Number,
        "place of the winning list in the order; -1 in the sky",
        SOURCE,
    ),
    Signal::ground(EDGES, Unit::Number, "crossings with a slot that the line has entered so far", SOURCE),
    Signal::ground("faces.ramp", Unit::Number, "change of the winning face's brightness a pixel", SOURCE),
];

/// How the signals run: scan line by scan line.
pub fn scan(view: &View, direction: Direction) -> Option<Scan> {
    let (lines, samples) = match direction {
        Direction::Vertical => (view.columns, view.lines),
        Direction::Horizontal => (view.lines, view.columns),
    };
    let timebase = Timebase::new(view.update, view.update, lines, samples, 0).ok()?;
    Some(Scan { line: "scan line", timebase, place: LINE, along: Along::Raster })
}

/// The wires of a view. Numbers of a program have no voltage.
pub fn wires(view: &View) -> Vec<Wire> {
    let wire = |signal: &Signal| {
        let full_scale = match signal.unit {
            Unit::Line => f64::from(view.lines.max(view.columns)),
            Unit::Number if signal.name != "faces.ramp" => 1000.0,
            _ => 1.0,
        };
        Wire { signal: *signal, full_scale, volts: 0.0, datum: 0.0 }
    };
    SIGNALS.iter().map(wire).collect()
}

/// Records the scan line `number` of a frame, if `probe` wants it.
pub fn record(
    (frame, number): (u64, usize),
    scene: &Scene,
    run: &Parameters,
    line: &ScanLine,
    probe: &mut Probe,
) {
    let sweep = number as u32;
    if !probe.wants_sweep(sweep) {
        return;
    }
    for signal in SIGNALS {
        if probe.wants(&signal) {
            let values = match signal.name {
                EDGES => entered(scene, run, number, line.samples.len()),
                name => values(name, line),
            };
            probe.waveforms.push(Waveform { signal, frame, sweep, times: Vec::new(), values });
        }
    }
}

fn values(name: &str, line: &ScanLine) -> Vec<f64> {
    let of = |value: &dyn Fn(usize, &Sample) -> f64| {
        line.samples.iter().enumerate().map(|(at, sample)| value(at, sample)).collect()
    };
    match name {
        LINE => of(&|at, _| at as f64),
        "faces.intensity" => of(&|_, sample| quantities::luminance(sample.colour)),
        "faces.level" => of(&|_, sample| sample.level),
        "faces.present" => of(&|_, sample| f64::from(u8::from(sample.winner.is_some()))),
        "faces.priority" => of(&|_, sample| sample.winner.map_or(-1.0, |[_, list]| f64::from(list))),
        _ => of(&|_, sample| sample.slope),
    }
}

/// How many crossings with a slot a line of so many samples has entered up to each of them.
fn entered(scene: &Scene, run: &Parameters, line: usize, samples: usize) -> Vec<f64> {
    let mut begun = vec![0.0; samples];
    entries(scene, run, line, samples).into_iter().for_each(|first| begun[first] += 1.0);
    let so_far = |count: &mut f64, begun: f64| {
        *count += begun;
        Some(*count)
    };
    begun.into_iter().scan(0.0, so_far).collect()
}
