//! A tiny scenario in a folder of its own, and the command run in that folder.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use assert_cmd::Command;
use tempfile::TempDir;

const SCENARIO: &str = include_str!("../tiny.toml");

/// A folder with `tiny.toml`.
pub struct Scene {
    folder: TempDir,
}

impl Scene {
    pub fn new() -> Self {
        let scene = Self { folder: tempfile::tempdir().unwrap() };
        scene.write("tiny.toml", SCENARIO);
        scene
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    pub fn join(&self, name: &str) -> PathBuf {
        self.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.join(name), content).unwrap();
    }

    /// `tiny.toml` with one thing changed, as `name`.
    pub fn vary(&self, name: &str, old: &str, new: &str) {
        assert!(SCENARIO.contains(old), "{old}");
        self.write(name, SCENARIO.replace(old, new));
    }

    /// Runs the command in the folder.
    pub fn run(&self, arguments: &[&str]) -> Output {
        lunoid().current_dir(self.path()).args(arguments).output().unwrap()
    }

    /// Runs the command, which must end with `code`; standard output and standard error.
    pub fn expect(&self, code: i32, arguments: &[&str]) -> (String, String) {
        let output = self.run(arguments);
        let [out, err] =
            [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
        assert_eq!(output.status.code(), Some(code), "{arguments:?}\n{out}\n{err}");
        assert!(!err.contains("panicked"), "{err}");
        (out, err)
    }

    /// Names in a folder below.
    pub fn list(&self, name: &str) -> Vec<String> {
        let entries = fs::read_dir(self.join(name)).into_iter().flatten();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

/// The command, without what the environment may say.
pub fn lunoid() -> Command {
    let mut command = Command::cargo_bin("lunoid").unwrap();
    let shards = ["LUNOID_SHARDS", "SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX"];
    for name in ["LUNOID_THREADS", "NO_COLOR", "CLICOLOR_FORCE"].into_iter().chain(shards) {
        command.env_remove(name);
    }
    command
}
