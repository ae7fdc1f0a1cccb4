//! Tests of NPZ files, read through numpy.

use signal::Axis;
use waveform::Format;

use crate::sample::{said, second, tool, waveforms, write};

/// Prints every array: name, type, shape, and the bits of its numbers.
const SCRIPT: &str = "
import sys, numpy
for name, array in numpy.load(sys.argv[1]).items():
    bits = array.view(numpy.uint64) if array.dtype == numpy.float64 else array
    print(name, array.dtype, 'x'.join(map(str, array.shape)), *bits.ravel())
";

fn bits(values: impl IntoIterator<Item = f64>) -> String {
    values.into_iter().map(|value| format!(" {}", value.to_bits())).collect()
}

#[test]
fn numpy_reads_npz() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("w.npz");
    let files = write(Format::Npz, &path, 3..6);
    assert_eq!(files, [path.clone(), folder.path().join("w.npz.json")]);
    let probe = tool("python3", &["-c", "import numpy"]);
    if !probe.is_some_and(|output| output.status.success()) {
        eprintln!("SKIPPED: python3 with numpy is not here; NPZ is not opened");
        return;
    }
    let text = said(tool("python3", &["-c", SCRIPT, path.to_str().unwrap()]).unwrap());
    let sweeps: Vec<_> = (3..6).map(waveforms).collect();
    let mut expected = Vec::new();
    for place in 0..sweeps[0].len() {
        let rows = || sweeps.iter().map(|sweep| &sweep[place]);
        let name = rows().next().unwrap().signal.name;
        let values = bits(rows().flat_map(|row| row.values.clone()));
        let count: usize = rows().map(|row| row.times.len()).sum();
        match rows().next().unwrap().signal.axis {
            Axis::Ground | Axis::Line => expected.push(format!("{name} float64 3x50{values}")),
            Axis::Display => expected.push(format!("{name} float64 3x20{values}")),
            Axis::Changes => {
                let times = bits(rows().flat_map(|row| row.times.clone()));
                let of: String =
                    rows().flat_map(|row| row.times.iter().map(|_| format!(" {}", row.sweep))).collect();
                expected.push(format!("{name}.times float64 {count}{times}"));
                expected.push(format!("{name}.values float64 {count}{values}"));
                expected.push(format!("{name}.sweep uint32 {count}{of}"));
            }
        }
        if name == "sweep.range" {
            expected.push(format!("range_m float64 50{}", bits(sweeps[0][place].values.clone())));
        }
    }
    expected.push("sweeps uint32 3 3 4 5".into());
    let found: Vec<&str> = text.lines().collect();
    assert_eq!(found[..expected.len()], expected);
    let close = |line: &str, name: &str, expected: Vec<f64>| {
        let mut words = line.split(' ');
        assert_eq!(words.next(), Some(name));
        let values = words.skip(2).map(|bits| f64::from_bits(bits.parse().unwrap()));
        assert!(values.zip(&expected).all(|(found, right)| (found - right).abs() <= 1e-15), "{line}");
    };
    close(found[expected.len()], "time_s", (0..50).map(|sample| second(0, sample)).collect());
    close(found[expected.len() + 1], "sweep_start_s", (3..6).map(|sweep| second(sweep, 0)).collect());
}
