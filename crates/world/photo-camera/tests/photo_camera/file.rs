//! The camera file: read, written, and refused with one error that says where and what.

use photo_camera::{Axes, CameraFile, Ellipsoid};

use crate::{ground, thesis_camera};

const TEXT: &str = r#"{
  "format": 1,
  "focal_length_m": 0.153197,
  "principal_point_m": [2e-6, 0],
  "perspective_centre_m": [-2693765.9, -4304520.4, 3859018.3],
  "omega_phi_kappa_rad": [0.8341764, -0.4563699, 3.0761254],
  "affine_x_um": [20.11323959, 6.01620794, -34954.59484],
  "affine_y_um": [-6.022849824, 20.10938801, -22566.71593],
  "body": { "semi_major_axis_m": 6378206.4, "eccentricity_squared": 0.006768658 }
}"#;

fn assert_same(file: CameraFile) {
    let point = ground("37:24:02 N", "122:02:06 W", 5.0);
    let [found, expected] =
        [file.camera, thesis_camera()].map(|camera| camera.image(point).expect("in front"));
    assert!((found[0] - expected[0]).abs() < 1e-6 && (found[1] - expected[1]).abs() < 1e-6);
    let Axes::Body(body) = file.axes else { panic!("a body") };
    assert!((body.semi_major() - Ellipsoid::CLARKE_1866.semi_major()).abs() < 1e-8);
}

#[test]
fn a_camera_file_gives_its_camera_and_is_written_and_read_again() {
    let file = CameraFile::read("moffett.json", TEXT).expect("a camera file");
    assert_same(file);
    let written = file.write();
    assert!(written.contains("image_axes") && written.ends_with("}\n"));
    assert_same(CameraFile::read("again.json", &written).expect("what was written"));
}

#[test]
fn what_is_no_camera_file_is_refused_with_place_and_name() {
    for (from, to, told) in [
        ("focal_length_m", "focal_length_mm", "unknown field `focal_length_mm`"),
        ("\"format\": 1", "\"format\": 2", "`format` is 2, not 1"),
        ("\"format\": 1,", "\"format\": 1, \"format\": 1,", "duplicate field `format`"),
        ("  \"format\": 1,\n", "", "missing field `format`"),
        ("0.153197", "0", "focal length (m) is 0"),
        ("0.153197", "NaN", "expected"),
        ("0.153197", "1e999", "number out of range"),
        ("0.153197", "\"0.15\"", "invalid type"),
        ("[2e-6, 0]", "[2e-6]", "invalid length 1"),
        ("[20.11323959, 6.01620794,", "[0, 0,", "cannot be inverted"),
        ("6378206.4", "-1", "semi-major axis (m) is -1"),
        ("\"omega_phi_kappa_rad\": [0.8341764, -0.4563699, 3.0761254],", "", "by neither of"),
        (
            "omega_phi_kappa_rad\": [0.8341764, -0.4563699, 3.0761254]",
            "image_axes\": [[1,0,0],[0,1,0],[0,0,-1]]",
            "handedness",
        ),
        ("\"affine_x_um\"", "\"image_axes\": [[1,0,0],[0,1,0],[0,0,1]], \"affine_x_um\"", "by both of"),
        ("}\n}", "}\n} x", "trailing characters"),
        ("}\n}", "},\n  \"axes\": \"landscape\"\n}", "by both of `body` and `axes`"),
        ("}\n}", "},\n  \"sun_azimuth_elevation_rad\": [0, 2]\n}", "elevation of the sun (rad) is 2"),
        ("}\n}", "},\n  \"grey_white_gamma\": [0, 1]\n}", "white of the grey curve is 0"),
        ("}\n}", "},\n  \"grey_white_gamma\": [1, 0]\n}", "gamma of the grey curve is 0"),
    ] {
        let text = TEXT.replacen(from, to, 1);
        let problem = CameraFile::read("bad.json", &text).expect_err(to);
        assert!(problem.title.contains(told), "{to}: {}", problem.title);
        assert!(problem.file.starts_with("bad.json") && problem.help.is_some());
    }
    let unknown = TEXT.replacen("focal_length_m", "focal", 1);
    assert_eq!(CameraFile::read("bad.json", &unknown).expect_err("unknown").file, "bad.json:3:9");
}

const BODY: &str = "\"body\": { \"semi_major_axis_m\": 6378206.4, \"eccentricity_squared\": 0.006768658 }";

#[test]
fn a_camera_of_a_landscape_carries_its_light() {
    let keys = "\"axes\": \"landscape\", \"sun_azimuth_elevation_rad\": [1.5, 0.25], \"grey_white_gamma\": [0.5, 2.2]";
    let file = CameraFile::read("made.json", &TEXT.replacen(BODY, keys, 1)).expect("a camera file");
    let again = CameraFile::read("again.json", &file.write()).expect("what was written");
    assert_eq!((again.axes, again.axes.body()), (Axes::Landscape, None));
    assert_eq!((again.light.sun(), again.light.grey()), (Some([1.5, 0.25]), Some([0.5, 2.2])));
    for (to, told) in [
        ("\"axes\": \"moon\"", "`axes` is \"moon\", not \"landscape\""),
        ("\"grey_white_gamma\": [0.5, 2.2]", "by neither of `body` and `axes`"),
    ] {
        let problem = CameraFile::read("bad.json", &TEXT.replacen(BODY, to, 1)).expect_err(to);
        assert!(problem.title.contains(told), "{to}: {}", problem.title);
    }
}
