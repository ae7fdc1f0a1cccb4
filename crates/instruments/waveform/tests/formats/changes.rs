//! VCD and FST through wellen, and through GTKWave's own converters.

use std::collections::BTreeMap;
use std::path::Path;

use signal::{Axis, Kind};
use waveform::Format;
use wellen::{SignalValueRef, simple};

use crate::sample::{
    LINES, RATE, RETRACE, SAMPLES, header, picosecond, said, tool, waveforms, write, written,
};

/// Changes of each variable, by its full name: picoseconds and values.
type Changes = BTreeMap<String, Vec<(u64, f64)>>;

fn read(path: &Path) -> Changes {
    let mut file = simple::read(path).unwrap();
    assert_eq!(file.hierarchy().timescale().unwrap().unit.to_exponent(), Some(-12));
    let variables: Vec<_> = (file.hierarchy().all_vars())
        .map(|var| {
            let var = &file.hierarchy()[var];
            (var.full_name(file.hierarchy()), var.signal_ref())
        })
        .collect();
    let mut changes = Changes::new();
    for (name, id) in variables {
        file.load_signals(&[id]);
        let signal = file.get_signal(id).unwrap();
        let of =
            |(index, value): (u32, SignalValueRef<'_>)| (file.time_table()[index as usize], number(value));
        changes.insert(name, signal.iter_changes().map(of).collect());
    }
    changes
}

fn number(value: SignalValueRef<'_>) -> f64 {
    match value {
        SignalValueRef::Real(value) => value,
        SignalValueRef::Event => 1.0,
        SignalValueRef::BitVec(bits) => {
            let bits = bits.bit_string();
            let word = u32::from_str_radix(&bits, 2).unwrap_or_else(|_| panic!("not of two states: {bits}"));
            if bits.len() == 32 { f64::from(word as i32) } else { f64::from(word) }
        }
        SignalValueRef::String(text) => panic!("{text}"),
    }
}

fn at(changes: &[(u64, f64)], time: u64) -> f64 {
    changes[changes.partition_point(|(then, _)| *then <= time) - 1].1
}

/// Returns whether two numbers are equal to the bit.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}

/// As far as sixteen digits go.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-15 * b.abs()
}

/// Every value at its picosecond, and nothing else.
fn compare(changes: &Changes, sweeps: std::ops::Range<u32>, is_equal: fn(f64, f64) -> bool) {
    for (place, wire) in header(sweeps.clone()).wires.iter().enumerate() {
        let name = match wire.signal.axis {
            Axis::Display => format!("display.{}", wire.signal.name),
            _ => wire.signal.name.to_owned(),
        };
        let mut expected: Vec<(u64, f64)> = Vec::new();
        for sweep in sweeps.clone() {
            let waveform = &waveforms(sweep)[place];
            let instant = |k: usize| match wire.signal.axis {
                Axis::Ground | Axis::Line => k as f64,
                Axis::Display => k as f64 * SAMPLES as f64 / LINES as f64,
                Axis::Changes => waveform.times[k],
            };
            let value = |k: usize| (picosecond(sweep, instant(k)), waveform.values[k]);
            expected.extend((0..waveform.values.len()).map(value));
        }
        if wire.signal.kind == Kind::Event {
            let times: Vec<u64> = expected.iter().map(|(time, _)| *time).collect();
            let pulses = &changes[&name];
            let pulses: Vec<u64> =
                pulses.iter().filter(|(_, value)| *value == 1.0).map(|(time, _)| *time).collect();
            assert_eq!(pulses, times, "{name}");
            let told = &changes[&format!("{name}_told")];
            expected.iter().for_each(|(time, value)| assert_eq!(at(told, *time), *value, "{name}"));
            continue;
        }
        let found = &changes[&name];
        assert!(found[0].0 == 0 && is_equal(found[0].1, expected[0].1), "{name}");
        for (time, value) in &expected {
            let found = at(found, *time);
            assert!(is_equal(found, *value), "{name} at {time} ps: {found} {value}");
        }
        let times: std::collections::BTreeSet<u64> = expected.iter().map(|(time, _)| *time).collect();
        assert!(found[1..].iter().all(|(time, _)| times.contains(time)), "{name}");
    }
}

#[test]
fn wellen_reads_vcd() {
    let (_folder, path) = written(Format::Vcd);
    compare(&read(&path), 3..6, same);
}

#[test]
fn wellen_reads_fst() {
    let (_folder, path) = written(Format::Fst);
    let changes = read(&path);
    compare(&changes, 3..6, same);
    let scale = |what: &str| changes[&format!("scale.tg.height.{what}")][0];
    assert_eq!([scale("full_scale"), scale("volts"), scale("datum")], [(0, 500.0), (0, 10.0), (0, 120.0)]);
}

/// The start of the frame is a sweep like others, but for what lies before it.
#[test]
fn the_first_sweep_of_a_frame() {
    let folder = tempfile::tempdir().unwrap();
    for format in [Format::Vcd, Format::Fst] {
        let path = folder.path().join(format.name());
        write(format, &path, 0..2);
        compare(&read(&path), 0..2, same);
    }
}

/// Files end where the last sweep does.
#[test]
fn the_retrace_of_the_last_sweep_is_there() {
    let (_folder, path) = written(Format::Vcd);
    let text = std::fs::read_to_string(&path).unwrap();
    let end = picosecond(5, (SAMPLES + RETRACE) as f64);
    assert!(text.ends_with(&format!("#{end}\n")), "{}", &text[text.len() - 40..]);
    assert!(text.contains("tg.height [m], full scale 500 = 10 V, 120 = 0 V"), "{}", &text[..2000]);
    assert!(!RATE[0].is_multiple_of(7) && end > 0);
}

#[test]
fn gtkwave_converts_fst_to_what_vcd_says() {
    let (_folder, path) = written(Format::Fst);
    let out = path.with_extension("of-fst.vcd");
    let Some(output) = tool("fst2vcd", &["-f", path.to_str().unwrap(), "-o", out.to_str().unwrap()]) else {
        return;
    };
    said(output);
    compare(&read(&out), 3..6, close);
}

#[test]
fn gtkwave_converts_vcd_to_fst() {
    let (_folder, path) = written(Format::Vcd);
    let out = path.with_extension("fst");
    let Some(output) = tool("vcd2fst", &[path.to_str().unwrap(), out.to_str().unwrap()]) else { return };
    said(output);
    compare(&read(&out), 3..6, same);
}

#[test]
fn no_two_scopes_share_a_name() {
    let (_folder, path) = written(Format::Vcd);
    let text = std::fs::read_to_string(&path).unwrap();
    let scopes = text.lines().filter(|line| line.starts_with("$scope module sweep")).count();
    assert_eq!(scopes, 1, "{text}");
}
