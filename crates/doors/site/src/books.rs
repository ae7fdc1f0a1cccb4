//! The books of `docs/`, made into pages by MkDocs.

use std::env;
use std::ffi::OsString;
use std::path::{Path, absolute};
use std::process::{Command, Stdio};

use files::{make_folder, write_atomic};

use crate::error::SiteError;

/// Folder of the books in the site.
const FOLDER: &str = "book";

/// Settings of MkDocs, from the workspace on.
const SETTINGS: &str = "crates/doors/site/books/mkdocs.yml";

/// Variable that names the program MkDocs.
const PROGRAM: &str = "MKDOCS";

/// Why the books are left out where MkDocs is missing.
pub const MISSING: &str =
    "MkDocs is missing: `python3 -m pip install mkdocs==1.6.1` installs it, or the variable MKDOCS names its program";

/// The page that stands for the books where they are left out.
const LEFT_OUT: &[u8] = include_bytes!("../books/left-out.html");

/// Writes the books into the site `half`, whose scenarios are there; where MkDocs is missing, a page that says so. Whether it was there.
pub fn write(workspace: &Path, half: &Path) -> Result<bool, SiteError> {
    let folder = half.join(FOLDER);
    let has_mkdocs = succeeds(mkdocs().arg("--version").stdout(Stdio::null()).stderr(Stdio::null()));
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
    let failed = |source| SiteError::System { path: folder.to_owned(), doing: "name the folder", source };
    // MkDocs takes its folder from that of its settings on.
    let folder = absolute(folder).map_err(failed)?;
    let mut command = mkdocs();
    command.args(["build", "--quiet", "--config-file"]).arg(workspace.join(SETTINGS));
    command.arg("--site-dir").arg(folder).env("SOURCE_DATE_EPOCH", "0").stdout(Stdio::null());
    if succeeds(&mut command) { Ok(()) } else { Err(SiteError::Books) }
}

fn succeeds(command: &mut Command) -> bool {
    command.status().is_ok_and(|status| status.success())
}

fn mkdocs() -> Command {
    let named = env::var_os(PROGRAM);
    let mut command = Command::new(named.clone().unwrap_or_else(|| OsString::from("python3")));
    if named.is_none() {
        command.args(["-m", "mkdocs"]);
    }
    command
}
