//! PDS4 products: a label in XML, and an array in a file beside it (PDS4 Standards Reference 1.22).

mod array;
mod label;
mod place;
pub mod words;

use std::path::Path;

use landscape::LUNOID_RADIUS;

use self::label::{Label, parse};
use super::gate;
use super::opened::Opened;
use super::options::ReadOptions;
use super::refusal::field;
use super::samples::Conversion;
use super::words::Decider;
use crate::elevation::Grid;
use crate::error::SurveyError;

/// Most bytes of a label; those of the archives have some hundred thousand.
const LABEL_BYTES: u64 = 1 << 23;

/// Whether a file begins like a label.
pub fn is_label(start: &[u8]) -> bool {
    let start = text::without_byte_order_mark(start).trim_ascii_start();
    start.starts_with(b"<?xml") || start.starts_with(b"<Product_")
}

/// Opens the array that a label describes.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let text = text(path)?;
    let document = parse(path, &text)?;
    let mut decider = Decider::new(path, options);
    let label = Label::of(path, &document, &mut decider)?;
    let mut notes = decider.finish()?;
    let file = array::file(&label)?;
    let raw = array::raw(&label, &file, options)?;
    let (affine, frame) = place::place(&label, options, [raw.lines, raw.columns], &mut notes)?;
    let said = array::said(&label, raw.kind, frame.sphere().unwrap_or(LUNOID_RADIUS), &mut notes)?;
    Ok(Opened {
        grid: Grid { lines: raw.lines, columns: raw.columns, affine, frame },
        path: path.to_path_buf(),
        title: label.title()?.to_owned(),
        sources: vec![path.to_path_buf(), file],
        notes,
        conversion: Conversion::new(path, options, said)?,
        samples: Box::new(raw),
    })
}

/// The text of a label, in UTF-8.
fn text(path: &Path) -> Result<String, SurveyError> {
    let bytes = gate::front(path, LABEL_BYTES + 1)?;
    if bytes.len() as u64 > LABEL_BYTES {
        let expected = format!("at most {LABEL_BYTES} bytes");
        return Err(field(path, "label", "a longer one", expected, "name the label of the product"));
    }
    String::from_utf8(bytes).map_err(|error| {
        let place = format!("label, byte {}", error.utf8_error().valid_up_to());
        field(path, place, "bytes that are no text", "UTF-8", "the label is damaged: fetch it again")
    })
}
