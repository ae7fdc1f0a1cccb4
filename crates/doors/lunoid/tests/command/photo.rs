//! Photographs on the command line: made, checked against their own elevations, refused.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

const MAKE: [&str; 9] =
    ["photo", "make", "tiny.toml", "--size", "60,40", "--ground-sample-m", "8", "--out", "p"];
const CHECK: [&str; 7] =
    ["photo", "check", "p/photo.png", "--camera", "p/camera.json", "--ground", "p/elevation.asc"];

fn made(more: &[&str]) -> Scene {
    let scene = Scene::new();
    scene.expect(0, &[&MAKE[..], more].concat());
    scene
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn a_photograph_agrees_with_its_own_elevations() {
    for more in [&[][..], &["--pitch-deg", "-40", "--heading-deg", "60", "--roll-deg", "10", "--bits", "16"]]
    {
        let scene = made(more);
        let files = ["camera.json", "elevation.asc", "ground.npy", "photo.json", "photo.png", "points.csv"];
        assert_eq!(scene.list("p"), files);
        let record = json(&fs::read_to_string(scene.join("p/photo.json")).unwrap());
        assert!(record["residual_px"].as_f64().unwrap() < 1e-6, "{record}");
        let check = [&CHECK[..], &["--points", "p/points.csv", "--at-most", "1e-6", "--json"]].concat();
        let report = json(&scene.expect(0, &check).0);
        assert_eq!((&report["schema"], &report["passes"]), (&"lunoid.photo-check/1".into(), &true.into()));
        assert!(report["control_points"]["root_mean_square_px"].as_f64().unwrap() < 1e-6, "{report}");
        assert_eq!(report["sun"]["source"], "of the photograph");
        assert!(report["likeness"]["correlation"].as_f64().unwrap() > 0.9, "{report}");
    }
}

/// The same photograph with other threads has the same bytes.
#[test]
fn threads_change_no_byte() {
    let scene = made(&["--noise", "0.02", "--jobs", "1"]);
    let again = [&MAKE[..8], &["q", "--noise", "0.02", "--jobs", "3"]].concat();
    scene.expect(0, &again);
    for file in ["photo.png", "camera.json", "ground.npy", "elevation.asc", "points.csv"] {
        let [one, three] = ["p", "q"].map(|folder| fs::read(scene.join(folder).join(file)).unwrap());
        assert!(one == three, "{file}");
    }
}

#[test]
fn moved_points_fail_by_exit_code_and_say_the_shift() {
    let scene = made(&[]);
    let points = fs::read_to_string(scene.join("p/points.csv")).unwrap();
    let moved: Vec<String> = points
        .lines()
        .enumerate()
        .map(|(row, line)| match row {
            0 => line.to_owned(),
            _ => {
                let (rest, j) = line.rsplit_once(',').unwrap();
                format!("{rest},{}", j.parse::<f64>().unwrap() + 3.0)
            }
        })
        .collect();
    scene.write("moved.csv", moved.join("\n"));
    let check = |at_most| [&CHECK[..], &["--points", "moved.csv", "--at-most", at_most]].concat();
    let (out, _) = scene.expect(1, &check("2.9"));
    assert!(
        out.contains("best shift of 0.000, 3.000") || out.contains("best shift of -0.000, 3.000"),
        "{out}"
    );
    assert!(out.contains("fails: root mean square 3.000 pixels, at most 2.9"), "{out}");
    scene.expect(0, &check("3.1"));
}

#[test]
fn pictures_page_and_drawing_are_written() {
    let scene = made(&[]);
    let outputs =
        ["--page", "c.html", "--relief", "r.png", "--mask", "m.png", "--lines", "l.svg", "--magnify", "5"];
    scene.expect(0, &[&CHECK[..], &outputs].concat());
    let read = |name: &str| fs::read(scene.join(name)).unwrap();
    let text = |name: &str| String::from_utf8(read(name)).unwrap();
    assert!(text("c.html").contains("id=\"flip\"") && text("c.html").matches("data:image/png").count() == 2);
    assert!(read("r.png").starts_with(b"\x89PNG") && read("m.png").starts_with(b"\x89PNG"));
    assert!(text("l.svg").contains("heights times 5"));
}

/// The sun of a photograph comes back from its shadows: within half a degree, and within twice what is said of it.
#[test]
fn the_sun_is_found_from_shadows() {
    let scene = Scene::new();
    let tiny = fs::read_to_string(scene.join("tiny.toml")).unwrap();
    let tiny = tiny
        .replace("rms_height_m = 2", "rms_height_m = 6")
        .replace("elevation_deg = 15", "elevation_deg = 8");
    scene.write("tiny.toml", tiny + "\n[shadows]\n");
    let make = [&MAKE[..3], &["--size", "90,90", "--ground-sample-m", "4", "--out", "p"]].concat();
    scene.expect(0, &make);
    let (text, _) = scene.expect(0, &[&CHECK[..], &["--find-sun"]].concat());
    assert!(text.contains("found from its shadows") && text.contains("for the camera file"), "{text}");
    let report = json(&scene.expect(0, &[&CHECK[..], &["--find-sun", "--json"]].concat()).0);
    let found = |key: &str| report["found_sun"][key].as_f64().unwrap();
    for (key, said, sun) in [
        ("azimuth_deg", "azimuth_uncertainty_deg", 100.0),
        ("elevation_deg", "elevation_uncertainty_deg", 8.0),
    ] {
        let off = (found(key) - sun).abs();
        assert!(off < 0.5 && off < 2.0 * found(said), "{report}");
    }
    assert!(found("overlap_correlation") > 0.8, "{report}");
    let (_, said) = scene.expect(2, &[&CHECK[..], &["--find-sun", "--sun", "1,2"]].concat());
    assert!(said.contains("cannot be used with"), "{said}");
}

/// A raster becomes a photograph that the check takes, and one with a hole is refused.
#[test]
fn a_raster_is_imported() {
    let scene = made(&[]);
    let raster = |value: &str| {
        format!("ncols 3\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 100\n1 2 3\n4 {value} 6\n")
    };
    scene.write("light.asc", raster("5"));
    let (told, _) =
        scene.expect(0, &["photo", "import", "light.asc", "--white", "5", "--sun", "30,10", "--out", "q"]);
    assert!(told.contains("3 x 2 pixels, white is 5; 1 values lie beyond"), "{told}");
    assert_eq!(scene.list("q"), ["camera.json", "photo.png"]);
    scene.write("ground.asc", raster("7"));
    let check = ["photo", "check", "q/photo.png", "--camera", "q/camera.json", "--ground", "ground.asc"];
    let (told, _) = scene.expect(0, &check);
    assert!(told.contains("posts: 6 in the photograph") && told.contains("azimuth 30.000"), "{told}");
    let (_, said) = scene.expect(3, &[&check[..], &["--find-sun"]].concat());
    assert!(said.contains("6 posts of the ground, expected 1000"), "{said}");
    scene.write("hole.asc", raster("-9999").replace("cellsize 100", "cellsize 100\nnodata_value -9999"));
    let (_, said) = scene.expect(3, &["photo", "import", "hole.asc", "--out", "r"]);
    assert!(said.contains("hole.asc") && said.contains("line 1, column 1"), "{said}");
    assert!(!scene.join("r").exists());
}

/// Voids at the words of the file: filled inside, left at the edge, counted in the report.
#[test]
fn voids_are_filled_as_asked_and_counted() {
    let scene = made(&[]);
    let grid = fs::read_to_string(scene.join("p/elevation.asc")).unwrap();
    let mut lines: Vec<String> = grid.lines().map(str::to_owned).collect();
    // Head lines are six; post 10 to 12 of lines 20 and 21 become void.
    for line in [25, 26] {
        let mut words: Vec<&str> = lines[line].split(' ').collect();
        words[10..13].fill("-99999");
        lines[line] = words.join(" ");
    }
    scene.write("holes.asc", lines.join("\n") + "\n");
    let check = |more: &[&'static str]| {
        let command = [&CHECK[..6], &["holes.asc", "--json"], more].concat();
        json(&scene.expect(0, &command).0)["voids"].clone()
    };
    let before = json(&scene.expect(0, &[&CHECK[..], &["--json"]].concat()).0)["voids"].clone();
    let more = |found: &Value, key: &str| found[key].as_u64().unwrap() - before[key].as_u64().unwrap();
    let filled = check(&[]);
    assert_eq!(
        (more(&filled, "posts"), more(&filled, "holes"), more(&filled, "still_void")),
        (6, 1, 0),
        "{filled}"
    );
    let left = check(&["--fill", "leave"]);
    assert_eq!((more(&left, "still_void"), left["fill"].as_str()), (6, Some("leave")), "{left}");
}

#[test]
fn what_makes_no_photograph_is_refused() {
    let scene = Scene::new();
    for (wrong, told) in [
        (&["--size", "60"][..], "expected columns and lines"),
        (&["--size", "0,40"], "each from 1 to 8192"),
        (&["--pitch-deg", "5"], "expected degrees from -90 to -0.1"),
        (&["--field-deg", "180"], "expected degrees from 0.01 to 170"),
        (&["--bits", "12"], "expected 8 or 16"),
        (&["--height-m", "100", "--field-deg", "20"], "cannot be used with"),
        (&["--gamma", "9"], "gamma is 9, expected 0.25 to 4"),
        (&["--centre-m", "1e6,0"], "lies beside the ground"),
        (&["--bogus"], "unexpected argument"),
    ] {
        let command = [&["photo", "make", "tiny.toml", "--out", "new"], wrong].concat();
        let (_, said) = scene.expect(2, &command);
        assert!(said.contains(told), "{wrong:?}: {said}");
    }
    assert_eq!(scene.list("."), ["tiny.toml"]);
}

#[test]
fn what_cannot_be_checked_is_refused() {
    let scene = made(&[]);
    let camera = fs::read_to_string(scene.join("p/camera.json")).unwrap();
    scene.write(
        "far.json",
        camera.replace("\"perspective_centre_m\": [\n    ", "\"perspective_centre_m\": [\n    9"),
    );
    scene.write("flat.json", camera.replacen("\"focal_length_m\": 0", "\"focal_length_m\": -0", 1));
    scene.write("wide.asc", "ncols 3\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 10\n1 2 3\n1 2\n");
    for (code, at, with, told) in [
        (3, 4, "far.json", "no pixel in common with the ground"),
        (3, 4, "flat.json", "focal length (m) is -0.15"),
        (3, 4, "gone.json", "gone.json"),
        (3, 2, "p/camera.json", "not a whole PNG, JPEG or TIFF"),
        (3, 6, "p/photo.png", "PNG picture, which has no heights"),
        (3, 6, "wide.asc", "wide.asc"),
    ] {
        let mut command = CHECK.to_vec();
        command[at] = with;
        command.extend(["--page", "never.html"]);
        let (_, said) = scene.expect(code, &command);
        assert!(said.contains(told), "{with}: {said}");
    }
    let (_, said) = scene.expect(2, &[&CHECK[..], &["--at-most", "3"]].concat());
    assert!(said.contains("--points"), "{said}");
    let (_, said) = scene.expect(2, &[&CHECK[..], &["--relief", "p/photo.png"]].concat());
    assert!(said.contains("would replace"), "{said}");
    let (_, said) = scene.expect(2, &[&CHECK[..], &["--page", "page.txt"]].concat());
    assert!(said.contains("ends in .html"), "{said}");
    assert!(!scene.list(".").contains(&"never.html".to_owned()));
}
