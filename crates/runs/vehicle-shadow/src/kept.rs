//! Pictures that an earlier run has made: each tells in itself what it was made from and what that took.

use std::fs;
use std::path::{Path, PathBuf};

use picture::{Limits, decode_png, png_texts};
use serde::{Deserialize, Serialize};

use crate::FrameWork;

/// Keyword of the text chunk.
const KEYWORD: &str = "Augmentation";

#[derive(Serialize, Deserialize)]
struct Stamp {
    /// Hash of everything that the picture is made from.
    made_from: String,
    work: FrameWork,
}

/// Keyword and text for a picture made from what has the hash `key`.
pub(crate) fn stamp(key: &str, work: &FrameWork) -> (&'static str, String) {
    let stamp = Stamp { made_from: key.to_owned(), work: work.clone() };
    // JSON escapes nothing but quotes in it; names of files may hold what Latin-1 does not.
    let text: String = serde_json::to_string(&stamp).expect("plain values");
    (KEYWORD, text.chars().map(|c| if c.is_ascii() { c } else { '?' }).collect())
}

/// What the picture at `path` took, if it is whole and was made from what has the hash `key`.
pub(crate) fn kept(path: &Path, key: &str) -> Option<FrameWork> {
    let limits = Limits::default();
    let bytes = files::read_all(path, limits.file_bytes).ok()?;
    let (_, text) = png_texts(&bytes).into_iter().find(|(keyword, _)| keyword == KEYWORD)?;
    let Stamp { made_from, mut work } = serde_json::from_str(&text).ok()?;
    let is_whole = || decode_png(&bytes, &limits).is_ok_and(|found| found.pixel_hash() == work.pixels_blake3);
    if made_from != key || !is_whole() {
        return None;
    }
    work.file = path.file_name()?.to_string_lossy().into_owned();
    Some(work)
}

/// Folders that were not there, the deepest first: they go again if nothing comes into them.
pub(crate) struct Made(Vec<PathBuf>);

impl Made {
    /// Those on the way to `folder`.
    pub fn at(folder: &Path) -> Self {
        let missing = folder.ancestors().take_while(|path| !path.as_os_str().is_empty() && !path.exists());
        Self(missing.map(Path::to_owned).collect())
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        for folder in &self.0 {
            // One with anything in it stays.
            let _ = fs::remove_dir(folder);
        }
    }
}
