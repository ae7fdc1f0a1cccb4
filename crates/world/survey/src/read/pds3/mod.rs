//! PDS3 images with a detached or an attached label, as LOLA and LROC write them.

mod image;
mod kind;
mod label;
mod map;
mod special;
mod statements;
pub mod words;

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use self::statements::Label;
use super::options::ReadOptions;
use super::refusal::field;
use super::words::Decider;
use crate::elevation::Elevation;
use crate::error::SurveyError;

/// Most bytes of a label; those of the archives have some thousand.
const LABEL_BYTES: u64 = 1 << 20;

/// Whether a file begins like a label.
pub fn is_label(start: &[u8]) -> bool {
    let words = [&b"PDS_VERSION_ID"[..], b"CCSD3ZF", b"ODL_VERSION_ID", b"/*"];
    let start = start.trim_ascii_start();
    words.iter().any(|word| start.starts_with(word))
}

/// The label of the same name in the same folder, for an image without one of its own.
pub fn label_beside(path: &Path) -> Result<Option<PathBuf>, SurveyError> {
    match path.file_stem() {
        Some(stem) => in_folder(path, &format!("{}.lbl", stem.to_string_lossy())),
        None => Ok(None),
    }
}

/// A file of this name, in any case, in the folder of `beside`.
fn in_folder(beside: &Path, name: &str) -> Result<Option<PathBuf>, SurveyError> {
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

/// Reads the image that a label describes.
pub fn read(path: &Path, options: &ReadOptions) -> Result<Elevation, SurveyError> {
    let failed = |source| SurveyError::Read { path: path.to_path_buf(), source };
    let mut bytes = Vec::new();
    File::open(path).map_err(failed)?.take(LABEL_BYTES).read_to_end(&mut bytes).map_err(failed)?;
    let statements = label::parse(&bytes).map_err(|fault| {
        let advice = "the label is damaged: correct it or fetch it again";
        field(path, format!("label line {}", fault.line), fault.found, fault.expected, advice)
    })?;
    let mut decider = Decider::new(path, options);
    let label = Label::decided(path, statements, &mut decider)?;
    let (file, start) = image::locate(&label)?;
    let mut elevation = image::read(&label, &file, start, options)?;
    elevation.notes.extend(decider.finish()?);
    if file != path {
        elevation.sources.insert(0, path.to_path_buf());
    }
    Ok(elevation)
}
