//! Colour pictures: through every format and back, and to grey.

use std::io::Cursor;

use picture::{
    AnyPicture, Apng, ColourPicture, Curve, Depth, Encoder, GAP, GreyPicture, Limits, PictureError, Transfer,
    Y4m, Y4mColour, beside, contact_sheet, decode_any_png, decode_png, encode_png, png_texts, shrink,
};
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};

fn eight(columns: usize, lines: usize, codes: &[u16]) -> ColourPicture {
    ColourPicture::new(columns, lines, Depth::Eight, codes.to_vec()).expect("a good picture")
}

fn ramp(columns: usize, lines: usize, depth: Depth) -> ColourPicture {
    let modulus = usize::from(depth.white()) + 1;
    let codes = (0..columns * lines * 3).map(|at| (at * 37 % modulus) as u16).collect();
    ColourPicture::new(columns, lines, depth, codes).expect("a good picture")
}

#[test]
fn pixels_stand_where_they_are_put() {
    let picture = eight(2, 2, &[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
    assert_eq!((picture.pixel(1, 0), picture.pixel(0, 1)), ([4, 5, 6], [7, 8, 9]));
    let wrong = ColourPicture::new(2, 2, Depth::Eight, vec![0; 4]).expect_err("a grey one");
    assert!(matches!(wrong, PictureError::Size { codes: 2, .. }), "{wrong}");
    let bright = ColourPicture::new(2, 1, Depth::Eight, vec![0, 0, 0, 0, 300, 0]).expect_err("300");
    assert_eq!(bright.to_string(), "pixel 1, 0 has code 300, expected at most 255");
}

#[test]
fn png_keeps_both_depths_and_texts() {
    for depth in [Depth::Eight, Depth::Sixteen] {
        let picture = ramp(13, 7, depth);
        let bytes = encode_png(&picture, &[("Frame", "3")]).expect("PNG holds it");
        assert_eq!(decode_any_png(&bytes, &Limits::default()).expect("ours"), AnyPicture::Colour(picture));
        assert_eq!(png_texts(&bytes), [("Frame".to_owned(), "3".to_owned())]);
        assert!(matches!(decode_png(&bytes, &Limits::default()), Err(PictureError::NotGrey { .. })));
    }
    let grey = GreyPicture::new(2, 1, Depth::Eight, vec![7, 8]).expect("a good picture");
    let bytes = encode_png(&grey, &[]).expect("PNG holds it");
    assert_eq!(decode_any_png(&bytes, &Limits::default()).expect("ours"), grey.into());
}

/// A colour picture and a grey one of three times its width hold the same codes.
#[test]
fn hashes_know_layouts_apart() {
    let colour = eight(2, 1, &[1, 2, 3, 4, 5, 6]);
    let grey = GreyPicture::new(6, 1, Depth::Eight, vec![1, 2, 3, 4, 5, 6]).expect("a good picture");
    let mut bytes = [2_u32, 1, 8, 3].map(u32::to_le_bytes).concat();
    bytes.extend([1, 2, 3, 4, 5, 6]);
    assert_eq!(colour.pixel_hash(), blake3::hash(&bytes).to_hex().as_str());
    assert_ne!(colour.pixel_hash(), grey.pixel_hash());
    assert_ne!(colour.pixel_hash(), eight(2, 1, &[3, 2, 1, 4, 5, 6]).pixel_hash());
}

/// As the program wrote them before there was colour: the bytes of grey files are the same for ever.
#[test]
fn grey_bytes_stay() {
    let of = |depth, step: u16| {
        GreyPicture::new(8, 6, depth, (0..48).map(|at| at * step).collect()).expect("a good picture")
    };
    let (picture, deep) = (of(Depth::Eight, 5), of(Depth::Sixteen, 1301));
    let hash = |bytes: &[u8]| blake3::hash(bytes).to_hex()[..32].to_owned();
    let png = encode_png(&picture, &[("Frame", "0")]).expect("PNG holds it");
    assert_eq!(hash(&png), "050df6dc9365d5294dab6372d3546ff5");
    assert_eq!(hash(&encode_png(&deep, &[]).expect("PNG holds it")), "39c948012870cb2f8d0759d5fcbab134");
    assert_eq!(picture.pixel_hash()[..32], *"4c887c0040784e060f5abc328590b574");
    let sheet = contact_sheet(&[&picture, &picture, &picture], 2, 5).expect("alike");
    assert_eq!(sheet.pixel_hash()[..32], *"11db17d280d1db7a3797c6ac7dbd0a12");
    let mut film = Y4m::new(Vec::new(), 8, 6, (30, 1), Y4mColour::Mono).expect("memory takes it");
    film.add(&picture).expect("memory takes it");
    assert_eq!(hash(&film.finish().expect("memory takes it")), "711e3c260c71727282fe7132f1169b86");
    let mut bytes = Vec::new();
    let mut film = Apng::new(&mut bytes, 8, 6, 2, (1, 30)).expect("memory takes it");
    film.add(&picture).expect("memory takes it");
    film.add(&picture).expect("memory takes it");
    film.finish().expect("memory takes it");
    assert_eq!(hash(&bytes), "5a85095613147f6982321c8eb22d0d91");
}

#[test]
fn three_planes_go_through_the_transfer_of_one() {
    let encoder = Encoder::new(Transfer::new(0.8, 2.2).expect("a law"), Depth::Sixteen);
    let planes = [[0.0, 0.1, 0.2, 0.9], [0.3, 0.3, 0.3, 0.3], [0.8, -1.0, 0.4, 0.01]];
    let colour = encoder.encode_colour(planes.each_ref().map(|plane| &plane[..]), 2, 2).expect("finite");
    for (channel, plane) in planes.iter().enumerate() {
        let grey = encoder.encode(plane, 2, 2).expect("finite");
        let found: Vec<u16> = colour.pixels().iter().map(|pixel| pixel[channel]).collect();
        assert_eq!(found, grey.codes());
    }
    let bad = encoder.encode_colour([&[0.0], &[f32::NAN], &[0.0]], 1, 1);
    assert!(matches!(bad, Err(PictureError::NotFinite { .. })));
    let short = encoder.encode_colour([&[0.0, 0.0], &[0.0, 0.0], &[0.0]], 2, 1);
    assert!(matches!(short, Err(PictureError::Size { codes: 1, .. })));
}

#[test]
fn sheets_and_sizes_keep_channels_apart() {
    let picture = eight(2, 1, &[0, 100, 200, 10, 120, 240]);
    assert_eq!(shrink(&picture, 1, 1).expect("a size"), eight(1, 1, &[5, 110, 220]));
    let row = beside(&[&picture, &picture]).expect("alike");
    assert_eq!(
        (row.columns(), row.pixel(2 + GAP + 1, 0), row.pixel(2, 0)),
        (4 + GAP, [10, 120, 240], [63; 3])
    );
    let sheet = contact_sheet(&[&picture, &picture], 1, 2).expect("alike");
    assert_eq!(sheet.pixel(1, 1 + GAP), [10, 120, 240]);
}

#[test]
fn an_animation_holds_colour_and_no_grey() {
    let frames = [ramp(5, 4, Depth::Eight), eight(5, 4, &[9; 60])];
    let mut bytes = Vec::new();
    let mut film = Apng::colour(&mut bytes, 5, 4, 2, (1, 30)).expect("memory takes it");
    let grey = GreyPicture::new(5, 4, Depth::Eight, vec![1; 20]).expect("a good picture");
    let refused = film.add(&grey).expect_err("grey in a film of colour").to_string();
    assert_eq!(
        refused,
        "a frame of 5 columns, 4 lines, 8 bits in a film of 5 columns, 4 lines, 8 bits, colour"
    );
    frames.iter().for_each(|frame| film.add(frame).expect("memory takes it"));
    film.finish().expect("memory takes it");
    let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().expect("a PNG");
    for frame in &frames {
        let mut codes = vec![0; 60];
        reader.next_frame(&mut codes).expect("a frame");
        assert_eq!(codes.iter().map(|code| u16::from(*code)).collect::<Vec<_>>(), frame.codes());
    }
}

/// Figures of BT.709: white has no colour; red is 54, 99, 255 (of 0.2126, and half the range above 128).
#[test]
fn y4m_has_the_matrix_of_bt_709() {
    let frame = eight(4, 1, &[255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255]);
    let mut film = Y4m::new(Vec::new(), 4, 1, (30, 1), Y4mColour::Planes444).expect("memory takes it");
    film.add(&frame).expect("memory takes it");
    let bytes = film.finish().expect("memory takes it");
    let head = b"YUV4MPEG2 W4 H1 F30:1 Ip A1:1 C444 XCOLORRANGE=FULL XMATRIX=BT709\nFRAME\n";
    assert!(bytes.starts_with(head));
    let planes = [[255, 54, 182, 18], [128, 99, 30, 255], [128, 255, 12, 116]];
    assert_eq!(bytes[head.len()..], *planes.as_flattened());
}

#[test]
fn grey_is_luminance_in_linear_light() {
    // sRGB red alone: 0.2126 of white, whose level is 1.055 0.2126^(1/2.4) - 0.055 = 0.49861.
    let picture = eight(3, 1, &[255, 0, 0, 0, 255, 0, 0, 0, 255]);
    assert_eq!(picture.to_grey(Curve::Srgb).codes(), [127, 220, 76]);
    // Under a linear display the codes themselves are weighted.
    assert_eq!(picture.to_grey(Curve::Power(1.0)).codes(), [54, 182, 18]);
}

proptest! {
    #[test]
    fn grey_of_grey_is_itself(codes in proptest::collection::vec(any::<u16>(), 1..40)) {
        let grey = GreyPicture::new(codes.len(), 1, Depth::Sixteen, codes).expect("a good picture");
        prop_assert_eq!(grey.to_colour().to_grey(Curve::Srgb), grey.clone());
        prop_assert_eq!(AnyPicture::from(grey.clone()).to_colour(), grey.to_colour());
    }

    #[test]
    fn luminance_lies_between_the_channels(pixel in any::<[u8; 3]>(), exponent in 0.5_f64..3.0) {
        let picture = eight(1, 1, &pixel.map(u16::from));
        for curve in [Curve::Srgb, Curve::Power(exponent)] {
            let grey = picture.to_grey(curve).code(0, 0);
            let [low, high] = [pixel.iter().min(), pixel.iter().max()].map(|code| u16::from(*code.unwrap_or(&0)));
            prop_assert!((low..=high).contains(&grey), "{pixel:?}: {grey}");
        }
    }

    #[test]
    fn curves_go_both_ways(code in any::<u16>()) {
        for curve in [Curve::Srgb, Curve::Power(2.2)] {
            let light = curve.light(f64::from(code) / 65_535.0);
            prop_assert_eq!(curve.code(light, Depth::Sixteen), code);
        }
    }
}
