//! However many sweeps there are, the memory is the same.
#![cfg(target_os = "linux")]

use quantities::{Rate, Timebase};
use signal::{Signal, Unit, Waveform, Wire};
use waveform::{Format, Header, SweepTraces, open};

const SIGNALS: [Signal; 4] = [
    Signal::ground("sweep.range", Unit::Metre, "", ""),
    Signal::ground("tg.height", Unit::Metre, "", ""),
    Signal::ground("mu.height", Unit::Metre, "", ""),
    Signal::ground("dpp.elevation", Unit::Tangent, "", ""),
];
const SAMPLES: usize = 400;
const SWEEPS: u32 = 2000;

fn write(format: Format, sweeps: u32) {
    let folder = tempfile::tempdir().unwrap();
    let update = Rate::new(30, 1).unwrap();
    let header = Header {
        title: "long".into(),
        provenance: vec![],
        wires: SIGNALS.map(|signal| Wire { signal, full_scale: 1.0, volts: 10.0, datum: 0.0 }).to_vec(),
        timebase: Timebase::new(update, update, SWEEPS, SAMPLES as u32, 10).unwrap(),
        lines: 1,
        frame: 0,
        sweeps: 0..sweeps,
    };
    let mut sink = open(format, &folder.path().join("w"), header).unwrap();
    let waveform =
        |signal| Waveform { signal, frame: 0, sweep: 0, times: vec![], values: vec![0.0; SAMPLES] };
    let mut waveforms = SIGNALS.map(waveform);
    for sweep in 0..sweeps {
        for (place, waveform) in waveforms.iter_mut().enumerate() {
            waveform.sweep = sweep;
            let value = |k: usize| 1.0 / (1 + k * (place + 1) + sweep as usize * SAMPLES) as f64;
            (0..SAMPLES).for_each(|k| waveform.values[k] = value(k));
        }
        sink.sweep(&SweepTraces { frame: 0, sweep, waveforms: &waveforms }).unwrap();
    }
    sink.finish().unwrap();
}

/// The most memory that this process has had, in kilobytes.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmHWM:")).unwrap();
    line.split_whitespace().nth(1).unwrap().parse().unwrap()
}

/// 26 MB of values a format: a tenth of them is as much at once as all.
#[test]
fn a_frame_is_never_held() {
    for format in Format::ALL {
        write(format, SWEEPS / 10);
    }
    let before = peak();
    for format in Format::ALL {
        write(format, SWEEPS);
        let more = peak() - before;
        assert!(more < 20_000, "{format:?}: {more} kB more than for a tenth of the sweeps");
    }
}
