//! Whole or not at all, and an error that says what to do.

use std::fs;
use std::io;

use files::{Action, FileError, read_all, write_atomic};

fn names(folder: &std::path::Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let mut names: Vec<_> =
        entries.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn content_replaces_content() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.txt");
    for content in ["long old content", "new"] {
        write_atomic(&path, |out| out.write_all(content.as_bytes())).expect("written");
        assert_eq!(read_all(&path, 100).expect("read"), content.as_bytes());
    }
    assert_eq!(names(folder.path()), ["a.txt"]);
}

#[test]
fn the_old_file_stays_until_the_new_one_is_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.txt");
    write_atomic(&path, |out| out.write_all(b"old")).expect("written");
    write_atomic(&path, |out| {
        out.write_all(&[0; 200_000])?;
        out.flush()?;
        assert_eq!(fs::read(&path)?, b"old");
        Ok(())
    })
    .expect("written");
    assert_eq!(read_all(&path, 1 << 20).map(|bytes| bytes.len()).expect("read"), 200_000);
}

#[test]
fn a_failure_leaves_the_old_file_and_nothing_else() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.txt");
    write_atomic(&path, |out| out.write_all(b"old")).expect("written");
    let full = write_atomic(&path, |out| {
        out.write_all(b"half")?;
        Err(io::Error::from(io::ErrorKind::StorageFull))
    });
    let error = full.expect_err("no space");
    assert!(matches!(error, FileError::NoSpace { action: Action::Write, .. }), "{error:?}");
    assert!(error.to_string().contains("a.txt: cannot write: no space left"), "{error}");
    assert_eq!(read_all(&path, 9).expect("read"), b"old");
    assert_eq!(names(folder.path()), ["a.txt"]);
}

#[test]
fn threads_that_write_one_path_do_not_mix() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.bin");
    std::thread::scope(|scope| {
        for letter in [b'a', b'b', b'c', b'd'] {
            let path = &path;
            scope
                .spawn(move || write_atomic(path, |out| out.write_all(&[letter; 300_000])).expect("written"));
        }
    });
    let bytes = read_all(&path, 1 << 20).expect("read");
    assert_eq!(bytes.len(), 300_000);
    assert!(bytes.iter().all(|byte| *byte == bytes[0]));
}

#[test]
fn places_where_nothing_can_be_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |path: &std::path::Path| write_atomic(path, |out| out.write_all(b"x")).expect_err("refused");
    assert!(matches!(write(folder.path()), FileError::IsFolder { .. }));
    assert!(matches!(write("/".as_ref()), FileError::IsFolder { .. }));
    let missing = write(&folder.path().join("none/a.txt"));
    assert!(matches!(&missing, FileError::MissingFolder { folder: none, .. } if none.ends_with("none")));
    fs::write(folder.path().join("file"), "x").expect("written");
    assert!(matches!(write(&folder.path().join("file/a.txt")), FileError::MissingFolder { .. }));
}

#[cfg(target_os = "linux")]
#[test]
fn devices_are_written_and_stay() {
    write_atomic("/dev/null", |out| out.write_all(b"x")).expect("written");
    let full = write_atomic("/dev/full", |out| out.write_all(b"x")).expect_err("always full");
    assert!(matches!(full, FileError::NoSpace { .. }), "{full:?}");
    assert!(!fs::metadata("/dev/null").expect("still there").is_file());
}

#[test]
fn reading_is_bounded() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.txt");
    fs::write(&path, [7; 10]).expect("written");
    assert_eq!(read_all(&path, 10).expect("it just fits").len(), 10);
    let large = read_all(&path, 9).expect_err("too large");
    assert!(matches!(large, FileError::TooLarge { bytes: 10, limit: 9, .. }));
    assert!(matches!(read_all(folder.path(), 9), Err(FileError::IsFolder { .. })));
    let missing = read_all(folder.path().join("b"), 9).expect_err("missing");
    assert!(matches!(missing, FileError::Missing { .. }));
    assert!(missing.path().ends_with("b"));
}

/// Set for a child of a test: the file it is to write.
const TO_WRITE: &str = "FILES_TEST_WRITES";

/// This test program as an argument list that runs one test.
fn only(test: &str) -> [std::ffi::OsString; 3] {
    [std::env::current_exe().expect("a name").into_os_string(), "--exact".into(), test.into()]
}

#[test]
#[cfg(unix)]
fn what_the_disk_does_not_take_is_an_error() {
    if let Some(path) = std::env::var_os(TO_WRITE) {
        // The child, whose files may have a kilobyte: fewer than the buffer holds.
        let error = write_atomic(path, |out| out.write_all(&[0; 4000])).expect_err("no room");
        assert!(matches!(error, FileError::Io { action: Action::Write, .. }), "{error:?}");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.txt");
    write_atomic(&path, |out| out.write_all(b"old")).expect("written");
    let child = std::process::Command::new("sh")
        .args(["-c", "ulimit -f 1; trap '' XFSZ; exec \"$@\"", "sh"])
        .args(only("what_the_disk_does_not_take_is_an_error"))
        .env(TO_WRITE, &path)
        .output()
        .expect("a shell");
    assert!(child.status.success(), "{}", String::from_utf8_lossy(&child.stdout));
    assert_eq!(read_all(&path, 9999).expect("read"), b"old");
    assert_eq!(names(folder.path()), ["a.txt"]);
}

#[test]
#[cfg(target_os = "linux")]
fn a_file_is_on_the_disk_before_it_has_its_name() {
    if let Some(path) = std::env::var_os(TO_WRITE) {
        return write_atomic(path, |out| out.write_all(b"new")).expect("written");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let log = folder.path().join("log");
    let child = std::process::Command::new("strace")
        .args(["-f", "-qq", "-e", "trace=fsync,rename,renameat,renameat2", "-o"])
        .arg(&log)
        .args(only("a_file_is_on_the_disk_before_it_has_its_name"))
        .env(TO_WRITE, folder.path().join("a.txt"))
        .output();
    // A container may forbid to trace.
    if !child.is_ok_and(|child| child.status.success()) {
        return eprintln!("skipped: strace is missing or may not trace");
    }
    let calls = fs::read_to_string(log).expect("a log");
    let order: Vec<&str> = calls
        .lines()
        .filter_map(|line| ["fsync(", "rename"].into_iter().find(|call| line.contains(call)))
        .collect();
    assert_eq!(order, ["fsync(", "rename", "fsync("], "the file, its name, the folder:\n{calls}");
}
