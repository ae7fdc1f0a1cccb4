//! Pictures, their codes and their hash.

use picture::{Depth, Encoder, GAP, GreyPicture, PictureError, Transfer, beside, contact_sheet, shrink};
use proptest::prelude::{prop_assert_eq, prop_assume, proptest};

fn eight(columns: usize, lines: usize, codes: &[u16]) -> GreyPicture {
    GreyPicture::new(columns, lines, Depth::Eight, codes.to_vec()).expect("a good picture")
}

#[test]
fn pictures_that_cannot_be_are_refused() {
    let new = |columns, lines, codes: &[u16]| GreyPicture::new(columns, lines, Depth::Eight, codes.to_vec());
    assert!(matches!(new(0, 0, &[]), Err(PictureError::Size { .. })));
    assert!(matches!(new(usize::MAX, 2, &[0, 0]), Err(PictureError::Size { .. })));
    assert!(matches!(new(2, 2, &[0; 3]), Err(PictureError::Size { codes: 3, .. })));
    let bright = new(2, 2, &[0, 0, 0, 256]).expect_err("256 is no code of 8 bits");
    assert_eq!(bright.to_string(), "pixel 1, 1 has code 256, expected at most 255");
}

#[test]
fn the_hash_is_of_size_depth_and_codes() {
    let mut bytes = [2_u32, 1, 8].map(u32::to_le_bytes).concat();
    bytes.extend([7, 255]);
    let picture = eight(2, 1, &[7, 255]);
    assert_eq!(picture.pixel_hash(), blake3::hash(&bytes).to_hex().as_str());
    let others = [eight(1, 2, &[7, 255]), eight(2, 1, &[7, 254]), deep(2, 1, &[7, 255])];
    assert!(others.iter().all(|other| other.pixel_hash() != picture.pixel_hash()));
}

fn deep(columns: usize, lines: usize, codes: &[u16]) -> GreyPicture {
    GreyPicture::new(columns, lines, Depth::Sixteen, codes.to_vec()).expect("a good picture")
}

#[test]
fn sixteen_bits_become_the_nearest_eight() {
    assert_eq!(deep(5, 1, &[0, 128, 129, 65_406, 65_535]).to_eight_bits(), eight(5, 1, &[0, 0, 1, 254, 255]));
}

#[test]
fn linear_transfer_is_a_scale() {
    let encoder = Encoder::new(Transfer::new(2.0, 1.0).expect("a good law"), Depth::Eight);
    let plane = [-1.0, -0.0, 0.0, 1.0, 2.0, 3.0, f32::MAX, f32::MIN_POSITIVE];
    let picture = encoder.encode(&plane, 8, 1).expect("finite");
    assert_eq!(picture.codes(), [0, 0, 0, 128, 255, 255, 255, 0]);
}

#[test]
fn what_is_no_number_never_becomes_a_code() {
    let encoder = Encoder::new(Transfer::new(1.0, 2.2).expect("a good law"), Depth::Eight);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let error = encoder.encode(&[0.0, 0.0, 0.0, 0.0, bad, bad], 3, 2).expect_err("not finite");
        assert!(matches!(error, PictureError::NotFinite { column: 1, line: 1, .. }), "{error}");
    }
    assert!(matches!(encoder.encode(&[0.0; 5], 3, 2), Err(PictureError::Size { .. })));
    assert!(matches!(encoder.encode(&[], 0, 0), Err(PictureError::Size { .. })));
    assert!(Transfer::new(0.0, 2.2).is_err());
    assert!(Transfer::new(1.0, f32::NAN).is_err());
}

#[test]
fn areas_are_averaged() {
    let picture = eight(4, 2, &[0, 10, 20, 30, 4, 6, 20, 33]);
    assert_eq!(shrink(&picture, 2, 1).expect("a size"), eight(2, 1, &[5, 26]));
    assert_eq!(shrink(&picture, 4, 2).expect("a size"), picture);
    // Three pixels into two: the middle one is shared.
    assert_eq!(shrink(&eight(3, 1, &[0, 90, 240]), 2, 1).expect("a size"), eight(2, 1, &[30, 190]));
    assert!(shrink(&picture, 0, 1).is_err());
}

#[test]
fn sheets_are_in_reading_order() {
    let pictures: Vec<_> = [10, 20, 30].map(|code| eight(6, 4, &[code; 24])).into();
    let pictures: Vec<_> = pictures.iter().collect();
    let sheet = contact_sheet(&pictures, 2, 3).expect("alike");
    assert_eq!((sheet.columns(), sheet.lines()), (3 + GAP + 3, 2 + GAP + 2));
    let corners = [(0, 0), (3 + GAP, 0), (0, 2 + GAP), (3 + GAP, 2 + GAP), (3, 0)];
    assert_eq!(corners.map(|(column, line)| sheet.code(column, line)), [10, 20, 30, 63, 63]);
    let row = beside(&pictures).expect("alike");
    assert_eq!((row.columns(), row.lines()), (3 * 6 + 2 * GAP, 4));
    assert_eq!(row.code(2 * (6 + GAP), 3), 30);
}

#[test]
fn sheets_of_unlike_pictures_are_refused() {
    let (small, large, dark) = (eight(1, 1, &[0]), eight(2, 1, &[0, 0]), deep(1, 1, &[0]));
    assert!(matches!(beside(&[&small, &large]), Err(PictureError::Unlike { .. })));
    assert!(matches!(beside(&[&small, &dark]), Err(PictureError::Unlike { .. })));
    assert!(matches!(beside::<1>(&[]), Err(PictureError::NoPictures)));
    assert!(matches!(contact_sheet(&[&small], 0, 4), Err(PictureError::NoPictures)));
    assert!(contact_sheet(&[&small], 1, 0).is_err());
}

proptest! {
    #[test]
    fn shrinking_keeps_what_is_even(code in 0_u16..=255, size in 1_usize..9, to in 1_usize..12) {
        let small = shrink(&eight(size, 3, &vec![code; size * 3]), to, 2).expect("a size");
        prop_assert_eq!(small.codes(), vec![code; to * 2]);
    }

    #[test]
    fn codes_grow_with_intensity(a in 0.0_f32..1.2, b in 0.0_f32..1.2) {
        prop_assume!(a <= b);
        let encoder = Encoder::new(Transfer::new(1.0, 2.2).expect("a good law"), Depth::Eight);
        let picture = encoder.encode(&[a, b], 2, 1).expect("finite");
        prop_assert_eq!(picture.code(0, 0).min(picture.code(1, 0)), picture.code(0, 0));
    }
}
