//! Places of the files of real ground.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Once;

/// The folder of real data, in the first folder upwards from here that has it; said once where there is none.
pub fn data() -> Option<PathBuf> {
    static TOLD: Once = Once::new();
    let above = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let found = above.map(|folder| folder.join("shared/data")).find(|folder| folder.is_dir());
    if found.is_none() {
        // Not `println`, which a passing test keeps to itself.
        TOLD.call_once(|| {
            let _ =
                writeln!(io::stderr(), "SKIPPED: drives over real ground; there is no folder shared/data");
        });
    }
    found
}

/// A file among the scenarios over real ground.
pub fn scenario(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenarios/real").join(file)
}

/// A text without the lines that begin with `#`.
pub fn without_comments(text: &str) -> String {
    text.lines().filter(|line| !line.starts_with('#')).map(|line| format!("{line}\n")).collect()
}
