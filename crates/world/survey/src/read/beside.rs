//! Files beside another one: the data of a label, the label of data.

use std::ffi::OsString;
use std::path::{Component, Path, PathBuf};

use crate::error::SurveyError;

/// The file of the same name with another ending, in any case, in the same folder.
pub fn with_ending(path: &Path, ending: &str) -> Result<Option<PathBuf>, SurveyError> {
    match path.file_stem() {
        Some(stem) => in_folder(path, &format!("{}.{ending}", stem.to_string_lossy())),
        None => Ok(None),
    }
}

/// The path of a file beside another, whose name goes on with `ending`.
pub fn going_on(path: &Path, ending: &str) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(ending);
    name.into()
}

/// A file of this name, in any case, in the folder of `beside`.
pub fn in_folder(beside: &Path, name: &str) -> Result<Option<PathBuf>, SurveyError> {
    let folder = beside.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let failed = |source| SurveyError::Read { path: folder.to_path_buf(), source };
    let mut found = Vec::new();
    for entry in folder.read_dir().map_err(failed)? {
        let entry = entry.map_err(failed)?;
        if entry.file_name().to_string_lossy().eq_ignore_ascii_case(name) {
            found.push(beside.with_file_name(entry.file_name()));
        }
    }
    // An exact match goes before one that differs in case; else the order is that of the names.
    found.sort_by_key(|path| (path.file_name().is_none_or(|found| found != name), path.clone()));
    Ok(found.into_iter().next())
}

/// Whether a name that a label gives is that of a file in the label's folder. A label may come from anywhere: it must not
/// choose files outside its folder.
pub fn is_plain(name: &str) -> bool {
    Path::new(name).components().eq([Component::Normal(name.as_ref())]) && !name.contains(['/', '\\', ':'])
}

#[cfg(test)]
mod tests {
    use super::is_plain;

    #[test]
    fn names_lead_nowhere_else() {
        assert!(is_plain("a.img") && is_plain("A b.IMG"));
        for name in ["", ".", "..", "/a", "a/b", "..\\a", "c:a", "a/", "./a"] {
            assert!(!is_plain(name), "{name}");
        }
    }
}
