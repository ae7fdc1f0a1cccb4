//! What is written comes back, and is written again with the same bytes.

use std::path::Path;

use proptest::prelude::*;
use terrain_database::{Contents, Database, Map};

use crate::{FRAME, ground, places};

fn again(database: &Database) -> Database {
    Database::parse(Path::new("again.lod"), &database.bytes()).unwrap()
}

/// Any bits that are a height.
fn any_height() -> impl Strategy<Value = f64> {
    any::<f64>()
        .prop_map(|height| if height.abs() <= 1e9 { height } else { height % 1.0 })
        .prop_filter("finite", |height| height.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn everything_comes_back(
        seed: u64,
        order in 1_u32..5,
        columns in 1_usize..4,
        rows in 1_usize..4,
        step in prop::option::of(1e-4_f64..10.0),
    ) {
        let contents = ground(seed, order, [columns, rows], step);
        let database = Database::new(contents.clone()).unwrap();
        let found = again(&database);
        prop_assert_eq!(&found, &database);
        prop_assert_eq!(found.bytes(), database.bytes());
        let most = contents.step.unwrap_or(0.0) * 0.500_001;
        for (height, asked) in found.contents().heights.iter().zip(&contents.heights) {
            prop_assert!((height - asked).abs() <= most);
        }
        prop_assert_eq!(&found.contents().boulders, &contents.boulders);
        prop_assert_eq!(&found.contents().light, &contents.light);
    }

    /// Heights of any bits come back with these bits: signs of zero, the smallest and the largest.
    #[test]
    fn every_bit_of_a_height_comes_back(heights in prop::collection::vec(any_height(), 25)) {
        let contents = Contents::new(FRAME, 2, [places(2, 1, 4), places(2, 1, 4)], heights.clone());
        let found = again(&Database::new(contents).unwrap());
        let bits = |heights: &[f64]| heights.iter().map(|height| height.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(&found.contents().heights), bits(&heights));
    }
}

#[test]
fn extreme_heights_stand_side_by_side() {
    let extremes = [1e9, -1e9, 0.0, -0.0, f64::MIN_POSITIVE, 5e-324, -5e-324, 1.0, -1.0];
    let contents = Contents::new(FRAME, 1, [places(1, 1, 2), places(1, 1, 2)], extremes.into());
    let found = again(&Database::new(contents).unwrap());
    let bits: Vec<_> = found.contents().heights.iter().map(|height| height.to_bits()).collect();
    assert_eq!(bits, extremes.map(f64::to_bits));
}

#[test]
fn a_file_is_replaced_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("terrain.lod");
    let first = Database::new(ground(1, 2, [2, 1], None)).unwrap();
    let second = Database::new(ground(2, 2, [1, 2], Some(0.001))).unwrap();
    first.write(&path).unwrap();
    assert_eq!(Database::open(&path).unwrap(), first);
    second.write(&path).unwrap();
    assert_eq!(Database::open(&path).unwrap(), second);
    assert_eq!(std::fs::read(&path).unwrap(), second.bytes());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "no temporary file stays");
}

#[test]
fn one_tile_without_extras_is_a_database() {
    let contents = Contents::new(FRAME, 3, [places(3, 1, 5), places(3, 1, 8)], vec![7.0; 81]);
    let database = Database::new(contents).unwrap();
    assert_eq!((database.counts(), database.tiles().len()), ([1, 1], 1));
    assert_eq!(again(&database), database);
    assert!(database.contents().light.is_none() && database.contents().sidecar.is_empty());
}

#[test]
fn a_remainder_tile_keeps_its_places() {
    let contents = Contents::new(FRAME, 2, [places(2, 2, 3), places(2, 1, 4)], vec![0.0; 45]);
    let found = again(&Database::new(contents).unwrap());
    assert_eq!(found.contents().places[0], [0.0, 100.0, 200.0, 300.0, 400.0, 475.0, 550.0, 625.0, 700.0]);
    assert_eq!(found.contents().places[1], [0.0, 100.0, 200.0, 300.0, 400.0]);
}

#[test]
fn threads_change_no_byte() {
    let database = Database::new(ground(9, 3, [3, 3], Some(0.01))).unwrap();
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let bytes = [1, 2, 5].map(|threads| pool(threads).install(|| database.bytes()));
    assert!(bytes[0] == bytes[1] && bytes[0] == bytes[2]);
    let read = |threads| pool(threads).install(|| again(&database));
    assert!(read(1) == database && read(5) == database);
}

#[test]
fn shares_of_maps_run_from_none_to_all() {
    let (coarse, fine) = (Map::U8(vec![0, 51, 255]), Map::U16(vec![0, 13107, 65535]));
    for map in [coarse, fine] {
        assert_eq!([0, 1, 2].map(|post| map.share(post)), [0.0, 0.2, 1.0]);
        assert!(map.len() == 3 && !map.is_empty());
    }
}
