//! Files of photographs: read, and refused with one message that names file and key.

use std::fs;
use std::path::PathBuf;

use photo_camera::{Axes, CameraFile, Light};
use photograph::{MapUnit, PhotoError, Photograph, Placement, read_photo_file};
use picture::{Depth, encode_png};
use tempfile::TempDir;

use crate::{from_above, picture};

const MAP: &str = r#"{
  "format": 1,
  "camera": "map",
  "unit": "m",
  "east_of_pixel": [1, 0, -15473.4],
  "north_of_pixel": [0, -1, 150987.2],
  "sun_azimuth_elevation_rad": [1.5, 0.2]
}"#;

/// A folder with a picture of 6 x 4 pixels and a file beside it.
fn folder(beside: &str) -> (TempDir, PathBuf, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let [photo, camera] = ["photo.png", "camera.json"].map(|name| folder.path().join(name));
    let picture = picture(6, 4, Depth::Sixteen, |column, line| (column * 100 + line) as u16);
    fs::write(&photo, encode_png(&picture, &[]).expect("a PNG")).expect("written");
    fs::write(&camera, beside).expect("written");
    (folder, photo, camera)
}

#[test]
fn a_map_file_makes_a_map() {
    let (_folder, photo, camera) = folder(MAP);
    let photo = Photograph::read(&photo, &camera).expect("a photograph");
    let Placement::Map(map) = photo.placement() else { panic!("a map") };
    assert_eq!((map.unit(), map.rows()[1]), (MapUnit::Metre, [0.0, -1.0, 150_987.2]));
    let sun = photo.sun().expect("a sun");
    assert_eq!(sun, [1.5, 0.2]);
    assert_eq!((photo.picture().depth(), photo.picture().code(3, 2)), (Depth::Sixteen, 302));
    assert_eq!((photo.transfer().white(), photo.transfer().gamma()), (1.0, 1.0));
}

#[test]
fn a_camera_file_makes_a_camera() {
    let made = from_above(picture(6, 4, Depth::Eight, |_, _| 0), Light::default());
    let Placement::Camera { camera, axes } = *made.placement() else { panic!("a camera") };
    let light = Light::new(Some([0.1, 0.2]), Some([0.5, 2.0])).expect("light");
    let (_folder, photo, file) = folder(&CameraFile { camera, axes, light }.write());
    let photo = Photograph::read(&photo, &file).expect("a photograph");
    assert_eq!(*photo.placement(), Placement::Camera { camera, axes: Axes::Landscape });
    assert_eq!((photo.transfer().white(), photo.transfer().gamma()), (0.5, 2.0));
}

#[test]
fn what_is_no_map_file_is_refused_with_its_key() {
    for (from, to, told) in [
        ("\"map\"", "\"fisheye\"", "`camera` is \"fisheye\", not \"map\""),
        ("\"unit\": \"m\"", "\"unit\": \"feet\"", "`unit`: it is \"feet\", not \"m\" or \"deg\""),
        ("\"format\": 1", "\"format\": 3", "`format`: it is 3, not 1"),
        ("[1, 0, -15473.4]", "[0, 2, -15473.4]", "cannot be inverted"),
        ("[1, 0, -15473.4]", "[1, 0]", "invalid length 2"),
        ("[1.5, 0.2]", "[1.5, 9]", "elevation of the sun (rad) is 9"),
        ("\"unit\"", "\"units\"", "unknown field `units`"),
        ("  \"camera\": \"map\",\n", "", "unknown field `unit`"),
        ("\"format\": 1,", "", "missing field `format`"),
        ("}", "", "cannot be read"),
    ] {
        let text = MAP.replacen(from, to, 1);
        let problem = read_photo_file("bad.json", &text).expect_err(to);
        assert!(problem.title.contains(told), "{to}: {}", problem.title);
        assert!(problem.file.starts_with("bad.json") && problem.help.is_some());
    }
}

#[test]
fn a_byte_order_mark_is_passed_over() {
    let read = |text: &str| read_photo_file("made.json", text).expect("a map file").placement;
    assert_eq!(format!("{:?}", read(&format!("\u{feff}{MAP}"))), format!("{:?}", read(MAP)));
}

#[test]
fn files_that_are_not_there_or_no_pictures_are_named() {
    let (_folder, photo, camera) = folder(MAP);
    let gone = photo.with_file_name("gone.png");
    let said = |photo: &PathBuf, camera: &PathBuf| {
        let error = Photograph::read(photo, camera).expect_err("refused");
        (error.to_string(), error)
    };
    assert!(said(&gone, &camera).0.contains("gone.png"));
    assert!(said(&photo, &gone).0.contains("gone.png"));
    let (text, error) = said(&camera, &camera);
    assert!(
        matches!(error, PhotoError::Picture(_)) && text.contains("not a whole PNG, JPEG or TIFF"),
        "{text}"
    );
    fs::write(&camera, MAP.replacen("\"m\"", "\"ell\"", 1)).expect("written");
    let (text, error) = said(&photo, &camera);
    assert!(matches!(error, PhotoError::Camera(_)) && text.contains("camera.json: `unit`"), "{text}");
}
