//! Samples: each is the look of a drive at its pose, whoever made it and with whom.

use std::collections::BTreeMap;
use std::fs;

use dataset::{Maker, Plan, read_array};
use drive::{Codes, Drive, EyePose, Wishes};
use files::NpyData;

use crate::scene::{PLAN, Scene, files, rows};

fn codes(data: &NpyData) -> &[u8] {
    match data {
        NpyData::U8(codes) => codes,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_sample_alone_is_that_of_the_whole() {
    let scene = Scene::new(PLAN);
    let whole = files(&scene.make_all("whole"));
    for sample in [0, 4, 8] {
        scene.make("alone", sample..sample + 1).unwrap();
        let alone = files(&scene.path("alone"));
        let (name, bytes) = alone.iter().find(|(name, _)| name.ends_with(".npz")).expect("a sample");
        assert!(whole[name] == *bytes, "{name}");
        let line = String::from_utf8(alone["manifest.jsonl"].clone()).unwrap();
        assert!(String::from_utf8_lossy(&whole["manifest.jsonl"]).contains(line.trim()), "{line}");
        fs::remove_dir_all(scene.path("alone")).unwrap();
    }
}

#[test]
fn a_sample_is_the_look_of_a_drive_at_its_pose() {
    let scene = Scene::new(PLAN);
    let plan = scene.plan();
    let folder = scene.make_all("whole");
    for row in rows(&folder) {
        let wanted = plan.wanted(row.sample);
        let set = plan.set.iter().chain(&wanted.drawn).cloned().collect();
        let overlays = if row.fault == "coarse" { vec!["coarse".into()] } else { Vec::new() };
        let wishes = Wishes { set, overlays, ..Wishes::default() };
        let drive = Drive::open(&scene.path("scene.toml"), &wishes, 1).unwrap();
        let pose = EyePose {
            time_s: row.pose.time_s,
            eye_m: [row.pose.x_m, row.pose.y_m, row.pose.z_m],
            heading_deg: row.pose.heading_deg,
            pitch_deg: row.pose.pitch_deg,
            roll_deg: row.pose.roll_deg,
            yoke_deg: row.pose.yoke_deg,
        };
        let view = drive.from_pose(row.frame, &pose).unwrap();
        let seen = view.draw().unwrap();
        assert_eq!(seen.hash(), row.pixels_blake3, "sample {}", row.sample);
        assert_eq!(seen.counts.get("late_words"), row.counts.get("late_words").copied());
        let path = folder.join(&row.file.file);
        let picture = read_array(&path, "picture").unwrap();
        let drawn: Vec<u8> = seen.picture.grey().unwrap().codes().iter().map(|code| *code as u8).collect();
        assert_eq!(codes(picture.data()), drawn);
        assert_eq!(picture.shape(), row.shape);
        for plane in view.truth("range,label").unwrap().planes {
            let kept = read_array(&path, plane.name).unwrap();
            match (&plane.values, kept.data()) {
                (Codes::Numbers(one), NpyData::F32(other)) => assert_eq!(one, other),
                (Codes::Codes(one), NpyData::U8(other)) => assert_eq!(one, other),
                (one, other) => panic!("{one:?} {other:?}"),
            }
        }
        assert_eq!(
            row.sun_deg.map(f64::round),
            [&wanted.drawn[0], &wanted.drawn[1]].map(|(_, value)| value.parse::<f64>().unwrap().round())
        );
    }
}

#[test]
fn faults_are_labels() {
    let scene = Scene::new(PLAN);
    let folder = scene.make_all("whole");
    let (mut changed, mut all_late) = (BTreeMap::<String, u64>::new(), 0);
    for row in rows(&folder) {
        let plane = read_array(&folder.join(&row.file.file), "changed").unwrap();
        let sum = codes(plane.data()).iter().map(|code| u64::from(*code)).sum::<u64>();
        assert_eq!(Some(sum), row.changed);
        let late = row.counts["late_words"];
        match row.fault.as_str() {
            "none" => assert_eq!((sum, late), (0, 0)),
            "tear" => {
                assert!(row.drawn["loader.access_ns"].as_f64().unwrap() >= 3000.0);
                all_late += late;
            }
            _ => assert!(!row.drawn.contains_key("loader.access_ns")),
        }
        *changed.entry(row.fault).or_default() += sum;
        let labels = row.labels.expect("asked for");
        assert_eq!(labels.values().sum::<u64>(), (row.shape[0] * row.shape[1]) as u64);
    }
    assert!(changed["coarse"] > 0 && all_late > 0, "{changed:?} {all_late}");
}

#[test]
fn the_pixels_that_changed_are_those_of_the_healthy_machine() {
    let scene = Scene::new(PLAN);
    let plan = scene.plan();
    let made = Maker::new(&plan).make(2).unwrap();
    assert!(made.row.fault == "coarse" && made.row.changed > Some(0));
    let wanted = plan.wanted(2);
    let set = plan.set.iter().chain(&wanted.drawn[..wanted.healthy]).cloned().collect();
    let drive = Drive::open(&scene.path("scene.toml"), &Wishes { set, ..Wishes::default() }, 1).unwrap();
    let pose = made.row.pose;
    let place = drive::Place { at_m: [pose.x_m, pose.y_m], heading_deg: pose.heading_deg, flight: None };
    let healthy = drive.look(0, &drive.place(0, &place).unwrap()).unwrap();
    let healthy = healthy.picture.grey().unwrap().codes().to_vec();
    let array = |name: &str| codes(made.arrays.iter().find(|(found, _)| *found == name).unwrap().1.data());
    for ((found, healthy), changed) in array("picture").iter().zip(healthy).zip(array("changed")) {
        assert_eq!(u16::from(*found) != healthy, *changed == 1);
    }
}

#[test]
fn a_vehicle_that_flies_is_drawn_again_while_its_eye_is_in_the_ground() {
    let flown =
        "heading_deg = [0, 360]\nz_m = [-12, 12]\npitch_deg = [-40, -5]\nroll_deg = [0, 0]\nframes = [1, 3]";
    let scene = Scene::new(&PLAN.replace("heading_deg = [0, 360]", flown));
    let plan = scene.plan();
    let maker = Maker::new(&plan);
    let rows: Vec<_> = (0..plan.samples()).map(|sample| maker.make(sample).unwrap().row).collect();
    let under: u32 = rows.iter().filter_map(|row| row.refused.get("under-ground")).sum();
    assert!(under > 0, "no eye was in the ground");
    for row in rows {
        assert!((-40.0..=-5.0).contains(&row.pose.pitch_deg) && (1..=3).contains(&row.frame), "{row:?}");
        assert!((row.pose.time_s - row.frame as f64 / 10.0).abs() < 1e-12, "{row:?}");
    }
}

#[test]
fn steep_ground_and_the_edge_are_drawn_again_and_counted() {
    let text = PLAN.replace("x_m = [20, 380]", "x_m = [-100, 400]");
    let text = text.replace("lines=30\"]", "lines=30\", \"scenario.vehicle.max_slope_deg=1.5\"]");
    let scene = Scene::new(&text);
    let plan = Plan { draws: 1, ..scene.plan() };
    let maker = Maker::new(&plan);
    let mut refused: BTreeMap<String, u32> = BTreeMap::new();
    for sample in 0..plan.samples() {
        for (reason, count) in maker.make(sample).unwrap().row.refused {
            *refused.entry(reason).or_default() += count;
        }
    }
    let has = |reason: &str| refused.get(reason).is_some_and(|count| *count > 0);
    assert!(has("steep") && has("outside") && has("split") && has("reach"), "{refused:?}");
}

#[test]
fn a_plan_without_a_pose_is_refused_with_its_reasons() {
    let far = PLAN.replace("x_m = [20, 380]", "x_m = [5000, 6000]");
    let said = Maker::new(&Scene::new(&far).plan()).make(0).expect_err("outside").to_string();
    assert!(said.contains("sample 0: none of 10000 poses") && said.contains("outside"), "{said}");
    let wide = PLAN.replace("block_m = 80\nreach_m = 15", "block_m = 20\nreach_m = 80");
    let said = Maker::new(&Scene::new(&wide).plan()).make(0).expect_err("no block is clear").to_string();
    assert!(said.contains("reach") && said.contains("smaller"), "{said}");
}
