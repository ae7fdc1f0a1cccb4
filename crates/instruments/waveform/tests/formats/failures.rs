//! What cannot be written leaves nothing.

use std::path::Path;

use signal::Waveform;
use waveform::{Format, SweepTraces, WaveformError, open};

use crate::sample::{FRAME, header, waveforms, write};

fn files(folder: &Path) -> Vec<String> {
    let name = |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
    let mut names: Vec<String> = std::fs::read_dir(folder).unwrap().map(name).collect();
    names.sort();
    names
}

fn give(format: Format, path: &Path, sweep: u32, waveforms: &[Waveform]) -> Result<(), WaveformError> {
    let mut sink = open(format, path, header(3..5))?;
    sink.sweep(&SweepTraces { frame: FRAME, sweep, waveforms })
}

#[test]
fn a_sink_that_is_dropped_leaves_nothing() {
    for format in Format::ALL {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("w");
        give(format, &path, 3, &waveforms(3)).unwrap();
        assert!(files(folder.path()).is_empty(), "{format:?}");
        let mut sink = open(format, &path, header(3..5)).unwrap();
        sink.sweep(&SweepTraces { frame: FRAME, sweep: 3, waveforms: &waveforms(3) }).unwrap();
        assert!(!path.exists() && !files(folder.path()).is_empty(), "{format:?}");
        let unfinished = sink.finish();
        assert!(
            matches!(unfinished, Err(WaveformError::Unfinished { found: 1, expected: 2, .. })),
            "{format:?}"
        );
        assert!(files(folder.path()).is_empty(), "{format:?}");
    }
}

#[test]
fn an_old_file_stays_until_a_new_one_is_whole() {
    for format in Format::ALL {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("w");
        std::fs::write(&path, "old").unwrap();
        give(format, &path, 3, &waveforms(3)).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"old");
        write(format, &path, 3..4);
        assert_ne!(std::fs::read(&path).unwrap(), b"old");
    }
}

/// A link stays, and what it leads to as well.
#[cfg(unix)]
#[test]
fn a_link_is_not_followed() {
    let folder = tempfile::tempdir().unwrap();
    let [link, real] = ["link.csv", "real.csv"].map(|name| folder.path().join(name));
    std::fs::write(&real, "old").unwrap();
    std::os::unix::fs::symlink(&real, &link).unwrap();
    let said = open(Format::Csv, &link, header(3..5)).err().unwrap().to_string();
    assert!(said.contains("link.csv: cannot write: this is a link"), "{said}");
    assert!(link.is_symlink() && std::fs::read(&real).unwrap() == b"old");
}

#[test]
fn folders_that_are_not_there_and_folders_in_the_way() {
    let folder = tempfile::tempdir().unwrap();
    for format in Format::ALL {
        let said = open(format, &folder.path().join("gone/w"), header(3..5)).err().unwrap().to_string();
        assert!(said.contains("gone/w") && said.contains("make it first"), "{said}");
        let said = open(format, folder.path(), header(3..5)).err().unwrap().to_string();
        assert!(said.contains("this is a folder"), "{said}");
    }
    assert!(files(folder.path()).is_empty());
}

/// The record cannot be written: neither is the file.
#[test]
fn a_companion_in_the_way_stops_the_file() {
    for (format, name) in
        [(Format::Fst, "w.fst.json"), (Format::Fst, "w.fst.gtkw"), (Format::Npz, "w.npz.json")]
    {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join(name)).unwrap();
        let path = folder.path().join(format!("w.{}", format.name()));
        let mut sink = open(format, &path, header(3..4)).unwrap();
        sink.sweep(&SweepTraces { frame: FRAME, sweep: 3, waveforms: &waveforms(3) }).unwrap();
        let said = sink.finish().unwrap_err().to_string();
        assert!(said.contains(name) && said.contains("this is a folder"), "{said}");
        assert_eq!(files(folder.path()), [name]);
    }
}

/// `/dev/full` is a disk without room.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    for format in Format::ALL {
        let said = (|| -> Result<(), WaveformError> {
            let mut sink = open(format, Path::new("/dev/full"), header(3..4))?;
            sink.sweep(&SweepTraces { frame: FRAME, sweep: 3, waveforms: &waveforms(3) })?;
            sink.finish().map(drop)
        })();
        let said = said.unwrap_err().to_string();
        assert!(said.contains("/dev/full") && said.contains("no space left"), "{format:?}: {said}");
    }
}

#[test]
fn what_does_not_follow_from_the_header_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("w.csv");
    let said =
        |sweep, waveforms: &[Waveform]| give(Format::Csv, &path, sweep, waveforms).unwrap_err().to_string();
    assert!(
        said(4, &waveforms(4)).contains("expected frame 7, sweep 3 of 3..5"),
        "{}",
        said(4, &waveforms(4))
    );
    assert!(said(3, &waveforms(3)[1..]).contains("expected sweep.range, sweep.fold.x"));
    let mut short = waveforms(3);
    short[4].values.pop();
    assert!(said(3, &short).contains("49 values at 0 instants of tg.height, expected 50 values"));
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut values = waveforms(3);
        values[4].values[17] = wrong;
        let said = said(3, &values);
        assert!(said.contains("tg.height of sweep 3") && said.contains("at value 17"), "{said}");
    }
}

#[test]
fn names_of_formats() {
    assert_eq!(Format::of_path(Path::new("a/b.fst")), Some(Format::Fst));
    assert_eq!(Format::of_path(Path::new("a/b.png")), None);
    let said = "txt".parse::<Format>().unwrap_err().to_string();
    assert_eq!(said, "`txt` is no format of waveforms: expected csv, vcd, fst, npz, json, raw, sr");
}
