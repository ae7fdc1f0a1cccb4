//! From bytes to a bank. Every size is checked against the bytes at hand before anything is allocated; the words of a level are
//! read straight to where they stay, and nothing of them is parsed.

use files::{Pieces, PiecesError};

use super::error::{BankFormatError, SectionName};
use super::layout::{
    BLOCK, FILE_LENGTH_AT, FORMAT, HASH, LEVEL, MAGIC, MAP, NORTH, PLACE, SECTION_HASH_AT, TABLE_HASH_AT,
    TITLE, VOIDS,
};
use super::{Outline, map};
use crate::{Bank, BankError, CornerWords, Georeference, Level, MapFrame, WORDS};
use std::f64::consts::PI;
use std::mem;

/// Bytes of a corner.
const CORNER: usize = WORDS * 8;

/// A section that lies within the file.
struct Section<P> {
    name: SectionName,
    kind: [u8; 8],
    offset: u64,
    length: u64,
    payload: P,
}

/// Bytes of a section.
enum Payload {
    Bytes(Vec<u8>),
    /// Of a level: its header, and its words where they stay.
    Level([u8; BLOCK], Vec<CornerWords>),
}

/// Why there is no bank.
type Fault<E> = PiecesError<E, BankFormatError>;

impl<E> From<BankFormatError> for Fault<E> {
    fn from(error: BankFormatError) -> Self {
        Self::Format(error)
    }
}

impl<E> From<BankError> for Fault<E> {
    fn from(error: BankError) -> Self {
        Self::Format(error.into())
    }
}

/// The bank in the bytes of a bank file; sections of unknown kind are skipped.
///
/// # Errors
/// The first fault, with section, byte, what was found and what was expected.
pub fn decode(mut bytes: &[u8]) -> Result<Bank, BankFormatError> {
    decode_pieces(&mut bytes).map_err(PiecesError::of_format)
}

/// The same of a bank file that is read piece by piece.
pub(super) fn decode_pieces<B: Pieces>(
    bytes: &mut B,
) -> Result<Bank, PiecesError<B::Error, BankFormatError>> {
    let table = table(bytes)?;
    let entries = table.chunks_exact(BLOCK).enumerate();
    let sections = entries.map(|(index, entry)| section(bytes.length(), &table, index, entry));
    let sections = sections.collect::<Result<Vec<_>, _>>()?;
    check_overlap(&sections)?;
    let sections = sections.into_iter().map(|section| section.read(bytes, &table));
    let sections = sections.collect::<Result<Vec<_>, _>>()?;
    let (mut levels, mut title, mut place) = (vec![], None, None);
    let (mut north, mut voids, mut map) = (None, None, None);
    for mut section in sections {
        match section.kind {
            LEVEL => levels.push(section.level()?),
            TITLE => section.only(&mut title, section.title()?)?,
            PLACE => section.only(&mut place, section.place()?)?,
            NORTH => section.only(&mut north, section.north()?)?,
            VOIDS => section.only(&mut voids, section.voids()?)?,
            MAP => section.only(&mut map, section.map()?)?,
            _ => {}
        }
    }
    if place.is_none() && north.is_some() {
        return Err(BankFormatError::NorthWithoutPlace.into());
    }
    let place = place.map(|place| Georeference { true_north: north, ..place });
    let bank = Bank::new(title.unwrap_or_default(), levels, place)?;
    Ok(bank.with_voids(voids.unwrap_or_default())?.with_map(map))
}

/// What a bank file says of its place: the ground itself is not read.
pub(super) fn decode_outline<B: Pieces>(
    bytes: &mut B,
) -> Result<Outline, PiecesError<B::Error, BankFormatError>> {
    let table = table(bytes)?;
    let (mut map, mut extent) = (None, None);
    for (index, entry) in table.chunks_exact(BLOCK).enumerate() {
        let section = section(bytes.length(), &table, index, entry)?;
        if section.kind == MAP {
            let section = section.read(bytes, &table)?;
            section.only(&mut map, section.map()?)?;
        } else if section.kind == LEVEL && extent.is_none() && section.length >= BLOCK as u64 {
            let mut header = [0; BLOCK];
            bytes.fill(section.offset, &mut header).map_err(Fault::Read)?;
            extent = Some(extent_of(&header));
        }
    }
    Ok(Outline { map, extent: extent.ok_or(BankError::NoLevels)? })
}

/// South, west, north, east edge (m) of the level with this header.
fn extent_of(header: &[u8; BLOCK]) -> [f64; 4] {
    let [size, south, west] = [0, 8, 16].map(|at| f64_at(header, at));
    let [north, east] = [24, 32].map(|at| u64_at(header, at).saturating_sub(1) as f64 * size);
    [south, west, south + north, west + east]
}

/// The section table, after the header is checked.
fn table<B: Pieces>(bytes: &mut B) -> Result<Vec<u8>, Fault<B::Error>> {
    let length = bytes.length();
    let header = bytes.take(0, length.min(BLOCK as u64) as usize).map_err(Fault::Read)?;
    let magic = &header[..header.len().min(MAGIC.len())];
    if magic != MAGIC {
        return Err(BankFormatError::NotBank { found: magic.escape_ascii().to_string() }.into());
    }
    let wrong_length = |expected: u64| BankFormatError::FileLength { found: length, expected };
    if header.len() < BLOCK {
        return Err(wrong_length(BLOCK as u64).into());
    }
    let [format, count] = [8, 12].map(|at| u32_at(&header, at));
    if format != FORMAT {
        return Err(BankFormatError::Version { found: format }.into());
    }
    let stated = u64_at(&header, FILE_LENGTH_AT);
    if stated != length {
        return Err(wrong_length(stated).into());
    }
    let end = (u64::from(count) + 1) * BLOCK as u64;
    if end > length {
        return Err(wrong_length(end).into());
    }
    let table = bytes.take(BLOCK as u64, count as usize * BLOCK).map_err(Fault::Read)?;
    let (found, expected) = (*blake3::hash(&table).as_bytes(), hash_at(&header, TABLE_HASH_AT));
    if found != expected {
        let (found, expected) = (short_hex(&found), short_hex(&expected));
        return Err(BankFormatError::TableChecksum { offset: BLOCK as u64, found, expected }.into());
    }
    Ok(table)
}

fn section(end: u64, table: &[u8], index: usize, entry: &[u8]) -> Result<Section<()>, BankFormatError> {
    let kind = array_at(entry, 0);
    let name = SectionName { index, kind: kind_text(&kind) };
    let [offset, length] = [8, 16].map(|at| u64_at(entry, at));
    if !offset.is_multiple_of(BLOCK as u64) {
        return Err(BankFormatError::Misaligned { section: name, offset });
    }
    let first = (BLOCK + table.len()) as u64;
    let inside = offset >= first && offset.checked_add(length).is_some_and(|last| last <= end);
    if !inside {
        return Err(BankFormatError::Outside { section: name, offset, length, first, end });
    }
    Ok(Section { name, kind, offset, length, payload: () })
}

/// A kind as text: trailing zero bytes left out, others that are not ASCII escaped.
fn kind_text(kind: &[u8; 8]) -> String {
    let end = kind.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    kind[..end].escape_ascii().to_string()
}

fn check_overlap(sections: &[Section<()>]) -> Result<(), BankFormatError> {
    let mut in_order: Vec<&Section<()>> = sections.iter().filter(|s| s.length > 0).collect();
    in_order.sort_by_key(|section| section.offset);
    for pair in in_order.windows(2) {
        let expected = pair[0].offset + pair[0].length;
        if pair[1].offset < expected {
            let (section, other) = (pair[1].name.clone(), pair[0].name.clone());
            return Err(BankFormatError::Overlap { section, offset: pair[1].offset, other, expected });
        }
    }
    Ok(())
}

impl Section<()> {
    /// With its bytes, which are undamaged.
    fn read<B: Pieces>(self, bytes: &mut B, table: &[u8]) -> Result<Section<Payload>, Fault<B::Error>> {
        let payload = self.payload(bytes).map_err(Fault::Read)?;
        let found = payload.hash();
        let expected = hash_at(table, self.name.index * BLOCK + SECTION_HASH_AT);
        let Self { name, kind, offset, length, .. } = self;
        if found != expected {
            let (found, expected) = (short_hex(&found), short_hex(&expected));
            return Err(BankFormatError::Checksum { section: name, offset, found, expected }.into());
        }
        Ok(Section { name, kind, offset, length, payload })
    }

    fn payload<B: Pieces>(&self, bytes: &mut B) -> Result<Payload, B::Error> {
        let words = self.length.checked_sub(BLOCK as u64).filter(|_| self.kind == LEVEL);
        let Some(words) = words.filter(|words| words.is_multiple_of(CORNER as u64)) else {
            return Ok(Payload::Bytes(bytes.take(self.offset, self.length as usize)?));
        };
        let mut header = [0; BLOCK];
        bytes.fill(self.offset, &mut header)?;
        let mut corners = vec![[0.0; WORDS]; words as usize / CORNER];
        bytes.fill(self.offset + BLOCK as u64, bytemuck::cast_slice_mut(&mut corners))?;
        Ok(Payload::Level(header, corners))
    }
}

impl Payload {
    fn hash(&self) -> [u8; HASH] {
        let mut hasher = blake3::Hasher::new();
        match self {
            Self::Bytes(bytes) => hasher.update(bytes),
            Self::Level(header, corners) => hasher.update(header).update(bytemuck::cast_slice(corners)),
        };
        *hasher.finalize().as_bytes()
    }
}

impl Section<Payload> {
    fn bytes(&self) -> &[u8] {
        match &self.payload {
            Payload::Bytes(bytes) => bytes,
            Payload::Level(header, _) => header,
        }
    }

    /// The level; its words are taken.
    fn level(&mut self) -> Result<Level, BankFormatError> {
        let header = self.bytes().get(..BLOCK).ok_or_else(|| self.wrong_length("at least 64"))?;
        let [region_size, north, east] = [0, 8, 16].map(|at| f64_at(header, at));
        let [rows, columns] = [24, 32].map(|at| u64_at(header, at));
        let needed = rows.checked_mul(columns).and_then(|corners| corners.checked_mul(CORNER as u64));
        let words = match &mut self.payload {
            Payload::Level(_, words) if needed == Some(self.length - BLOCK as u64) => mem::take(words),
            _ => return Err(self.wrong_length(&format!("64 + 72 x {rows} x {columns} corners"))),
        };
        let words = self.finite(words, columns)?;
        Level::new(region_size, [north, east], [rows as usize, columns as usize], words).map_err(|source| {
            BankFormatError::Level { section: self.name.clone(), offset: self.offset, source }
        })
    }

    /// Words in the numbers of this machine, all of them finite.
    fn finite(&self, mut words: Vec<CornerWords>, columns: u64) -> Result<Vec<CornerWords>, BankFormatError> {
        let all = words.as_flattened_mut();
        for word in &mut *all {
            *word = f64::from_le_bytes(word.to_ne_bytes());
        }
        match all.iter().position(|word| !word.is_finite()) {
            None => Ok(words),
            Some(place) => {
                let (corner, word) = (place as u64 / 9, place % 9);
                let (m, n) = (corner / columns, corner % columns);
                let expected = format!("a finite number, word {word} of corner ({m}, {n})");
                Err(self.value(BLOCK + 8 * place, all[place], &expected))
            }
        }
    }

    fn title(&self) -> Result<String, BankFormatError> {
        let not_text = |error: std::str::Utf8Error| {
            let at = error.valid_up_to();
            self.value(at, format!("byte {:#04x}", self.bytes()[at]), "UTF-8 text")
        };
        std::str::from_utf8(self.bytes()).map(str::to_owned).map_err(not_text)
    }

    fn place(&self) -> Result<Georeference, BankFormatError> {
        if self.bytes().len() != 32 {
            return Err(self.wrong_length("32"));
        }
        let ranges = [(PI / 2.0, "latitude"), (2.0 * PI, "longitude"), (1e9, "north"), (1e9, "east")];
        for (index, (most, what)) in ranges.into_iter().enumerate() {
            let value = f64_at(self.bytes(), 8 * index);
            if !(-most..=most).contains(&value) {
                return Err(self.value(8 * index, value, &format!("{what} within -{most} to {most}")));
            }
        }
        let [latitude, longitude, north, east] = [0, 8, 16, 24].map(|at| f64_at(self.bytes(), at));
        Ok(Georeference { latitude, longitude, at: [north, east], true_north: None })
    }

    fn north(&self) -> Result<f64, BankFormatError> {
        if self.bytes().len() != 8 {
            return Err(self.wrong_length("8"));
        }
        match f64_at(self.bytes(), 0) {
            north if (-2.0 * PI..=2.0 * PI).contains(&north) => Ok(north),
            north => Err(self.value(0, north, &format!("true north within -{0} to {0}", 2.0 * PI))),
        }
    }

    fn map(&self) -> Result<MapFrame, BankFormatError> {
        let bytes = self.bytes().try_into().map_err(|_| self.wrong_length(&map::LENGTH.to_string()))?;
        map::read(bytes).map_err(|fault| self.value(fault.at, fault.found, &fault.expected))
    }

    fn voids(&self) -> Result<Vec<[u32; 2]>, BankFormatError> {
        if !self.bytes().len().is_multiple_of(8) {
            return Err(self.wrong_length("a multiple of 8"));
        }
        Ok(self.bytes().chunks_exact(8).map(|pair| [u32_at(pair, 0), u32_at(pair, 4)]).collect())
    }

    fn only<T>(&self, slot: &mut Option<T>, value: T) -> Result<(), BankFormatError> {
        match slot.replace(value) {
            None => Ok(()),
            Some(_) => Err(BankFormatError::Repeated { section: self.name.clone(), offset: self.offset }),
        }
    }

    fn wrong_length(&self, expected: &str) -> BankFormatError {
        let (section, found) = (self.name.clone(), self.length);
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
