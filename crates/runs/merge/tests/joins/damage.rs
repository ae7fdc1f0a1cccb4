use std::fs;
use std::path::{Path, PathBuf};

use tempfile::tempdir;

use crate::drive::{Drive, content, expect_equal, joined, refused};

fn drawn(at: &Path) -> (Drive, Vec<PathBuf>) {
    let drive = Drive::new("first-light", None, 0..6);
    let folders = drive.shards(2, at);
    (drive, folders)
}

/// Flips one bit in the middle of a file.
fn flip(path: &Path) {
    let mut bytes = fs::read(path).unwrap();
    let place = bytes.len() / 2;
    bytes[place] ^= 1;
    fs::write(path, bytes).unwrap();
}

#[test]
fn changed_files_are_found_by_their_hash() {
    let at = tempdir().unwrap();
    let (drive, folders) = drawn(at.path());
    let out = at.path().join("joined");
    for name in ["frames/frame-000004.png", "poses.csv", "camera.json"] {
        let path = folders[1].join(name);
        let before = fs::read(&path).unwrap();
        flip(&path);
        let said = refused(&folders, &out);
        assert!(said.starts_with(&format!("{}: gone, or its bytes are not those", path.display())), "{said}");
        fs::write(&path, before).unwrap();
    }
    let frame = folders[1].join("frames/frame-000004.png");
    fs::remove_file(&frame).unwrap();
    assert!(refused(&folders, &out).starts_with(&format!("{}: gone, or", frame.display())));
    // The same replay makes it anew.
    drive.shard(2, 2, &folders[1]);
    drive.whole(&at.path().join("whole"));
    joined(&folders, &out);
    expect_equal(&at.path().join("whole"), &out, "after repair");
}

/// A frame under the name of another is no frame of the run.
#[test]
fn frames_under_each_other_s_names_are_found() {
    let at = tempdir().unwrap();
    let (_, folders) = drawn(at.path());
    let [four, five] = [4, 5].map(|frame| folders[1].join(format!("frames/frame-{frame:06}.png")));
    let kept = at.path().join("kept");
    fs::rename(&four, &kept).unwrap();
    fs::rename(&five, &four).unwrap();
    fs::rename(&kept, &five).unwrap();
    assert!(refused(&folders, &at.path().join("joined")).contains("frame-000004.png"));
}

#[test]
fn changed_records_are_refused() {
    let at = tempdir().unwrap();
    let (_, folders) = drawn(at.path());
    let path = folders[0].join("run.json");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, text.replacen("\"depth\": 8", "\"depth\": 9", 1)).unwrap();
    let said = refused(&folders, &at.path().join("joined"));
    assert!(said.contains("run.json") && said.contains("changed since it was written"), "{said}");
}

/// Half a frame, a frame of no run, and a lock of a process that is gone, as after kill -9.
#[test]
fn what_a_killed_join_left_is_cleared() {
    let at = tempdir().unwrap();
    let (drive, folders) = drawn(at.path());
    let (whole, out) = (at.path().join("whole"), at.path().join("joined"));
    drive.whole(&whole);
    crate::drive::join_until(&folders, None, &out, 2).unwrap();
    fs::write(out.join("frames/.frame-000003.png.77-1.tmp"), "half").unwrap();
    fs::copy(whole.join("frames/frame-000004.png"), out.join("frames/frame-000500.png")).unwrap();
    fs::write(out.join(".lunoid.lock"), "77").unwrap();
    joined(&folders, &out);
    expect_equal(&whole, &out, "after a kill");
    assert!(content(&out).keys().all(|name| !name.contains("tmp") && !name.contains("lock")));
}
