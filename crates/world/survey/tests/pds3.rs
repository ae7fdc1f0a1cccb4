//! PDS3 images and `.npy` arrays built here, whole and damaged.

use std::fs;
use std::path::{Path, PathBuf};

use files::{Npy, NpyData, write_npy};
use quantities::degrees;
use survey::{Elevation, Frame, Method, ReadOptions, SurveyError, read};
use tempfile::TempDir;

const LABEL: &str = include_str!("ground.lbl");

fn little() -> Vec<u8> {
    [2i16, -4, 6, 8, -32768, 12].iter().flat_map(|height| height.to_le_bytes()).collect()
}

/// Label and image in a folder.
fn folder(label: &str, image: &[u8]) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("GROUND.IMG"), image).unwrap();
    let path = folder.path().join("ground.lbl");
    fs::write(&path, label).unwrap();
    (folder, path)
}

fn plain(path: &Path) -> Result<Elevation, SurveyError> {
    read(path, &ReadOptions::default())
}

fn heights(elevation: &Elevation) -> Vec<Option<f64>> {
    (0..elevation.lines * elevation.columns)
        .map(|index| elevation.height(index / elevation.columns, index % elevation.columns))
        .collect()
}

const EXPECTED: [Option<f64>; 6] = [Some(1.0), Some(-2.0), Some(3.0), Some(4.0), None, Some(6.0)];

#[test]
fn label_or_image_may_be_named() {
    let (folder, label) = folder(LABEL, &little());
    for path in [label.clone(), folder.path().join("GROUND.IMG")] {
        let elevation = plain(&path).unwrap();
        assert_eq!(heights(&elevation), EXPECTED);
        assert_eq!(elevation.sources, [label.clone(), folder.path().join("GROUND.IMG")]);
        assert!(matches!(elevation.frame, Frame::Geographic { .. }));
        assert!((degrees(elevation.affine.first[0]) - 89.875).abs() < 1e-9);
        assert!((degrees(elevation.affine.first[1]) - 0.125).abs() < 1e-9);
    }
}

#[test]
fn attached_labels_point_by_record_or_byte() {
    let length = LABEL.len() + 40;
    for (pointer, start) in [("^IMAGE = 301", 1800), ("^IMAGE = 1001 <BYTES>", 1000)] {
        let mut bytes = LABEL.replace("^IMAGE = \"GROUND.IMG\"", pointer).into_bytes();
        assert!(bytes.len() < start && length < start);
        bytes.resize(start, b' ');
        bytes.extend(little());
        let (folder, _) = folder("", &[]);
        let path = folder.path().join("ONE.IMG");
        fs::write(&path, &bytes).unwrap();
        assert_eq!(heights(&plain(&path).unwrap()), EXPECTED, "{pointer}");
        fs::write(&path, &bytes[..bytes.len() - 1]).unwrap();
        assert!(matches!(plain(&path), Err(SurveyError::Truncated { .. })), "{pointer}");
    }
    let offset = LABEL.replace("\"GROUND.IMG\"", "(\"GROUND.IMG\", 2)");
    let (_folder, path) = folder(&offset, &[&[0; 6], little().as_slice()].concat());
    assert_eq!(heights(&plain(&path).unwrap()), EXPECTED);
}

#[test]
fn sample_types() {
    let numbers = [2.0_f64, -4.0, 6.0, 8.0, -32768.0, 12.0];
    let cases: Vec<(&str, u32, Vec<u8>)> = vec![
        ("MSB_INTEGER", 16, numbers.iter().flat_map(|&v| (v as i16).to_be_bytes()).collect()),
        ("MSB_INTEGER", 32, numbers.iter().flat_map(|&v| (v as i32).to_be_bytes()).collect()),
        ("LSB_INTEGER", 32, numbers.iter().flat_map(|&v| (v as i32).to_le_bytes()).collect()),
        ("PC_REAL", 32, numbers.iter().flat_map(|&v| (v as f32).to_le_bytes()).collect()),
        ("IEEE_REAL", 32, numbers.iter().flat_map(|&v| (v as f32).to_be_bytes()).collect()),
        ("PC_REAL", 64, numbers.iter().flat_map(|&v| v.to_le_bytes()).collect()),
        ("IEEE_REAL", 64, numbers.iter().flat_map(|&v| v.to_be_bytes()).collect()),
    ];
    for (kind, bits, image) in cases {
        let label =
            LABEL.replace("LSB_INTEGER", kind).replace("SAMPLE_BITS = 16", &format!("SAMPLE_BITS = {bits}"));
        let (_folder, path) = folder(&label, &image);
        assert_eq!(heights(&plain(&path).unwrap()), EXPECTED, "{kind} {bits}");
    }
    let bytes = LABEL.replace("LSB_INTEGER", "UNSIGNED_INTEGER").replace("BITS = 16", "BITS = 8");
    let (_folder, path) = folder(&bytes, &[2, 200, 6, 8, 0, 12]);
    assert_eq!(heights(&plain(&path).unwrap())[1], Some(100.0));
    let bits = LABEL.replace("LSB_INTEGER", "IEEE_REAL").replace("BITS = 16", "BITS = 32");
    let bits = bits.replace("-32768", "16#FF7FFFFB#");
    let image =
        [2.0f32, 4.0, f32::from_bits(0xff7f_fffb), 1.0, 1.0, 1.0].into_iter().flat_map(|v| v.to_be_bytes());
    let (_folder, path) = folder(&bits, &image.collect::<Vec<_>>());
    assert_eq!(heights(&plain(&path).unwrap())[2], None);
}

#[test]
fn kilometres_of_radius_become_heights() {
    let label = LABEL.replace("LSB_INTEGER", "PC_REAL\n UNIT = KILOMETER").replace("BITS = 16", "BITS = 32");
    let label = label.replace("SCALING_FACTOR = 0.5", "SCALING_FACTOR = 1").replace("1737400.", "1737.4");
    let image = [0.5f32, -0.25, 1.0, 2.0, 0.0, 0.0].iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>();
    let (_folder, path) = folder(&label, &image);
    assert_eq!(heights(&plain(&path).unwrap())[..3], [Some(500.0), Some(-250.0), Some(1000.0)]);
}

#[test]
fn plane_projections() {
    let plane =
        LABEL.replace("MAP_RESOLUTION = 4", "MAP_RESOLUTION = 303.233").replace("7.580838 <km", "0.1 <km");
    let polar =
        plane.replace("SIMPLE CYLINDRICAL", "POLAR STEREOGRAPHIC").replace("LATITUDE = 0", "LATITUDE = -90");
    let (_folder, path) = folder(&polar.replace("LONGITUDE = 180", "LONGITUDE = 0"), &little());
    let elevation = plain(&path).unwrap();
    assert_eq!(elevation.affine.first, [35_950.0, -71_950.0]);
    assert_eq!(elevation.affine.step, [-100.0, 100.0]);
    let Frame::Plane(Some(projection)) = elevation.frame else { panic!() };
    assert_eq!(projection.method, Method::PolarStereographic { scale: 1.0 });
    let (_folder, path) = folder(&plane.replace("SIMPLE CYLINDRICAL", "EQUIRECTANGULAR"), &little());
    assert!(matches!(plain(&path).unwrap().frame, Frame::Plane(Some(_))));
}

#[test]
fn damaged_labels_name_line_and_keyword() {
    let refused = |from: &str, to: &str| {
        let (_folder, path) = folder(&LABEL.replace(from, to), &little());
        plain(&path).unwrap_err().to_string()
    };
    assert!(refused("SAMPLE_BITS = 16", "SAMPLE_BITS = 12").contains("line 9, SAMPLE_BITS"));
    assert!(refused("SAMPLE_BITS = 16", "").contains("SAMPLE_BITS"));
    assert!(refused("LSB_INTEGER", "VAX_REAL").contains("PC_REAL"));
    assert!(refused("LINES = 2", "LINES = many").contains("line 6, LINES"));
    assert!(refused("LINES = 2", "LINES = -2").contains("whole number"));
    assert!(refused("LINES = 2", "LINES = 0").contains("0 lines"));
    assert!(refused("LINES = 2", "LINES = 3").contains("12 bytes; expected at least 18"));
    assert!(refused("LINES = 2", "LINES = 9e15").contains("expected at least"));
    assert!(refused("0.5", "0").contains("scale"));
    assert!(refused("SIMPLE CYLINDRICAL", "SINUSOIDAL").contains("POLAR STEREOGRAPHIC"));
    assert!(refused("\"EAST\"", "\"WEST\"").contains("EAST"));
    assert!(refused("= 4 <pix/deg>", "= 0 <pix/deg>").contains("MAP_RESOLUTION"));
    assert!(refused("MAP_PROJECTION_TYPE = \"SIMPLE CYLINDRICAL\"", "").contains("--spacing-m METRES"));
    assert!(refused("^IMAGE", "^TABLE").contains("^IMAGE"));
    assert!(refused("\nEND\n", "\n").contains("truncated"));
    assert!(refused("MISSING_CONSTANT = -32768", "MISSING_CONSTANT = 16#XY#").contains("16#DIGITS#"));
    let all = LABEL.replace("-32768", "7");
    let (_folder, path) = folder(&all, &[7, 0].repeat(6));
    assert!(plain(&path).unwrap_err().to_string().contains("all 6 samples are void"));
}

#[test]
fn a_label_cannot_leave_its_folder() {
    for name in ["../GROUND.IMG", "/etc/passwd", "sub/GROUND.IMG", "..", "C:\\GROUND.IMG", "ABSENT.IMG"] {
        let (_folder, path) = folder(&LABEL.replace("GROUND.IMG", name), &little());
        let message = plain(&path).unwrap_err().to_string();
        assert!(
            message.contains("line 3, ^IMAGE") && message.contains("folder of the label"),
            "{name}: {message}"
        );
    }
}

#[test]
fn no_damaged_byte_panics() {
    let (_folder, path) = folder(LABEL, &little());
    for at in 0..LABEL.len() {
        for byte in [b'"', b'(', 0xff] {
            let mut damaged = LABEL.as_bytes().to_vec();
            damaged[at] = byte;
            fs::write(&path, damaged).unwrap();
            let _ = plain(&path);
        }
        fs::write(&path, &LABEL.as_bytes()[..at]).unwrap();
        assert!(plain(&path).is_err() || at + 1 >= LABEL.len());
    }
}

#[test]
fn npy_arrays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ground.npy");
    let write = |shape: Vec<usize>, data: NpyData| write_npy(&path, &Npy::new(shape, data).unwrap()).unwrap();
    write(vec![2, 3], NpyData::F64(vec![1.0, 2.0, f64::NAN, 4.0, 5.0, 6.0]));
    assert!(matches!(plain(&path), Err(SurveyError::NoSpacing(_))));
    let spaced = ReadOptions { spacing: Some([2.0, 3.0]), ..ReadOptions::default() };
    let elevation = read(&path, &spaced).unwrap();
    assert_eq!(heights(&elevation), [Some(1.0), Some(2.0), None, Some(4.0), Some(5.0), Some(6.0)]);
    assert_eq!(elevation.extent(), [0.0, 0.0, 2.0, 6.0]);
    assert_eq!(elevation.place(0, 0), [2.0, 0.0]);
    let south = ReadOptions { first_line_south: true, ..spaced.clone() };
    assert_eq!(read(&path, &south).unwrap().place(0, 0), [0.0, 0.0]);
    write(vec![2, 2], NpyData::I16(vec![1, -2, 3, -4]));
    assert_eq!(heights(&read(&path, &spaced).unwrap()), [1.0, -2.0, 3.0, -4.0].map(Some));
    write(vec![2, 2], NpyData::F32(vec![1.0, f32::INFINITY, 3.0, 4.0]));
    assert!(matches!(read(&path, &spaced), Err(SurveyError::NotFinite { line: 0, column: 1, .. })));
    write(vec![6], NpyData::F64(vec![1.0; 6]));
    assert!(read(&path, &spaced).unwrap_err().to_string().contains("[lines, columns]"));
    write(vec![0, 6], NpyData::F64(vec![]));
    assert!(matches!(read(&path, &spaced), Err(SurveyError::Empty { .. })));
    let bad = ReadOptions { spacing: Some([0.0, 1.0]), ..ReadOptions::default() };
    assert!(matches!(read(&path, &bad), Err(SurveyError::Option { option: "spacing", .. })));
    let whole = fs::read(&path).unwrap();
    fs::write(&path, &whole[..20]).unwrap();
    assert!(read(&path, &spaced).unwrap_err().to_string().contains("ground.npy"));
}

#[test]
fn what_is_no_elevation_file() {
    let folder = tempfile::tempdir().unwrap();
    assert!(matches!(plain(folder.path()), Err(SurveyError::File(files::FileError::IsFolder { .. }))));
    let absent = plain(&folder.path().join("absent.tif"));
    assert!(matches!(absent, Err(SurveyError::File(files::FileError::Missing { .. }))));
    let path = folder.path().join("text.tif");
    for (bytes, found) in [(&b""[..], "empty"), (b"hello", "68 65 6C")] {
        fs::write(&path, bytes).unwrap();
        let message = plain(&path).unwrap_err().to_string();
        assert!(message.contains("text.tif") && message.contains(found), "{message}");
    }
}
