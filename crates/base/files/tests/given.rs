//! Files in memory: found by every reader, written by nothing, bounded, and never outside the store.

use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use files::{
    Action, FileError, FilePieces, GIVEN_BYTES, GIVEN_FILES, GivenError, Kind, Pieces, give, holds, is_file,
    is_given, is_there, make_folder, names_in, open, open_own, read_all, take_back, take_back_all,
    write_atomic,
};

/// The store is the process's: one test has it at a time, and finds it empty.
fn turn() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    take_back_all();
    turn
}

#[test]
fn readers_find_what_was_given() {
    let _turn = turn();
    let path = Path::new("given:scenarios/first.toml");
    give(path, *b"format = 1").unwrap();
    assert_eq!(read_all(path, 100).unwrap(), b"format = 1");
    assert!(holds(path, b"format = 1") && !holds(path, b"format = 2"));
    let mut pieces = FilePieces::open(path, 100).unwrap();
    assert_eq!((pieces.length(), pieces.take(9, 1).unwrap()), (10, b"1".to_vec()));
    assert!(is_file(path) && is_there(path) && is_there("given:scenarios") && !is_file("given:scenarios"));
}

#[test]
fn paths_are_joined_as_those_of_the_disk() {
    let _turn = turn();
    give("given:scenarios/a/first.toml", *b"1").unwrap();
    give("given:hardware-models/own.toml", *b"2").unwrap();
    let folder = Path::new("given:scenarios/a/first.toml").parent().unwrap();
    for name in ["first.toml", "./first.toml", "../a/first.toml", "../../scenarios/a/first.toml"] {
        assert_eq!(read_all(folder.join(name), 9).unwrap(), b"1", "{name}");
    }
    assert_eq!(read_all(folder.join("../../hardware-models/own.toml"), 9).unwrap(), b"2");
    assert_eq!(read_all("given:/scenarios//a/first.toml", 9).unwrap(), b"1");
}

#[test]
fn nothing_leads_out_of_the_store() {
    let _turn = turn();
    // The test's own file is on the disk, in the current folder.
    assert!(Path::new("tests/given.rs").is_file());
    for path in [
        "given:tests/../../tests/given.rs",
        "given:../tests/given.rs",
        "given:a/../../given:tests/given.rs",
        "given:tests/given.rs",
    ] {
        assert!(matches!(read_all(path, 1 << 20), Err(FileError::Missing { .. })), "{path}");
        assert!(!is_there(path) && names_in(path).is_empty() && is_given(path), "{path}");
    }
    for path in [
        "tests/given.rs",
        "/given:a/b",
        "given:name",
        "given:",
        "given:a/../b",
        "given:../a/b",
        "given:a/../../b/c",
        "given:a\\b/c",
    ] {
        let refused = give(path, *b"x");
        assert!(
            matches!(&refused, Err(GivenError::Path { path: told }) if told == path),
            "{path}: {refused:?}"
        );
    }
}

#[test]
fn nothing_is_written_there() {
    let _turn = turn();
    give("given:a/b.toml", *b"1").unwrap();
    let written = write_atomic("given:a/b.toml", |out| out.write_all(b"2")).unwrap_err();
    assert!(
        matches!(written, FileError::NoFile { kind: Kind::Given, action: Action::Write, .. }),
        "{written}"
    );
    assert!(written.to_string().contains("a given file, which is held in memory alone"), "{written}");
    assert!(matches!(open_own(Path::new("given:a/new")), Err(FileError::NoFile { kind: Kind::Given, .. })));
    assert!(matches!(open(Path::new("given:a/b.toml")), Err(FileError::NoFile { kind: Kind::Given, .. })));
    assert!(make_folder(Path::new("given:c")).is_err());
    assert!(
        holds("given:a/b.toml", b"1") && !Path::new("given:a").exists() && !Path::new("given:c").exists()
    );
}

#[test]
fn folders_list_their_names() {
    let _turn = turn();
    for path in ["given:a/z.toml", "given:a/b/c", "given:a/b/d", "given:ab/e"] {
        give(path, *b"").unwrap();
    }
    assert_eq!(names_in("given:a"), ["b", "z.toml"]);
    assert_eq!(names_in("given:/"), ["a", "ab"]);
    assert!(matches!(read_all("given:a", 9), Err(FileError::IsFolder { .. })));
    for (path, other) in [("given:a/z.toml/x", "given:a/z.toml"), ("given:a/b", "given:a/b/c")] {
        assert!(
            matches!(give(path, *b""), Err(GivenError::Folder { other: told, .. }) if told == other),
            "{path}"
        );
    }
}

#[test]
fn files_are_taken_back() {
    let _turn = turn();
    give("given:a/b", *b"1").unwrap();
    give("given:a/b", *b"22").unwrap();
    assert_eq!(read_all("given:a/b", 9).unwrap(), b"22");
    assert!(take_back("given:a/./b") && !take_back("given:a/b") && !take_back("tests/given.rs"));
    assert!(!is_there("given:a"));
    // What was taken back makes room for as much again.
    for _ in 0..2 {
        give("given:a/b", vec![0; GIVEN_BYTES as usize]).unwrap();
        take_back("given:a/b");
    }
}

#[test]
fn files_and_bytes_are_bounded() {
    let _turn = turn();
    give("given:a/large", vec![0; 100]).unwrap();
    assert!(matches!(read_all("given:a/large", 99), Err(FileError::TooLarge { bytes: 100, limit: 99, .. })));
    assert!(FilePieces::open("given:a/large", 99).is_err());
    let most = vec![0; GIVEN_BYTES as usize - 99];
    let bytes = give("given:a/more", most).unwrap_err();
    assert_eq!(bytes, GivenError::Bytes { path: "given:a/more".into(), bytes: GIVEN_BYTES + 1 });
    for count in 1..GIVEN_FILES {
        give(format!("given:a/{count}"), *b"").unwrap();
    }
    assert!(matches!(give("given:a/last", *b""), Err(GivenError::Files { .. })));
    // A file that is there already is replaced all the same; a replaced one makes room for its bytes.
    give("given:a/large", vec![0; GIVEN_BYTES as usize]).unwrap();
    take_back_all();
    give("given:a/last", *b"").unwrap();
}
