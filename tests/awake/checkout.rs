//! The files that are broken: this checkout, or a clone of its last commit.

use std::path::{Path, PathBuf};
use std::process::Command;

use lunoid_tests::breaks::{Break, root};

/// A checkout, and the folder that cargo builds it into.
#[derive(Debug)]
pub struct Checkout {
    /// Root folder of the checkout.
    pub root: PathBuf,
    /// Target folder: the clone has its own. In one folder cargo would hold a library of the clone for that of this
    /// checkout, look for changes in the clone's files only, and never compile this checkout's again.
    pub target: PathBuf,
    /// Profile by which it is compiled.
    pub profile: String,
}

/// Profile with debug assertions and overflow checks.
const CHECKED: &str = "dev";

/// A break in the files; restored when dropped, by a panic too.
pub struct Broken {
    path: PathBuf,
    before: String,
}

impl Checkout {
    /// Returns the checkout that this program was built from.
    pub fn here() -> Self {
        let target =
            std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
        Self { root: root(), target, profile: CHECKED.into() }
    }

    /// A clone at the last commit of this checkout, in the target folder; it is kept from run to run.
    pub fn cloned() -> Result<Self, String> {
        let here = Self::here();
        let clone = here.target.join("awake");
        if clone.exists() {
            git(&clone, &["fetch", "--quiet", "origin", "HEAD"])?;
        } else {
            std::fs::create_dir_all(&here.target).map_err(|error| error.to_string())?;
            let [from, to] = [&here.root, &clone].map(|path| path.to_string_lossy().into_owned());
            git(&here.root, &["clone", "--quiet", "--no-checkout", &from, &to])?;
            git(&clone, &["fetch", "--quiet", "origin", "HEAD"])?;
        }
        git(&clone, &["reset", "--quiet", "--hard", "FETCH_HEAD"])?;
        let target = clone.join("target");
        Ok(Self { root: clone, target, profile: CHECKED.into() })
    }

    /// That every break applies, and that no file of one has changes that are not committed.
    pub fn check(&self, breaks: &[Break]) -> Result<(), String> {
        for one in breaks {
            one.texts(&self.root)?;
            let file = one.file.to_string_lossy();
            if !git(&self.root, &["status", "--porcelain", "--", &file])?.is_empty() {
                return Err(format!("{file}: it has changes that are not committed; commit them first"));
            }
        }
        Ok(())
    }

    /// Breaks the code until the returned value is dropped.
    pub fn apply(&self, one: &Break) -> Result<Broken, String> {
        let [before, after] = one.texts(&self.root)?;
        let path = self.root.join(&one.file);
        write(&path, &after)?;
        Ok(Broken { path, before })
    }

    /// Its last commit, in twelve digits.
    pub fn commit(&self) -> Result<String, String> {
        git(&self.root, &["rev-parse", "--short=12", "HEAD"])
    }
}

impl Drop for Broken {
    fn drop(&mut self) {
        // Its time is new, so that cargo compiles it again.
        if let Err(error) = write(&self.path, &self.before) {
            eprintln!("error: still broken, restore it by `git checkout`: {error}");
        }
    }
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    files::write_atomic(path, |file| file.write_all(text.as_bytes())).map_err(|error| error.to_string())
}

fn git(folder: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new("git").arg("-C").arg(folder).args(arguments).output();
    let output = output.map_err(|error| format!("git: {error}"))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(format!("git {}: {}", arguments.join(" "), said.trim()));
    }
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
