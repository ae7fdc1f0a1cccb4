use std::fs;
use std::ops::Range;
use std::path::PathBuf;

use merge::{Gap, MergeError, Outcome};
use tempfile::tempdir;

use crate::drive::{Drive, join, join_frames, join_until, joined};

fn drive() -> Drive {
    Drive::new("first-light", None, 0..14)
}

/// The gaps of `folders`, with the words of the command that fills them. Nothing is written.
fn gaps(folders: &[PathBuf], frames: Option<&Range<u64>>, out: &std::path::Path) -> (Vec<Gap>, Vec<String>) {
    let outcome = join_frames(folders, frames, out).expect("no refusal");
    let Outcome::Gaps { gaps, words } = outcome else { panic!("{outcome:?}") };
    assert!(!out.exists());
    (gaps, words.unwrap_or_default())
}

fn gap(frames: Range<u64>) -> Gap {
    Gap { frames, folder: None, truth: false }
}

#[test]
fn every_missing_shard_is_a_gap_also_at_the_ends() {
    let at = tempdir().unwrap();
    let folders = drive().shards(7, at.path());
    let out = at.path().join("joined");
    let of = |numbers: &[usize]| numbers.iter().map(|number| folders[number - 1].clone()).collect::<Vec<_>>();
    for (there, expected) in [
        (&[1, 2, 3, 4, 5, 6][..], vec![gap(12..14)]),
        (&[2, 3, 4, 5, 6, 7], vec![gap(0..2)]),
        (&[7, 1, 2, 6, 5], vec![gap(4..8)]),
        (&[6, 2, 4], vec![gap(0..2), gap(4..6), gap(8..10), gap(12..14)]),
    ] {
        let (found, words) = gaps(&of(there), None, &out);
        assert_eq!((found, words.join(" ").as_str()), (expected, "a.toml --machine m"), "{there:?}");
    }
}

#[test]
fn ordinary_runs_state_no_whole_so_frames_does() {
    let at = tempdir().unwrap();
    let drive = drive();
    let folders = [4..6, 8..10].map(|frames| {
        let out = at.path().join(format!("{}", frames.start));
        drive.draw(frames, None, &out);
        out
    });
    let out = at.path().join("joined");
    assert_eq!(gaps(&folders, None, &out), (vec![gap(6..8)], vec![]));
    assert_eq!(gaps(&folders, Some(&(3..12)), &out).0, [gap(3..4), gap(6..8), gap(10..12)]);
    for narrow in [5..12, 3..9] {
        let error = join_frames(&folders, Some(&narrow), &out).unwrap_err();
        assert!(matches!(error, MergeError::Outside { .. }), "{error}");
        assert!(!out.exists());
    }
}

#[test]
fn a_gap_is_filled_in_the_folder_of_its_unfinished_run() {
    let at = tempdir().unwrap();
    let drive = drive();
    let mut folders = drive.shards(2, at.path());
    let out = at.path().join("joined");
    // A run that was left in the middle: joining leaves one as a replay does.
    let left = at.path().join("left");
    join_until(&[folders.remove(1)], Some(&(7..14)), &left, 3).expect("left");
    folders.push(left.clone());
    let (found, _) = gaps(&folders, None, &out);
    assert_eq!(found, [Gap { frames: 7..14, folder: Some(left.clone()), truth: false }]);
    drive.shard(2, 2, &left);
    assert_eq!(joined(&folders, &out).frames, 0..14);
}

#[test]
fn nothing_finished_is_no_run() {
    let at = tempdir().unwrap();
    let folders = drive().shards(2, at.path());
    let left = at.path().join("left");
    join_until(&folders, None, &left, 3).expect("left");
    let error = join(&[left], &at.path().join("joined")).unwrap_err();
    assert!(matches!(error, MergeError::NothingFinished { .. }), "{error}");
    let gone = at.path().join("gone");
    assert!(join(std::slice::from_ref(&gone), &at.path().join("joined")).is_err());
    assert!(!gone.exists() && !fs::exists(at.path().join("joined")).unwrap());
}
