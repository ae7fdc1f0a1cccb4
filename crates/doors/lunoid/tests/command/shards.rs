use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::scene::{Scene, lunoid};

/// Every file below a folder but the wall times.
fn content(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if !path.ends_with("performance.json") {
                let name = path.strip_prefix(folder).unwrap().display().to_string();
                found.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    found
}

fn expect_equal(scene: &Scene, one: &str, other: &str) {
    let [one, other] = [one, other].map(|folder| content(&scene.join(folder)));
    let differ: Vec<_> =
        one.keys().chain(other.keys()).filter(|name| one.get(*name) != other.get(*name)).collect();
    assert!(differ.is_empty() && one.contains_key("run.json"), "{differ:?}");
}

#[test]
fn shards_with_page_truth_film_and_plots_are_the_run_of_one_machine() {
    let scene = Scene::new();
    let wishes = ["--apng", "--truth", "range,pose", "--probe", "1:20", "--probe", "3:7", "--depth", "16"];
    let replay = |rest: &[&str]| {
        scene.expect(0, &[&["replay", "tiny.toml", "--machine", "pra-nominal"], &wishes[..], rest].concat())
    };
    replay(&["--out", "whole"]);
    for number in ["1/3", "2/3", "3/3"] {
        replay(&["--shard", number]);
    }
    let shards = ["runs/tiny-shard-3-of-3", "runs/tiny-shard-1-of-3", "runs/tiny-shard-2-of-3"];
    let (out, _) = scene.expect(0, &[&["merge"], &shards[..], &["--out", "joined"]].concat());
    assert_eq!(out, "joined: frames 0..4 of 3 folders\n  ground truth of 4 frames\nopen joined/index.html\n");
    expect_equal(&scene, "whole", "joined");
    // A replay into the joined folder has nothing to do, and changes nothing.
    let (out, _) = replay(&["--out", "joined"]);
    assert!(out.starts_with("joined: frames 0..4, all there already"), "{out}");
    expect_equal(&scene, "whole", "joined");
    // A shard goes on in its folder.
    fs::remove_file(scene.join("runs/tiny-shard-2-of-3/frames/frame-000001.png")).unwrap();
    let (out, _) = replay(&["--shard", "2/3"]);
    assert!(out.contains("frames 1..2, 1 drawn now"), "{out}");
}

#[test]
fn every_gap_has_the_command_that_fills_it() {
    let scene = Scene::new();
    let wishes = ["replay", "tiny.toml", "--set", "raster.sweeps=30", "--refresh", "--no-page"];
    scene.expect(0, &[&wishes[..], &["--out", "whole"]].concat());
    for number in ["2/4", "4/4"] {
        scene.expect(0, &[&wishes[..], &["--shard", number]].concat());
    }
    let shards = ["runs/tiny-shard-2-of-4", "runs/tiny-shard-4-of-4"];
    let (out, _) = scene.expect(1, &[&["merge"], &shards[..], &["--out", "joined"]].concat());
    assert_eq!(out.matches(" are missing; this makes them:\n  lunoid replay tiny.toml ").count(), 2, "{out}");
    assert!(!scene.join("joined").exists());
    let (out, _) = scene.expect(1, &[&["merge"], &shards[..], &["--out", "joined", "--json"]].concat());
    let document: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&document["schema"], &document["joined"]), (&"lunoid.merge/1".into(), &false.into()));
    let mut folders = shards.map(str::to_owned).to_vec();
    for gap in document["gaps"].as_array().unwrap() {
        let command = gap["command"].as_str().unwrap();
        let words: Vec<&str> = command.split(' ').skip(1).collect();
        scene.expect(0, &words);
        folders.push((*words.last().unwrap()).to_owned());
    }
    let folders: Vec<&str> = folders.iter().map(String::as_str).collect();
    let (out, _) = scene.expect(0, &[&["merge"], &folders[..], &["--out", "joined", "--json"]].concat());
    let document: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&document["joined"], &document["frames"]), (&true.into(), &serde_json::json!([0, 4])));
    expect_equal(&scene, "whole", "joined");
}

#[test]
fn shards_that_there_are_not_are_refused() {
    let scene = Scene::new();
    let refused = |arguments: &[&str]| scene.expect(2, &[&["replay", "tiny.toml"], arguments].concat()).1;
    let said = refused(&["--shard", "5/4"]);
    assert!(said.contains("expected K/N with 1 <= K <= N, as 3/7, or auto, not `5/4`"), "{said}");
    let said = refused(&["--shard", "2/5"]);
    assert!(said.contains("--shard 2/5: the run has 4 frames, expected at most as many shards"), "{said}");
    let said = refused(&["--shard", "1/2", "--check", "3"]);
    assert!(said.contains("cannot be used with"), "{said}");
    let said = refused(&["--shard", "1/2", "--machine", "ideal", "--machine", "exact"]);
    assert!(said.contains("--shard: this belongs to one run"), "{said}");
    let said = refused(&["--shard", "auto"]);
    assert!(
        said.contains("--shard auto: found neither SLURM_ARRAY_TASK_ID nor JOB_COMPLETION_INDEX"),
        "{said}"
    );
    assert_eq!(scene.list("."), ["tiny.toml"]);
}

#[test]
fn costs_cut_where_the_time_is() {
    let scene = Scene::new();
    let costs = |seconds: [f64; 4]| {
        let frames: Vec<(u64, f64)> = (0..).zip(seconds).collect();
        let document = serde_json::json!({ "schema": "lunoid.performance/1", "frames_s": frames });
        fs::create_dir_all(scene.join("costs")).unwrap();
        scene.write("costs/performance.json", document.to_string());
    };
    costs([3.0, 1.0, 1.0, 1.0]);
    for number in ["1/2", "2/2"] {
        scene.expect(0, &["replay", "tiny.toml", "--no-page", "--shard", number, "--costs", "costs"]);
    }
    assert_eq!(scene.list("runs/tiny-shard-1-of-2/frames"), ["frame-000000.png"]);
    scene.expect(0, &["merge", "runs/tiny-shard-1-of-2", "runs/tiny-shard-2-of-2", "-o", "joined"]);
    scene.expect(0, &["replay", "tiny.toml", "--no-page", "--out", "whole"]);
    expect_equal(&scene, "whole", "joined");
    // The times of a run as a replay writes them.
    scene.expect(
        0,
        &["replay", "tiny.toml", "--no-page", "--shard", "2/3", "--costs", "whole", "--out", "other"],
    );
    scene.write("whole/performance.json", "{}");
    let (_, said) = scene.expect(3, &["replay", "tiny.toml", "--shard", "1/3", "--costs", "whole"]);
    assert!(said.contains("whole/performance.json: it has no list `frames_s`"), "{said}");
    costs([1.0, f64::NAN, 1.0, 1.0]);
    let (_, said) = scene.expect(3, &["replay", "tiny.toml", "--shard", "1/3", "--costs", "costs"]);
    assert!(said.contains("costs/performance.json"), "{said}");
}

#[test]
fn a_cluster_names_the_shard() {
    let scene = Scene::new();
    let run = |variables: &[(&str, &str)]| {
        let mut command = lunoid();
        command.current_dir(scene.path()).args(["replay", "tiny.toml", "--shard", "auto", "--no-page"]);
        command.envs(variables.iter().copied()).assert().success();
    };
    run(&[
        ("SLURM_ARRAY_TASK_ID", "2"),
        ("SLURM_ARRAY_TASK_MIN", "1"),
        ("SLURM_ARRAY_TASK_MAX", "2"),
        ("SLURM_ARRAY_TASK_COUNT", "2"),
    ]);
    run(&[("JOB_COMPLETION_INDEX", "0"), ("LUNOID_SHARDS", "2")]);
    assert_eq!(scene.list("runs"), ["tiny-shard-1-of-2", "tiny-shard-2-of-2"]);
    scene.expect(0, &["merge", "runs/tiny-shard-1-of-2", "runs/tiny-shard-2-of-2", "-o", "joined"]);
    scene.expect(0, &["replay", "tiny.toml", "--no-page", "--out", "whole"]);
    expect_equal(&scene, "whole", "joined");
}

#[test]
fn two_runs_are_not_joined_and_a_page_needs_its_scenario() {
    let scene = Scene::new();
    scene.expect(0, &["replay", "tiny.toml", "--shard", "1/2"]);
    scene.expect(0, &["replay", "tiny.toml", "--shard", "2/2", "--machine", "pra-nominal"]);
    let merge = ["merge", "runs/tiny-shard-1-of-2", "runs/tiny-shard-2-of-2", "--out", "joined"];
    let (_, said) = scene.expect(3, &merge);
    assert!(
        said.contains(
            "runs/tiny-shard-1-of-2/run.json and runs/tiny-shard-2-of-2/run.json are not of one run"
        ),
        "{said}"
    );
    scene.expect(0, &["replay", "tiny.toml", "--shard", "2/2", "--fresh"]);
    fs::rename(scene.join("tiny.toml"), scene.join("gone.toml")).unwrap();
    let (_, said) = scene.expect(3, &merge);
    assert!(said.contains("its scenario cannot be read") && said.contains("--no-page"), "{said}");
    assert!(!scene.join("joined").exists());
    let (out, _) = scene.expect(0, &[&merge[..], &["--no-page"]].concat());
    assert!(out.ends_with("open joined/contact-sheet.png\n"), "{out}");
}

#[test]
fn timing_records_of_shards_are_that_of_one_machine() {
    let scene = Scene::new();
    let record = |rest: &[&str]| {
        let words = ["timing", "record", "tiny.toml", "--machine", "pra-nominal", "--no-progress"];
        scene.expect(0, &[&words[..], rest].concat());
    };
    record(&["--frames", "0..4", "--out", "whole.json"]);
    for number in ["1", "2", "3"] {
        let (shard, file) = (format!("{number}/3"), format!("{number}.json"));
        record(&["--frames", "0..4", "--shard", &shard, "--out", &file]);
    }
    scene.expect(0, &["merge", "3.json", "1.json", "2.json", "--out", "joined.json"]);
    let [whole, joined] = ["whole.json", "joined.json"].map(|name| fs::read(scene.join(name)).unwrap());
    assert!(whole == joined, "they differ");
    let (out, _) = scene.expect(1, &["merge", "3.json", "1.json", "--out", "part.json"]);
    assert!(out.contains("frames 1..2 are missing"), "{out}");
    assert!(!scene.join("part.json").exists());
}

#[test]
fn cartridges_sweeps_and_seeds_are_shared_out() {
    let scene = Scene::new();
    let lockstep = |rest: &[&str]| {
        let (out, _) = scene.expect(0, &[&["lockstep", "--json", "--frame", "1"], rest].concat());
        serde_json::from_str::<Value>(&out).unwrap()["sweeps"].as_u64().unwrap()
    };
    let part = |shard: &str| lockstep(&["tiny.toml", "--every", "8", "--shard", shard]);
    assert_eq!((lockstep(&["tiny.toml", "--every", "8"]), part("1/2"), part("2/2")), (5, 2, 3));
    let (out, _) = scene.expect(0, &["lockstep", "--random", "5", "--seed", "3", "--shard", "2/2"]);
    assert!(out.contains("random scenes of seeds 5..8 in"), "{out}");
    let (_, said) = scene.expect(2, &["lockstep", "--random", "5", "--shard", "2/6"]);
    assert!(said.contains("--shard 2/6: there are 5 seeds, expected at most as many shards"), "{said}");
    let run = |rest: &[&str]| {
        let words = ["cartridge", "run", "one-coefficient*", "--json"];
        let (out, _) = scene.expect(0, &[&words[..], rest].concat());
        let document: Value = serde_json::from_str(&out).unwrap();
        let name = |cartridge: &Value| cartridge["name"].as_str().unwrap().to_owned();
        document["cartridges"].as_array().unwrap().iter().map(name).collect::<Vec<_>>()
    };
    assert_eq!([run(&["--shard", "1/2"]), run(&["--shard", "2/2"])].concat(), run(&[]));
}

#[test]
fn a_study_says_why_it_has_no_shards() {
    let scene = Scene::new();
    for (study, why) in [
        ("error", "times of two workers cannot be"),
        ("economy", "times of two workers cannot be"),
        ("pops", "a pop lies between two frames"),
        ("levels", "times of two workers cannot be"),
        ("tracks", "a track goes through all frames"),
        ("lights", "it has one table of all frames"),
        ("sea", "a spectrum goes through all frames"),
        ("shadow", "its largest error is over all places"),
    ] {
        let (_, said) = scene.expect(2, &["study", study, "tiny.toml", "--shard", "1/2"]);
        assert!(said.contains(&format!("study {study} --shard 1/2: this study has no shards")), "{said}");
        assert!(said.contains(why), "{said}");
    }
    let (_, said) = scene.expect(2, &["study", "stability", "--shard", "auto"]);
    assert!(said.contains("its table has the time of each method"), "{said}");
}
