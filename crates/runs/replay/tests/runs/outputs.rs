use std::fs;
use std::time::Instant;

use picture::{Depth, Limits, read_png};
use quantities::Rate;
use replay::{HeldRun, Outcome, Phases, Pictures, ReplayError, RunFolder, write_y4m};
use run_record::FileRecord;
use tempfile::tempdir;

use crate::stage::{Wish, content, document};

fn pictures(depth: Depth, refresh: bool, film: bool) -> Wish {
    Wish { pictures: Pictures { depth, colour: false, refresh, film }, frames: 0..3, ..Wish::default() }
}

#[test]
fn the_record_lists_every_file_with_its_hash() {
    let at = tempdir().unwrap();
    pictures(Depth::Eight, false, true).run(at.path()).unwrap();
    let run = HeldRun::read(at.path()).unwrap();
    let listed = run.frames.iter().flat_map(|frame| &frame.files).chain(&run.outputs);
    let mut names: Vec<String> = listed.map(|file| file.file.clone()).collect();
    for file in run.frames.iter().flat_map(|frame| &frame.files).chain(&run.outputs) {
        assert_eq!(run_record::file_hash(&at.path().join(&file.file)).unwrap(), file.blake3, "{}", file.file);
    }
    names.push("run.json".into());
    names.sort();
    assert_eq!(content(at.path()).into_keys().collect::<Vec<_>>(), names);
    for frame in &run.frames {
        let picture = read_png(at.path().join(&frame.files[0].file), &Limits::default()).unwrap();
        assert_eq!(picture.pixel_hash(), frame.pixels_blake3);
        assert_eq!((frame.counts["sweeps"], frame.counts["samples"]), (40, 3200));
    }
    assert_eq!(document(&run)["totals"]["samples"], 9600);
    assert_eq!(document(&run)["settings"]["clocks"]["sample"], "32000 Hz");
    assert_eq!(document(&run)["view"]["laws"]["projection"], "exact");
    assert_eq!(document(&run)["ground"]["generator"]["seed"], 3);
    assert_eq!(document(&run)["omissions"][0]["weight"], "lossless");
}

#[test]
fn no_clock_and_no_threads_in_the_record() {
    let at = tempdir().unwrap();
    pictures(Depth::Eight, false, false).run(at.path()).unwrap();
    let performance: serde_json::Value =
        serde_json::from_slice(&fs::read(at.path().join("performance.json")).unwrap()).unwrap();
    assert_eq!(performance["threads"], 2);
    assert_eq!(performance["frames_drawn"], 3);
    assert!(performance["samples_per_s"].as_f64().unwrap() > 0.0);
    let record = fs::read_to_string(at.path().join("run.json")).unwrap();
    for word in ["threads", "seconds", "per_s\"", at.path().to_str().unwrap()] {
        assert!(!record.contains(word), "{word}");
    }
}

/// Whatever the command does before and after the run: phases follow one another, so that their sum is its wall time.
#[test]
fn phases_before_and_after_the_run_stand_in_one_list() {
    let at = tempdir().unwrap();
    let folder = RunFolder::claim(at.path(), false).unwrap();
    let start = Instant::now();
    let in_file = || {
        let text = fs::read(at.path().join("performance.json")).unwrap();
        serde_json::from_slice::<serde_json::Value>(&text).unwrap()["phases"].clone()
    };
    let session = |wish: &Wish| {
        let mut phases = Phases::since(start);
        phases.mark("read");
        let Outcome::Finished { mut performance, .. } = wish.run_after(&folder, &mut phases).unwrap() else {
            panic!()
        };
        phases.mark("page");
        performance.follow(&phases, &folder).unwrap();
        assert_eq!(performance.document()["phases"], serde_json::json!(phases.list()));
        let seconds: f64 = phases.list().iter().map(|phase| phase.seconds).sum();
        assert!(seconds <= start.elapsed().as_secs_f64(), "{phases:?}");
        performance.document()["phases"].clone()
    };
    let wish = Wish { check: 2, ..pictures(Depth::Eight, false, false) };
    let first = session(&wish);
    let names: Vec<_> = first.as_array().unwrap().iter().map(|phase| phase["phase"].clone()).collect();
    assert_eq!(names, ["read", "prepare", "begin", "draw", "check", "finish", "page"]);
    assert_eq!(in_file(), first);
    // One that draws nothing tells its own times, and leaves those of the drawing in the folder.
    let second = session(&wish);
    let names: Vec<_> = second.as_array().unwrap().iter().map(|phase| phase["phase"].clone()).collect();
    assert_eq!(names, ["read", "prepare", "verify", "begin", "draw", "finish", "page"]);
    assert_eq!(in_file(), first);
}

#[test]
fn refresh_shows_every_update_several_times() {
    let at = tempdir().unwrap();
    pictures(Depth::Eight, true, true).run(at.path()).unwrap();
    let run = HeldRun::read(at.path()).unwrap();
    let names: Vec<_> = run.frames[2].files.iter().map(|file| file.file.as_str()).collect();
    assert_eq!(names, ["frames/frame-000006.png", "frames/frame-000007.png", "frames/frame-000008.png"]);
    for frame in &run.frames {
        for file in &frame.files {
            let picture = read_png(at.path().join(&file.file), &Limits::default()).unwrap();
            assert_eq!(picture.pixel_hash(), frame.pixels_blake3);
        }
    }
    assert_eq!(content(at.path()).keys().filter(|name| name.starts_with("frames/")).count(), 9);
}

/// The last showing is the frame as it is kept without `refresh`.
#[test]
fn each_showing_has_noise_of_its_own() {
    let at = tempdir().unwrap();
    let (updates, showings) = (at.path().join("updates"), at.path().join("showings"));
    let noisy = |refresh| Wish { grey: Some(8), ..pictures(Depth::Eight, refresh, false) };
    noisy(false).run(&updates).unwrap();
    noisy(true).run(&showings).unwrap();
    let [updates, shown] = [&updates, &showings].map(|folder| HeldRun::read(folder).unwrap());
    for (update, frame) in updates.frames.iter().zip(&shown.frames) {
        let picture = |file: &FileRecord| read_png(showings.join(&file.file), &Limits::default()).unwrap();
        let hashes: Vec<_> = frame.files.iter().map(|file| picture(file).pixel_hash()).collect();
        assert!(hashes[0] != hashes[1] && hashes[1] != hashes[2] && hashes[0] != hashes[2], "{hashes:?}");
        assert_eq!((&hashes[2], &frame.pixels_blake3), (&update.pixels_blake3, &update.pixels_blake3));
    }
}

#[test]
fn sixteen_bits_hold_what_eight_bits_round() {
    let at = tempdir().unwrap();
    let (eight, sixteen) = (at.path().join("8"), at.path().join("16"));
    pictures(Depth::Eight, false, false).run(&eight).unwrap();
    pictures(Depth::Sixteen, false, true).run(&sixteen).unwrap();
    for name in content(&eight).keys().filter(|name| name.starts_with("frames/")) {
        let [coarse, fine] =
            [&eight, &sixteen].map(|folder| read_png(folder.join(name), &Limits::default()).unwrap());
        assert_eq!(fine.depth(), Depth::Sixteen);
        let far = |(a, b): (&u16, &u16)| i32::from(*a).abs_diff(i32::from(*b)) > 1;
        assert!(!coarse.codes().iter().zip(fine.to_eight_bits().codes()).any(far), "{name}");
        assert!(coarse.codes().iter().any(|code| *code > 20), "{name} is not empty");
    }
}

#[test]
fn films_hold_all_pictures() {
    let at = tempdir().unwrap();
    pictures(Depth::Eight, false, true).run(at.path()).unwrap();
    let first = read_png(at.path().join("frames/frame-000000.png"), &Limits::default()).unwrap();
    assert_eq!(read_png(at.path().join("animation.png"), &Limits::default()).unwrap(), first);
    let animation = fs::read(at.path().join("animation.png")).unwrap();
    assert_eq!(animation.windows(4).filter(|bytes| bytes == b"fcTL").count(), 3);

    let run = HeldRun::read(at.path()).unwrap();
    let mut film = Vec::new();
    write_y4m(&mut film, at.path(), &run, Rate::new(10, 1).unwrap()).unwrap();
    let heading = film.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    assert!(String::from_utf8_lossy(&film[..heading]).contains(" F10:1 "));
    assert_eq!(film.len() - heading, 3 * (6 + first.codes().len()));
}

#[test]
fn a_film_once_made_follows_the_frames() {
    let at = tempdir().unwrap();
    let count = || {
        let animation = fs::read(at.path().join("animation.png")).unwrap();
        animation.windows(4).filter(|bytes| bytes == b"fcTL").count()
    };
    pictures(Depth::Eight, false, true).run(at.path()).unwrap();
    assert_eq!(count(), 3);
    Wish { frames: 0..5, ..pictures(Depth::Eight, false, false) }.run(at.path()).unwrap();
    assert_eq!(count(), 5);
}

#[test]
fn frames_say_when_and_where_they_were_seen() {
    let at = tempdir().unwrap();
    Wish { frames: 3..4, ..Wish::default() }.run(at.path()).unwrap();
    let png = fs::read(at.path().join("frames/frame-000003.png")).unwrap();
    let text = String::from_utf8_lossy(&png);
    for part in ["Frame\u{0}3", "Time\u{0}0.3 s", "Pose\u{0}x_m=100"] {
        assert!(text.contains(part), "{part:?}");
    }
}

#[test]
fn limits_are_reported_and_bad_paths_refused() {
    let at = tempdir().unwrap();
    let fast = Wish { frames: 0..3, ..Wish::default() }.in_place_of("x_m = 108", "x_m = 300");
    let Outcome::Finished { limits, .. } = fast.run(&at.path().join("fast")).unwrap() else { panic!() };
    assert!(!limits.is_empty());
    let run = HeldRun::read(&at.path().join("fast")).unwrap();
    assert_eq!(document(&run)["limits"][0]["limit"], "speed");

    let away = Wish { frames: 0..12, ..Wish::default() }.in_place_of("x_m = 108", "x_m = 9000");
    let refused = away.run(&at.path().join("away"));
    assert!(matches!(refused, Err(ReplayError::Poses(_))), "{refused:?}");
    assert!(!at.path().join("away").exists());
}
