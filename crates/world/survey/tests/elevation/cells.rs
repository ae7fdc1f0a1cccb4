//! DTED cells and SRTM tiles: south and west, signs, voids, sums, sizes.

use std::path::Path;

use quantities::{degrees, radians};
use survey::{Elevation, Fate, Frame, ReadOptions, VOCABULARIES};

use crate::made::Made;

/// Meridians and samples of a made cell.
const CELL: [usize; 2] = [5, 4];

/// Height of a sample of a made cell (m), by meridian from the west and point from the south.
fn height(meridian: usize, point: usize) -> i32 {
    100 * meridian as i32 - 7 * point as i32 - 150
}

fn sign_and_magnitude(height: i32) -> [u8; 2] {
    let sign = if height < 0 { 0x8000 } else { 0 };
    (height.unsigned_abs() as u16 | sign).to_be_bytes()
}

/// Writes text over bytes from a place on.
fn put(bytes: &mut [u8], at: usize, text: &str) {
    bytes[at..at + text.len()].copy_from_slice(text.as_bytes());
}

/// Headers of a cell with its first sample at a place, by the offsets of MIL-PRF-89020B.
fn headers(longitude: &str, latitude: &str) -> Vec<u8> {
    let mut bytes = vec![b' '; 3428];
    put(&mut bytes, 0, "UHL1");
    put(&mut bytes, 4, longitude);
    put(&mut bytes, 12, latitude);
    put(&mut bytes, 20, "01800300NA  U  ");
    put(&mut bytes, 47, &format!("{:04}{:04}0", CELL[0], CELL[1]));
    put(&mut bytes, 80, "DSIU");
    put(&mut bytes, 139, "DTED0");
    put(&mut bytes, 221, "E96WGS84");
    let [side, up] = [longitude, latitude].map(|text| text.split_at(text.len() - 1));
    put(&mut bytes, 265, &format!("{}.0{}", &up.0[1..], up.1));
    put(&mut bytes, 274, &format!("{}.0{}", side.0, side.1));
    put(&mut bytes, 344, "0000000.0");
    put(&mut bytes, 353, &format!("03000180{:04}{:04}00", CELL[1], CELL[0]));
    put(&mut bytes, 728, "ACC");
    bytes
}

/// A record with its sum.
fn record(meridian: usize, heights: &[[u8; 2]]) -> Vec<u8> {
    let counts = [(meridian as u32).to_be_bytes()[1..].to_vec(), (meridian as u16).to_be_bytes().to_vec()];
    let mut bytes = [vec![0xaa], counts.concat(), vec![0, 0], heights.concat()].concat();
    let sum: u32 = bytes.iter().map(|byte| u32::from(*byte)).sum();
    bytes.extend(sum.to_be_bytes());
    bytes
}

/// A cell whose third meridian has these stored heights instead of its own.
fn cell(longitude: &str, latitude: &str, third: &[[u8; 2]]) -> Vec<u8> {
    let own = |meridian: usize| {
        (0..CELL[1]).map(|point| sign_and_magnitude(height(meridian, point))).collect::<Vec<_>>()
    };
    let records = (0..CELL[0]).flat_map(|meridian| match meridian {
        2 if !third.is_empty() => record(meridian, third),
        _ => record(meridian, &own(meridian)),
    });
    headers(longitude, latitude).into_iter().chain(records).collect()
}

fn made(bytes: &[u8]) -> Made {
    Made::new(&[("made.dt0", bytes)])
}

const USUAL: [&str; 2] = ["0060000E", "0450000N"];

fn usual() -> Vec<u8> {
    cell(USUAL[0], USUAL[1], &[])
}

fn first(elevation: &Elevation) -> [f64; 2] {
    elevation.affine.first.map(degrees)
}

#[test]
fn cells_of_all_hemispheres() {
    for (longitude, latitude, expected) in [
        ("0060000E", "0450000N", [45.0, 6.0]),
        ("1203000W", "0430000S", [-43.0, -120.5]),
        ("0000000W", "0000000S", [0.0, 0.0]),
        ("1790000E", "0001500S", [-0.25, 179.0]),
    ] {
        let read = made(&cell(longitude, latitude, &[])).plain().unwrap();
        assert_eq!((read.lines, read.columns, read.title.as_str()), (4, 5, "made: DTED0"));
        let found = first(&read);
        assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 1e-12), "{found:?}");
        let step = read.affine.step.map(|step| degrees(step) * 3600.0);
        assert!((step[0] - 30.0).abs() < 1e-9 && (step[1] - 18.0).abs() < 1e-9, "{step:?}");
        for (point, meridian) in (0..20).map(|index| (index / 5, index % 5)) {
            assert_eq!(read.height(point, meridian), Some(f64::from(height(meridian, point))));
        }
    }
}

#[test]
fn voids_and_signs() {
    let third = [[0xff, 0xff], [0x80, 0x07], [0x80, 0x00], [0x23, 0x28]];
    let read = made(&cell(USUAL[0], USUAL[1], &third)).plain().unwrap();
    let found: Vec<_> = (0..4).map(|point| read.height(point, 2)).collect();
    assert_eq!(found, [None, Some(-7.0), Some(0.0), Some(9000.0)]);
    assert_eq!(read.voids(), 1);
    // -7 in two's complement is a height that no cell may have.
    let refusal = made(&cell(USUAL[0], USUAL[1], &[[0xff, 0xf9], [0, 0], [0, 0], [0, 0]])).refusal();
    assert!(refusal.contains("record 2, sample 0 (from 0): found -32761"), "{refusal}");
    assert!(refusal.contains("two's complement"), "{refusal}");
    let none = ReadOptions { no_data: vec![-32767.0, -7.0], ..ReadOptions::default() };
    assert_eq!(made(&cell(USUAL[0], USUAL[1], &third)).read(&none).unwrap().voids(), 2);
}

#[test]
fn sums_and_counts_of_records() {
    let damaged = |at: usize, byte: u8| {
        let mut bytes = usual();
        bytes[3428 + 20 + at] = byte;
        made(&bytes)
    };
    let sum = damaged(19, 99);
    let refusal = sum.refusal();
    assert!(
        refusal.contains("record 1 (from 0), checksum") && refusal.contains("--ignore checksum"),
        "{refusal}"
    );
    let forgiving = ReadOptions { ignore: vec!["checksum".into()], ..ReadOptions::default() };
    let read = sum.read(&forgiving).unwrap();
    assert!(read.notes.iter().any(|note| note.starts_with("checksum")), "{:?}", read.notes);
    assert!(damaged(9, 99).refusal().contains("checksum"));
    for (at, what) in
        [(0, "sentinel"), (3, "data block count"), (5, "longitude count"), (7, "latitude count")]
    {
        let made = damaged(at, 9);
        assert!(made.refusal().contains(&format!("record 1 (from 0), {what}: found ")), "{}", made.refusal());
        assert!(made.read(&forgiving).is_err(), "{what}");
    }
    let bytes = usual();
    for length in [3, 70, 90, 3000, 3427, 3440, bytes.len() - 1] {
        assert!(made(&bytes[..length]).plain().is_err(), "{length}");
    }
    assert!(made(&bytes[..3500]).refusal().contains("5 records of 20 bytes"));
}

#[test]
fn every_field_is_what_its_table_says() {
    let (_, fields) = VOCABULARIES.iter().find(|(_, table)| table.kind.contains("DTED")).unwrap();
    let told = |bytes: &[u8]| {
        let read = made(bytes).plain()?;
        let heights: Vec<_> = (0..20).map(|index| read.height(index / 5, index % 5)).collect();
        Ok::<_, String>(format!(
            "{:?} {:?} {} {:?} {heights:?}",
            read.affine, read.frame, read.title, read.notes
        ))
    };
    let whole = told(&usual());
    assert!(whole.is_ok(), "{whole:?}");
    for word in fields.words {
        let mut bytes = usual();
        bytes[usize::from(word.number)] = b'7';
        let found = told(&bytes);
        match word.fate {
            Fate::Harmless(_) => assert_eq!(found, whole, "{}", word.name),
            Fate::Only(..) => assert!(found.clone().unwrap_err().contains(word.name), "{found:?}"),
            _ => assert_ne!(found, whole, "{}", word.name),
        }
    }
}

#[test]
fn labels_of_a_tape_and_two_headers() {
    let tape = |labels: usize| {
        let label = |k: usize| format!("{}{:76}", ["VOL1", "HDR1", "HDR2", "HDR3", "HDR4"][k], "");
        let front: String = (0..labels).map(label).collect();
        made(&[front.as_bytes(), &usual()].concat())
    };
    assert_eq!(first(&tape(2).plain().unwrap()).map(f64::round), [45.0, 6.0]);
    assert!(tape(4).plain().is_ok() && tape(5).refusal().contains("at most 4 labels"));
    let mut other = usual();
    put(&mut other, 265, "440000.0N");
    let refusal = made(&other).refusal();
    assert!(refusal.contains("DSI latitude of origin: found 440000.0N"), "{refusal}");
    let spaced = ReadOptions { spacing: Some([1.0; 2]), ..ReadOptions::default() };
    assert!(made(&usual()).read(&spaced).unwrap_err().starts_with("spacing"));
}

/// A tile of 1201 x 1201 samples: line by line from the north, -32768 in the north-west corner.
fn tile() -> Vec<u8> {
    let at = |index: usize| if index == 0 { -32768 } else { (index / 1201) as i16 - (index % 1201) as i16 };
    (0..1201 * 1201).flat_map(|index| at(index).to_be_bytes()).collect()
}

#[test]
fn tiles_lie_where_their_names_say() {
    let bytes = tile();
    for (name, south, west) in
        [("N45E006.hgt", 45.0, 6.0), ("S05W120.hgt", -5.0, -120.0), ("s01e000.SRTMGL3.HGT", -1.0, 0.0)]
    {
        let read = Made::new(&[(name, &bytes)]).plain().unwrap();
        let edges = read.extent().map(degrees);
        let expected = [south, west, south + 1.0, west + 1.0];
        assert!((0..4).all(|k| (edges[k] - expected[k]).abs() < 1e-9), "{name}: {edges:?}");
        assert!((read.affine.step[1] - radians(3.0 / 3600.0)).abs() < 1e-12);
        assert_eq!(
            [read.height(0, 0), read.height(7, 3), read.height(1200, 0)],
            [None, Some(4.0), Some(1200.0)]
        );
        assert!(matches!(read.frame, Frame::Geographic { radius: 6_378_137.0 }));
    }
    let refused = |name: &str, bytes: &[u8]| Made::new(&[(name, bytes)]).refusal();
    let named = refused("tile.hgt", &bytes);
    assert!(named.contains("found tile.hgt") && named.contains("N45E006.hgt"), "{named}");
    // The advice is followed: the same file under such a name is read, as above.
    for length in [0, 1, 1201, bytes.len() - 2] {
        let said = refused("N45E006.hgt", &bytes[..length]);
        assert!(said.contains(&format!("found {length} bytes")) && said.contains("2884802"), "{said}");
    }
    let half: Vec<u8> = (0..3601 * 1801).flat_map(|index| ((index % 1801) as i16).to_be_bytes()).collect();
    let read = Made::new(&[("N61E010.hgt", &half)]).plain().unwrap();
    assert_eq!((read.lines, read.columns, read.height(3, 1800)), (3601, 1801, Some(1800.0)));
    assert!((degrees(read.extent()[3]) - 11.0).abs() < 1e-9);
}

#[test]
fn the_real_cell_has_its_heights() {
    let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let name = "shared/data/dted/n00_e006_3arc_v2.dt1";
    let Some(path) = folders.map(|folder| folder.join(name)).find(|path| path.is_file()) else {
        println!("SKIPPED: {name} is not there");
        return;
    };
    let read = survey::read(path, &ReadOptions::default()).unwrap();
    assert_eq!((read.lines, read.columns, read.range()), (1201, 1201, Some([-7.0, 1979.0])));
    let share = read.voids() as f64 / (1201.0 * 1201.0);
    assert!((share - 0.0028).abs() < 1e-4, "{share}");
    assert_eq!(read.extent().map(degrees).map(f64::round), [0.0, 6.0, 1.0, 7.0]);
}
