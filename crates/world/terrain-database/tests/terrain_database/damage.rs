//! Files that are cut off, changed, or something else.

use std::path::Path;

use terrain_database::{Block, Database, DatabaseError};

use crate::ground;

fn error(bytes: &[u8]) -> DatabaseError {
    Database::parse(Path::new("moon.lod"), bytes).expect_err("a damaged file")
}

/// Blocks of a database of 2 x 2 tiles with everything, in the order of the file.
fn blocks() -> Vec<Block> {
    let tiles = || [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter();
    [Block::Places, Block::Tiles]
        .into_iter()
        .chain(tiles().map(Block::Heights))
        .chain(tiles().map(Block::Light))
        .chain(tiles().map(Block::Albedo))
        .chain([Block::Boulders, Block::Sidecar])
        .collect()
}

/// First byte of every block: the table has 40 bytes a block and stands before the hash of the header.
fn starts(bytes: &[u8], count: usize) -> Vec<usize> {
    let table = 8 + 8 + 6 * 8 + 12 + 3 + 2 * 16;
    let mut start = table + 40 * count + 32;
    let start_of = |block: usize| {
        let length = bytes[table + 40 * block..][..8].try_into().unwrap();
        let found = start;
        start += u64::from_le_bytes(length) as usize;
        found
    };
    (0..count).map(start_of).collect()
}

#[test]
fn a_flipped_byte_names_its_block() {
    let bytes = Database::new(ground(3, 2, [2, 2], None)).unwrap().bytes();
    let blocks = blocks();
    for (block, start) in blocks.iter().zip(starts(&bytes, blocks.len())) {
        let mut damaged = bytes.clone();
        damaged[start] ^= 0x10;
        let error = error(&damaged);
        assert!(
            matches!(error, DatabaseError::Damaged { block: found, .. } if found == *block),
            "{block}: {error}"
        );
    }
}

#[test]
fn the_message_names_file_block_and_tile() {
    let bytes = Database::new(ground(3, 2, [2, 2], None)).unwrap().bytes();
    let mut damaged = bytes.clone();
    damaged[starts(&bytes, 16)[3]] ^= 1;
    assert_eq!(
        error(&damaged).to_string(),
        "moon.lod: the block of the heights of tile (column 1, row 0) is damaged: its hash differs; export the landscape again"
    );
}

#[test]
fn every_flipped_byte_is_found() {
    let bytes = Database::new(ground(4, 1, [1, 2], Some(0.5))).unwrap().bytes();
    for place in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[place] ^= 1;
        let error = error(&damaged);
        let is_named = match place {
            0..8 => matches!(error, DatabaseError::Magic { .. }),
            8..12 => matches!(error, DatabaseError::Version { .. }),
            _ => matches!(error, DatabaseError::Damaged { .. } | DatabaseError::Length { .. }),
        };
        assert!(is_named, "byte {place}: {error}");
    }
}

#[test]
fn a_file_that_is_cut_off_is_refused() {
    let bytes = Database::new(ground(5, 1, [2, 1], None)).unwrap().bytes();
    for length in 0..bytes.len() {
        let error = error(&bytes[..length]);
        let is_named = match length {
            0..8 => matches!(error, DatabaseError::Magic { .. }),
            _ => matches!(error, DatabaseError::Length { .. }),
        };
        assert!(is_named, "{length} bytes: {error}");
    }
    let longer: Vec<u8> = bytes.iter().copied().chain([0]).collect();
    let expected = format!("{} bytes; expected {} by its header", longer.len(), bytes.len());
    assert!(error(&longer).to_string().contains(&expected));
}

#[test]
fn another_version_is_refused_by_its_number() {
    let mut bytes = Database::new(ground(6, 1, [1, 1], None)).unwrap().bytes();
    bytes[8] = 7;
    assert_eq!(
        error(&bytes).to_string(),
        "moon.lod: terrain database of version 7; expected version 1; export the landscape again"
    );
}

#[test]
fn another_file_is_refused() {
    let text = error(b"format = 1\n[area]\n").to_string();
    assert!(text.contains("expected a terrain database; make one with `lunoid terrain export`"), "{text}");
    let missing = Database::open("no-such-folder/moon.lod").expect_err("no file").to_string();
    assert_eq!(missing, "no-such-folder/moon.lod: no such file; check the spelling");
}
