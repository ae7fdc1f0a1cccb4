//! From a bank to bytes.

use super::layout::{BLOCK, FORMAT, LEVEL, MAGIC, MAP, NORTH, PLACE, TITLE, VOIDS, aligned};
use super::map;
use crate::{Bank, Georeference, Level, WORDS};

struct Section {
    kind: [u8; 8],
    payload: Vec<u8>,
}

/// The bytes of a bank file: the same bank gives the same bytes.
pub fn encode(bank: &Bank) -> Vec<u8> {
    let mut sections = defining_sections(bank);
    sections.extend(north(bank).map(|north| Section { kind: NORTH, payload: north.to_le_bytes().to_vec() }));
    sections.extend(bank.map().map(|frame| Section { kind: MAP, payload: map::payload(frame) }));
    sections.push(Section { kind: TITLE, payload: bank.title().as_bytes().to_vec() });
    let table_end = BLOCK * (1 + sections.len());
    let mut end = table_end;
    let mut table = Vec::new();
    for section in &sections {
        table.extend(entry(section, end));
        end = aligned(end + section.payload.len());
    }
    let mut bytes = header(sections.len(), end, &table);
    bytes.reserve_exact(end - BLOCK);
    bytes.extend(table);
    for section in sections {
        bytes.extend(section.payload);
        bytes.resize(aligned(bytes.len()), 0);
    }
    bytes
}

/// True north at the bank's place, if its map does not give it.
fn north(bank: &Bank) -> Option<f64> {
    let place = bank.georeference()?;
    let is_in_map = bank.map().is_some_and(|map| map.true_north(place.at).is_some());
    place.true_north.filter(|_| !is_in_map)
}

/// BLAKE3 of what makes the ground: kind, length and payload of each level, of the place and of the voids, in file order.
///
/// Title, true north and map are not part of it: the same ground under another name, or from another file, has the same hash.
pub fn content_hash(bank: &Bank) -> [u8; 32] {
    let mut hasher = blake3::Hasher::new();
    for section in defining_sections(bank) {
        hasher.update(&section.kind);
        hasher.update(&(section.payload.len() as u64).to_le_bytes());
        hasher.update(&section.payload);
    }
    *hasher.finalize().as_bytes()
}

fn defining_sections(bank: &Bank) -> Vec<Section> {
    let level = |level| Section { kind: LEVEL, payload: level_payload(level) };
    let place = |place| Section { kind: PLACE, payload: place_payload(&place) };
    let voids =
        (!bank.voids().is_empty()).then(|| Section { kind: VOIDS, payload: voids_payload(bank.voids()) });
    bank.levels().iter().map(level).chain(bank.georeference().map(place)).chain(voids).collect()
}

fn header(count: usize, file_length: usize, table: &[u8]) -> Vec<u8> {
    let mut bytes = MAGIC.to_vec();
    bytes.extend(FORMAT.to_le_bytes());
    bytes.extend((count as u32).to_le_bytes());
    bytes.extend((file_length as u64).to_le_bytes());
    bytes.extend([0; 8]);
    bytes.extend(blake3::hash(table).as_bytes());
    bytes
}

fn entry(section: &Section, offset: usize) -> Vec<u8> {
    let mut bytes = section.kind.to_vec();
    bytes.extend((offset as u64).to_le_bytes());
    bytes.extend((section.payload.len() as u64).to_le_bytes());
    bytes.extend([0; 8]);
    bytes.extend(blake3::hash(&section.payload).as_bytes());
    bytes
}

fn level_payload(level: &Level) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(BLOCK + level.words().len() * WORDS * 8);
    for value in [level.region_size(), level.origin()[0], level.origin()[1]] {
        bytes.extend(value.to_le_bytes());
    }
    for count in level.corners() {
        bytes.extend((count as u64).to_le_bytes());
    }
    bytes.resize(BLOCK, 0);
    for word in level.words().iter().flatten() {
        bytes.extend(word.to_le_bytes());
    }
    bytes
}

fn voids_payload(voids: &[[u32; 2]]) -> Vec<u8> {
    voids.as_flattened().iter().flat_map(|index| index.to_le_bytes()).collect()
}

fn place_payload(place: &Georeference) -> Vec<u8> {
    [place.latitude, place.longitude, place.at[0], place.at[1]]
        .iter()
        .flat_map(|value| value.to_le_bytes())
        .collect()
}
