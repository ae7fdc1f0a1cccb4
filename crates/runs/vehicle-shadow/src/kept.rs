//! Pictures that an earlier run has made: each tells in itself what it was made from and what that took.

use std::io::Read;
use std::path::Path;

use picture::{Limits, decode_png, png_texts};
use serde::{Deserialize, Serialize};

use crate::frame_work::FrameWork;

/// Keyword of the text chunk.
const KEYWORD: &str = "Augmentation";

/// Bytes of a file in which the stamp is looked for.
const HEAD_BYTES: u64 = 1 << 16;

/// What a picture tells of itself.
#[derive(Serialize, Deserialize)]
pub(crate) struct Stamp {
    /// Hash of everything that the picture is made from.
    made_from: String,
    /// Hash of the same without the old picture and its pose: that of all pictures of a folder.
    #[serde(default)]
    pub inputs: String,
    work: FrameWork,
}

/// Keyword and text for a picture made from what has the hash `key`.
pub(crate) fn stamp(key: &str, inputs: &str, work: &FrameWork) -> (&'static str, String) {
    let stamp = Stamp { made_from: key.to_owned(), inputs: inputs.to_owned(), work: work.clone() };
    // JSON escapes nothing but quotes in it; names of files may hold what Latin-1 does not.
    let text: String = serde_json::to_string(&stamp).expect("plain values");
    (KEYWORD, text.chars().map(|c| if c.is_ascii() { c } else { '?' }).collect())
}

/// What the picture at `path` took, if it is whole and was made from what has the hash `key`.
pub(crate) fn kept(path: &Path, key: &str) -> Option<FrameWork> {
    let limits = Limits::default();
    let bytes = files::read_all(path, limits.file_bytes).ok()?;
    let Stamp { made_from, mut work, .. } = stamp_in(&bytes)?;
    let is_whole = || decode_png(&bytes, &limits).is_ok_and(|found| found.pixel_hash() == work.pixels_blake3);
    if made_from != key || !is_whole() {
        return None;
    }
    work.file = path.file_name()?.to_string_lossy().into_owned();
    Some(work)
}

/// What the picture at `path` tells of itself, if a command of this kind has made it.
pub(crate) fn stamp_of(path: &Path) -> Option<Stamp> {
    let mut head = Vec::new();
    files::open(path).ok()?.take(HEAD_BYTES).read_to_end(&mut head).ok()?;
    stamp_in(&head)
}

fn stamp_in(bytes: &[u8]) -> Option<Stamp> {
    let (_, text) = png_texts(bytes).into_iter().find(|(keyword, _)| keyword == KEYWORD)?;
    serde_json::from_str(&text).ok()
}
