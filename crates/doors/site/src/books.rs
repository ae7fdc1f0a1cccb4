//! The books of `docs/`, made into pages by MkDocs.

use std::env;
use std::ffi::OsString;
use std::path::{Path, absolute};
use std::process::{Command, Output};

use files::{make_folder, write_atomic};

use crate::error::SiteError;

/// Folder of the books in the site.
const FOLDER: &str = "book";

/// Settings of MkDocs, from the workspace on.
const SETTINGS: &str = "crates/doors/site/books/mkdocs.yml";

/// Variable that names the program MkDocs.
const PROGRAM: &str = "MKDOCS";

/// Why the books are left out where MkDocs is missing.
pub const MISSING: &str = "MkDocs is missing: `python3 -m pip install mkdocs==1.6.1` installs it, or the variable MKDOCS names its program";

/// The page that stands for the books where they are left out.
const LEFT_OUT: &[u8] = include_bytes!("../books/left-out.html");

/// Writes the books into the site `half`, whose scenarios are there; where MkDocs is missing, a page that says so. Whether it was there.
pub fn write(workspace: &Path, half: &Path) -> Result<bool, SiteError> {
    let folder = half.join(FOLDER);
    let has_mkdocs = mkdocs().arg("--version").output().is_ok_and(|output| output.status.success());
    if has_mkdocs {
        make(workspace, &folder)?;
    } else {
        make_folder(&folder)?;
        write_atomic(folder.join("index.html"), |out| out.write_all(LEFT_OUT))?;
    }
    Ok(has_mkdocs)
}

/// Makes the pages in `folder`. The day of the build stands nowhere in them.
fn make(workspace: &Path, folder: &Path) -> Result<(), SiteError> {
    let failed = |doing| move |source| SiteError::System { path: folder.to_owned(), doing, source };
    let mut command = mkdocs();
    command.args(["build", "--config-file"]).arg(workspace.join(SETTINGS)).env("SOURCE_DATE_EPOCH", "0");
    // Nothing is left behind beside the hooks.
    command.env("PYTHONDONTWRITEBYTECODE", "1");
    // MkDocs takes its folder from that of its settings on.
    command.arg("--site-dir").arg(absolute(folder).map_err(failed("name the folder"))?);
    let Output { status, stderr, .. } = command.output().map_err(failed("make the books"))?;
    if status.success() {
        Ok(())
    } else {
        Err(SiteError::Books(String::from_utf8_lossy(&stderr).into_owned()))
    }
}

fn mkdocs() -> Command {
    let named = env::var_os(PROGRAM);
    let mut command = Command::new(named.clone().unwrap_or_else(|| OsString::from("python3")));
    if named.is_none() {
        command.args(["-m", "mkdocs"]);
    }
    command
}
