//! The page `docs/own-ground.md`, run from top to bottom: place, sun and first pose are compared with values that lunoid did not make.

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use serde_json::Value;

const PAGE: &str = include_str!("../../../../docs/own-ground.md");

/// Radius of the Moon of the file's map (m).
const MOON: f64 = 1_737_400.0;
/// Latitude of the map's true parallel and longitude of its middle (degrees).
const PARALLEL: f64 = 20.19;
const MERIDIAN: f64 = 30.77;
/// Northing and easting of the south-west sample on the file's map (m).
const SOUTH_WEST: [f64; 2] = [611_620.0, -600.0];
/// The eye above the ground (m).
const EYE: f64 = 1.6334;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// Blocks of the page in order, each with its language.
fn blocks() -> Vec<(&'static str, &'static str)> {
    let fences = PAGE.split("\n```").skip(1).step_by(2);
    fences.map(|block| block.split_once('\n').expect("a language")).collect()
}

/// Height of the made hill (m), `north` and `east` of the middle of the file (m).
fn height(north: f64, east: f64) -> f64 {
    let bump = |top: f64, radius: f64, at: [f64; 2]| {
        let [north, east] = [north - at[0], east - at[1]];
        top * libm::exp(-(north * north + east * east) / (2.0 * radius * radius))
    };
    -2610.0 + 0.02 * east + bump(90.0, 160.0, [260.0, 150.0]) + bump(-6.0, 60.0, [-180.0, -250.0])
}

/// Runs a command of the page in `folder`; what it prints.
fn run(folder: &Path, line: &str) -> String {
    let mut words = line.split_whitespace();
    match words.next() {
        Some("cp") => {
            let [from, to] = [words.next(), words.next()].map(|path| folder.join(path.expect("a path")));
            fs::copy(from, to).expect("a copy");
            String::new()
        }
        Some("lunoid") => {
            let mut command = Command::cargo_bin("lunoid").expect("the command");
            let done = command.env_remove("LUNOID_THREADS").current_dir(folder).args(words).output();
            let done = done.expect("it runs");
            assert!(done.status.success(), "{line}\n{}", String::from_utf8_lossy(&done.stderr));
            String::from_utf8(done.stdout).expect("text")
        }
        other => panic!("{other:?}: no command of the page"),
    }
}

fn json(folder: &Path, line: &str) -> Value {
    serde_json::from_str(&run(folder, line)).expect("JSON")
}

fn close(what: &str, found: &Value, expected: f64, within: f64) {
    let found = found.as_f64().unwrap_or_else(|| panic!("{what}: {found}"));
    assert!((found - expected).abs() <= within, "{what}: {found}, expected {expected} within {within}");
}

#[test]
fn the_page_leads_from_files_to_frames_with_truth() {
    let room = tempfile::tempdir().expect("a folder");
    let folder = room.path();
    fs::create_dir_all(folder.join("runs")).expect("a folder");
    fs::create_dir_all(folder.join("scenarios/own-ground")).expect("a folder");
    for name in ["site.asc", "site.prj", "drive.gpx"] {
        let of = Path::new("scenarios/own-ground").join(name);
        fs::copy(root().join(&of), folder.join(&of)).expect("a shipped file");
    }
    let mut last = String::new();
    for (language, text) in blocks() {
        match language {
            "toml" => fs::write(folder.join("runs/own-ground.toml"), text).expect("a file"),
            _ => last = text.lines().map(|line| run(folder, line)).collect(),
        }
    }
    assert!(last.ends_with("open runs/own-ground-1970/index.html\n"), "{last}");

    place_is_that_of_the_map(folder);
    sun_is_that_of_another_theory(folder);
    first_pose_is_on_the_hill(folder);
    for name in ["index.html", "frames/frame-000019.png", "truth/frame-000000.npz", "truth/poses.csv"] {
        assert!(folder.join("runs/own-ground").join(name).is_file(), "{name}");
    }
}

/// The bank touches the Moon in its middle, by the closed form of the map.
fn place_is_that_of_the_map(folder: &Path) {
    let bank = json(folder, "lunoid bank show runs/site.bank --json");
    let north = SOUTH_WEST[0] + 600.0;
    close("latitude", &bank["place"]["latitude_deg"], (north / MOON).to_degrees(), 1e-9);
    close("longitude", &bank["place"]["longitude_deg"], MERIDIAN, 1e-9);
}

/// Sun and Earth at the date, from JPL's ephemeris DE421 and its librations by `jplephem` (docs/sun.md), at 20.189721 N, 30.77 E.
fn sun_is_that_of_another_theory(folder: &Path) {
    let sun = json(folder, "lunoid sun runs/site.bank --at 1972-12-11T22:00:00Z --json");
    close("elevation", &sun["skies"][0]["sun"]["elevation_deg"], SUN[0], 0.02);
    close("azimuth", &sun["skies"][0]["sun"]["true_azimuth_deg"], SUN[1], 0.02);
}

/// Elevation and azimuth of the sun (degrees).
const SUN: [f64; 2] = [14.335_25, 96.240_43];

/// The first point of the track, by the closed form of the map; the eye above the made hill.
fn first_pose_is_on_the_hill(folder: &Path) {
    let track = fs::read_to_string(root().join("scenarios/own-ground/drive.gpx")).expect("a track");
    let degrees = |name: &str| -> f64 {
        let (_, rest) = track.split_once(&format!("{name}=\"")).expect("a point");
        rest.split('"').next().and_then(|number| number.parse().ok()).expect("a number")
    };
    let north = degrees("lat").to_radians() * MOON - SOUTH_WEST[0];
    let east =
        (degrees("lon") - MERIDIAN).to_radians() * MOON * libm::cos(PARALLEL.to_radians()) - SOUTH_WEST[1];
    let poses = fs::read_to_string(folder.join("runs/own-ground/poses.csv")).expect("poses");
    let first: Vec<f64> =
        poses.lines().nth(1).expect("a row").split(',').map(|cell| cell.parse().expect("a number")).collect();
    for (what, found, expected, within) in [
        ("north", first[2], north, 1e-3),
        ("east", first[3], east, 1e-3),
        // The wheels stand 2 m apart, the fit misses by centimetres.
        ("height", first[4], height(north - 600.0, east - 600.0) + EYE, 0.05),
    ] {
        assert!((found - expected).abs() < within, "{what}: {found}, expected {expected}");
    }
}
