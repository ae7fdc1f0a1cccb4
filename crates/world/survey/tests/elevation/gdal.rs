//! Files that GDAL writes, against what GDAL reads: heights, voids, place and units are equal, or the file is refused.
//!
//! Needs a Python with rasterio: `python3 -m venv V && V/bin/pip install rasterio`, then
//! `LUNOID_GDAL_PYTHON=V/bin/python cargo test -p survey --test elevation gdal`. It is skipped loudly without.

use std::path::Path;
use std::process::Command;

use serde_json::Value;
use survey::{Frame, ReadOptions, read};

/// Files that must be refused, with a word of the refusal.
const REFUSED: [(&str, &str); 5] = [
    ("bits-7", "BitsPerSample"),
    ("bits-12", "BitsPerSample"),
    ("turned", "a rotated grid"),
    ("strange", "--ignore item:BIAS"),
    ("crs-paris", "GeodeticCRSGeoKey"),
];

/// Fewest files that GDAL must have written.
const FEWEST: usize = 70;

#[test]
fn files_of_gdal_are_read_as_gdal_reads_them() {
    let Some(python) = std::env::var_os("LUNOID_GDAL_PYTHON") else {
        println!("SKIPPED: LUNOID_GDAL_PYTHON does not name a Python with rasterio");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/elevation/gdal.py");
    assert!(Command::new(python).arg(script).arg(folder.path()).status().unwrap().success());
    let (mut faults, mut count) = (Vec::new(), 0);
    for entry in folder.path().read_dir().unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "tif") {
            count += 1;
            faults.extend(fault(&path));
        }
    }
    faults.sort();
    assert!(faults.is_empty(), "{} of {count}:\n{}", faults.len(), faults.join("\n"));
    println!("{count} files of GDAL are as GDAL reads them, {} of them refused", REFUSED.len());
    assert!(count >= FEWEST, "only {count} files");
}

/// What is wrong with what is read of a file.
fn fault(path: &Path) -> Option<String> {
    let name = path.file_stem().unwrap().to_string_lossy().into_owned();
    let expected = REFUSED.iter().find(|(refused, _)| *refused == name).map(|(_, word)| *word);
    match (read(path, &ReadOptions::default()), expected) {
        (Err(said), Some(word)) if said.to_string().contains(word) => None,
        (Err(said), _) => Some(format!("{name}: refused: {said}")),
        (Ok(_), Some(word)) => Some(format!("{name}: read, and not refused with {word}")),
        (Ok(read), None) => {
            compared(path, &read).map(|fault| format!("{name}: {fault}, notes {:?}", read.notes))
        }
    }
}

fn compared(path: &Path, read: &survey::Elevation) -> Option<String> {
    let array = files::read_npy(path.with_extension("npy"), limits::Limit::ElevationBytes).unwrap();
    for (index, height) in array.data().to_f64().into_iter().enumerate() {
        let (line, column) = (index / read.columns, index % read.columns);
        let found = read.height(line, column);
        let is_equal = found.map_or(height.is_nan(), |found| (found - height).abs() <= 1e-9 * height.abs());
        if !is_equal {
            return Some(format!("line {line}, column {column}: {found:?}, GDAL has {height}"));
        }
    }
    let place: Value = serde_json::from_slice(&std::fs::read(path.with_extension("json")).unwrap()).unwrap();
    let number = |key: usize| place["transform"][key].as_f64().unwrap() * place["unit"].as_f64().unwrap();
    let step = [number(4), number(0)];
    let east = quantities::radians(place["east"].as_f64().unwrap());
    let first = [number(5) + 0.5 * step[0], number(2) + 0.5 * step[1] + east];
    let is_geographic = matches!(read.frame, Frame::Geographic { .. });
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
    let is_there = (0..2).all(|k| near(read.affine.first[k], first[k]) && near(read.affine.step[k], step[k]));
    let is_right = is_there && place["geographic"].as_bool() == Some(is_geographic);
    let on_moon = place["first"].as_array().zip(match read.frame {
        Frame::Plane(projection) => projection.and_then(|projection| projection.inverse(read.affine.first)),
        Frame::Geographic { .. } => None,
    });
    if let Some((gdal, found)) = on_moon {
        let apart = |k: usize| (gdal[k].as_f64().unwrap() - quantities::degrees(found[k])).abs();
        if apart(0).max(apart(1)) > 1e-8 {
            return Some(format!("first sample at {found:?} rad, GDAL has {gdal:?} deg"));
        }
    }
    (!is_right).then(|| format!("{:?} {:?}, GDAL has {first:?} {step:?}", read.affine, read.frame))
}
