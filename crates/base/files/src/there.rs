//! What is there, on the disk or given.

use std::fs;
use std::path::Path;

use crate::given::{self, Found};

/// Whether a file is at `path`, on the disk or given. A link to a file counts.
pub fn is_file(path: impl AsRef<Path>) -> bool {
    let path = path.as_ref();
    given::find(path).map_or_else(|| path.is_file(), |found| matches!(found, Found::File(_)))
}

/// Whether a file or a folder is at `path`, on the disk or given.
pub fn is_there(path: impl AsRef<Path>) -> bool {
    let path = path.as_ref();
    given::find(path).map_or_else(|| path.exists(), |found| !matches!(found, Found::Nothing))
}

/// The names of what lies in a folder, on the disk or given, in alphabetical order; none where it cannot be listed. Names that are no
/// Unicode are left out.
pub fn names_in(folder: impl AsRef<Path>) -> Vec<String> {
    let folder = folder.as_ref();
    given::names(folder).unwrap_or_else(|| {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        let mut names: Vec<String> =
            entries.filter_map(|entry| entry.file_name().into_string().ok()).collect();
        names.sort();
        names
    })
}
