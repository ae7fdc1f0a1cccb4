//! A TIFF file that is open, within the limits of its size.

use std::fs::File;
use std::io::{BufReader, Seek};
use std::path::Path;

use tiff::TiffResult;
use tiff::decoder::ifd::Value;
use tiff::decoder::{Decoder, Limits};
use tiff::tags::Tag;

use super::directory::{TooLarge, too_large};
use crate::error::SurveyError;
use crate::read::gate;
use crate::read::refusal::field;

/// Most decoded bytes a byte of a compressed file; flat ground packs well, but not without limit.
pub const MOST_EXPANSION: u64 = 4096;

/// Most bytes of the values of a tag: the places of some ten million tiles.
const MOST_VALUE: usize = 256 << 20;

/// A TIFF file being read.
pub type Tiff = Decoder<BufReader<File>>;

/// A TIFF at its first picture, and its bytes.
pub fn open(path: &Path) -> Result<(Tiff, u64), SurveyError> {
    let failed = |source| SurveyError::Read { path: path.to_path_buf(), source };
    let (file, bytes) = gate::open(path)?;
    let mut file = BufReader::new(file);
    if let Some(claim) = too_large(&mut file, bytes) {
        return Err(impossible(path, claim, bytes));
    }
    file.rewind().map_err(failed)?;
    let broken = |source| SurveyError::Tiff { path: path.to_path_buf(), place: "header".into(), source };
    Ok((Decoder::new(file).map_err(broken)?.with_limits(limits(bytes)), bytes))
}

fn impossible(path: &Path, TooLarge { tag, bytes }: TooLarge, size: u64) -> SurveyError {
    let place = tag.map_or_else(|| "directory".to_owned(), |tag| format!("tag {tag}"));
    let expected = format!("at most {size}, the bytes of the file");
    field(path, place, format!("{bytes} bytes"), expected, "the header is damaged: fetch the file again")
}

/// What a strip or a value of a file of so many bytes may take, whatever its header claims.
pub fn limits(bytes: u64) -> Limits {
    let usual = Limits::default();
    let most = |bytes: u64, usual: usize| usize::try_from(bytes).map_or(usual, |bytes| bytes.min(usual));
    let mut limits = usual.clone();
    limits.decoding_buffer_size = most(bytes.saturating_mul(MOST_EXPANSION), usual.decoding_buffer_size);
    limits.intermediate_buffer_size = most(bytes, usual.intermediate_buffer_size);
    limits.ifd_value_size = most(bytes, MOST_VALUE);
    limits
}

/// Text of a tag, without what ends it.
pub fn text(tiff: &mut Tiff, tag: Tag) -> TiffResult<Option<String>> {
    let value = tiff.find_tag(tag)?.map(Value::into_string).transpose()?;
    Ok(value.map(|text| text.trim_end_matches('\0').to_string()))
}
