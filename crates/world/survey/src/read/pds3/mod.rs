//! PDS3 images with a detached or an attached label, as LOLA and LROC write them.

mod image;
mod kind;
mod map;
mod special;
pub mod words;

use std::path::Path;

use super::gate;
use super::label::Label;
use super::opened::Opened;
use super::options::ReadOptions;
use super::words::Decider;
use crate::error::SurveyError;

/// The object of the samples.
const IMAGE: &str = "IMAGE";
/// The object of their place.
const MAP: &str = "IMAGE_MAP_PROJECTION";

/// Most bytes of a label; those of the archives have some thousand.
const LABEL_BYTES: u64 = 1 << 20;

/// Whether a file begins like a label.
pub fn is_label(start: &[u8]) -> bool {
    let words = [&b"PDS_VERSION_ID"[..], b"CCSD3ZF", b"ODL_VERSION_ID", b"/*"];
    let start = start.trim_ascii_start();
    words.iter().any(|word| start.starts_with(word))
}

/// Opens the image that a label describes.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let bytes = gate::front(path, LABEL_BYTES)?;
    let mut decider = Decider::new(path, options);
    let label = Label::of(path, &words::DIALECT, &bytes, &mut decider)?;
    let (file, start) = image::locate(&label)?;
    let mut opened = image::open(&label, &file, start, options)?;
    opened.notes.extend(decider.finish()?);
    if file != path {
        opened.sources.insert(0, path.to_path_buf());
    }
    Ok(opened)
}
