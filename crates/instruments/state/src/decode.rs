//! From bytes to a state. Every length is checked against the bytes at hand before anything is allocated.

use std::sync::Arc;

use serde::Deserialize;

use crate::Fault;
use crate::container::{
    Block, BlockHeader, BlockKind, CHECKSUM, FORMAT, Head, Header, LEAD, MAGIC, SCHEMA, State, checksum,
};

/// The state in the bytes of a file.
pub(crate) fn decode(bytes: &[u8]) -> Result<State, Fault> {
    check_lead(bytes)?;
    let mut rest = Rest { bytes, at: LEAD };
    let header = header(rest.take("header", u64::from(u32_at(bytes, 12)))?)?;
    let digital = text("digital side", rest.take("digital side", header.digital_bytes)?)?.to_owned();
    rest.align()?;
    check_order(&header.blocks)?;
    let blocks = header.blocks.iter().map(|block| rest.block(block)).collect::<Result<_, _>>()?;
    rest.end()?;
    let Header { saved_by, words, place, tick, time_s, .. } = header;
    Ok(State { head: Head { identity: saved_by, words, place, tick, time_s }, digital, blocks })
}

/// The first bytes: magic, format, length, checksum.
fn check_lead(bytes: &[u8]) -> Result<(), Fault> {
    let magic = &bytes[..bytes.len().min(MAGIC.len())];
    if magic != MAGIC {
        return Err(Fault::NotState { found: magic.escape_ascii().to_string() });
    }
    let length = bytes.len() as u64;
    if bytes.len() < LEAD {
        return Err(Fault::Length { found: length, expected: LEAD as u64 });
    }
    let format = u32_at(bytes, 8);
    if format != FORMAT {
        return Err(Fault::Format { found: format });
    }
    let stated = u64::from_le_bytes(array_at(bytes, 16));
    if stated != length {
        return Err(Fault::Length { found: length, expected: stated });
    }
    let (found, expected) = (checksum(bytes), array_at::<32>(bytes, CHECKSUM));
    if found != expected {
        let [found, expected] = [found, expected].map(|hash| hex(&hash));
        return Err(Fault::Checksum { found, expected });
    }
    let reserved = u64::from_le_bytes(array_at(bytes, 24));
    expect("byte 24, reserved", reserved, 0)
}

fn header(bytes: &[u8]) -> Result<Header, Fault> {
    #[derive(Deserialize)]
    struct Schema {
        schema: String,
    }
    let refused = |error: serde_json::Error| Fault::Value {
        part: format!("header, line {} column {}", error.line(), error.column()),
        found: error.to_string(),
        expected: "the keys of docs/state-format.md".into(),
    };
    let Schema { schema } = serde_json::from_slice(bytes).map_err(refused)?;
    if schema != SCHEMA {
        return Err(Fault::Schema { found: schema });
    }
    serde_json::from_slice(bytes).map_err(refused)
}

/// Rows first and once, then stores, then pictures, each ascending by frame.
fn check_order(blocks: &[BlockHeader]) -> Result<(), Fault> {
    let begins = blocks.first().is_some_and(|block| block.kind == BlockKind::Rows);
    let follows = |pair: &[BlockHeader]| (pair[0].kind, pair[0].frame) < (pair[1].kind, pair[1].frame);
    let is_once = blocks.iter().filter(|block| block.kind == BlockKind::Rows).count() == 1;
    if begins && is_once && blocks.windows(2).all(follows) {
        return Ok(());
    }
    let names =
        blocks.iter().take(40).map(|block| format!("{:?} {}", block.kind, block.frame).to_lowercase());
    Err(Fault::Value {
        part: "header, blocks".into(),
        found: names.collect::<Vec<_>>().join(", "),
        expected: "rows, then stores, then pictures, each kind ascending by frame".into(),
    })
}

/// The bytes that are not read yet.
struct Rest<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Rest<'a> {
    fn take(&mut self, part: &str, length: u64) -> Result<&'a [u8], Fault> {
        let rest = &self.bytes[self.at..];
        let taken = usize::try_from(length).ok().and_then(|length| rest.get(..length));
        let taken = taken.ok_or_else(|| Fault::TooLong {
            part: part.to_owned(),
            found: length,
            most: rest.len() as u64,
        })?;
        self.at += taken.len();
        Ok(taken)
    }

    /// Passes over the zeros in front of the blocks.
    fn align(&mut self) -> Result<(), Fault> {
        let at = self.at;
        let zeros = self.take("padding before the blocks", (at.next_multiple_of(LEAD) - at) as u64)?;
        match zeros.iter().position(|&byte| byte != 0) {
            None => Ok(()),
            Some(place) => expect(&format!("byte {}", at + place), u64::from(zeros[place]), 0),
        }
    }

    fn block(&mut self, header: &BlockHeader) -> Result<Block, Fault> {
        let BlockHeader { kind, frame, rows, values_a_row } = *header;
        let mut block = Block { kind, frame, rows, row: values_a_row, values: Arc::default() };
        let length = rows.checked_mul(values_a_row).and_then(|values| values.checked_mul(4));
        let at = self.at as u64;
        let bytes = self.take(&block.name().to_string(), length.unwrap_or(u64::MAX))?;
        let values = bytes.as_chunks::<4>().0.iter().map(|&word| f32::from_le_bytes(word));
        let values: Vec<f32> = values.collect();
        if let Some(place) = values.iter().position(|value| !value.is_finite()) {
            let (found, place) = (values[place], place as u64);
            let (row, value) = (place / values_a_row, place % values_a_row);
            return Err(Fault::NotFinite { block: block.name(), row, value, byte: at + 4 * place, found });
        }
        block.values = Arc::new(values);
        Ok(block)
    }

    fn end(&self) -> Result<(), Fault> {
        expect("bytes behind the last block", (self.bytes.len() - self.at) as u64, 0)
    }
}

fn expect(part: &str, found: u64, expected: u64) -> Result<(), Fault> {
    if found == expected {
        return Ok(());
    }
    let [found, expected] = [found, expected].map(|number| number.to_string());
    Err(Fault::Value { part: part.to_owned(), found, expected })
}

fn text<'a>(part: &str, bytes: &'a [u8]) -> Result<&'a str, Fault> {
    std::str::from_utf8(bytes).map_err(|error| Fault::Value {
        part: format!("{part}, byte {} of it", error.valid_up_to()),
        found: format!("byte {:#04x}", bytes[error.valid_up_to()]),
        expected: "UTF-8 text".into(),
    })
}

fn array_at<const N: usize>(bytes: &[u8], at: usize) -> [u8; N] {
    std::array::from_fn(|index| bytes[at + index])
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(array_at(bytes, at))
}

/// The first eight bytes of a checksum: enough to tell two apart.
fn hex(hash: &[u8; 32]) -> String {
    hash[..8].iter().map(|byte| format!("{byte:02x}")).collect()
}
