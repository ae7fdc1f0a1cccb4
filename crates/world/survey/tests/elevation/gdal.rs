//! Files that GDAL writes, against what GDAL reads: heights, voids, place and units are equal, or the file is refused.
//!
//! Needs a Python with rasterio: `python3 -m venv V && V/bin/pip install rasterio`, then
//! `LUNOID_GDAL_PYTHON=V/bin/python cargo test -p survey --test elevation gdal`. It is skipped loudly without.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;
use survey::{Elevation, Frame, ReadOptions, SurveyError, read};

use crate::made::{Directory, Field, Made, bytes, tiff};

/// Files that must be refused, with a word of the refusal.
const REFUSED: [(&str, &str); 7] = [
    ("geotiff/bits-7.tif", "BitsPerSample"),
    ("geotiff/bits-12.tif", "BitsPerSample"),
    ("geotiff/turned.tif", "a rotated grid"),
    ("geotiff/strange.tif", "--ignore item:BIAS"),
    ("geotiff/crs-paris.tif", "GeodeticCRSGeoKey"),
    ("pds4/west.xml", "longitude_direction"),
    ("isis/west.cub", "LONGITUDEDIRECTION"),
];

/// Fewest files that GDAL must have written of each format, and fewest that are made by hand.
const FEWEST: [(&str, usize); 15] = [
    ("geotiff", 100),
    ("dted", 20),
    ("hgt", 20),
    ("pds4", 20),
    ("isis", 20),
    ("envi", 20),
    ("ascii", 20),
    ("geotiff-hand", 10),
    ("dted-hand", 10),
    ("hgt-hand", 10),
    ("pds3-hand", 10),
    ("pds4-hand", 10),
    ("isis-hand", 10),
    ("envi-hand", 10),
    ("ascii-hand", 10),
];

/// Runs the script; false, and a loud line, if there is no Python for it.
fn gdal(arguments: &[&Path]) -> bool {
    let Some(python) = std::env::var_os("LUNOID_GDAL_PYTHON") else {
        println!("SKIPPED: LUNOID_GDAL_PYTHON does not name a Python with rasterio");
        return false;
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/elevation/gdal.py");
    let done = Command::new(python).arg(script).args(arguments).output().unwrap();
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    true
}

#[test]
fn files_are_read_as_gdal_reads_them() {
    let folder = tempfile::tempdir().unwrap();
    if !gdal(&["all".as_ref(), folder.path()]) {
        return;
    }
    let list: Vec<String> =
        serde_json::from_slice(&std::fs::read(folder.path().join("list.json")).unwrap()).unwrap();
    let faults: Vec<String> = list.iter().filter_map(|name| fault(folder.path(), name)).collect();
    assert!(faults.is_empty(), "{} of {}:\n{}", faults.len(), list.len(), faults.join("\n"));
    for (format, fewest) in FEWEST {
        let count = list.iter().filter(|name| name.starts_with(&format!("{format}/"))).count();
        println!("{format}: {count} files");
        assert!(count >= fewest, "{format}: {count} files");
    }
    println!("{} files are as GDAL reads them, {} of them refused", list.len(), REFUSED.len());
    assert!(list.len() >= 400, "{} files", list.len());
}

/// Band of files that have several.
fn read_one(path: &Path) -> Result<Elevation, SurveyError> {
    match read(path, &ReadOptions::default()) {
        Err(SurveyError::BandNotChosen { .. }) => {
            read(path, &ReadOptions { band: Some(1), ..ReadOptions::default() })
        }
        found => found,
    }
}

/// What is wrong with what is read of a file.
fn fault(folder: &Path, name: &str) -> Option<String> {
    let path = folder.join(name);
    let expected = REFUSED.iter().find(|(refused, _)| *refused == name).map(|(_, word)| *word);
    match (read_one(&path), expected) {
        (Err(said), Some(word)) if said.to_string().contains(word) => None,
        (Err(said), _) => Some(format!("{name}: refused: {said}")),
        (Ok(_), Some(word)) => Some(format!("{name}: read, and not refused with {word}")),
        (Ok(read), None) => {
            compared(&path, &read).map(|fault| format!("{name}: {fault}, notes {:?}", read.notes))
        }
    }
}

/// A file of what GDAL reads: it has the name of the samples.
fn told(path: &Path, ending: &str) -> PathBuf {
    let with = |path: &Path| PathBuf::from(format!("{}{ending}", path.display()));
    let samples = [path.with_extension(""), path.with_extension("dat")];
    let all = [path.to_path_buf()].into_iter().chain(samples).map(|path| with(&path));
    all.into_iter().find(|path| path.is_file()).unwrap()
}

/// The elevation files of `shared/data`.
const SHARED: [&str; 8] = [
    "lunar/herodotus_mons_hsr_54m.tif",
    "lunar/kepler_lola_48m.tif",
    "lunar/nac_southpole_image_M139939938LE_1m.tif",
    "lunar/nac_southpole_sfs_dem_1m.tif",
    "lunar/nac_southpole_stereo_dem_1m.tif",
    "pds3/LDEM_4.LBL",
    "dted/n00_e006_3arc_v2.dt1",
    "photo_dem/craterlake-elev-16bit-30m.tif",
];
/// A photograph in colour beside them: no heights.
const PICTURE: &str = "photo_dem/craterlake-imagery-30m.tif";

#[test]
fn shared_files_are_read_as_gdal_reads_them() {
    let mut folders =
        Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().map(|folder| folder.join("shared/data"));
    let Some(data) = folders.find(|folder| folder.is_dir()) else {
        println!("SKIPPED: shared/data is not there");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    for name in SHARED {
        let path = data.join(name);
        if !gdal(&["tell".as_ref(), &path, folder.path()]) {
            return;
        }
        let read = read_one(&path).unwrap_or_else(|error| panic!("{error}"));
        let fault = compared(&folder.path().join(path.file_name().unwrap()), &read);
        assert_eq!(fault, None, "{name}: notes {:?}", read.notes);
    }
    let refused = read_one(&data.join(PICTURE)).err().map(|error| error.to_string()).unwrap_or_default();
    assert!(refused.contains("a picture"), "{PICTURE}: {refused}");
    println!("{} shared files are as GDAL reads them, one is refused as a picture", SHARED.len());
}

/// How what GDAL tells of a file differs from what is read.
fn compared(path: &Path, read: &Elevation) -> Option<String> {
    let is_turned = path.extension().is_some_and(|ending| ending.to_string_lossy().starts_with("dt"));
    let array = files::read_npy(told(path, ".npy"), limits::Limit::ElevationBytes).unwrap();
    if *array.shape() != [read.lines, read.columns] {
        return Some(format!("{} x {} samples, GDAL has {:?}", read.lines, read.columns, array.shape()));
    }
    for (index, height) in array.data().to_f64().into_iter().enumerate() {
        // GDAL turns cells whose first line is the southernmost.
        let (line, column) = (index / read.columns, index % read.columns);
        let line = if is_turned { read.lines - 1 - line } else { line };
        let found = read.height(line, column);
        // GDAL leaves radii as they are.
        let is_radius = (height / 1_737_400.0 - 1.0).abs() < 0.02;
        let height = if is_radius { height - 1_737_400.0 } else { height };
        let is_equal = found.map_or(height.is_nan(), |found| (found - height).abs() <= 1e-9 * height.abs());
        if !is_equal {
            return Some(format!("line {line}, column {column}: {found:?}, GDAL has {height}"));
        }
    }
    let place: Value = serde_json::from_slice(&std::fs::read(told(path, ".json")).unwrap()).unwrap();
    let number = |key: usize| place["transform"][key].as_f64().unwrap() * place["unit"].as_f64().unwrap();
    let step = [number(4), number(0)];
    let east = quantities::radians(place["east"].as_f64().unwrap());
    let first = [number(5) + 0.5 * step[0], number(2) + 0.5 * step[1] + east];
    let is_geographic = matches!(read.frame, Frame::Geographic { .. });
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs().max(step[1].abs());
    let last = read.place(read.lines - 1, 0);
    let (found, across) = if is_turned { (last, -1.0) } else { (read.affine.first, 1.0) };
    let [north, east] = read.affine.step;
    let is_there = near(found[0], first[0]) && near(found[1], first[1]);
    let is_there = is_there && near(across * north, step[0]) && near(east, step[1]);
    // GDAL takes a simple cylindrical grid as one of metres, by the rounded scale of its label.
    let is_metric = is_geographic && place["geographic"].as_bool() == Some(false);
    let is_right = is_metric || (is_there && place["geographic"].as_bool() == Some(is_geographic));
    let on_moon = place["first"].as_array().zip(match read.frame {
        Frame::Plane(projection) => projection.and_then(|projection| projection.inverse(read.affine.first)),
        Frame::Geographic { .. } => is_metric.then_some(read.affine.first),
    });
    if let Some((gdal, found)) = on_moon {
        let apart = |k: usize| (gdal[k].as_f64().unwrap() - quantities::degrees(found[k])).abs();
        if apart(0).max(apart(1)) > if is_metric { 1e-4 } else { 1e-8 } {
            return Some(format!("first sample at {found:?} rad, GDAL has {gdal:?} deg"));
        }
    }
    (!is_right).then(|| format!("{:?} {:?}, GDAL has {first:?} {step:?}", read.affine, read.frame))
}

/// A file that is refused, a word of the refusal, the command that it advises, and the words of the command for the script.
type Advice<'a> = (&'a str, Made, &'a str, &'a [&'a str]);

fn advised() -> Vec<Advice<'static>> {
    let with = |tag: u16, field: Field| Directory::ground().with(tag, field).made();
    let matrix = |a: f64, b: f64| {
        vec![a, b, 0.0, 10_000.0, b, -10.0, 0.0, 20_000.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    };
    let mut turned = Directory::ground().with(34264, Field::Doubles(matrix(10.0, 1.0)));
    [33550, 33922].iter().for_each(|tag| drop(turned.tags.remove(tag)));
    let corners = [[0.0, 0.0], [24.0, 0.0], [0.0, 24.0], [24.0, 24.0]];
    let tie = |[x, y]: [f64; 2]| vec![x, y, 0.0, 10_000.0 + 10.0 * x, 20_000.0 - 10.0 * y, 0.0];
    let mut tied = Directory::ground().with(33922, Field::Doubles(corners.map(tie).concat()));
    tied.tags.remove(&33550);
    let mut bare = Directory::ground();
    [33550, 33922, 34735, 34736].iter().for_each(|tag| drop(bare.tags.remove(tag)));
    let mut unsaid = Directory::ground();
    unsaid.tags.remove(&262);
    let mut small = Directory::new(
        &[(254, 4), (256, 12), (257, 12), (258, 8), (259, 1), (262, 4), (277, 1), (278, 12)],
        vec![vec![255; 144]],
    );
    small.put(339, Field::Shorts(vec![1]));
    let rows = "1 2 3\n".repeat(3);
    let grid = format!("DSAA\n3 3\n0 20\n0 20\n1 3\n{rows}");
    let california = Directory::ground().with_keys(&[(1024, 1.0), (1025, 1.0), (3072, 2226.0)]);
    let dangling = Field::Shorts(vec![1, 1, 0, 2, 1024, 0, 1, 1, 2057, 34736, 1, 9]);
    vec![
        ("made.grd", Made::new(&[("made.grd", grid.as_bytes())]), "gdal_translate -of GTiff", &["translate"]),
        ("made.tif", with(274, Field::Shorts(vec![6])), "gdal_translate", &["translate"]),
        (
            "made.tif",
            with(262, Field::Shorts(vec![0])),
            "gdal_translate -co PHOTOMETRIC=MINISBLACK",
            &["translate", "PHOTOMETRIC=MINISBLACK"],
        ),
        (
            "made.tif",
            Directory::of(vec![0; 24 * 24 * 2], 12, 1).made(),
            "gdal_translate -ot Float32",
            &["translate", "ot=float32"],
        ),
        ("made.tif", turned.made(), "turn it north up with gdalwarp", &["warp", "same"]),
        ("made.tif", tied.made(), "lay it on a regular grid with gdalwarp", &["warp", "same"]),
        ("made.tif", california.made(), "gdal_translate, which adds the unit", &["translate"]),
        ("made.tif", bare.made(), "gdal_translate -a_ullr", &["translate", "a_ullr=0,240,240,0"]),
        ("made.tif", tiff(&[Directory::ground(), small]), "gdal_translate", &["translate"]),
        ("made.tif", with(34264, Field::Doubles(matrix(11.0, 0.0))), "gdal_translate", &["translate"]),
        ("made.tif", with(34735, dangling), "gdal_translate", &["translate"]),
        ("made.tif", with(42112, Field::Text("<Item name=".into())), "gdal_translate", &["translate"]),
        (
            "made.tif",
            unsaid.made(),
            "gdal_translate -of GTiff -co COMPRESS=DEFLATE",
            &["translate", "COMPRESS=DEFLATE"],
        ),
    ]
}

/// Files of GDAL itself, as those of [`advised`].
fn advised_of_gdal() -> Option<Vec<Advice<'static>>> {
    let packed = Made::new(&[("made.tif", b"")]);
    let paris = Made::new(&[("made.tif", b"")]);
    let degrees = Directory::ground()
        .with(33550, Field::Doubles(vec![0.01, 0.01, 0.0]))
        .with(33922, Field::Doubles(vec![0.0, 0.0, 0.0, 5.0, 40.0, 0.0]))
        .with_keys(&[(1024, 2.0), (1025, 1.0), (2048, 4807.0)]);
    std::fs::write(&paris.path, bytes(&[degrees])).unwrap();
    gdal(&["packed".as_ref(), &packed.path, "LZMA".as_ref()]).then(|| {
        vec![
            (
                "made.tif",
                packed,
                "gdal_translate -co COMPRESS=DEFLATE",
                &["translate", "COMPRESS=DEFLATE"][..],
            ),
            ("made.tif", paris, "gdalwarp -t_srs", &["warp", "EPSG:4326"]),
        ]
    })
}

#[test]
fn commands_of_gdal_that_refusals_advise_lead_out() {
    let all = advised().into_iter().chain(advised_of_gdal().into_iter().flatten());
    for (name, made, command, words) in all {
        let refusal = made.refusal();
        assert!(refusal.contains(command) && refusal.contains(name), "no {command}: {refusal}");
        let target = made.path.with_file_name("after.tif");
        let arguments = [words[0], made.path.to_str().unwrap(), target.to_str().unwrap()];
        let arguments: Vec<&Path> = arguments.iter().chain(&words[1..]).map(Path::new).collect();
        if gdal(&arguments) {
            let after = read(&target, &ReadOptions::default());
            assert!(
                after.is_ok(),
                "{refusal}\n{command} leads to {:?}",
                after.map_err(|said| said.to_string())
            );
        }
    }
}
