//! Files whose hashes are right, and whose values are not.

use std::path::Path;

use terrain_database::{Database, DatabaseError};

use crate::{ground, places};

/// Bytes before the table of a header with two ranges, and bytes of its blocks in the table.
const TABLE: usize = 111;
const ROW: usize = 40;

/// A database whose header is changed and signed again. `blocks` is their number.
fn changed(place: usize, value: &[u8], blocks: usize) -> DatabaseError {
    let mut bytes = Database::new(ground(3, 2, [2, 2], None)).unwrap().bytes();
    bytes[place..][..value.len()].copy_from_slice(value);
    sign(&mut bytes, TABLE + ROW * blocks);
    Database::parse(Path::new("moon.lod"), &bytes).expect_err("a hostile file")
}

fn sign(bytes: &mut [u8], end: usize) {
    let hash = *blake3::hash(&bytes[..end]).as_bytes();
    bytes[end..][..hash.len()].copy_from_slice(&hash);
}

#[test]
fn values_of_the_header_are_checked() {
    let number = |value: f64| value.to_le_bytes();
    let cases: [(usize, &[u8], &str); 9] = [
        (12, &2_u32.to_le_bytes(), "units is 2: expected 1, metres and radians"),
        (16, &number(0.5), "radius is 0.5: expected a length from 1 m to 1e9 m"),
        (24, &number(2.0), "latitude is 2: expected"),
        (32, &number(f64::NAN), "longitude is NaN: expected"),
        (40, &number(f64::INFINITY), "origin is [inf, -250.0]: expected"),
        (56, &number(-1.0), "step is -1: expected a length from 1e-9 m to 1e6 m"),
        (64, &13_u32.to_le_bytes(), "order is 13: expected a whole number from 1 to 12"),
        (76, &[7], "bits of the light is 7: expected 0, 8 or 16"),
        (79, &number(-5.0), "end of a range is -5: expected a length above 0 m"),
    ];
    for (place, value, expected) in cases {
        let text = changed(place, value, 16).to_string();
        assert!(text.contains("moon.lod: the block of the header: ") && text.contains(expected), "{text}");
    }
}

#[test]
fn sizes_beyond_the_file_are_refused_before_memory_is_asked_for() {
    for (place, value) in [(68, u32::MAX), (72, u32::MAX), (68, 3)] {
        let error = changed(place, &value.to_le_bytes(), 16);
        assert!(matches!(error, DatabaseError::Length { .. } | DatabaseError::Damaged { .. }), "{error}");
    }
    let error = changed(64, &12_u32.to_le_bytes(), 16).to_string();
    assert!(error.contains("number of posts is 67125249: expected at most"), "{error}");
    let error = changed(TABLE, &u64::MAX.to_le_bytes(), 16);
    assert!(matches!(error, DatabaseError::Length { .. }), "{error}");
}

/// Whole steps of a thousand kilometres make of every height but 0 one that no terrain has: tile and post are named.
#[test]
fn a_height_that_cannot_be_is_named_with_its_tile_and_post() {
    let text = changed(56, &1e6_f64.to_le_bytes(), 16).to_string();
    let tile = text.split("tile (column ").nth(1).and_then(|rest| rest.split(')').next());
    let post = text.split("post (column ").nth(1).and_then(|rest| rest.split(')').next());
    let numbers = |text: Option<&str>| -> Vec<usize> {
        text.unwrap().split(", row ").map(|number| number.parse().unwrap()).collect()
    };
    let (tile, post) = (numbers(tile), numbers(post));
    assert!(text.starts_with("moon.lod: the block of the heights of tile"), "{text}");
    // Tiles of four cells; the last post of a row belongs to the last tile.
    assert_eq!(tile, post.iter().map(|at| (at / 4).min(1)).collect::<Vec<_>>(), "{text}");
}

/// A database whose block is changed; table and header are signed again.
fn with_block(block: usize, value: impl FnOnce(&mut [u8])) -> DatabaseError {
    let mut bytes = Database::new(ground(3, 2, [2, 2], None)).unwrap().bytes();
    let length = |bytes: &[u8], block: usize| {
        u64::from_le_bytes(bytes[TABLE + ROW * block..][..8].try_into().unwrap()) as usize
    };
    let start = TABLE + ROW * 16 + 32 + (0..block).map(|block| length(&bytes, block)).sum::<usize>();
    let end = start + length(&bytes, block);
    value(&mut bytes[start..end]);
    let hash = *blake3::hash(&bytes[start..end]).as_bytes();
    bytes[TABLE + ROW * block + 8..][..hash.len()].copy_from_slice(&hash);
    sign(&mut bytes, TABLE + ROW * 16);
    Database::parse(Path::new("moon.lod"), &bytes).expect_err("a hostile file")
}

#[test]
fn blocks_with_other_content_are_named() {
    let first = |value: f64| move |bytes: &mut [u8]| bytes[..8].copy_from_slice(&value.to_le_bytes());
    let cases = [
        (
            with_block(0, first(1e7)),
            "the block of the places of posts: place along x of post 1 is 100: expected a length above 10000000 m",
        ),
        (
            with_block(0, first(f64::NAN)),
            "the block of the places of posts: place along x of post 0 is NaN: expected a length within 1e9 m",
        ),
        (
            with_block(1, first(-1.0)),
            "the block of the errors and bounds of tiles: its content is of another form",
        ),
        (
            with_block(3, |bytes| bytes.fill(0)),
            "the block of the heights of tile (column 1, row 0): its content",
        ),
        (
            with_block(6, |bytes| bytes.fill(0xff)),
            "the block of the light of tile (column 0, row 0): its content",
        ),
        (with_block(14, |bytes| bytes[64] = 3), "the block of the boulders: its content is of another form"),
        (
            with_block(14, |bytes| bytes[68 + 40..][..8].copy_from_slice(&0.95_f64.to_le_bytes())),
            "the block of the boulders: burial of boulder 1 is 0.95: expected a share from 0 to 0.9",
        ),
        (with_block(15, |bytes| bytes[0] = 0xff), "the block of the text of the landscape: its content"),
    ];
    for (error, expected) in cases {
        assert!(error.to_string().contains(expected), "{error}");
    }
}

#[test]
fn contents_that_make_no_terrain_are_refused() {
    let contents = || ground(1, 2, [1, 1], None);
    let told = |contents| Database::new(contents).expect_err("no terrain").to_string();
    let short = terrain_database::Contents { places: [places(1, 1, 2), places(2, 1, 4)], ..contents() };
    assert_eq!(
        told(short),
        "posts along x is 3: expected a multiple of 4 and one more, for tiles of 4 cells"
    );
    assert_eq!(
        told(terrain_database::Contents { order: 0, ..contents() }),
        "order is 0: expected a whole number from 1 to 12"
    );
    let mut void = contents();
    void.heights[3] = f64::NAN;
    assert!(told(void).starts_with("height of post (column 3, row 0) is NaN: expected a length within"));
    let mut few = contents();
    few.heights.pop();
    assert_eq!(told(few), "number of heights is 24: expected 25");
    let mut buried = contents();
    buried.boulders[1].burial = 0.95;
    assert_eq!(told(buried), "burial of boulder 1 is 0.95: expected a share from 0 to 0.9");
    let dark =
        terrain_database::Contents { light: Some(terrain_database::Map::U8(vec![0; 24])), ..contents() };
    assert_eq!(told(dark), "light is 24 numbers: expected 25 numbers, one a post");
}
