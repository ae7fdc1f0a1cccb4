use std::fs;

use front_door::Wishes;
use merge::MergeError;
use tempfile::tempdir;

use crate::drive::{Drive, content, join, joined, refused};

fn drive() -> Drive {
    Drive::new("first-light", None, 0..6)
}

#[test]
fn runs_of_two_versions_name_the_difference_and_both_files() {
    let at = tempdir().unwrap();
    let one = drive();
    let mut folders = one.shards(2, at.path());
    let other = Drive { commit: "d".into(), ..drive() };
    folders[1] = at.path().join("other");
    other.shard(2, 2, &folders[1]);
    let said = refused(&folders, &at.path().join("joined"));
    let [first, second] = [&folders[0], &folders[1]].map(|folder| folder.join("run.json"));
    let start = format!("{} and {} are not of one run: they differ in ", first.display(), second.display());
    assert!(said.starts_with(&start), "{said}");
    assert!(said.contains("program.commit (\"c\" in the first, \"d\" in the second)"), "{said}");
}

#[test]
fn other_grounds_rasters_machines_and_depths_are_refused() {
    let at = tempdir().unwrap();
    let one = drive();
    let folder = at.path().join("one");
    one.shard(1, 2, &folder);
    let wishes = |set: &[(&str, &str)]| Wishes {
        sweeps: Some(24),
        samples: Some(40),
        set: set.iter().map(|(key, value)| ((*key).into(), (*value).into())).collect(),
        ..Wishes::default()
    };
    let sixteen = Drive {
        pictures: replay::Pictures { depth: picture::Depth::Sixteen, ..crate::drive::GREY },
        ..drive()
    };
    let others = [
        ("ground", Drive::with("first-light", &wishes(&[("scenario.landscape.generated.seed", "9")]), 0..6)),
        ("view.display", Drive::with("first-light", &wishes(&[("scenario.display.gamma", "1.5")]), 0..6)),
        ("settings", Drive::new("first-light", Some("pra-nominal"), 0..6)),
        ("pictures.depth", sixteen),
    ];
    for (key, other) in others {
        let second = at.path().join(key);
        other.shard(2, 2, &second);
        let said = refused(&[folder.clone(), second], &at.path().join("joined"));
        assert!(said.contains(" are not of one run: they differ in ") && said.contains(key), "{said}");
    }
}

/// Frames are known by their hashes: the name of a frame proves nothing.
#[test]
fn an_overlap_that_disagrees_names_the_frame_and_both_files() {
    let at = tempdir().unwrap();
    let drive = drive();
    let [one, other] = ["one", "other"].map(|name| at.path().join(name));
    drive.draw(0..4, None, &one);
    drive.draw(2..6, None, &other);
    // A record of the same run whose frame 3 shows what frame 5 does, whole and sealed.
    let record = replay::HeldRun::read(&other).unwrap().into_record();
    let mut changed = record.clone();
    let five = record.frames[3].clone();
    changed.frames[1].pixels_blake3 = five.pixels_blake3.clone();
    changed.frames[1].files[0].blake3 = five.files[0].blake3.clone();
    fs::write(other.join("run.json"), changed.text()).unwrap();
    fs::copy(other.join("frames/frame-000005.png"), other.join("frames/frame-000003.png")).unwrap();
    let said = refused(&[one.clone(), other.clone()], &at.path().join("joined"));
    assert!(said.starts_with("frame 3: ") && said.contains("pixels_blake3 (other content)"), "{said}");
    for folder in [one, other] {
        assert!(said.contains(&folder.join("run.json").display().to_string()), "{said}");
    }
}

#[test]
fn a_folder_is_given_once_and_is_not_the_result() {
    let at = tempdir().unwrap();
    let folders = drive().shards(2, at.path());
    let before = content(&folders[0]);
    let twice = [folders[0].clone(), folders[1].clone(), at.path().join("./1-of-2")];
    let said = refused(&twice, &at.path().join("joined"));
    assert!(said.ends_with("given twice; give each folder once"), "{said}");
    let error = join(&folders, &folders[0]).unwrap_err();
    assert!(matches!(error, MergeError::IntoItself { .. }), "{error}");
    assert_eq!(content(&folders[0]), before);
}

#[test]
fn the_folder_of_another_run_stays() {
    let at = tempdir().unwrap();
    let drive = drive();
    let folders = drive.shards(2, at.path());
    let out = at.path().join("out");
    Drive { commit: "d".into(), ..self::drive() }.whole(&out);
    let before = content(&out);
    let said = join(&folders, &out).unwrap_err().to_string();
    assert!(said.contains("holds another run, from which this one differs"), "{said}");
    assert_eq!(content(&out), before);
    // The same run with more frames would lose some.
    let longer = at.path().join("longer");
    Drive { frames: 0..9, ..self::drive() }.whole(&longer);
    let before = content(&longer);
    let said = join(&folders, &longer).unwrap_err().to_string();
    assert!(said.contains("holds frame 6, and the joined run has frames 0..6"), "{said}");
    assert_eq!(content(&longer), before);
    // A part of the same run is completed.
    let part = at.path().join("part");
    drive.draw(2..5, None, &part);
    joined(&folders, &part);
    let foreign = at.path().join("foreign");
    fs::create_dir(&foreign).unwrap();
    fs::write(foreign.join("mine.txt"), "mine").unwrap();
    assert!(join(&folders, &foreign).is_err());
    assert_eq!(content(&foreign).len(), 1);
}
