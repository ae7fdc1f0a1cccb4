//! From bytes to a bank. Every size is checked against the bytes at hand before anything is allocated.

use super::error::{BankFormatError, SectionName};
use super::layout::{
    BLOCK, FILE_LENGTH_AT, FORMAT, HASH, LEVEL, MAGIC, PLACE, SECTION_HASH_AT, TABLE_HASH_AT, TITLE, VOIDS,
};
use crate::{Bank, CornerWords, Georeference, Level, WORDS};
use std::f64::consts::PI;

/// A section whose bytes are there and undamaged.
struct Section<'a> {
    name: SectionName,
    kind: [u8; 8],
    offset: u64,
    payload: &'a [u8],
}

/// The bank in the bytes of a bank file; sections of unknown kind are skipped.
///
/// # Errors
/// The first fault, with section, byte, what was found and what was expected.
pub fn decode(bytes: &[u8]) -> Result<Bank, BankFormatError> {
    let table = table(bytes)?;
    let sections =
        table.chunks_exact(BLOCK).enumerate().map(|(index, entry)| section(bytes, table, index, entry));
    let sections = sections.collect::<Result<Vec<_>, _>>()?;
    check_overlap(&sections)?;
    for section in &sections {
        check_hash(section, table)?;
    }
    let (mut levels, mut title, mut place, mut voids) = (vec![], None, None, None);
    for section in &sections {
        match section.kind {
            LEVEL => levels.push(section.level()?),
            TITLE => section.only(&mut title, section.title()?)?,
            PLACE => section.only(&mut place, section.place()?)?,
            VOIDS => section.only(&mut voids, section.voids()?)?,
            _ => {}
        }
    }
    Ok(Bank::new(title.unwrap_or_default(), levels, place)?.with_voids(voids.unwrap_or_default())?)
}

/// The section table, after the header is checked.
fn table(bytes: &[u8]) -> Result<&[u8], BankFormatError> {
    let magic = &bytes[..bytes.len().min(MAGIC.len())];
    if magic != MAGIC {
        return Err(BankFormatError::NotBank { found: magic.escape_ascii().to_string() });
    }
    let wrong_length = |expected: u64| BankFormatError::FileLength { found: bytes.len() as u64, expected };
    let header = bytes.get(..BLOCK).ok_or_else(|| wrong_length(BLOCK as u64))?;
    let [format, count] = [8, 12].map(|at| u32_at(header, at));
    if format != FORMAT {
        return Err(BankFormatError::Version { found: format });
    }
    let length = u64_at(header, FILE_LENGTH_AT);
    if length != bytes.len() as u64 {
        return Err(wrong_length(length));
    }
    let end = (u64::from(count) + 1) * BLOCK as u64;
    let end_here = usize::try_from(end).map_err(|_| wrong_length(end))?;
    let table = bytes.get(BLOCK..end_here).ok_or_else(|| wrong_length(end))?;
    let (found, expected) = (*blake3::hash(table).as_bytes(), hash_at(header, TABLE_HASH_AT));
    if found != expected {
        let (found, expected) = (short_hex(&found), short_hex(&expected));
        return Err(BankFormatError::TableChecksum { offset: BLOCK as u64, found, expected });
    }
    Ok(table)
}

fn section<'a>(
    bytes: &'a [u8],
    table: &[u8],
    index: usize,
    entry: &[u8],
) -> Result<Section<'a>, BankFormatError> {
    let kind = array_at(entry, 0);
    let name = SectionName { index, kind: kind_text(&kind) };
    let [offset, length] = [8, 16].map(|at| u64_at(entry, at));
    if !offset.is_multiple_of(BLOCK as u64) {
        return Err(BankFormatError::Misaligned { section: name, offset });
    }
    let [first, end] = [BLOCK + table.len(), bytes.len()].map(|at| at as u64);
    let inside = offset >= first && offset.checked_add(length).is_some_and(|last| last <= end);
    if !inside {
        return Err(BankFormatError::Outside { section: name, offset, length, first, end });
    }
    let payload = &bytes[offset as usize..(offset + length) as usize];
    Ok(Section { name, kind, offset, payload })
}

/// A kind as text: trailing zero bytes left out, others that are not ASCII escaped.
fn kind_text(kind: &[u8; 8]) -> String {
    let end = kind.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    kind[..end].escape_ascii().to_string()
}

fn check_overlap(sections: &[Section<'_>]) -> Result<(), BankFormatError> {
    let mut in_order: Vec<&Section<'_>> = sections.iter().filter(|s| !s.payload.is_empty()).collect();
    in_order.sort_by_key(|section| section.offset);
    for pair in in_order.windows(2) {
        let expected = pair[0].offset + pair[0].payload.len() as u64;
        if pair[1].offset < expected {
            let (section, other) = (pair[1].name.clone(), pair[0].name.clone());
            return Err(BankFormatError::Overlap { section, offset: pair[1].offset, other, expected });
        }
    }
    Ok(())
}

fn check_hash(section: &Section<'_>, table: &[u8]) -> Result<(), BankFormatError> {
    let found = *blake3::hash(section.payload).as_bytes();
    let expected = hash_at(table, section.name.index * BLOCK + SECTION_HASH_AT);
    if found == expected {
        return Ok(());
    }
    let (found, expected) = (short_hex(&found), short_hex(&expected));
    Err(BankFormatError::Checksum { section: section.name.clone(), offset: section.offset, found, expected })
}

impl Section<'_> {
    fn level(&self) -> Result<Level, BankFormatError> {
        let header = self.payload.get(..BLOCK).ok_or_else(|| self.wrong_length("at least 64"))?;
        let [region_size, north, east] = [0, 8, 16].map(|at| f64_at(header, at));
        let [rows, columns] = [24, 32].map(|at| u64_at(header, at));
        let words = &self.payload[BLOCK..];
        let needed = rows.checked_mul(columns).and_then(|corners| corners.checked_mul(WORDS as u64 * 8));
        if needed != Some(words.len() as u64) {
            return Err(self.wrong_length(&format!("64 + 72 x {rows} x {columns} corners")));
        }
        let words = self.words(words, columns)?;
        Level::new(region_size, [north, east], [rows as usize, columns as usize], words).map_err(|source| {
            BankFormatError::Level { section: self.name.clone(), offset: self.offset, source }
        })
    }

    fn words(&self, bytes: &[u8], columns: u64) -> Result<Vec<CornerWords>, BankFormatError> {
        let corner = |nine: &[u8]| std::array::from_fn(|word| f64_at(nine, 8 * word));
        let words: Vec<CornerWords> = bytes.chunks_exact(WORDS * 8).map(corner).collect();
        match words.as_flattened().iter().position(|word| !word.is_finite()) {
            None => Ok(words),
            Some(place) => {
                let (corner, word) = (place as u64 / 9, place % 9);
                let (m, n) = (corner / columns, corner % columns);
                let expected = format!("a finite number, word {word} of corner ({m}, {n})");
                Err(self.value(BLOCK + 8 * place, words.as_flattened()[place], &expected))
            }
        }
    }

    fn title(&self) -> Result<String, BankFormatError> {
        let not_text = |error: std::str::Utf8Error| {
            let at = error.valid_up_to();
            self.value(at, format!("byte {:#04x}", self.payload[at]), "UTF-8 text")
        };
        std::str::from_utf8(self.payload).map(str::to_owned).map_err(not_text)
    }

    fn place(&self) -> Result<Georeference, BankFormatError> {
        if self.payload.len() != 32 {
            return Err(self.wrong_length("32"));
        }
        let ranges = [(PI / 2.0, "latitude"), (2.0 * PI, "longitude"), (1e9, "north"), (1e9, "east")];
        for (index, (most, what)) in ranges.into_iter().enumerate() {
            let value = f64_at(self.payload, 8 * index);
            if !(-most..=most).contains(&value) {
                return Err(self.value(8 * index, value, &format!("{what} within -{most} to {most}")));
            }
        }
        let [latitude, longitude, north, east] = [0, 8, 16, 24].map(|at| f64_at(self.payload, at));
        Ok(Georeference { latitude, longitude, at: [north, east] })
    }

    fn voids(&self) -> Result<Vec<[u32; 2]>, BankFormatError> {
        if !self.payload.len().is_multiple_of(8) {
            return Err(self.wrong_length("a multiple of 8"));
        }
        Ok(self.payload.chunks_exact(8).map(|pair| [u32_at(pair, 0), u32_at(pair, 4)]).collect())
    }

    fn only<T>(&self, slot: &mut Option<T>, value: T) -> Result<(), BankFormatError> {
        match slot.replace(value) {
            None => Ok(()),
            Some(_) => Err(BankFormatError::Repeated { section: self.name.clone(), offset: self.offset }),
        }
    }

    fn wrong_length(&self, expected: &str) -> BankFormatError {
        let (section, found) = (self.name.clone(), self.payload.len() as u64);
        BankFormatError::SectionLength { section, offset: self.offset, found, expected: expected.into() }
    }

    fn value(&self, at: usize, found: impl ToString, expected: &str) -> BankFormatError {
        let (section, offset) = (self.name.clone(), self.offset + at as u64);
        BankFormatError::Value { section, offset, found: found.to_string(), expected: expected.into() }
    }
}

fn array_at<const N: usize>(bytes: &[u8], at: usize) -> [u8; N] {
    std::array::from_fn(|index| bytes[at + index])
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(array_at(bytes, at))
}

fn u64_at(bytes: &[u8], at: usize) -> u64 {
    u64::from_le_bytes(array_at(bytes, at))
}

fn f64_at(bytes: &[u8], at: usize) -> f64 {
    f64::from_le_bytes(array_at(bytes, at))
}

fn hash_at(bytes: &[u8], at: usize) -> [u8; HASH] {
    array_at(bytes, at)
}

/// The first eight bytes in hexadecimal: enough to tell two checksums apart.
fn short_hex(hash: &[u8; HASH]) -> String {
    hash[..8].iter().map(|byte| format!("{byte:02x}")).collect()
}
