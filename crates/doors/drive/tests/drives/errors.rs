//! One error with all faults; nothing is driven by a pose that is refused.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use drive::{Drive, DriveError, EyePose, Loop, Wishes};

use crate::scene::{SCENARIO, Scene};

fn refused<T>(result: Result<T, DriveError>) -> DriveError {
    result.err().expect("it is refused")
}

#[test]
fn a_scenario_with_three_faults_tells_all_with_their_lines() {
    let scene = Scene::new("", &[]);
    let text = SCENARIO.replace("seed = 3", "seed = -3").replace("start_m = 2", "start_m = \"two\"");
    let text = text.replace("elevation_deg = 15", "elevation_deg = 15\nstray = 1");
    fs::write(scene.path(), &text).unwrap();
    let faults = refused(Drive::open(&scene.path(), &scene.wishes, 1)).faults();
    assert_eq!(faults.len(), 3, "{faults:?}");
    for (fault, word) in faults.iter().zip(["seed = -3", "stray", "two"]) {
        let line = fault.line.expect("each has its line");
        assert!(text.lines().nth(line - 1).unwrap().contains(word), "{fault:?}");
        assert!(fault.file.ends_with("scene.toml") && fault.expected.is_some(), "{fault:?}");
    }
}

/// The scenario, the tables of generators in its file and the hardware model are read side by side.
#[test]
fn faults_of_scenario_generators_and_model_are_told_at_once() {
    let keys = |scene: &Scene| -> Vec<String> {
        let faults = refused(Drive::open(&scene.path(), &scene.wishes, 1)).faults();
        faults.into_iter().filter_map(|fault| fault.key).collect()
    };
    let tables = "[sampled]\noverload = \"never\"\n[lunsim]\nfly = 1\n";
    let scene = Scene::new(tables, &[]);
    let text = fs::read_to_string(scene.path()).unwrap();
    fs::write(scene.path(), text.replace("seed = 3", "seed = -3")).unwrap();
    assert_eq!(keys(&scene), ["landscape.generated.seed", "sampled.overload", "lunsim.fly"]);
    let of_model = Scene::new(tables, &[("loader.axes_ns", "3"), ("cpu.axes_ns", "3")]);
    let mut keys = keys(&of_model);
    keys.sort();
    assert_eq!(keys, ["cpu.axes_ns", "loader.axes_ns", "lunsim.fly", "sampled.overload"]);
}

#[test]
fn what_is_asked_wrongly_is_refused() {
    let drive = Scene::new("", &[]).drive();
    let pose = drive.pose(0).unwrap();
    let cases = [
        refused(Drive::open(Path::new("no/such.toml"), &Wishes::default(), 1)),
        refused(drive.frame(4)),
        refused(drive.pose(u64::MAX)),
        refused(drive.truth(0, "range,deep")),
        refused(drive.truth(0, "range, pose")),
        refused(drive.probe(&["zz.*".into()], 0, 0..1)),
        refused(drive.probe(&["tg.*".into()], 0, 3..3)),
        refused(drive.probe(&["tg.*".into()], 0, 39..41)),
        refused(drive.explain(0, [40, 0])),
        refused(drive.study(&["nothing".into()], &mut || true)),
        refused(drive.look(0, &EyePose { roll_deg: 30.0, yoke_deg: 30.0, ..pose })),
        refused(drive.look(0, &EyePose { time_s: 1e300, ..pose })),
    ];
    let words = [
        "such.toml",
        "frame 4",
        "frame",
        "deep",
        "pose",
        "zz.*",
        "3..3",
        "39..41",
        "40,0",
        "nothing",
        "no deflection yoke",
        "1e300\n",
    ];
    assert_eq!(cases.len(), words.len());
    for (error, word) in cases.iter().zip(words) {
        assert!(error.to_string().contains(word), "{error}");
    }
    assert_eq!(cases[1].faults()[0].found.as_deref(), Some("4"));
}

#[test]
fn a_refused_pose_is_not_driven() {
    for machine in ["ideal", "pra-overloaded"] {
        let scene = Scene::new("", &[]).by(machine);
        let drive = scene.drive();
        let good = drive.pose(0).unwrap();
        let mut driven = Loop::new(Arc::clone(&drive));
        let bad = [
            EyePose { heading_deg: f64::NAN, ..good },
            EyePose { eye_m: [f64::INFINITY, 0.0, 0.0], ..good },
            EyePose { eye_m: [100.0, 200.0, -500.0], ..good },
            EyePose { eye_m: [-9000.0, 200.0, 10.0], ..good },
            EyePose { pitch_deg: 170.0, ..good },
        ];
        for pose in &bad {
            refused(driven.look(pose));
        }
        assert_eq!(driven.frames(), 0);
        refused(driven.save(&scene.folder.path().join("none")));
        let first = driven.look(&good).unwrap().hash();
        for pose in &bad {
            refused(driven.look(pose));
        }
        let second = driven.look(&good).unwrap().hash();
        let mut clean = Loop::new(Arc::clone(&drive));
        assert_eq!([first, second], [0, 1].map(|_| clean.look(&good).unwrap().hash()));
        refused(driven.ahead(&good, f64::NAN));
        refused(driven.ahead(&good, 1e6));
    }
}

#[test]
fn nothing_is_written_over() {
    let scene = Scene::new("", &[]);
    let drive = scene.drive();
    let mut driven = Loop::new(Arc::clone(&drive));
    driven.look(&drive.pose(0).unwrap()).unwrap();
    let error = refused(driven.save(scene.folder.path()));
    assert!(error.to_string().contains("there already"), "{error}");
    driven.save(&scene.folder.path().join("new")).unwrap();
    let names = fs::read_dir(scene.folder.path()).unwrap().map(|entry| entry.unwrap().file_name());
    assert_eq!(names.count(), 2, "no half-written folder stays");
}
