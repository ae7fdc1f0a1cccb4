//! A disk that fails once, at every file operation in turn: one error, what was there stays, and the same command again
//! makes what it should have made. `disk.c` is the disk; the program is the one that ships.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::build::Tiff;
use crate::room::{Content, INPUT, OUTPUT, Room, Said, content, said};

/// What a disk says: `errno` of Linux, or that it wrote half.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fault {
    pub errno: &'static str,
    /// Whether it goes on failing.
    pub stays: bool,
}

pub const NO_SPACE: Fault = Fault { errno: "28", stays: false };
/// The failing disk as a library to be loaded first.
fn disk() -> &'static Path {
    static DISK: OnceLock<PathBuf> = OnceLock::new();
    DISK.get_or_init(|| {
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad_input/disk.c");
        let library = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("disk-{}.so", std::process::id()));
        let mut compiler = Command::new("cc");
        let compiler =
            compiler.args(["-shared", "-fPIC", "-O1", "-Wall", "-o"]).arg(&library).arg(source).arg("-ldl");
        assert!(compiler.status().expect("a C compiler, as Rust has for its linker").success());
        library
    })
}

/// A command of one room, and what it leaves when nothing fails.
pub struct Case {
    room: Room,
    arguments: Vec<&'static str>,
    /// Everything in the room before the command.
    before: Content,
    whole: Content,
    /// File operations that it takes.
    operations: usize,
}

/// What a run under a fault came to.
struct Ended {
    said: Said,
    operations: usize,
    failed: String,
}

impl Case {
    fn new(room: Room, arguments: Vec<&'static str>) -> Self {
        let before = content(room.path());
        let mut case = Self { room, arguments, before, whole: Content::new(), operations: 0 };
        let ended = case.run(0, NO_SPACE);
        assert_eq!(ended.said.code, Some(0), "{:?}", ended.said);
        case.whole = case.content();
        case.operations = ended.operations;
        assert!(case.whole != case.before && case.operations > 10, "{} operations", case.operations);
        case.reset();
        case
    }

    /// Times differ from run to run.
    fn content(&self) -> Content {
        let all = content(self.room.path()).into_iter();
        all.filter(|(path, _)| !path.ends_with("performance.json")).collect()
    }

    /// The room as it was before the command.
    fn reset(&self) {
        for entry in fs::read_dir(self.room.path()).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { fs::remove_dir_all(path).unwrap() } else { fs::remove_file(path).unwrap() }
        }
        for (path, bytes) in &self.before {
            match bytes {
                None => fs::create_dir_all(path).unwrap(),
                Some(bytes) => {
                    fs::create_dir_all(path.parent().unwrap()).unwrap();
                    fs::write(path, bytes).unwrap();
                }
            }
        }
    }

    /// The command, its operation number `at` failing; none fails where that is 0.
    fn run(&self, at: usize, fault: Fault) -> Ended {
        let report = tempfile::NamedTempFile::new().unwrap();
        let mut command = self.room.command(&self.arguments);
        command
            .env("LD_PRELOAD", disk())
            .env("DISK_UNDER", self.room.path())
            .env("DISK_REPORT", report.path());
        command.env("DISK_AT", at.to_string()).env("DISK_ERRNO", fault.errno);
        if fault.stays {
            command.env("DISK_STAYS", "1");
        }
        let said = said(command);
        let report = fs::read_to_string(report.path()).unwrap();
        let (operations, failed) = report.trim_end().split_once('\n').expect("the disk was there");
        Ended { said, operations: operations.parse().unwrap(), failed: failed.to_owned() }
    }

    /// `fault` at operation `at`: everything that has to hold; what failed.
    fn fails_well(&self, at: usize, fault: Fault) -> String {
        let Ended { said, failed, .. } = self.run(at, fault);
        let what = format!("{:?}, {fault:?} at {at}: {failed}\n{said:?}", self.arguments);
        assert!(!said.err.contains("panicked"), "{what}");
        match said.code {
            // What failed did not matter, as the removal of a lock at the end.
            Some(0) => assert!(fault.errno != "short" || said.err.is_empty(), "{what}"),
            Some(INPUT | OUTPUT) => {
                assert!(
                    said.err.starts_with("error: ") && said.errors() == 1 && said.out.is_empty(),
                    "{what}"
                );
            }
            _ => panic!("{what}"),
        }
        self.nothing_is_torn(fault, &failed, &what);
        let again = self.run(0, NO_SPACE).said;
        assert_eq!(again.code, Some(0), "{what}\nand again: {again:?}");
        let after = self.content();
        let differ: Vec<_> =
            self.whole.iter().filter(|(path, bytes)| after.get(*path) != Some(bytes)).collect();
        let is_left = |path: &&PathBuf| !(is_temporary(path) && may_stay(fault, &failed));
        let more: Vec<_> =
            after.keys().filter(|path| !self.whole.contains_key(*path)).filter(is_left).collect();
        let differ: Vec<_> = differ.into_iter().map(|(path, _)| path).collect();
        assert!(
            differ.is_empty() && more.is_empty(),
            "{what}\nand again: {differ:?} differ, {more:?} are left"
        );
        self.reset();
        failed
    }

    /// Every file is the old one or the new one, but the journal, and what could not be removed.
    fn nothing_is_torn(&self, fault: Fault, failed: &str, what: &str) {
        for (path, bytes) in self.content() {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let on_its_way = name.ends_with(".journal") || name == ".lunoid.lock";
            let is_old_or_new = [&self.before, &self.whole].iter().any(|all| all.get(&path) == Some(&bytes));
            let is_fine = is_old_or_new || on_its_way || (is_temporary(&path) && may_stay(fault, failed));
            assert!(is_fine, "{what}\nleaves {}", path.display());
        }
        let gone = self.before.keys().find(|path| !path.exists());
        assert_eq!(gone, None, "{what}\ntakes it away");
    }

    /// Every `step`-th operation fails in turn.
    pub fn fails_everywhere(&self, fault: Fault, step: usize) {
        let failed = (1..=self.operations).step_by(step).map(|at| self.fails_well(at, fault));
        let failed = failed.filter(|failed| failed != "nothing").count();
        println!("{:?}: {} operations, {failed} failures of {fault:?}", self.arguments[0], self.operations);
        // The order of threads is not the same every time.
        assert!(failed + 3 >= self.operations.div_ceil(step), "{failed} of {}", self.operations);
    }
}

/// What could not be removed stays: a run clears its folder next time, a folder of the user's is not looked through.
fn may_stay(fault: Fault, failed: &str) -> bool {
    fault.stays || failed.starts_with("remove")
}

fn is_temporary(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.starts_with('.') && name.ends_with(".tmp")
}

pub fn replay() -> Case {
    let room = Room::new();
    Case::new(room, "replay tiny.toml -q --frames 0..2 --jobs 1 --apng --out r".split(' ').collect())
}

/// A run of one frame that goes on: what it has is not lost.
pub fn longer() -> Case {
    let room = Room::new();
    room.done(&"replay tiny.toml -q --frames 0..1 --jobs 1 --out r".split(' ').collect::<Vec<_>>());
    Case::new(room, "replay tiny.toml -q --frames 0..2 --jobs 1 --out r".split(' ').collect())
}

/// Over an older bank and its description.
pub fn survey() -> Case {
    let room = Room::new();
    room.write("plane.tif", Tiff::plane().bytes());
    room.done(&["bank", "generate", "tiny.toml", "-o", "s.bank"]);
    Case::new(room, "survey plane.tif --region-size-m 40 -o s.bank --picture fit.png".split(' ').collect())
}

/// Over an older record.
pub fn timing() -> Case {
    let room = Room::new();
    let record = |frames: &'static str| {
        vec![
            "timing",
            "record",
            "tiny.toml",
            "--no-progress",
            "--frames",
            frames,
            "--jobs",
            "1",
            "--out",
            "t.json",
        ]
    };
    room.done(&record("1..2"));
    Case::new(room, record("0..1"))
}

#[test]
fn a_replay_whose_disk_fails_goes_on() {
    replay().fails_everywhere(NO_SPACE, 5);
}

#[test]
fn a_longer_run_loses_nothing_of_a_shorter_one() {
    longer().fails_everywhere(NO_SPACE, 7);
}

#[test]
fn a_survey_whose_disk_fails_leaves_the_old_bank() {
    survey().fails_everywhere(NO_SPACE, 1);
}

#[test]
fn a_timing_record_whose_disk_fails_leaves_the_old_one() {
    timing().fails_everywhere(NO_SPACE, 1);
}
