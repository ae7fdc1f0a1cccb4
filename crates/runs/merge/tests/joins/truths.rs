use std::fs;

use merge::Outcome;
use tempfile::tempdir;

use crate::drive::{Drive, expect_equal, join, joined, refused};

fn drive(items: &str) -> Drive {
    let drive = Drive::new("first-light", None, 2..9);
    Drive { truth: Some(items.parse().expect("items")), ..drive }
}

#[test]
fn the_truth_of_shards_is_that_of_one_machine() {
    for items in ["range,normal,label,pose", "pose", "all", "range"] {
        let at = tempdir().unwrap();
        let drive = drive(items);
        drive.whole(&at.path().join("whole"));
        let mut folders = drive.shards(3, at.path());
        folders.reverse();
        let twice = at.path().join("twice");
        drive.shard(2, 3, &twice);
        folders.push(twice);
        assert_eq!(joined(&folders, &at.path().join("joined")).truth, 7);
        expect_equal(&at.path().join("whole"), &at.path().join("joined"), items);
    }
}

#[test]
fn a_shard_without_the_truth_of_the_others_is_a_gap() {
    let at = tempdir().unwrap();
    let mut drive = drive("range");
    let mut folders = drive.shards(2, at.path());
    drive.truth = None;
    let bare = at.path().join("bare");
    drive.shard(2, 2, &bare);
    folders[1] = bare.clone();
    let out = at.path().join("joined");
    let Ok(Outcome::Gaps { gaps, .. }) = join(&folders, &out) else { panic!("joined") };
    assert_eq!((gaps.len(), gaps[0].frames.clone(), gaps[0].truth), (1, 5..9, true));
    assert_eq!(gaps[0].folder.as_deref(), Some(bare.as_path()));
    assert!(!out.exists());
}

#[test]
fn truths_of_other_kinds_and_changed_arrays_are_refused() {
    let at = tempdir().unwrap();
    let (ranges, labels) = (drive("range"), drive("label"));
    let mut folders = ranges.shards(2, at.path());
    let out = at.path().join("joined");
    let other = at.path().join("other");
    labels.shard(2, 2, &other);
    let said = refused(&[folders[0].clone(), other], &out);
    assert!(said.contains("1-of-2/truth/truth.json and") && said.contains("differ in planes"), "{said}");
    let array = folders[1].join("truth/frame-000006.npz");
    let mut bytes = fs::read(&array).unwrap();
    let place = bytes.len() / 2;
    bytes[place] ^= 1;
    fs::write(&array, bytes).unwrap();
    folders.reverse();
    let said = refused(&folders, &out);
    assert!(said.starts_with(&format!("{}: gone, or its bytes are not those", array.display())), "{said}");
}
