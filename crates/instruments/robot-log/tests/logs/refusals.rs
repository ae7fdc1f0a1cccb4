//! What is refused, and what stays.

use std::fs;

use robot_log::Outcome;

use crate::scene::{Made, Wish};

#[test]
fn a_file_of_somebody_else_stays() {
    let made = Made::new(Wish::default());
    let (file, ours) = (made.beside("notes.mcap"), made.beside("log.mcap"));
    for theirs in [
        &b""[..],
        b"not a log",
        b"\x89MCAP0\r\n",
        b"\x89MCAP0\r\n\x01\x0c\0\0\0\0\0\0\0\0\0\0\0\x04\0\0\0mine",
    ] {
        fs::write(&file, theirs).expect("a file");
        let said = made.write_log(&file).expect_err("refused").to_string();
        assert!(said.contains("notes.mcap: exists, and is no log that lunoid wrote"), "{said}");
        assert_eq!(fs::read(&file).expect("there"), theirs);
    }
    let said = made.write_log(&made.path()).expect_err("refused").to_string();
    assert!(said.contains("folder"), "{said}");
    // Our own log is replaced by the same bytes.
    made.write_log(&ours).expect("written");
    let first = fs::read(&ours).expect("there");
    made.write_log(&ours).expect("written again");
    assert!(fs::read(&ours).expect("there") == first);
    // A file in the way of an OpenEXR file stays too.
    fs::create_dir(made.path().join("exr")).expect("a folder");
    let theirs = made.path().join("exr/frame-000001.exr");
    fs::write(&theirs, b"mine").expect("a file");
    let said = made.exr().expect_err("refused").to_string();
    assert!(said.contains("exr/frame-000001.exr"), "{said}");
    assert_eq!(fs::read(&theirs).expect("there"), b"mine");
}

/// Told to end, a log leaves what was there before; the same call afterwards writes all of it.
#[test]
fn a_log_that_is_told_to_end_leaves_nothing_half_written() {
    let made = Made::new(Wish { cancel_after: Some(2), threads: 1, ..Wish::default() });
    let file = made.beside("a.mcap");
    assert_eq!(made.write_log(&file).expect("told to end"), Outcome { frames: 3, done: 2 });
    let names: Vec<_> = fs::read_dir(made.beside(""))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name())
        .collect();
    assert_eq!(names, ["run"]);
    assert_eq!(made.exr().expect("told to end"), Outcome { frames: 3, done: 2 });
    assert_eq!(fs::read_dir(made.path().join("exr")).expect("a folder").count(), 2);
}

#[test]
fn truth_that_lacks_what_a_log_needs_and_truth_that_was_changed() {
    let said = |made: &Made| made.write_log(&made.beside("a.mcap")).expect_err("refused").to_string();
    let made = Made::new(Wish { truth: "range,label", ..Wish::default() });
    assert!(said(&made).contains("the ground truth has no `distance`; expected --truth with label,distance"));
    let made = Made::new(Wish { truth: "distance,label", ..Wish::default() });
    let file = made.path().join("truth/frame-000001.npz");
    let mut bytes = fs::read(&file).expect("truth");
    *bytes.last_mut().expect("a byte") ^= 1;
    fs::write(&file, bytes).expect("changed");
    assert!(
        said(&made).contains("frame-000001.npz: gone, or its bytes are not those that the record"),
        "{}",
        said(&made)
    );
    assert!(!made.beside("a.mcap").exists());
}
