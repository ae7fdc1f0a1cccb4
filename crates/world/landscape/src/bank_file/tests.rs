use super::layout::{BLOCK, PLACE, SECTION_HASH_AT, TABLE_HASH_AT};
use super::{
    BankFileError, BankFormatError, CornersError, content_hash, decode, describe, encode, export_corners,
    import_corners, read, write,
};
use crate::projection::{Method, Projection};
use crate::{Bank, FileCoordinates, Georeference, Level, MapFrame};
use files::{Npy, NpyData};
use proptest::prelude::{ProptestConfig, Strategy, any, prop_assert, prop_assert_eq, proptest};

/// The worked example of docs/bank-format.md: h = 0.5 x on one region of 100 m.
fn ramp() -> Bank {
    let corner = |north: f64| [50.0 * north, 0.0, 0.0, 50.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let words = vec![corner(0.0), corner(0.0), corner(1.0), corner(1.0)];
    Bank::new("ramp", vec![Level::new(100.0, [0.0, 0.0], [2, 2], words).unwrap()], None).unwrap()
}

fn two_levels() -> Bank {
    let place = Georeference { latitude: 0.45, longitude: -0.06, at: [100.0, 200.0], true_north: None };
    let words = |count: usize, seed: f64| {
        (0..count).map(|i| std::array::from_fn(|w| seed * (i * 9 + w) as f64 - 7.0)).collect()
    };
    let levels = vec![
        Level::new(50.0, [0.0, -50.0], [3, 4], words(12, 0.1)).unwrap(),
        Level::new(200.0, [-200.0, 0.0], [2, 3], words(6, -0.3)).unwrap(),
    ];
    Bank::new("two levels, µ", levels, Some(place)).unwrap()
}

#[test]
fn regions_without_data_are_part_of_the_ground() {
    let bank = two_levels().with_voids(vec![[0, 2], [1, 1]]).unwrap();
    let bytes = encode(&bank);
    assert_eq!(decode(&bytes).unwrap(), bank);
    assert_ne!(content_hash(&bank), content_hash(&two_levels()));
    // The fourth section: levels, place, voids. Its last index, 1, becomes 7.
    let offset = u64::from_le_bytes(bytes[BLOCK * 4 + 8..BLOCK * 4 + 16].try_into().unwrap()) as usize;
    let mut beyond = bytes.clone();
    beyond[offset + 12] = 7;
    let refused = decode(&sealed(beyond)).unwrap_err().to_string();
    assert!(refused.contains("region (1, 7)") && refused.contains("2 x 3"), "{refused}");
    let mut odd = bytes;
    odd[BLOCK * 4 + 16] = 12;
    let refused = decode(&sealed(odd)).unwrap_err().to_string();
    assert!(refused.contains("section 3 (voids)") && refused.contains("a multiple of 8"), "{refused}");
}

/// Puts the right checksums over damaged bytes, so that what lies behind them is met.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let count = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    for entry in (1..=count).map(|index| index * BLOCK) {
        let at = |place: usize| u64::from_le_bytes(bytes[place..place + 8].try_into().unwrap()) as usize;
        let (offset, length) = (at(entry + 8), at(entry + 16));
        if let Some(payload) = offset.checked_add(length).and_then(|end| bytes.get(offset..end)) {
            let hash = *blake3::hash(payload).as_bytes();
            bytes[entry + SECTION_HASH_AT..entry + BLOCK].copy_from_slice(&hash);
        }
    }
    let hash = *blake3::hash(&bytes[BLOCK..BLOCK * (1 + count)]).as_bytes();
    bytes[TABLE_HASH_AT..BLOCK].copy_from_slice(&hash);
    bytes
}

/// What `decode` says when eight bytes at `at` of the two-level bank are replaced and sealed.
fn with(at: usize, bytes: [u8; 8]) -> String {
    let mut file = encode(&two_levels());
    file[at..at + 8].copy_from_slice(&bytes);
    decode(&sealed(file)).unwrap_err().to_string()
}

#[test]
fn a_bank_comes_back() {
    for bank in [ramp(), two_levels()] {
        assert_eq!(decode(&encode(&bank)), Ok(bank));
    }
}

#[test]
fn the_worked_example_stands_in_the_docs() {
    let page = include_str!("../../../../../docs/bank-format.md");
    let bytes = encode(&ramp());
    let hex = |bytes: &[u8]| bytes.iter().map(|b| format!("{b:02x}")).collect::<String>();
    assert!(page.contains(&format!("{} bytes in all", bytes.len())), "{} bytes", bytes.len());
    for (what, expected) in [
        ("content hash", hex(&content_hash(&ramp()))),
        ("table checksum", hex(&bytes[TABLE_HASH_AT..BLOCK])),
        ("level checksum", hex(&bytes[BLOCK + SECTION_HASH_AT..2 * BLOCK])),
    ] {
        assert!(page.contains(&expected), "{what}: {expected}");
    }
}

#[test]
fn the_title_is_not_part_of_the_ground() {
    let bank = two_levels();
    let renamed = Bank::new("another name", bank.levels().to_vec(), bank.georeference()).unwrap();
    assert_eq!(content_hash(&bank), content_hash(&renamed));
    let moved = Bank::new(bank.title(), bank.levels().to_vec(), None).unwrap();
    assert_ne!(content_hash(&bank), content_hash(&moved));
}

#[test]
fn every_truncation_is_refused() {
    let bytes = encode(&ramp());
    for length in 0..bytes.len() {
        assert!(decode(&bytes[..length]).is_err(), "{length} bytes");
    }
    assert_eq!(
        decode(&bytes[..100]).unwrap_err().to_string(),
        format!("the file has 100 bytes, expected {}; copy it again", bytes.len())
    );
}

#[test]
fn headers_that_cannot_be_are_named() {
    assert_eq!(
        decode(b"GIF89a..").unwrap_err().to_string(),
        "not a bank: byte 0: found \"GIF89a..\", expected \"LUNOBANK\""
    );
    assert_eq!(with(8, *b"\x02\0\0\0\x04\0\0\0"), "byte 8: format 2, expected 1: use a newer lunoid");
    let mut many = encode(&ramp());
    many[12..16].copy_from_slice(&u32::MAX.to_le_bytes());
    let error = decode(&many).unwrap_err();
    assert!(matches!(error, BankFormatError::FileLength { expected: 274_877_906_944, .. }), "{error}");
}

#[test]
fn sections_that_cannot_be_are_named() {
    // Entries: 64 level, 128 level, 192 place, 256 title; sections from byte 320 on.
    let number = |value: u64| value.to_le_bytes();
    assert_eq!(with(72, number(321)), "section 0 (level): begins at byte 321, expected a multiple of 64");
    assert!(
        with(72, number(64)).starts_with("section 0 (level): 928 bytes from byte 64 on, expected within")
    );
    assert!(with(80, number(u64::MAX)).contains("18446744073709551615 bytes from byte 320 on"));
    assert_eq!(
        with(136, number(384)),
        "section 1 (level): begins at byte 384, inside section 0 (level), expected byte 1248 or later"
    );
    assert!(
        with(320 + 24, number(u64::MAX)).contains("928 bytes, expected 64 + 72 x 18446744073709551615 x 4")
    );
    assert_eq!(with(192 + 16, number(24)), "section 2 (place), byte 1792: 24 bytes, expected 32");
    assert_eq!(with(256, *b"place\0\0\0"), "section 3 (place), byte 1856: 14 bytes, expected 32");
    assert_eq!(
        with(192, *b"title\0\0\0").split(':').next(),
        Some("section 2 (title), byte 1792"),
        "a place is no UTF-8"
    );
    // The title's entry renamed and moved: a second place, as long as the first.
    let mut twice = encode(&two_levels());
    let place = 192..192 + 24;
    twice.copy_within(place, 256);
    twice[256 + 8..256 + 16].copy_from_slice(&number(1856));
    twice[1856..1888].fill(0);
    let error = decode(&sealed(twice)).unwrap_err();
    assert!(matches!(&error, BankFormatError::Repeated { offset: 1856, .. }), "{error}");
}

#[test]
fn values_that_cannot_be_are_named() {
    let words = 320 + BLOCK;
    assert_eq!(
        with(words + 8 * (9 * 5 + 3), f64::NAN.to_le_bytes()),
        format!(
            "section 0 (level), byte {}: NaN, expected a finite number, word 3 of corner (1, 1)",
            words + 8 * 48
        )
    );
    assert!(with(320, (-1.0f64).to_le_bytes()).contains("region size -1 m"));
    assert!(with(1792, 2.0f64.to_le_bytes()).contains("section 2 (place), byte 1792: 2, expected latitude"));
    assert!(with(1856, [0xff; 8]).contains("byte 1856: byte 0xff, expected UTF-8 text"));
    let mut damaged = encode(&two_levels());
    damaged[words] ^= 1;
    let error = decode(&damaged).unwrap_err().to_string();
    assert!(error.starts_with("section 0 (level), byte 320: checksum "), "{error}");
}

/// Read from a file piece by piece, a bank and what is wrong with it are those of its bytes.
#[test]
fn a_file_is_what_its_bytes_are() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("site.bank");
    let whole = encode(&two_levels());
    let cut = (0..whole.len()).step_by(61).map(|length| whole[..length].to_vec());
    let damaged = (0..whole.len()).step_by(7).map(|at| {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x10;
        // Every other one has the right checksums over the wrong bytes.
        let is_sealed = at % 2 == 0 && bytes[..BLOCK] == whole[..BLOCK];
        if is_sealed { sealed(bytes) } else { bytes }
    });
    for bytes in cut.chain(damaged).chain([whole.clone()]) {
        std::fs::write(&path, &bytes).unwrap();
        let found = read(&path).map_err(|error| match error {
            BankFileError::Format { source, .. } => source,
            BankFileError::File(error) => panic!("{error}"),
        });
        assert_eq!(format!("{found:?}"), format!("{:?}", decode(&bytes)));
    }
}

#[test]
fn unknown_sections_are_skipped() {
    // The title's entry renamed: a kind of a later version.
    let mut bytes = encode(&two_levels());
    bytes[256..264].copy_from_slice(b"features");
    let bank = decode(&sealed(bytes)).unwrap();
    assert_eq!((bank.title(), bank.levels()), ("", two_levels().levels()));
}

#[test]
fn files_come_back_with_a_sidecar_that_is_toml() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("site.bank");
    write(&path, &two_levels()).unwrap();
    assert_eq!(read(&path).unwrap(), two_levels());
    let text = std::fs::read_to_string(folder.path().join("site.bank.toml")).unwrap();
    assert_eq!(text, describe(&two_levels()));
    let table: toml::Table = text.parse().unwrap();
    assert_eq!(table["format"].as_integer(), Some(1));
    assert_eq!(table["title"].as_str(), Some("two levels, µ"));
    assert_eq!(table["levels"][1]["region_size_m"].as_float(), Some(200.0));
    let degrees = table["place"]["latitude_deg"].as_float().unwrap();
    assert!((degrees - 25.783_100_780_887_047).abs() < 1e-12);
    std::fs::write(&path, b"LUNOBANK").unwrap();
    let error = read(&path).unwrap_err();
    assert!(matches!(error, BankFileError::Format { .. }));
    assert!(error.to_string().contains("site.bank: the file has 8 bytes, expected 64"), "{error}");
}

/// The lattice of check table 23.2b, whole numbers that differ along every axis.
fn lattice(shape: [usize; 2]) -> Npy {
    let value = |m: usize, n: usize, p: usize, q: usize| {
        let sum = 17 * m + 29 * n + 37 * p + 43 * q + 11 * m * p + 5 * n * q + 3 * p * q + 13 * m * n;
        (sum % 23) as f64 - 11.0
    };
    let corners = (0..shape[0]).flat_map(|m| (0..shape[1]).map(move |n| (m, n)));
    let values: Vec<f64> =
        corners.flat_map(|(m, n)| (0..9).map(move |word| value(m, n, word / 3, word % 3))).collect();
    Npy::new(vec![shape[0], shape[1], 9], values).unwrap()
}

#[test]
fn plain_coefficients_make_the_ground_of_check_table_23_2b() {
    let level = import_corners(lattice([16, 16]), 1.0, [0.0, 0.0]).unwrap();
    let rows = [
        ([2, 5], [0.3, 0.6], [6.1803546704, 3.6912244, 25.2576592]),
        ([5, 7], [1.0 - 0.2358983848622454, 0.6], [1.740642251427979, -3.07782696675675, 27.22698583769006]),
    ];
    for (region, at, expected) in rows {
        let found = level.height_and_slopes(region, at);
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-11, "{region:?}: {found} against {expected}");
        }
    }
    assert_eq!(export_corners(&level), lattice([16, 16]));
}

#[test]
fn arrays_of_other_shape_or_type_are_refused() {
    let of = |shape: Vec<usize>, data: NpyData| {
        import_corners(Npy::new(shape, data).unwrap(), 1.0, [0.0; 2]).unwrap_err()
    };
    assert_eq!(of(vec![9, 2, 2], vec![0.0f64; 36].into()), CornersError::Shape { found: vec![9, 2, 2] });
    assert_eq!(of(vec![4, 9], vec![0.0f64; 36].into()), CornersError::Shape { found: vec![4, 9] });
    for (data, found) in [
        (vec![0.0f32; 36].into(), "f32"),
        (NpyData::U8(vec![0; 36]), "u8"),
        (NpyData::I8(vec![0; 36]), "i8"),
        (NpyData::U16(vec![0; 36]), "u16"),
        (NpyData::I16(vec![0; 36]), "i16"),
        (NpyData::U32(vec![0; 36]), "u32"),
        (NpyData::I32(vec![0; 36]), "i32"),
        (NpyData::U64(vec![0; 36]), "u64"),
        (NpyData::I64(vec![0; 36]), "i64"),
    ] {
        assert_eq!(of(vec![2, 2, 9], data), CornersError::Type { found });
    }
    assert!(matches!(of(vec![1, 4, 9], vec![0.0f64; 36].into()), CornersError::Level(_)));
}

fn banks() -> impl Strategy<Value = Bank> {
    let finite = proptest::num::f64::NORMAL | proptest::num::f64::ZERO;
    let finite = finite.prop_map(|word| word.clamp(-1e12, 1e12));
    let level = (2usize..5, 2usize..5, 1e-3..1e3, proptest::collection::vec(finite, 9 * 16));
    (level, ".*", any::<bool>()).prop_map(|((rows, columns, size, values), title, placed)| {
        let words = values.as_chunks::<9>().0[..rows * columns].to_vec();
        let place = Georeference { latitude: -1.5, longitude: 3.0, at: [1.0, -2.0], true_north: Some(-0.1) };
        let level = Level::new(size, [size, -size], [rows, columns], words).unwrap();
        Bank::new(title, vec![level], placed.then_some(place)).unwrap()
    })
}

#[test]
fn true_north_needs_a_place_and_a_range() {
    let of = |place: [u8; 8], north: f64| {
        let georeference =
            Georeference { latitude: 0.5, longitude: 0.1, at: [0.0; 2], true_north: Some(north) };
        let level = Level::new(1.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
        let mut bytes = encode(&Bank::new("", vec![level], Some(georeference)).unwrap());
        // Table: level, place, north, title.
        bytes[2 * BLOCK..2 * BLOCK + 8].copy_from_slice(&place);
        decode(&sealed(bytes)).map(|bank| bank.georeference().and_then(|place| place.true_north))
    };
    let said = |result: Result<_, BankFormatError>| result.unwrap_err().to_string();
    assert_eq!(of(PLACE, -0.25), Ok(Some(-0.25)));
    assert_eq!(of(*b"other\0\0\0", 0.0), Err(BankFormatError::NorthWithoutPlace));
    assert!(said(of(PLACE, 7.0)).contains("true north within"));
    assert!(said(of(PLACE, f64::NAN)).contains("NaN, expected true north"));
}

/// Of a section `north` and a map, the map says where true north is.
#[test]
fn the_map_gives_true_north() {
    let place = Georeference { latitude: 0.5, longitude: 0.1, at: [3.0, 4.0], true_north: Some(1.5) };
    let level = Level::new(1.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
    let bank = Bank::new("", vec![level], Some(place)).unwrap();
    for map in frames() {
        let bank = bank.clone().with_map(Some(map));
        let found = bank.georeference().and_then(|place| place.true_north);
        assert_eq!(found, map.true_north([3.0, 4.0]).or(Some(1.5)));
        let bytes = encode(&bank);
        let has_section = bytes.chunks(BLOCK).any(|block| block.starts_with(&NORTH));
        assert_eq!(has_section, map.projection.is_none());
        assert_eq!(decode(&bytes), Ok(bank));
    }
}

/// A frame with each method, and one without.
fn frames() -> Vec<MapFrame> {
    let methods = [
        Some(Method::Equirectangular { parallel: 0.25 }),
        Some(Method::PolarStereographic { scale: 0.994 }),
        Some(Method::Orthographic),
        None,
    ];
    let of = |method: Option<Method>| MapFrame {
        projection: method.map(|method| Projection {
            method,
            latitude: -0.5,
            longitude: 3.0,
            radius: 1_737_400.0,
            offset: [10.0, -20.0],
        }),
        coordinates: if method.is_some() { FileCoordinates::Metres } else { FileCoordinates::Degrees },
        origin: [150_000.5, -15_000.25],
        first_sample: [0.5, 0.25],
        spacing: [1.0, 2.0],
    };
    methods.into_iter().map(of).collect()
}

#[test]
fn the_map_comes_back_and_is_no_part_of_the_ground() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.bank");
    for map in frames() {
        let bank = two_levels().with_map(Some(map));
        assert_eq!(decode(&encode(&bank)), Ok(bank.clone()));
        assert_eq!(content_hash(&bank), content_hash(&two_levels()));
        write(&path, &bank).unwrap();
        let expected = super::Outline { map: Some(map), extent: bank.finest().extent() };
        assert_eq!(super::read_outline(&path).unwrap(), expected);
        let sidecar = std::fs::read_to_string(folder.path().join("a.bank.toml")).unwrap();
        let table: toml::Table = sidecar.parse().unwrap();
        assert_eq!(table["map"]["origin_north_m"].as_float(), Some(150_000.5));
        assert_eq!(table["map"]["projection"].as_str(), Some(map.projection_name()));
    }
    write(&path, &two_levels()).unwrap();
    assert_eq!(super::read_outline(&path).unwrap().map, None);
}

#[test]
fn a_map_that_cannot_be_is_refused() {
    // Sections: two levels, place, map.
    let entry = BLOCK * 4;
    let with = |at: usize, bytes: [u8; 8]| {
        let mut file = encode(&two_levels().with_map(Some(frames()[1])));
        let offset = u64::from_le_bytes(file[entry + 8..entry + 16].try_into().unwrap()) as usize;
        file[offset + at..offset + at + 8].copy_from_slice(&bytes);
        decode(&sealed(file)).unwrap_err().to_string()
    };
    let cases = [
        (0, *b"\x04\0\0\0\0\0\0\0", "expected 0 to 3"),
        (0, *b"\x02\0\0\0\x02\0\0\0", "expected 0 (metres) or 1 (degrees)"),
        (8, 0.0_f64.to_le_bytes(), "radius within"),
        (16, 0.0_f64.to_le_bytes(), "scale within"),
        (24, f64::NAN.to_le_bytes(), "latitude within"),
        (56, f64::INFINITY.to_le_bytes(), "north of the origin within"),
        (96, (-1.0_f64).to_le_bytes(), "spacing to the east within"),
    ];
    for (at, bytes, expected) in cases {
        let said = with(at, bytes);
        assert!(said.contains("section 3 (map)") && said.contains(expected), "{at}: {said}");
    }
    let mut short = encode(&two_levels().with_map(Some(frames()[0])));
    short[entry + 16] = 96;
    assert!(decode(&sealed(short)).unwrap_err().to_string().contains("96 bytes, expected 104"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn decoding_undoes_encoding(bank in banks()) {
        prop_assert_eq!(decode(&encode(&bank)), Ok(bank));
    }

    #[test]
    fn flipped_bytes_are_refused_or_harmless(bank in banks(), at in any::<u32>(), flip in 1u8..) {
        let mut bytes = encode(&bank);
        let at = at as usize % bytes.len();
        bytes[at] ^= flip;
        let found = decode(&bytes);
        prop_assert!(found.is_err() || found == Ok(bank));
    }

    #[test]
    fn sealed_damage_never_panics(at in any::<u32>(), bytes in any::<[u8; 8]>()) {
        let mut file = encode(&two_levels());
        let at = 64 + at as usize % (file.len() - 72);
        file[at..at + 8].copy_from_slice(&bytes);
        let _ = decode(&sealed(file));
    }

    #[test]
    fn any_bytes_are_refused(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        prop_assert!(decode(&bytes).is_err());
    }
}
