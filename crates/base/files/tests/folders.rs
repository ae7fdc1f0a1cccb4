//! Nothing is written outside: links, pipes, devices, locks, leftovers.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use files::{Folder, FolderError, LOCK, Lock, is_locked, read_all, remove_leftovers, remove_leftovers_of};

/// Everything below a folder: what a link says, the content of files, nothing for folders.
fn content(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_symlink() {
            found.insert(path.clone(), fs::read_link(&path).expect("a link").display().to_string().into());
        } else if path.is_dir() {
            found.extend(content(&path));
        } else if path.is_file() {
            found.insert(path.clone(), fs::read(&path).expect("a file"));
        }
    }
    found
}

fn claim(path: &Path) -> Result<Folder, FolderError> {
    Folder::claim(path, &["frames"], |name| ["run.json", "frames/a.png"].contains(&name))
}

#[test]
fn leftovers_are_removed_and_nothing_else() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let keep = [".a.tmp", ".hidden", "a.12-3.tmp", ".a.12-x.tmp", ".a.12-.tmp", "frame.png", ".mine.1-2.tmp"];
    for name in keep.iter().chain(&[".frame.png.12-3.tmp", ".a.4-0.tmp"]) {
        fs::write(at(name), "x").expect("written");
    }
    let held = fs::File::create(at(".a.5-0.tmp")).expect("made");
    held.lock().expect("locked");
    let removed = remove_leftovers(folder.path(), |name| name == "a" || name == "frame.png");
    assert_eq!(removed.expect("removed"), 2, "one is still written");
    drop(held);
    assert_eq!(remove_leftovers_of(&at("a")).expect("removed"), 1);
    assert_eq!(content(folder.path()).into_keys().collect::<Vec<_>>(), {
        let mut kept = keep.map(at).to_vec();
        kept.sort();
        kept
    });
}

#[test]
fn one_process_a_folder_and_what_it_made_goes_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = folder.path().join("a/b");
    let first = claim(&run).expect("claimed");
    first.make("frames").expect("made");
    let second = claim(&run).expect_err("locked").to_string();
    assert!(second.contains(&format!("process {}", std::process::id())), "{second}");
    drop(first);
    assert!(!folder.path().join("a").exists());
    fs::create_dir_all(&run).expect("made");
    fs::write(run.join(LOCK), "12345, whom nobody holds").expect("written");
    drop(claim(&run).expect("a lock that is left locks nobody out"));
    assert!(!run.join(LOCK).exists());
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::symlink;

    use files::{
        Action, FileError, FilePieces, Kind, append_own, expect_output, leads_outside, make_folder, open,
        open_own, write_atomic,
    };

    use super::*;

    fn pipe(path: &Path) {
        let made = std::process::Command::new("mkfifo").arg(path).status();
        assert!(made.expect("mkfifo, as every Unix has it").success());
    }

    #[test]
    fn nothing_is_written_through_a_link() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("far")).expect("made");
        fs::write(at("far/a.txt"), "old").expect("written");
        symlink("far/a.txt", at("near")).expect("linked");
        symlink("near", at("nearer")).expect("linked");
        symlink("far/new.txt", at("dangling")).expect("linked");
        symlink("round", at("round")).expect("linked");
        fs::hard_link(at("far/a.txt"), at("twin")).expect("linked");
        let before = content(folder.path());
        for name in ["near", "nearer", "dangling", "round"] {
            let said = write_atomic(at(name), |out| out.write_all(b"new")).expect_err(name);
            assert!(
                matches!(said, FileError::NoFile { kind: Kind::Link, action: Action::Write, .. }),
                "{said}"
            );
            assert!(said.to_string().contains(name) && said.to_string().contains("this is a link"), "{said}");
            assert!(expect_output(&at(name)).is_err());
            assert!(open_own(&at(name)).is_err() && append_own(&at(name)).is_err(), "{name}");
        }
        assert!(open_own(&at("twin")).is_err(), "two names of one file");
        assert_eq!(content(folder.path()), before);
        // A rename gives the name another file: what the other name leads to stays.
        write_atomic(at("twin"), |out| out.write_all(b"new")).expect("written");
        assert_eq!(fs::read(at("far/a.txt")).expect("read"), b"old");
    }

    #[test]
    fn pipes_and_devices_are_no_files_and_keep_nobody_waiting() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        pipe(&at("pipe"));
        symlink("pipe", at("to-pipe")).expect("linked");
        for path in [at("pipe"), at("to-pipe"), "/dev/zero".into(), "/dev/null".into()] {
            let said = read_all(&path, 4096).expect_err("refused");
            assert!(matches!(said, FileError::NoFile { action: Action::Read, .. }), "{said}");
            assert!(FilePieces::open(&path, 4096).is_err() && open(&path).is_err());
        }
        for path in [at("pipe"), at("to-pipe")] {
            assert!(write_atomic(&path, |out| out.write_all(b"x")).is_err());
            assert!(open_own(&path).is_err());
        }
        assert!(matches!(expect_output(Path::new("/dev/null")), Ok(Kind::Stream)));
        // A slash behind the name does not look through the link.
        symlink(folder.path(), at("round")).expect("linked");
        assert_eq!(Kind::of(&at("round/")).expect("looked"), Kind::Link);
        assert!(make_folder(&at("round/")).is_err() && make_folder(&at("round/.")).is_err());
        assert!(make_folder(&at("pipe")).is_err());
    }

    #[test]
    fn a_claim_writes_nothing_through_links() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        fs::create_dir_all(at("far/frames")).expect("made");
        for name in ["far/precious.txt", "far/frames/a.png", "far/frames/.a.png.1-2.tmp"] {
            fs::write(at(name), "precious").expect("written");
        }
        let attack = |make: &dyn Fn(&Path), word: &str| {
            let run = at("run");
            fs::create_dir(&run).expect("made");
            make(&run);
            let before = content(folder.path());
            let said = claim(&run).expect_err(word).to_string();
            assert!(said.contains(word), "{said}");
            assert_eq!(content(folder.path()), before, "{word}");
            fs::remove_dir_all(run).expect("removed");
        };
        let link = |to: &'static str, name: &'static str| {
            move |run: &Path| symlink(to, run.join(name)).expect("linked")
        };
        attack(&link("../far/precious.txt", LOCK), ".lunoid.lock: cannot write: this is a link");
        attack(&link("../far/new", LOCK), ".lunoid.lock: cannot write: this is a link");
        attack(&link("../far/frames", "frames"), "frames: this is a link, expected a folder");
        attack(&link("../far/precious.txt", "run.json"), "run.json: cannot write: this is a link");
        attack(
            &|run| {
                fs::create_dir(run.join("frames")).expect("made");
                symlink("../../far/precious.txt", run.join("frames/a.png")).expect("linked");
            },
            "frames/a.png: cannot write: this is a link",
        );
        attack(&|run| pipe(&run.join(LOCK)), "this is a pipe");
        attack(&|run| pipe(&run.join("run.json")), "this is a pipe");
        attack(
            &|run| fs::hard_link(at("far/precious.txt"), run.join(LOCK)).expect("linked"),
            ".lunoid.lock: cannot open: this file has another name too (a hard link)",
        );
        attack(
            &|run| fs::write(run.join("frames"), "mine").expect("written"),
            "this is a file, expected a folder",
        );
        symlink("far", at("run")).expect("linked");
        assert!(claim(&at("run")).expect_err("a link").to_string().contains("run: this is a link"));
    }

    #[test]
    fn whoever_leaves_a_folder_by_a_link_is_seen() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        fs::create_dir_all(at("in/below")).expect("made");
        fs::write(at("out.csv"), "x").expect("written");
        fs::write(at("in/below/a.csv"), "x").expect("written");
        symlink("../out.csv", at("in/out.csv")).expect("linked");
        symlink("..", at("in/up")).expect("linked");
        symlink("below/a.csv", at("in/a.csv")).expect("linked");
        for (name, leaves) in [
            ("out.csv", true),
            ("up/out.csv", true),
            ("a.csv", false),
            ("below/a.csv", false),
            ("gone", false),
        ] {
            assert_eq!(leads_outside(&at("in"), &at("in").join(name)).is_some(), leaves, "{name}");
        }
    }
}

/// Whoever is refused takes nothing away, also where the other has made its folders and written nothing yet.
#[test]
fn who_is_refused_removes_no_folder_of_the_holder() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("run");
    let held = claim(&path).unwrap();
    held.make("frames").unwrap();
    assert!(matches!(claim(&path), Err(FolderError::Locked { .. })));
    assert!(path.join("frames").is_dir(), "it has no file yet, and is somebody's");
    fs::write(held.join("frames/a.png"), "a").unwrap();
    drop(held);
    assert!(path.join("frames/a.png").is_file() && !path.join(LOCK).exists());
}

#[test]
fn whoever_asks_for_a_lock_keeps_nobody_out() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(LOCK);
    assert!(!is_locked(folder.path()) && !path.exists(), "asking makes no file");
    let lock = Lock::take(folder.path()).expect("free");
    assert!(is_locked(folder.path()));
    drop(lock);
    fs::write(&path, "1").expect("a killed run leaves the file");
    assert!(!is_locked(folder.path()));
    // The instant in which somebody asks.
    let asking = fs::File::open(&path).expect("there");
    asking.lock_shared().expect("free");
    let ends = std::thread::spawn(move || {
        std::thread::sleep(std::time::Duration::from_millis(30));
        drop(asking);
    });
    let taken = Lock::take(folder.path());
    ends.join().expect("ended");
    assert!(taken.is_ok(), "{:?}", taken.err());
}
