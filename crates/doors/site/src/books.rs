//! The books of `docs/`, made into pages by MkDocs.

use std::env;
use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::error::SiteError;

/// Folder of the books in the site.
const FOLDER: &str = "book";

/// Settings of MkDocs, from the workspace on.
const SETTINGS: &str = "crates/doors/site/books/mkdocs.yml";

/// Variable that names the program MkDocs.
const PROGRAM: &str = "MKDOCS";

/// Why the books are left out where MkDocs is missing.
pub const MISSING: &str =
    "MkDocs is missing: `pip install mkdocs==1.6.1` installs it, or the variable MKDOCS names its program";

/// Writes the books into the site `half`, whose scenarios are there. False where MkDocs is missing.
pub fn write(workspace: &Path, half: &Path) -> Result<bool, SiteError> {
    let is_there = mkdocs().arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !is_there.is_ok_and(|status| status.success()) {
        return Ok(false);
    }
    let out = std::path::absolute(half).unwrap_or_else(|_| half.to_owned()).join(FOLDER);
    let mut command = mkdocs();
    command.args(["build", "--quiet", "--config-file"]).arg(workspace.join(SETTINGS));
    command.arg("--site-dir").arg(out).stdout(Stdio::null());
    // The day of the build stands nowhere.
    let status = command.env("SOURCE_DATE_EPOCH", "0").status();
    if status.is_ok_and(|status| status.success()) { Ok(true) } else { Err(SiteError::Books) }
}

fn mkdocs() -> Command {
    let named = env::var_os(PROGRAM);
    let mut command = Command::new(named.clone().unwrap_or_else(|| OsString::from("python3")));
    if named.is_none() {
        command.args(["-m", "mkdocs"]);
    }
    command
}
