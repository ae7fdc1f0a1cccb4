//! `lunoid study levels` and `lunoid study tracks`: what they find, what they leave in a folder, what they refuse.

use std::process::Command;

use serde_json::Value;

use crate::dataset::{has, python};
use crate::scene::Scene;

/// Rough ground of 20 x 20 tiles under a camera that comes down straight.
const ROUGH: &str = r#"format = 1
title = "Rough"
shows = "Tiles of the ground take finer levels as the camera comes down."
machine = "lod-mesh"
duration_s = 2
[landscape]
albedo = 0.6
[landscape.generated]
seed = 5
extent_m = [1600, 1600]
region_size_m = 20
[landscape.generated.undulation]
rms_height_m = 12
hurst = 0.6
longest_m = 400
shortest_m = 60
waves = 96
[sun]
azimuth_deg = 70
elevation_deg = 30
[vehicle]
max_speed_m_s = 200
[path]
file = "rough.csv"
[raster]
columns = 240
lines = 200
field_of_view_deg = [50, 42.5]
update_hz = 10
[lod]
order = 3
spacing_m = 10
levels = 3
ranges_m = [560, 1000, 1500]
"#;

fn rough() -> Scene {
    let scene = Scene::new();
    scene.write("rough.toml", ROUGH);
    scene.write(
        "rough.csv",
        "t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n0,800,810,580,0,-90,0\n2,800,810,540,0,-90,0\n",
    );
    scene
}

#[test]
fn levels_lose_ground_and_save_triangles() {
    let scene = rough();
    let words = ["study", "levels", "rough.toml", "--count", "2", "--repetitions", "1", "--no-progress"];
    let (out, _) = scene.expect(0, &[&words[..], &["--out", "found", "--json"]].concat());
    let told: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(
        (told["schema"].as_str(), &told["frames"]),
        (Some("lunoid.study-levels/1"), &serde_json::json!([5, 15]))
    );
    let ladders = told["ladders"].as_array().unwrap();
    assert_eq!(
        ladders.iter().map(|ladder| &ladder["name"]).collect::<Vec<_>>(),
        ["tolerance", "level-count", "one-level"]
    );
    let rungs = ladders[2]["rungs"].as_array().unwrap();
    let of = |rung: &Value, keys: [&str; 2]| rung[keys[0]][keys[1]].as_f64().unwrap();
    // The coarsest level has one cell a tile: whether it lies nearer than the next is chance.
    for (coarse, fine) in rungs[1..].iter().zip(&rungs[2..]) {
        assert!(coarse["triangles"].as_f64() < fine["triangles"].as_f64(), "{coarse} {fine}");
        assert!(of(coarse, ["pixels", "rms"]) > of(fine, ["pixels", "rms"]), "{coarse} {fine}");
    }
    assert_eq!(of(&rungs[5], ["metres", "worst"]), 0.0, "the finest level loses nothing");
    // Of all rungs that lose nothing, those with the fewest triangles are on the front, and no others.
    let all = ladders.iter().flat_map(|ladder| ladder["rungs"].as_array().unwrap());
    let whole: Vec<&Value> = all.filter(|rung| of(rung, ["pixels", "rms"]) == 0.0).collect();
    let triangles = |rung: &Value| rung["triangles"].as_f64().unwrap();
    let fewest = whole.iter().map(|rung| triangles(rung)).fold(f64::INFINITY, f64::min);
    for rung in whole {
        assert_eq!(rung["is_on_triangle_front"], Value::Bool(triangles(rung) == fewest), "{rung}");
    }
    for file in ["levels.json", "levels.csv", "levels.md", "levels-time.svg", "levels-triangles.png"] {
        assert!(scene.path().join("found").join(file).exists(), "{file}");
    }
}

#[test]
#[ignore = "long: .ci/long runs it"]
fn tracks_jump_where_levels_switch_and_not_where_they_morph() {
    let scene = rough();
    let words = ["study", "tracks", "rough.toml", "--only", "one-level", "--no-progress"];
    let (out, _) = scene.expect(0, &[&words[..], &["--out", "found", "--json"]].concat());
    let told: Value = serde_json::from_str(&out).unwrap();
    let way = |test: &str, name: &str| {
        let ways = told[test].as_array().unwrap().iter();
        ways.clone().find(|way| way["name"] == name).unwrap().clone()
    };
    let [switching, morphing] = ["switching", "morphing"].map(|name| way("held", name));
    assert!(switching["begun"].as_u64() > Some(40), "{switching}");
    assert!(
        switching["jumps"].as_u64() > Some(0) && switching["level_change_frames"].as_u64() > Some(0),
        "{switching}"
    );
    assert_eq!(morphing["jumps"].as_u64(), Some(0), "{morphing}");
    assert!(way("flown", "finest")["rms_px"].as_f64() < Some(0.5), "{told}");
    assert_eq!(told["ladders"][0]["rungs"].as_array().unwrap().len(), 6);
    for file in ["tracks.json", "tracks.csv", "tracks.md", "tracks.svg"] {
        assert!(scene.path().join("found").join(file).exists(), "{file}");
    }
}

#[test]
fn a_generator_without_levels_is_refused_with_those_that_have_some() {
    let scene = rough();
    for study in ["levels", "tracks"] {
        let (_, said) = scene.expect(2, &["study", study, "rough.toml", "--machine", "sampled"]);
        assert!(said.contains("it has no levels of detail") && said.contains("lod-mesh"), "{said}");
        let (_, said) = scene.expect(2, &["study", study, "rough.toml", "--only", "tolerances"]);
        assert!(
            said.contains("--only tolerances: no such ladder of levels; known: tolerance, level-count"),
            "{said}"
        );
    }
    let (_, said) = scene.expect(2, &["study", "tracks", "rough.toml", "--frames", "3"]);
    assert!(said.contains("--frames 3..4: one frame; expected at least two"), "{said}");
}

/// The judge is off by nothing against itself, and coarse ground by more than fine ground.
#[test]
fn frames_are_held_against_the_judge() {
    let scene = rough();
    let judged = |more: &[&str]| -> Vec<Value> {
        let words = ["study", "judge", "rough.toml", "--every", "15", "--no-progress", "--json"];
        let (out, _) = scene.expect(0, &[&words[..], more].concat());
        let told: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(told["schema"].as_str(), Some("lunoid.study-judge/1"));
        told["frames"].as_array().unwrap().clone()
    };
    let of = |frame: &Value, keys: [&str; 2]| frame[keys[0]][keys[1]].as_f64().unwrap();
    for frame in judged(&["--machine", "exact"]) {
        assert_eq!((of(&frame, ["metres", "worst"]), of(&frame, ["greys", "worst"])), (0.0, 0.0));
        assert_eq!((frame["pixels"].as_u64(), frame["outline"].as_u64()), (Some(240 * 200), Some(0)));
    }
    let (fine, coarse) = (judged(&["--set", "lod.levels=1", "--out", "found"]), judged(&[]));
    assert_eq!(fine.iter().map(|frame| frame["frame"].as_u64().unwrap()).collect::<Vec<_>>(), [0, 15]);
    for (fine, coarse) in fine.iter().zip(&coarse) {
        assert!(of(fine, ["metres", "rms"]) < 0.5 * of(coarse, ["metres", "rms"]), "{fine} {coarse}");
        assert!(of(fine, ["metres", "rms"]) > 0.0 && of(fine, ["greys", "worst"]) < 255.0, "{fine}");
    }
    for file in ["judge.json", "judge.csv", "judge.md", "judge.svg"] {
        assert!(scene.path().join("found").join(file).exists(), "{file}");
    }
    let (_, said) = scene.expect(2, &["study", "judge", "rough.toml", "--machine", "ideal"]);
    assert!(said.contains("draws no distances"), "{said}");
}

/// The last file that a study writes cannot be replaced, so none is written.
#[test]
fn a_study_looks_at_all_its_places_before_it_writes_one() {
    let scene = rough();
    for (study, last) in [
        ("levels", "levels-triangles.png"),
        ("tracks", "tracks.svg"),
        ("pops", "pops.png"),
        ("sea", "sea.png"),
    ] {
        let folder = scene.join(study);
        std::fs::create_dir_all(folder.join(last)).unwrap();
        let words = ["study", study, "rough.toml", "--no-progress", "--out", study];
        let (out, said) = scene.expect(4, &words);
        assert!(
            out.is_empty() && said.contains(last) && said.contains("this is a folder"),
            "{study}: {said}"
        );
        assert_eq!(std::fs::read_dir(folder).unwrap().count(), 1, "{study}");
    }
    scene.write("taken", "");
    let (_, said) = scene.expect(4, &["study", "levels", "rough.toml", "--out", "taken"]);
    assert!(said.contains("taken: this is a file, expected a folder"), "{said}");
}

/// The folder of a run has pictures, poses, range, distance, normal, label and light: a client reads them with NumPy alone.
#[test]
fn a_program_reads_a_run_without_us() {
    if !has("numpy") {
        return;
    }
    let scene = rough();
    scene.expect(
        0,
        &["replay", "rough.toml", "--frames", "0..2", "--no-page", "--truth", "all", "--out", "run"],
    );
    let client = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../docs/clients/read_run.py");
    let output = Command::new(python()).args(["-B", client]).arg(scene.join("run")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8(output.stdout).unwrap();
    let lines: Vec<&str> = said.lines().collect();
    assert_eq!(lines.len(), 2, "{said}");
    for (number, line) in lines.iter().enumerate() {
        let file = scene.join(&format!("run/frames/frame-{number:06}.png"));
        let picture = picture::read_png(file, &picture::Limits::default()).unwrap();
        let mean = picture.codes().iter().map(|code| f64::from(*code)).sum::<f64>() / (240.0 * 200.0);
        let told: f64 = line.split(' ').nth(4).unwrap().parse().unwrap();
        assert!((told - mean).abs() < 1e-9 && line.contains("(200, 240, 1)"), "{line} {mean}");
        for plane in ["range[200, 240]", "distance[200, 240]", "normal[200, 240, 3]", "label[200, 240]"] {
            assert!(line.contains(plane), "{line}");
        }
    }
}
