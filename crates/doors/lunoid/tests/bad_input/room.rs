//! A folder with a tiny scenario, the command run in it, and what every refusal has in common.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

/// The scenario of every room, one thing changed at a time.
pub const TINY: &str = include_str!("../tiny.toml");

/// The path of [`TINY`] as it is written there.
pub const KEYFRAMES: &str =
    "keyframes = [\n  { t_s = 0, x_m = 100, y_m = 200 },\n  { t_s = 5, x_m = 108, y_m = 205 },\n]";

/// Exit code of wrong usage.
pub const USAGE: i32 = 2;
/// Exit code of bad input.
pub const INPUT: i32 = 3;
/// Exit code of a failed output.
pub const OUTPUT: i32 = 4;

/// Everything below a folder: content of files, nothing for folders.
pub type Content = BTreeMap<PathBuf, Option<Vec<u8>>>;

/// What a command said.
#[derive(Debug)]
pub struct Said {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// A folder of its own for a test.
pub struct Room(TempDir);

impl Room {
    /// With `tiny.toml` and an empty `folder`.
    pub fn new() -> Self {
        let room = Self(tempfile::tempdir().unwrap());
        room.write("tiny.toml", TINY);
        fs::create_dir(room.join("folder")).unwrap();
        room
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn join(&self, name: &str) -> PathBuf {
        self.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.join(name), content).unwrap();
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.join(name)).unwrap()
    }

    /// [`TINY`] with one thing changed, as `name`.
    pub fn vary(&self, name: &str, old: &str, new: &str) {
        assert_eq!(TINY.matches(old).count(), 1, "{old}");
        self.write(name, TINY.replace(old, new));
    }

    /// The command, in the room, without what the environment may say.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lunoid"));
        command.current_dir(self.path()).args(arguments);
        ["LUNOID_THREADS", "NO_COLOR", "CLICOLOR_FORCE"].iter().for_each(|name| {
            command.env_remove(name);
        });
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Said {
        said(self.command(arguments))
    }

    /// Runs what must succeed.
    pub fn done(&self, arguments: &[&str]) -> String {
        let said = self.run(arguments);
        assert_eq!(said.code, Some(0), "{arguments:?}\n{said:?}");
        assert_eq!(said.err, "", "{arguments:?}");
        said.out
    }

    /// Runs what must be refused: `code`, silent standard output, one error that holds all `words`, and a room that
    /// is byte for byte as before.
    pub fn refused(&self, code: i32, arguments: &[&str], words: &[&str]) {
        let before = content(self.path());
        let said = self.run(arguments);
        said.is_one_error(code, words, &arguments.join(" "));
        let after = content(self.path());
        let changed: Vec<_> =
            before.keys().chain(after.keys()).filter(|name| before.get(*name) != after.get(*name)).collect();
        assert!(changed.is_empty(), "{arguments:?} leaves {changed:?}");
    }
}

impl Said {
    /// One error of this kind, and nothing on standard output.
    pub fn is_one_error(&self, code: i32, words: &[&str], what: &str) {
        assert_eq!(self.code, Some(code), "{what}\n{self:?}");
        assert_eq!(self.out, "", "{what}");
        assert!(self.err.starts_with("error: "), "{what}\n{}", self.err);
        assert_eq!(self.errors(), 1, "{what}\n{}", self.err);
        assert!(!self.err.contains("panicked"), "{what}\n{}", self.err);
        let missing: Vec<_> = words.iter().filter(|word| !self.err.contains(**word)).collect();
        assert!(missing.is_empty(), "{what}: no {missing:?} in\n{}", self.err);
    }

    /// Number of errors on standard error.
    pub fn errors(&self) -> usize {
        self.err.lines().filter(|line| line.starts_with("error")).count()
    }
}

/// Runs a command to its end.
pub fn said(mut command: Command) -> Said {
    let output = command.output().unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    Said { code: output.status.code(), out, err }
}

/// Everything below `folder`; nothing if there is none. Of a link, where it leads; of a pipe, nothing.
pub fn content(folder: &Path) -> Content {
    let mut found = Content::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        if path.is_symlink() {
            let target = fs::read_link(&path).unwrap();
            found.insert(path, Some(target.to_string_lossy().into_owned().into_bytes()));
        } else if path.is_dir() {
            found.extend(content(&path));
            found.insert(path, None);
        } else if !path.is_file() {
            found.insert(path, None);
        } else {
            found.insert(path.clone(), Some(fs::read(path).unwrap()));
        }
    }
    found
}
