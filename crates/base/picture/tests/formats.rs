//! PNG, animated PNG and Y4M, read back and damaged.

use std::io::Cursor;

use picture::{
    Apng, Depth, GreyPicture, Limits, PictureError, PictureFileError, Y4m, Y4mColour, decode_png, encode_png,
    read_png, write_png,
};
use proptest::prelude::{any, prop_assert_eq, proptest};

fn ramp(columns: usize, lines: usize, depth: Depth, from: usize) -> GreyPicture {
    let modulus = usize::from(depth.white()) + 1;
    let codes = (0..columns * lines).map(|at| ((from + at * 37) % modulus) as u16).collect();
    GreyPicture::new(columns, lines, depth, codes).expect("a good picture")
}

/// A PNG of one pixel as another program would write it.
fn foreign(colour: png::ColorType, depth: png::BitDepth, bytes: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 1, 1);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().expect("memory takes it");
    writer.write_image_data(bytes).expect("memory takes it");
    writer.finish().expect("memory takes it");
    file
}

#[test]
fn both_depths_survive() {
    for depth in [Depth::Eight, Depth::Sixteen] {
        let picture = ramp(70, 40, depth, 5);
        let bytes = encode_png(&picture, &[]).expect("PNG holds it");
        assert_eq!(decode_png(&bytes, &Limits::default()).expect("ours"), picture);
    }
}

#[test]
fn texts_are_kept() {
    let texts = [("Frame", "12"), ("Time", "0.4 s")];
    let bytes = encode_png(&ramp(3, 3, Depth::Eight, 0), &texts).expect("PNG holds it");
    let reader = png::Decoder::new(Cursor::new(&bytes)).read_info().expect("a PNG");
    let found = &reader.info().uncompressed_latin1_text;
    let found: Vec<_> = found.iter().map(|chunk| (chunk.keyword.as_str(), chunk.text.as_str())).collect();
    assert_eq!(found, texts);
    let too_long = "x".repeat(80);
    assert!(matches!(
        encode_png(&ramp(3, 3, Depth::Eight, 0), &[(&too_long, "")]),
        Err(PictureError::Encode(_))
    ));
}

#[test]
fn what_is_not_grey_is_refused() {
    use png::{BitDepth, ColorType};
    let read = |colour, depth, bytes: &[u8]| decode_png(&foreign(colour, depth, bytes), &Limits::default());
    let colour = read(ColorType::Rgb, BitDepth::Eight, &[1, 2, 3]).expect_err("colour");
    let expected =
        "the PNG is Rgb of 8 bits, expected grey of 8 or 16 bits; convert it to grey without alpha";
    assert_eq!(colour.to_string(), expected);
    let alpha = read(ColorType::GrayscaleAlpha, BitDepth::Sixteen, &[1, 2, 3, 4]);
    assert!(matches!(alpha, Err(PictureError::NotGrey { .. })));
    assert!(matches!(read(ColorType::Grayscale, BitDepth::One, &[1]), Err(PictureError::NotGrey { .. })));
    assert!(read(ColorType::Grayscale, BitDepth::Eight, &[1]).is_ok());
}

#[test]
fn limits_hold_before_anything_is_allocated() {
    let bytes = encode_png(&ramp(9, 9, Depth::Eight, 0), &[]).expect("PNG holds it");
    let limits = Limits { pixels: 80, ..Limits::default() };
    assert!(matches!(decode_png(&bytes, &limits), Err(PictureError::TooManyPixels { .. })));
    let mut hollow = Vec::new();
    let mut encoder = png::Encoder::new(&mut hollow, 8000, 8000);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header().expect("memory takes it");
    writer.write_chunk(png::chunk::IDAT, &[]).expect("memory takes it");
    drop(writer);
    assert!(matches!(decode_png(&hollow, &Limits::default()), Err(PictureError::Hollow { .. })));
}

#[test]
fn files_name_themselves_in_errors() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("frame-000000.png");
    let picture = ramp(5, 4, Depth::Sixteen, 1);
    write_png(&path, &picture, &[]).expect("written");
    assert_eq!(read_png(&path, &Limits::default()).expect("ours"), picture);
    let bytes = std::fs::read(&path).expect("read");
    std::fs::write(&path, &bytes[..bytes.len() / 2]).expect("written");
    let cut = read_png(&path, &Limits::default()).expect_err("half a file");
    assert!(cut.to_string().contains("frame-000000.png: not a whole PNG"), "{cut}");
    assert!(matches!(read_png(folder.path(), &Limits::default()), Err(PictureFileError::File(_))));
}

#[test]
fn an_animation_holds_every_frame() {
    let frames: Vec<_> = (0..3).map(|from| ramp(30, 20, Depth::Eight, from)).collect();
    let mut bytes = Vec::new();
    let mut film = Apng::new(&mut bytes, 30, 20, 3, (1001, 30_000)).expect("memory takes it");
    frames.iter().for_each(|frame| film.add(frame).expect("memory takes it"));
    film.finish().expect("memory takes it");
    assert_eq!(decode_png(&bytes, &Limits::default()).expect("a PNG"), frames[0]);
    let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().expect("a PNG");
    for frame in &frames {
        let mut codes = vec![0; 600];
        reader.next_frame(&mut codes).expect("a frame");
        assert_eq!(codes.iter().map(|code| u16::from(*code)).collect::<Vec<_>>(), frame.codes());
        let control = reader.info().frame_control.expect("an animation");
        assert_eq!((control.delay_num, control.delay_den), (1001, 30_000));
    }
}

#[test]
fn films_of_wrong_frames_are_refused() {
    let mut film = Apng::new(Vec::new(), 4, 4, 1, (1, 30)).expect("memory takes it");
    assert!(film.add(&ramp(4, 5, Depth::Eight, 0)).is_err());
    let deep = film.add(&ramp(4, 4, Depth::Sixteen, 0)).expect_err("16 bits");
    let expected = "a frame of 4 columns, 4 lines, 16 bits in a film of 4 columns, 4 lines, 8 bits";
    assert_eq!(deep.to_string(), expected);
    film.add(&ramp(4, 4, Depth::Eight, 0)).expect("memory takes it");
    assert!(film.add(&ramp(4, 4, Depth::Eight, 0)).is_err());
    let short = Apng::new(Vec::new(), 4, 4, 1, (1, 30)).expect("memory takes it");
    assert!(short.finish().is_err());
    assert!(Apng::new(Vec::new(), 4, 4, 0, (1, 30)).is_err());
}

#[test]
fn y4m_is_a_line_and_bytes() {
    let frame = ramp(3, 1, Depth::Eight, 1);
    let write = |colour| {
        let mut film = Y4m::new(Vec::new(), 3, 1, (30_000, 1001), colour).expect("memory takes it");
        film.add(&frame).expect("memory takes it");
        film.add(&frame).expect("memory takes it");
        film.finish().expect("memory takes it")
    };
    let mono =
        b"YUV4MPEG2 W3 H1 F30000:1001 Ip A1:1 Cmono XCOLORRANGE=FULL\nFRAME\n\x01\x26\x4bFRAME\n\x01\x26\x4b";
    assert_eq!(write(Y4mColour::Mono), mono);
    let planes = write(Y4mColour::Planes420);
    assert!(planes.ends_with(b"FRAME\n\x01\x26\x4b\x80\x80\x80\x80"));
    let mut film = Y4m::new(Vec::new(), 3, 1, (30, 1), Y4mColour::Mono).expect("memory takes it");
    assert!(film.add(&ramp(1, 3, Depth::Eight, 0)).is_err());
}

proptest! {
    #[test]
    fn any_picture_survives(codes in proptest::collection::vec(any::<u16>(), 1..60)) {
        let picture = GreyPicture::new(codes.len(), 1, Depth::Sixteen, codes).expect("a good picture");
        let bytes = encode_png(&picture, &[]).expect("PNG holds it");
        prop_assert_eq!(decode_png(&bytes, &Limits::default()).expect("ours"), picture);
    }

    #[test]
    fn damage_is_survived(at in 0_usize..120, to in any::<u8>(), cut in 0_usize..120) {
        let mut bytes = encode_png(&ramp(6, 6, Depth::Eight, 3), &[]).expect("PNG holds it");
        let (at, cut) = (at % bytes.len(), cut % bytes.len());
        bytes[at] = to;
        let limits = Limits { pixels: 1 << 20, ..Limits::default() };
        let _ = decode_png(&bytes, &limits);
        let _ = decode_png(&bytes[..cut], &limits);
    }
}
