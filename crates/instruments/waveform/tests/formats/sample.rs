//! A machine of eight wires, one of every form, and what they do in a few sweeps.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use quantities::{Rate, Timebase};
use signal::{Axis, Kind, Signal, Unit, Waveform, Wire};
use waveform::{Format, Header, SweepTraces, open};

const SIGNALS: [Signal; 8] = [
    Signal::ground("sweep.range", Unit::Metre, "ground range", "section 6.2"),
    Signal::digital("sweep.fold.x", Unit::Number, Kind::Event, "ramp X folds", "fig. 17"),
    Signal::digital("sweep.polarity.x", Unit::Gate, Kind::Gate, "flip-flop", "section 6.4"),
    Signal::digital("tg.red.hold", Unit::Corner, Kind::Bus, "corner", "fig. 22"),
    Signal::ground("tg.height", Unit::Metre, "height", "fig. 21"),
    Signal::ground("dpp.blank", Unit::Gate, "hidden", "fig. 30"),
    Signal::display("pg.present", Unit::Gate, "share of a line", "fig. 29"),
    Signal::display("sm.write", Unit::Reflectivity, "what is written", "fig. 14"),
];

pub const SAMPLES: usize = 50;
pub const RETRACE: usize = 11;
pub const LINES: usize = 20;
pub const FRAME: u64 = 7;

/// A sample rate that is no whole number of hertz.
pub fn timebase() -> Timebase {
    let update = Rate::new(30_000, 1001).unwrap();
    Timebase::new(update, update, 40, SAMPLES as u32, RETRACE as u32).unwrap()
}

/// Samples a second: 30000/1001 * 40 * 61.
pub const RATE: [u128; 2] = [30_000 * 40 * 61, 1001];

pub fn header(sweeps: std::ops::Range<u32>) -> Header {
    let wire = |signal: Signal| {
        let [full_scale, datum] = if signal.name == "tg.height" { [500.0, 120.0] } else { [1.0, 0.0] };
        let volts = match signal.kind {
            Kind::Analog => 10.0,
            Kind::Gate => 5.0,
            Kind::Bus | Kind::Event => 0.0,
        };
        Wire { signal, full_scale, volts, datum }
    };
    Header {
        title: "eight wires, to the $end of été".into(),
        provenance: vec![("machine".into(), "none".into())],
        wires: SIGNALS.map(wire).to_vec(),
        timebase: timebase(),
        lines: LINES as u32,
        frame: FRAME,
        sweeps,
    }
}

/// A number in 0..1 that looks like chance.
fn chance(a: usize, b: usize) -> f64 {
    let mixed = (a as u64 * 2_654_435_761 + b as u64 * 40_503 + 12_345).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (mixed >> 11) as f64 / (1u64 << 53) as f64
}

/// The waveforms of a sweep: reals with all their digits, held stretches, instants between samples, a fold before the
/// first sample, and one after the last.
pub fn waveforms(sweep: u32) -> Vec<Waveform> {
    let s = sweep as usize;
    let of = |signal: Signal| {
        let (times, values): (Vec<f64>, Vec<f64>) = match signal.name {
            "sweep.range" => (vec![], (0..SAMPLES).map(|k| 2.0 + k as f64 / 3.0).collect()),
            "sweep.fold.x" => {
                let folds = vec![-0.625, 3.25, 17.0, 17.0 + chance(s, 1), SAMPLES as f64 - 0.5];
                (folds, vec![1.0, 0.0, 1.0, (s % 2) as f64, 0.0])
            }
            "sweep.polarity.x" => (vec![0.0, 3.25, 17.0], vec![1.0, 0.0, 1.0]),
            "tg.red.hold" => {
                (vec![0.0, 9.125, 30.5 + chance(s, 2)], vec![-1.0, 77.0 + s as f64, 1_234_567.0])
            }
            "tg.height" => (vec![], (0..SAMPLES).map(|k| 400.0 * chance(s, k.min(40)) - 50.0).collect()),
            "dpp.blank" => (vec![], (0..SAMPLES).map(|k| f64::from(u8::from(k / 7 % 2 == s % 2))).collect()),
            "pg.present" => (vec![], (0..LINES).map(|k| if k < 5 { 0.0 } else { 0.25 }).collect()),
            _ => (vec![], (0..LINES).map(|k| f64::from(chance(s, k) as f32)).collect()),
        };
        Waveform { signal, frame: FRAME, sweep, times, values }
    };
    SIGNALS.map(of).to_vec()
}

/// What stands on a wire at a sample: the law of the formats that have a value a sample, written once more.
pub fn held(waveform: &Waveform, sample: usize) -> f64 {
    match waveform.signal.axis {
        Axis::Ground | Axis::Line => waveform.values[sample],
        Axis::Display => waveform.values[sample * LINES / SAMPLES],
        Axis::Changes => {
            let before = waveform.times.iter().rposition(|time| *time <= sample as f64);
            before.map_or(0.0, |place| waveform.values[place])
        }
    }
}

/// What an event tells at the sample that first sees it.
pub fn pulse(waveform: &Waveform, sample: usize) -> Option<f64> {
    let sees = |time: f64| {
        let first = sample == 0 && time <= 0.0;
        let last = sample == SAMPLES - 1 && time > sample as f64;
        first || last || (time <= sample as f64 && time > sample as f64 - 1.0)
    };
    waveform.times.iter().rposition(|time| sees(*time)).map(|place| waveform.values[place])
}

/// The picosecond of an instant, by whole numbers and a rest.
pub fn picosecond(sweep: u32, instant: f64) -> u64 {
    let period = RATE[1] as f64 * 1e12 / RATE[0] as f64;
    let step = u128::from(sweep) * (SAMPLES + RETRACE) as u128;
    let (over, under) = (step * 1_000_000_000_000 * RATE[1], RATE[0]);
    let rest = (over % under) as f64 / under as f64 + instant * period;
    ((over / under) as f64 + rest).round().max(0.0) as u64
}

/// Seconds from the start of the frame.
pub fn second(sweep: u32, sample: usize) -> f64 {
    let step = sweep as usize * (SAMPLES + RETRACE) + sample;
    step as f64 * RATE[1] as f64 / RATE[0] as f64
}

/// Writes sweeps 3..6 in a format, into a folder of its own.
pub fn written(format: Format) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(format!("w.{}", format.name()));
    write(format, &path, 3..6);
    (folder, path)
}

pub fn write(format: Format, path: &Path, sweeps: std::ops::Range<u32>) -> Vec<PathBuf> {
    let mut sink = open(format, path, header(sweeps.clone())).unwrap();
    for sweep in sweeps {
        let waveforms = waveforms(sweep);
        sink.sweep(&SweepTraces { frame: FRAME, sweep, waveforms: &waveforms }).unwrap();
    }
    sink.finish().unwrap()
}

/// Runs a tool that may be missing: then says so, and the test has nothing to say.
pub fn tool(name: &str, arguments: &[&str]) -> Option<Output> {
    match Command::new(name).args(arguments).output() {
        Ok(output) => Some(output),
        Err(error) => {
            eprintln!(
                "SKIPPED: {name} cannot be run here ({error}); what it would have opened is not tested"
            );
            None
        }
    }
}

/// What a tool that must succeed said.
pub fn said(output: Output) -> String {
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{err}");
    String::from_utf8(output.stdout).unwrap()
}
