//! What is said before is what comes, within a quarter.

use waveform::{Format, SweepTraces, estimate};

use crate::sample::{FRAME, header, waveforms, write};

#[test]
fn estimates_hold_within_a_quarter() {
    for format in Format::ALL {
        for (sweeps, specimen) in [(3..4, vec![3]), (0..40, (0..16).collect()), (0..40, (12..20).collect())] {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join(format.name());
            let waveforms: Vec<_> = specimen.iter().map(|sweep| waveforms(*sweep)).collect();
            let traces: Vec<_> = (specimen.iter().zip(&waveforms))
                .map(|(&sweep, waveforms)| SweepTraces { frame: FRAME, sweep, waveforms })
                .collect();
            let said = estimate(format, &header(sweeps.clone()), &traces).unwrap() as f64;
            write(format, &path, sweeps.clone());
            let real = std::fs::metadata(&path).unwrap().len() as f64;
            assert!(
                (0.75..1.25).contains(&(said / real)),
                "{format:?} {sweeps:?}: {said} said, {real} written"
            );
        }
    }
}

/// Bytes depend on what is written alone.
#[test]
fn the_same_bytes_every_time() {
    for format in Format::ALL {
        let folder = tempfile::tempdir().unwrap();
        let bytes = |name: &str| {
            let path = folder.path().join(name);
            write(format, &path, 3..6);
            std::fs::read(path).unwrap()
        };
        assert!(bytes("a") == bytes("b"), "{format:?}");
    }
}
