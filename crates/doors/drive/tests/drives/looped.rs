//! Loops: what was driven, saved and replayed, has the same pixels.

use std::fs;
use std::sync::Arc;

use drive::{Drive, EyePose, Loop};
use quantities::unit_interval;

use crate::scene::{FREE, Scene};

/// A window to port, for the scene through a channel.
const WINDOW: &str = "[[channel]]\nname = \"port\"\nheading_deg = -30\npitch_deg = 3\n";

/// A drive that turns, nods and rolls.
fn wild(step: u64, from: &EyePose) -> EyePose {
    let random = |key: u64| unit_interval(7, &[step, key]) - 0.5;
    EyePose {
        eye_m: [
            from.eye_m[0] + 1.5 * random(1),
            from.eye_m[1] + 1.5 * random(2),
            from.eye_m[2] + 0.1 * random(3),
        ],
        heading_deg: from.heading_deg + 260.0 * random(4),
        pitch_deg: 8.0 * random(5),
        roll_deg: 20.0 * random(6),
        ..*from
    }
}

/// Drives `steps` wild poses; the hashes, and the hashes of a replay of what was saved.
fn both(scene: &Scene, steps: u64) -> [Vec<String>; 2] {
    let drive = scene.drive();
    let mut driven = Loop::new(Arc::clone(&drive));
    let mut pose = drive.pose(0).unwrap();
    pose.eye_m[2] += 1.0;
    let mut hashes = Vec::new();
    for step in 0..steps {
        let seen = driven.look(&pose).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(seen.frame, step);
        hashes.push(seen.hash());
        pose = wild(step, &pose);
    }
    let saved = scene.folder.path().join("saved");
    driven.save(&saved).unwrap();
    let (replayed, _) = scene.run(&saved.join("scenario.toml"), None);
    [hashes, replayed]
}

/// Past the path, with rocks that lie along it: they stay where they were.
#[test]
fn a_loop_saved_and_replayed_has_the_same_pixels() {
    for machine in ["ideal", "pra-parts", "modern-analog", "exact", "lunsim", "sampled"] {
        let [looked, replayed] = both(&Scene::new("", &FREE).by(machine), 9);
        assert_eq!(looked, replayed, "{machine}");
    }
}

/// Storage tube, phosphor and two fields remember; so do drums and a sampler that shows the frame before.
#[test]
fn machines_with_memory_remember_what_was_driven() {
    for machine in ["pra-frugal", "pra-nominal", "pra-overloaded"] {
        let scene = Scene::new("", &[]).by(machine);
        assert!(scene.drive().remembers_frames());
        let [looked, replayed] = both(&scene, 8);
        assert_eq!(looked, replayed, "{machine}");
    }
    for overload in ["'late'", "'extend'"] {
        let scene = Scene::new("", &[("sampled.overload", overload)]).by("sampled");
        assert!(scene.drive().remembers_frames());
        let [looked, replayed] = both(&scene, 9);
        assert_eq!(looked, replayed, "{overload}");
    }
}

/// What cannot be drawn is not remembered: the loop goes on as if nobody had asked for it, whether it goes back to the start or not.
#[test]
fn a_pose_that_cannot_be_drawn_leaves_no_trace_in_the_memory() {
    let scene = Scene::new("", &[]).by("pra-overloaded");
    let drive = scene.drive();
    let start = drive.pose(0).unwrap();
    let poses: Vec<EyePose> = (0..6).map(|step| wild(step, &start)).collect();
    let upside_down = EyePose { pitch_deg: 89.0, ..start };
    let mut smooth = Loop::new(Arc::clone(&drive));
    let mut disturbed = Loop::new(Arc::clone(&drive));
    for pose in &poses {
        disturbed.look(&upside_down).unwrap_err();
        assert_eq!(disturbed.look(pose).unwrap().hash(), smooth.look(pose).unwrap().hash());
    }
    // A branch from the middle remembers what it has driven, and nothing of the loop that went on.
    let mut branch = Loop::after(Arc::clone(&drive), &poses[..3]).unwrap();
    let mut other = Loop::new(drive);
    poses[..3].iter().for_each(|pose| drop(other.look(pose).unwrap()));
    assert_eq!(branch.look(&poses[5]).unwrap().hash(), other.look(&poses[5]).unwrap().hash());
}

/// A frame that fails while it is drawn was not driven: the memory has the frame that is drawn in its place.
#[test]
fn a_frame_that_fails_is_not_remembered() {
    let mut scene = Scene::new("[shadows]\n", &[]).by("pra-overloaded");
    let start = scene.drive().pose(0).unwrap();
    let poses: Vec<EyePose> = (0..4).map(|step| wild(step, &start)).collect();
    let mut smooth = Loop::new(scene.drive());
    let hashes: Vec<String> = poses.iter().map(|pose| smooth.look(pose).unwrap().hash()).collect();
    let cache = scene.folder.path().join("cache");
    scene.wishes.shadow_cache = Some(cache.clone());
    let mut disturbed = Loop::new(scene.drive());
    for (number, (pose, hash)) in poses.iter().zip(hashes).enumerate() {
        // No boundary can be kept where a file is in the way, and elsewhere the boundaries are others.
        let [x, y, z] = start.eye_m;
        let elsewhere = EyePose { eye_m: [x + 30.0 * number as f64, y, z + 9.0], ..start };
        fs::remove_dir_all(&cache).unwrap();
        fs::write(&cache, "in the way").unwrap();
        assert!(disturbed.look(&elsewhere).is_err(), "step {number}");
        fs::remove_file(&cache).unwrap();
        fs::create_dir(&cache).unwrap();
        assert_eq!(disturbed.look(pose).unwrap().hash(), hash);
    }
}

/// The memory is in the pixels: the same pose after another drive is another picture.
#[test]
fn memory_shows() {
    let scene = Scene::new("", &[]).by("pra-overloaded");
    let drive = scene.drive();
    let start = drive.pose(0).unwrap();
    let last = |turn: f64| {
        let mut driven = Loop::new(Arc::clone(&drive));
        driven.look(&EyePose { heading_deg: start.heading_deg + turn, ..start }).unwrap();
        driven.look(&start).unwrap().hash()
    };
    assert_ne!(last(0.0), last(40.0));
    let error = drive.look(0, &start).unwrap_err();
    assert_eq!(error.faults()[0].help.as_deref(), Some("look in a loop, which keeps what was driven"));
}

#[test]
fn the_yoke_follows_from_the_first_frame() {
    let scene = Scene::new("[roll]\ndisplay = \"yoke\"\n", &[]).by("pra-parts");
    let [looked, replayed] = both(&scene, 8);
    assert_eq!(looked, replayed);
    let drive = scene.drive();
    let mut driven = Loop::new(Arc::clone(&drive));
    let level = EyePose { roll_deg: 0.0, ..drive.pose(0).unwrap() };
    let rolled = EyePose { roll_deg: 15.0, ..level };
    assert_eq!(driven.look(&level).unwrap().pose.yoke_deg, 0.0);
    let yoke = driven.look(&rolled).unwrap().pose.yoke_deg;
    assert!(0.0 < yoke && yoke < 10.0, "the yoke is on its way: {yoke}");
}

#[test]
fn a_channel_is_looked_through() {
    let scene = Scene::new(WINDOW, &[]);
    let mut wishes = scene.wishes.clone();
    wishes.channel = Some("port".into());
    let scene = Scene { wishes, ..scene };
    let [looked, replayed] = both(&scene, 4);
    assert_eq!(looked, replayed);
    // The pose is that of the vehicle, not of its window.
    let plain = Scene::new("", &[]).drive().pose(1).unwrap();
    assert!((scene.drive().pose(1).unwrap().heading_deg - plain.heading_deg).abs() < 1e-9);
}

#[test]
fn a_look_from_a_pose_of_the_path_is_its_frame_but_for_the_rounding_of_degrees() {
    let drive = Scene::new("", &[]).drive();
    let [frame, look] = [drive.frame(2).unwrap(), drive.look(2, &drive.pose(2).unwrap()).unwrap()];
    let codes = |seen: &drive::Seen| seen.picture.grey().unwrap().codes().to_vec();
    let (a, b) = (codes(&frame), codes(&look));
    assert!(a.iter().zip(&b).all(|(a, b)| a.abs_diff(*b) <= 1));
    assert!(a.iter().any(|code| *code > 20) && a.contains(&0));
}

#[test]
fn ahead_stands_on_the_ground() {
    let drive: Arc<Drive> = Scene::new("", &[]).drive();
    let mut driven = Loop::new(Arc::clone(&drive));
    let mut pose = drive.pose(0).unwrap();
    for step in 0..5 {
        let next = driven.ahead(&pose, 0.5).unwrap();
        let [north, east] = [0, 1].map(|axis| next.eye_m[axis] - pose.eye_m[axis]);
        let way = (north * north + east * east).sqrt();
        assert!((way - 0.5).abs() < 1e-9 && (next.heading_deg - pose.heading_deg).abs() < 1e-9);
        assert_eq!(next.time_s, f64::from(step) / 10.0);
        driven.look(&next).unwrap();
        pose = next;
    }
    // As a path over the same place has it.
    let (x, y) = (pose.eye_m[0], pose.eye_m[1]);
    let keyframes = format!("[{{ t_s = 0, x_m = {x}, y_m = {y}, heading_deg = {} }}]", pose.heading_deg);
    let there = Scene::new("", &[("scenario.path.keyframes", &keyframes)]).drive().pose(0).unwrap();
    assert!((there.eye_m[2] - pose.eye_m[2]).abs() < 1e-9 && (there.pitch_deg - pose.pitch_deg).abs() < 1e-9);
}
