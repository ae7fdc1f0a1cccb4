//! Pictures of other programs: every layout and format, what is told of them, and what is refused.

use std::io::Cursor;

use image::{DynamicImage, ImageEncoder, ImageFormat, ImageReader};
use photographs::{PhotographError, Use, decode, decode_for, read};
use picture::{AnyPicture, ColourPicture, Curve, Depth, GreyPicture, Limits};
use png::{BitDepth, ColorType};
use proptest::prelude::{ProptestConfig, any, proptest};
use tiff::encoder::{TiffEncoder, colortype};

fn of(bytes: &[u8]) -> Result<AnyPicture, PhotographError> {
    decode(bytes, &Limits::default())
}

fn refused(bytes: &[u8]) -> String {
    of(bytes).expect_err("it is refused").to_string()
}

fn grey(columns: usize, lines: usize, depth: Depth, codes: &[u16]) -> AnyPicture {
    GreyPicture::new(columns, lines, depth, codes.to_vec()).expect("a good picture").into()
}

fn colour(columns: usize, lines: usize, depth: Depth, codes: &[u16]) -> AnyPicture {
    ColourPicture::new(columns, lines, depth, codes.to_vec()).expect("a good picture").into()
}

/// A PNG of one line.
fn png_of(
    columns: u32,
    colour: ColorType,
    depth: BitDepth,
    bytes: &[u8],
    set: impl Fn(&mut png::Encoder<&mut Vec<u8>>),
) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, columns, 1);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    set(&mut encoder);
    let mut writer = encoder.write_header().expect("memory takes it");
    writer.write_image_data(bytes).expect("memory takes it");
    writer.finish().expect("memory takes it");
    file
}

fn png(columns: u32, colour: ColorType, depth: BitDepth, bytes: &[u8]) -> Vec<u8> {
    png_of(columns, colour, depth, bytes, |_| ())
}

fn tiff_of<C: colortype::ColorType>(columns: u32, data: &[C::Inner]) -> Vec<u8>
where
    [C::Inner]: tiff::encoder::TiffValue,
{
    let mut file = Cursor::new(Vec::new());
    TiffEncoder::new(&mut file).unwrap().write_image::<C>(columns, 1, data).unwrap();
    file.into_inner()
}

#[test]
fn every_layout_of_png_is_read() {
    use BitDepth::{Eight, One, Sixteen, Two};
    let read = |colour, depth, columns, bytes: &[u8]| of(&png(columns, colour, depth, bytes)).unwrap();
    assert_eq!(read(ColorType::Grayscale, Eight, 2, &[7, 200]), grey(2, 1, Depth::Eight, &[7, 200]));
    assert_eq!(read(ColorType::Grayscale, Sixteen, 1, &[1, 2]), grey(1, 1, Depth::Sixteen, &[258]));
    assert_eq!(read(ColorType::Grayscale, One, 2, &[0x40]), grey(2, 1, Depth::Eight, &[0, 255]));
    assert_eq!(read(ColorType::Grayscale, Two, 3, &[0b0001_1000]), grey(3, 1, Depth::Eight, &[0, 85, 170]));
    assert_eq!(read(ColorType::Rgb, Eight, 1, &[1, 2, 3]), colour(1, 1, Depth::Eight, &[1, 2, 3]));
    assert_eq!(
        read(ColorType::Rgb, Sixteen, 1, &[0, 1, 1, 0, 255, 255]),
        colour(1, 1, Depth::Sixteen, &[1, 256, 65_535])
    );
    let palette =
        png_of(2, ColorType::Indexed, Eight, &[1, 0], |encoder| encoder.set_palette(&[9, 8, 7, 1, 2, 3][..]));
    assert_eq!(of(&palette).unwrap(), colour(2, 1, Depth::Eight, &[1, 2, 3, 9, 8, 7]));
}

/// Half the light of a white pixel over black is level 0.7354 of sRGB: 188 of 255.
#[test]
fn alpha_lies_over_black_in_linear_light() {
    let read = |colour, depth, columns, bytes: &[u8]| of(&png(columns, colour, depth, bytes)).unwrap();
    let found = read(ColorType::GrayscaleAlpha, BitDepth::Eight, 4, &[77, 255, 77, 0, 255, 128, 0, 128]);
    assert_eq!(found, grey(4, 1, Depth::Eight, &[77, 0, 188, 0]));
    let found = read(ColorType::Rgba, BitDepth::Eight, 2, &[1, 2, 3, 255, 255, 0, 255, 128]);
    assert_eq!(found, colour(2, 1, Depth::Eight, &[1, 2, 3, 188, 0, 188]));
    let found = read(ColorType::GrayscaleAlpha, BitDepth::Sixteen, 1, &[1, 2, 255, 255]);
    assert_eq!(found, grey(1, 1, Depth::Sixteen, &[258]));
    // A colour that is named as clear is clear.
    let clear =
        png_of(2, ColorType::Grayscale, BitDepth::Eight, &[7, 9], |encoder| encoder.set_trns(&[0, 7][..]));
    assert!(matches!(of(&clear).unwrap(), AnyPicture::Colour(_) | AnyPicture::Grey(_)));
    assert_eq!(of(&clear).unwrap().to_grey(photographs::CURVE).codes(), [0, 9]);
}

fn with_gamma(gamma: f32) -> Vec<u8> {
    png_of(1, ColorType::Grayscale, BitDepth::Eight, &[100], |encoder| {
        encoder.set_source_gamma(png::ScaledFloat::new(gamma));
    })
}

/// A chunk behind the header of a PNG.
fn with_chunk(png: &[u8], kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let mut named = kind.to_vec();
    named.extend(data);
    let crc = named.iter().fold(u32::MAX, |sum, byte| {
        (0..8).fold(
            sum ^ u32::from(*byte),
            |sum, _| if sum & 1 == 1 { sum >> 1 ^ 0xEDB8_8320 } else { sum >> 1 },
        )
    });
    let (head, rest) = png.split_at(33);
    [head, &(data.len() as u32).to_be_bytes(), &named, &(!crc).to_be_bytes(), rest].concat()
}

/// The least colour profile that has a description, of version 2, or of version 4.
fn profile(name: &str, is_fourth: bool) -> Vec<u8> {
    let text: Vec<u8> = match is_fourth {
        false => name.bytes().chain([0]).collect(),
        true => name.encode_utf16().flat_map(u16::to_be_bytes).collect(),
    };
    let number = |value: usize| (value as u32).to_be_bytes();
    let tag = match is_fourth {
        false => [b"desc".as_slice(), &[0; 4], &number(text.len()), &text].concat(),
        true => [
            b"mluc".as_slice(),
            &[0; 4],
            &number(1),
            &number(12),
            b"enUS",
            &number(text.len()),
            &number(28),
            &text,
        ]
        .concat(),
    };
    [
        vec![0; 128],
        number(1).to_vec(),
        b"desc".to_vec(),
        number(144).to_vec(),
        number(tag.len()).to_vec(),
        tag,
    ]
    .concat()
}

fn with_profile(name: &str, is_fourth: bool) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let mut encoder = image::codecs::png::PngEncoder::new(&mut file);
    encoder.set_icc_profile(profile(name, is_fourth)).unwrap();
    encoder.write_image(&[100], 1, 1, image::ExtendedColorType::L8).unwrap();
    file.into_inner()
}

/// A file may say what its codes mean: sRGB is what they are taken for, and anything else is refused.
#[test]
fn light_of_another_kind_is_refused_by_name() {
    let plain = grey(1, 1, Depth::Eight, &[100]);
    let of_points =
        |points: &[u8]| with_chunk(&png(1, ColorType::Grayscale, BitDepth::Eight, &[100]), b"cICP", points);
    let same = [
        with_gamma(0.45455),
        with_profile("sRGB IEC61966-2.1", false),
        with_profile("sRGB v4 preference", true),
        with_profile("Generic Gray Gamma 2.2 Profile", true),
        of_points(&[1, 13, 0, 1]),
        with_chunk(&with_gamma(1.0), b"sRGB", &[0]),
    ];
    for file in same {
        assert_eq!(of(&file).unwrap(), plain);
    }
    let others = [
        (with_gamma(1.0), "the PNG has gamma 1, expected sRGB"),
        (with_profile("Adobe RGB (1998)", false), "a colour profile Adobe RGB (1998), expected sRGB"),
        (with_profile("Display P3", true), "a colour profile Display P3"),
        (of_points(&[9, 16, 0, 1]), "code points [9, 16, 0, 1]"),
    ];
    for (file, said) in &others {
        assert!(refused(file).contains(said), "{}", refused(file));
        // A map whose curve somebody states has the codes as they are.
        assert_eq!(decode_for(Use::Map(Curve::Power(1.0)), file, &Limits::default()).unwrap(), plain);
        assert!(decode_for(Use::Map(Curve::Srgb), file, &Limits::default()).is_err());
    }
}

#[test]
fn a_map_has_a_value_in_every_pixel() {
    let map = |bytes: &[u8]| decode_for(Use::Map(Curve::Srgb), bytes, &Limits::default());
    let opaque = png(2, ColorType::GrayscaleAlpha, BitDepth::Eight, &[77, 255, 9, 255]);
    assert_eq!(map(&opaque).unwrap(), grey(2, 1, Depth::Eight, &[77, 9]));
    for (colour, depth, bytes) in [
        (ColorType::GrayscaleAlpha, BitDepth::Eight, &[77, 255, 9, 254][..]),
        (ColorType::Rgba, BitDepth::Eight, &[1, 2, 3, 255, 1, 2, 3, 0]),
        (ColorType::GrayscaleAlpha, BitDepth::Sixteen, &[1, 2, 255, 255, 1, 2, 255, 254]),
        (ColorType::Rgba, BitDepth::Sixteen, &[0, 1, 0, 1, 0, 1, 255, 255, 0, 1, 0, 1, 0, 1, 0, 0]),
    ] {
        let said = map(&png(2, colour, depth, bytes)).unwrap_err().to_string();
        assert!(said.contains("pixels that let light through"), "{said}");
    }
}

#[test]
fn tiff_is_read_in_both_depths() {
    assert_eq!(of(&tiff_of::<colortype::Gray8>(2, &[3, 4])).unwrap(), grey(2, 1, Depth::Eight, &[3, 4]));
    assert_eq!(of(&tiff_of::<colortype::Gray16>(1, &[999])).unwrap(), grey(1, 1, Depth::Sixteen, &[999]));
    assert_eq!(
        of(&tiff_of::<colortype::RGB8>(1, &[1, 2, 3])).unwrap(),
        colour(1, 1, Depth::Eight, &[1, 2, 3])
    );
    let deep = of(&tiff_of::<colortype::RGB16>(1, &[1, 2, 60_000])).unwrap();
    assert_eq!(deep, colour(1, 1, Depth::Sixteen, &[1, 2, 60_000]));
}

fn jpeg_of(image: &DynamicImage) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    image.write_to(&mut file, ImageFormat::Jpeg).unwrap();
    file.into_inner()
}

fn flat(colour: [u8; 3]) -> DynamicImage {
    DynamicImage::ImageRgb8(image::RgbImage::from_pixel(16, 8, image::Rgb(colour)))
}

#[test]
fn jpeg_is_read_near_its_codes() {
    let read = of(&jpeg_of(&flat([200, 100, 50]))).unwrap();
    let AnyPicture::Colour(found) = read else { panic!("colour") };
    assert_eq!((found.columns(), found.lines(), found.depth()), (16, 8, Depth::Eight));
    assert!(found.pixels().iter().all(|pixel| (0..3).all(|k| pixel[k].abs_diff([200, 100, 50][k]) <= 3)));
    let grey = DynamicImage::ImageLuma8(image::GrayImage::from_pixel(8, 8, image::Luma([90])));
    assert!(matches!(of(&jpeg_of(&grey)).unwrap(), AnyPicture::Grey(_)));
}

/// An EXIF segment with orientation 6, "turn a quarter to the right", behind the start of a JPEG of 16 x 8.
#[test]
fn cameras_that_lay_on_their_side_are_set_upright() {
    let jpeg = jpeg_of(&flat([9, 9, 9]));
    let exif = b"\xFF\xE1\x00\x22Exif\0\0MM\x00\x2A\x00\x00\x00\x08\x00\x01\x01\x12\x00\x03\x00\x00\x00\x01\x00\x06\x00\x00\x00\x00\x00\x00";
    let turned = [&jpeg[..2], exif, &jpeg[2..]].concat();
    let found = of(&turned).unwrap();
    assert_eq!((found.columns(), found.lines()), (8, 16));
}

#[test]
fn what_is_read_wrong_elsewhere_is_refused_by_name() {
    let float = refused(&tiff_of::<colortype::RGB32Float>(1, &[0.1, 0.2, 0.3]));
    assert!(
        float.starts_with("the TIFF is in floating point, expected grey or RGB of 8 or 16 bits"),
        "{float}"
    );
    let lone = refused(&tiff_of::<colortype::Gray32Float>(1, &[0.1]));
    assert!(
        lone.starts_with("the TIFF is") && lone.contains("expected grey or RGB of 8 or 16 bits"),
        "{lone}"
    );
    let inks = refused(&tiff_of::<colortype::CMYK8>(1, &[1, 2, 3, 4]));
    assert_eq!(
        inks,
        "the TIFF is in the inks of print (CMYK), expected grey or RGB; convert it to sRGB by its profile"
    );
    let mut jpeg = jpeg_of(&flat([9, 9, 9]));
    let frame = jpeg.windows(2).position(|pair| pair == [0xFF, 0xC0]).expect("a frame header");
    jpeg[frame + 9] = 4;
    assert!(refused(&jpeg).starts_with("the JPEG is in the inks of print (CMYK)"));
    let animated =
        png_of(1, ColorType::Grayscale, BitDepth::Eight, &[1], |encoder| encoder.set_animated(1, 0).unwrap());
    assert!(refused(&animated).starts_with("an animated PNG, expected one picture"));
}

#[test]
fn a_jpeg_that_was_cut_off_is_no_grey_picture() {
    let noise =
        image::RgbImage::from_fn(64, 64, |x, y| image::Rgb([(x * y) as u8, (x * 7) as u8, (y * 31) as u8]));
    let jpeg = jpeg_of(&DynamicImage::ImageRgb8(noise));
    assert!(of(&jpeg).is_ok());
    // The decoder itself would fill the rest.
    let cut = &jpeg[..jpeg.len() / 2];
    assert!(ImageReader::with_format(Cursor::new(cut), ImageFormat::Jpeg).decode().is_ok());
    assert_eq!(refused(cut), "not a whole JPEG: its last scan has no end; fetch the file again");
}

#[test]
fn other_files_are_told_by_their_first_bytes() {
    assert_eq!(
        refused(b"GIF89a\x01\x00\x01"),
        "not a whole PNG, JPEG or TIFF: it begins with 47 49 46 38 39 61 01 00; save the picture as one of these"
    );
    assert!(refused(b"").contains("nothing: the file is empty"));
    let whole = png(3, ColorType::Rgb, BitDepth::Eight, &[1; 9]);
    assert!(refused(&whole[..whole.len() / 2]).starts_with("not a whole PNG: "));
    let deep = tiff_of::<colortype::Gray16>(2, &[1, 2]);
    assert!(refused(&deep[..deep.len() - 20]).starts_with("not a whole TIFF: "));
}

#[test]
fn limits_hold_before_anything_is_allocated() {
    let limits = Limits { pixels: 15, ..Limits::default() };
    for (format, bytes) in [
        ("PNG", png(16, ColorType::Grayscale, BitDepth::Eight, &[0; 16])),
        ("TIFF", tiff_of::<colortype::Gray8>(16, &[0; 16])),
        ("JPEG", jpeg_of(&flat([1, 2, 3]))),
    ] {
        let said = decode(&bytes, &limits).expect_err("too many pixels").to_string();
        assert!(said.starts_with(&format!("the {format} has 16 columns")), "{said}");
        assert!(said.ends_with("expected at most 15 pixels; --raise pixels=N allows more"), "{said}");
    }
}

/// A header of 65 000 x 1000 pixels over a few hundred bytes.
#[test]
fn claims_that_no_file_of_the_size_can_hold_are_refused() {
    let mut jpeg = jpeg_of(&flat([1, 2, 3]));
    let frame = jpeg.windows(2).position(|pair| pair == [0xFF, 0xC0]).expect("a frame header");
    jpeg[frame + 5..frame + 9].copy_from_slice(&[0x03, 0xE8, 0xFD, 0xE8]);
    let said = refused(&jpeg);
    assert!(said.starts_with("the JPEG claims 65000 columns and 1000 lines, but its "), "{said}");
    // What is flat packs well, and is read.
    let wide = DynamicImage::ImageRgb8(image::RgbImage::from_pixel(2000, 2000, image::Rgb([9, 9, 9])));
    assert!(of(&jpeg_of(&wide)).is_ok());
}

#[test]
fn files_name_themselves() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("moon.jpg");
    std::fs::write(&path, png(1, ColorType::Rgb, BitDepth::Eight, &[255, 0, 0])).unwrap();
    // The contents decide, not the name.
    assert_eq!(read(&path).unwrap().to_grey(photographs::CURVE).codes(), [127]);
    std::fs::write(&path, b"no picture").unwrap();
    assert!(
        read(&path).expect_err("no picture").to_string().contains("moon.jpg: not a whole PNG, JPEG or TIFF")
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    /// Damaged pictures are refused or read, and nothing else happens.
    #[test]
    fn damage_is_survived(which in 0_usize..4, at in any::<usize>(), to in any::<u8>(), cut in any::<usize>()) {
        let mut bytes = match which {
            0 => png(5, ColorType::Rgba, BitDepth::Sixteen, &[3; 40]),
            1 => tiff_of::<colortype::RGB16>(5, &[3; 15]),
            2 => jpeg_of(&flat([1, 2, 3])),
            _ => png(5, ColorType::Grayscale, BitDepth::Eight, &[3; 5]),
        };
        let limits = Limits { pixels: 1 << 16, ..Limits::default() };
        let (at, cut) = (at % bytes.len(), cut % bytes.len());
        bytes[at] = to;
        let _ = decode(&bytes, &limits).map_err(|error| error.to_string());
        let _ = decode(&bytes[..cut], &limits).map_err(|error| error.to_string());
    }
}
