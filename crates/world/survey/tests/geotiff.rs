//! GeoTIFF files built here, whole and damaged.

use std::fs::{self, File};
use std::path::PathBuf;

use quantities::{degrees, radians};
use survey::{Affine, Elevation, Frame, Method, ReadOptions, SurveyError, read};
use tempfile::TempDir;
use tiff::encoder::colortype::{
    ColorType, Gray8, Gray16, Gray32Float, Gray64Float, GrayI8, GrayI16, GrayI32, RGB32Float,
};
use tiff::encoder::compression::DeflateLevel;
use tiff::encoder::{Compression, Predictor, TiffEncoder, TiffValue};
use tiff::tags::Tag;

const PROJECTED: [u16; 16] = [1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3076, 0, 1, 9001];

/// What goes into a file beside its samples.
struct Tags {
    scale: Option<Vec<f64>>,
    tie: Option<Vec<f64>>,
    matrix: Option<Vec<f64>>,
    keys: Vec<u16>,
    numbers: Vec<f64>,
    no_data: Option<&'static str>,
    metadata: Option<String>,
    compression: Compression,
    predictor: Predictor,
}

impl Default for Tags {
    fn default() -> Self {
        Self {
            scale: Some(vec![2.0, 3.0, 0.0]),
            tie: Some(vec![0.0, 0.0, 0.0, 100.0, 500.0, 0.0]),
            matrix: None,
            keys: PROJECTED.to_vec(),
            numbers: vec![],
            no_data: None,
            metadata: None,
            compression: Compression::Uncompressed,
            predictor: Predictor::None,
        }
    }
}

fn write<C: ColorType>(width: u32, height: u32, data: &[C::Inner], tags: &Tags) -> (TempDir, PathBuf)
where
    [C::Inner]: TiffValue,
{
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ground.tif");
    let mut tiff = TiffEncoder::new(File::create(&path).unwrap())
        .unwrap()
        .with_compression(tags.compression)
        .with_predictor(tags.predictor);
    let mut image = tiff.new_image::<C>(width, height).unwrap();
    let directory = image.encoder();
    let mut put = |tag, numbers: &Option<Vec<f64>>| {
        numbers.iter().for_each(|numbers| directory.write_tag(tag, numbers.as_slice()).unwrap());
    };
    put(Tag::ModelPixelScaleTag, &tags.scale);
    put(Tag::ModelTiepointTag, &tags.tie);
    put(Tag::ModelTransformationTag, &tags.matrix);
    put(Tag::GeoDoubleParamsTag, &Some(tags.numbers.clone()).filter(|numbers| !numbers.is_empty()));
    directory.write_tag(Tag::GeoKeyDirectoryTag, tags.keys.as_slice()).unwrap();
    if let Some(text) = tags.no_data {
        directory.write_tag(Tag::GdalNodata, text).unwrap();
    }
    if let Some(text) = &tags.metadata {
        directory.write_tag(Tag::Unknown(42112), text.as_str()).unwrap();
    }
    image.write_data(data).unwrap();
    drop(tiff);
    (folder, path)
}

fn heights(elevation: &Elevation) -> Vec<Option<f64>> {
    let places =
        (0..elevation.lines).flat_map(|line| (0..elevation.columns).map(move |column| (line, column)));
    places.map(|(line, column)| elevation.height(line, column)).collect()
}

fn read_back<C: ColorType>(data: &[C::Inner], tags: &Tags) -> Vec<Option<f64>>
where
    [C::Inner]: TiffValue,
{
    let (_folder, path) = write::<C>(3, 2, data, tags);
    heights(&read(path, &ReadOptions::default()).unwrap())
}

#[test]
fn all_sample_types() {
    let expected: Vec<Option<f64>> = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(Some).to_vec();
    let tags = Tags::default();
    assert_eq!(read_back::<Gray8>(&[1, 2, 3, 4, 5, 6], &tags), expected);
    assert_eq!(read_back::<Gray16>(&[1, 2, 3, 4, 5, 6], &tags), expected);
    assert_eq!(read_back::<Gray32Float>(&[1., 2., 3., 4., 5., 6.], &tags), expected);
    assert_eq!(read_back::<Gray64Float>(&[1., 2., 3., 4., 5., 6.], &tags), expected);
    let signed: Vec<Option<f64>> = [-1.0, 2.0, -3.0, 4.0, -5.0, 6.0].map(Some).to_vec();
    assert_eq!(read_back::<GrayI8>(&[-1, 2, -3, 4, -5, 6], &tags), signed);
    assert_eq!(read_back::<GrayI16>(&[-1, 2, -3, 4, -5, 6], &tags), signed);
    assert_eq!(read_back::<GrayI32>(&[-1, 2, -3, 4, -5, 6], &tags), signed);
}

#[test]
fn compressions_and_predictors() {
    let data: Vec<i16> = (0..60 * 50).map(|index| (index % 60) * 3 - (index / 60) * 7).collect();
    let expected: Vec<Option<f64>> = data.iter().map(|&height| Some(f64::from(height))).collect();
    for (compression, predictor) in [
        (Compression::Lzw, Predictor::None),
        (Compression::Lzw, Predictor::Horizontal),
        (Compression::Deflate(DeflateLevel::default()), Predictor::Horizontal),
        (Compression::Packbits, Predictor::None),
    ] {
        let tags = Tags { compression, predictor, ..Tags::default() };
        let (_folder, path) = write::<GrayI16>(60, 50, &data, &tags);
        assert_eq!(heights(&read(path, &ReadOptions::default()).unwrap()), expected);
    }
}

#[test]
fn no_data_scale_offset_and_their_options() {
    let metadata = "<GDALMetadata>\n <Item name=\"OFFSET\" sample=\"0\" role=\"offset\">1737400</Item>\
                    <Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.5</Item></GDALMetadata>";
    let tags = Tags { no_data: Some("-32768"), metadata: Some(metadata.into()), ..Tags::default() };
    let (_folder, path) = write::<GrayI16>(2, 2, &[-32768, 2, 3, -5], &tags);
    let with = |options: &ReadOptions| heights(&read(&path, options).unwrap());
    assert_eq!(with(&ReadOptions::default()), [None, Some(1.0), Some(1.5), Some(-2.5)]);
    let own =
        ReadOptions { scale: Some(2.0), offset: Some(1.0), no_data: vec![3.0], ..ReadOptions::default() };
    assert_eq!(with(&own), [Some(-65535.0), Some(5.0), None, Some(-9.0)]);

    let tags = Tags { no_data: Some("-3.4028226550889045e+38"), ..Tags::default() };
    let data = [-3.402_822_6e38, 1.0, f32::NAN, f32::NEG_INFINITY];
    let (_folder, path) = write::<Gray32Float>(2, 2, &data, &tags);
    assert_eq!(heights(&read(path, &ReadOptions::default()).unwrap()), [None, Some(1.0), None, None]);
    let tags = Tags { no_data: Some("-inf"), ..Tags::default() };
    assert_eq!(read_back::<Gray32Float>(&[1., 2., 3., f32::NEG_INFINITY, 5., 6.], &tags)[3], None);
}

#[test]
fn pixels_are_areas_or_points() {
    let (_folder, path) = write::<Gray8>(4, 3, &[1; 12], &Tags::default());
    let area = read(path, &ReadOptions::default()).unwrap();
    assert_eq!(area.affine, Affine { first: [498.5, 101.0], step: [-3.0, 2.0] });
    let mut keys = PROJECTED.to_vec();
    keys[11] = 2;
    let (_folder, path) = write::<Gray8>(4, 3, &[1; 12], &Tags { keys, ..Tags::default() });
    let point = read(path, &ReadOptions::default()).unwrap();
    assert_eq!(point.affine, Affine { first: [500.0, 100.0], step: [-3.0, 2.0] });
    let matrix = [2.0, 0.0, 0.0, 100.0, 0.0, -3.0, 0.0, 500.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let tags = Tags { scale: None, tie: None, matrix: Some(matrix.to_vec()), ..Tags::default() };
    let (_folder, path) = write::<Gray8>(4, 3, &[1; 12], &tags);
    assert_eq!(read(path, &ReadOptions::default()).unwrap().affine, area.affine);
}

#[test]
fn degrees_and_projections() {
    let keys = vec![1, 1, 0, 3, 1024, 0, 1, 2, 1025, 0, 1, 1, 2054, 0, 1, 9102];
    let tie = Some(vec![0.0, 0.0, 0.0, 100.0, 50.0, 0.0]);
    let (_folder, path) = write::<Gray8>(4, 3, &[1; 12], &Tags { keys, tie, ..Tags::default() });
    let geographic = read(path, &ReadOptions::default()).unwrap();
    assert!(matches!(geographic.frame, Frame::Geographic { radius: 1_737_400.0 }));
    assert!((degrees(geographic.affine.first[0]) - 48.5).abs() < 1e-9);

    let mut keys = PROJECTED.to_vec();
    keys[3] = 6;
    keys.extend([3075, 0, 1, 17, 3078, 34736, 1, 0, 3088, 34736, 1, 1]);
    let tags = Tags { keys, numbers: vec![20.0, -30.0], ..Tags::default() };
    let (_folder, path) = write::<Gray8>(4, 3, &[1; 12], &tags);
    let Frame::Plane(Some(projection)) = read(path, &ReadOptions::default()).unwrap().frame else { panic!() };
    assert_eq!(projection.method, Method::Equirectangular { parallel: radians(20.0) });
    assert_eq!(projection.longitude, radians(-30.0));
}

#[test]
fn bands_are_listed_and_chosen() {
    let metadata = "<GDALMetadata><Item name=\"DESCRIPTION\" sample=\"1\" role=\"description\">height</Item></GDALMetadata>";
    let tags = Tags { metadata: Some(metadata.into()), ..Tags::default() };
    let data: Vec<f32> = (0..12).map(|index| index as f32).collect();
    let (_folder, path) = write::<RGB32Float>(2, 2, &data, &tags);
    let message = read(&path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(message.contains("tag 262 (PhotometricInterpretation): found 2"), "{message}");
    // The writer knows three bands as colours only: the meaning (tag 262, one short) becomes grey.
    let mut bytes = fs::read(&path).unwrap();
    let entry = [6, 1, 3, 0, 1, 0, 0, 0, 2, 0];
    let at = bytes.windows(entry.len()).position(|window| window == entry).unwrap();
    bytes[at + 8] = 1;
    fs::write(&path, bytes).unwrap();
    let message = read(&path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(message.contains("3 bands") && message.contains("2 (height)"), "{message}");
    let with = |band| read(&path, &ReadOptions { band: Some(band), ..ReadOptions::default() });
    let second = with(2).unwrap();
    assert_eq!(heights(&second), [1.0, 4.0, 7.0, 10.0].map(Some));
    assert_eq!(second.title, "ground: height");
    assert!(matches!(with(4), Err(SurveyError::NoSuchBand { chosen: 4, count: 3, .. })));
    assert!(matches!(with(0), Err(SurveyError::NoSuchBand { .. })));
}

/// A TIFF of 2-byte signed samples made by hand: tags and what its strips or tiles hold.
fn by_hand(
    mut tags: Vec<(u16, Vec<u32>)>,
    chunks: &[Vec<i16>],
    offsets: u16,
    counts: u16,
) -> (TempDir, PathBuf) {
    let mut bytes = b"II*\0\0\0\0\0".to_vec();
    let mut put = |words: Vec<u8>| {
        bytes.extend(words);
        bytes.len() as u32
    };
    let lengths: Vec<u32> = chunks.iter().map(|chunk| 2 * chunk.len() as u32).collect();
    let ends: Vec<u32> =
        chunks.iter().map(|chunk| put(chunk.iter().flat_map(|v| v.to_le_bytes()).collect())).collect();
    tags.push((offsets, ends.iter().zip(&lengths).map(|(end, length)| end - length).collect()));
    tags.push((counts, lengths));
    tags.sort();
    let mut entries = Vec::new();
    for (tag, values) in &tags {
        let stored: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        let field = if values.len() == 1 { values[0] } else { put(stored.clone()) - stored.len() as u32 };
        entries.extend([tag.to_le_bytes(), 4u16.to_le_bytes()].concat());
        entries.extend([(values.len() as u32).to_le_bytes(), field.to_le_bytes()].concat());
    }
    let directory = bytes.len() as u32;
    bytes[4..8].copy_from_slice(&directory.to_le_bytes());
    bytes.extend((tags.len() as u16).to_le_bytes());
    bytes.extend(entries);
    bytes.extend([0; 4]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ground.tif");
    fs::write(&path, bytes).unwrap();
    (folder, path)
}

fn spaced(band: Option<usize>) -> ReadOptions {
    ReadOptions { spacing: Some([1.0; 2]), band, ..ReadOptions::default() }
}

#[test]
fn tiles_and_planes() {
    let height = |line: usize, column: usize| (100 * line + column) as i16;
    let raster = |bands: u32| {
        let bits = vec![16; bands as usize];
        vec![
            (256, vec![20]),
            (257, vec![18]),
            (258, bits),
            (259, vec![1]),
            (262, vec![1]),
            (277, vec![bands]),
            (339, vec![2; bands as usize]),
        ]
    };
    let check = |path: PathBuf, band: Option<usize>, add: f64| {
        let elevation = read(path, &spaced(band)).unwrap();
        for (line, column) in (0..360).map(|index| (index / 20, index % 20)) {
            assert_eq!(elevation.height(line, column), Some(f64::from(height(line, column)) + add));
        }
    };
    // Four tiles of 16 x 16, filled up with -1.
    let tile = |tile: usize| {
        let at = |index: usize| (tile / 2 * 16 + index / 16, tile % 2 * 16 + index % 16);
        (0..256).map(at).map(|(l, c)| if l < 18 && c < 20 { height(l, c) } else { -1 }).collect()
    };
    let mut tags = raster(1);
    tags.extend([(322, vec![16]), (323, vec![16])]);
    let (_folder, path) = by_hand(tags, &[tile(0), tile(1), tile(2), tile(3)], 324, 325);
    check(path, None, 0.0);
    // Two planes in strips of 7 lines.
    let strip = |strip: usize| -> Vec<i16> {
        let (band, first) = (strip / 3, strip % 3 * 7);
        let lines = first..(first + 7).min(18);
        lines.flat_map(|line| (0..20).map(move |column| height(line, column) + 5 * band as i16)).collect()
    };
    let mut tags = raster(2);
    tags.extend([(278, vec![7]), (284, vec![2])]);
    let (_folder, path) = by_hand(tags, &[0, 1, 2, 3, 4, 5].map(strip), 273, 279);
    check(path.clone(), Some(1), 0.0);
    check(path, Some(2), 5.0);
}

fn refused(width: u32, height: u32, data: &[f32], tags: &Tags) -> String {
    let (_folder, path) = write::<Gray32Float>(width, height, data, tags);
    let error = read(&path, &ReadOptions::default()).unwrap_err();
    assert!(error.to_string().contains("ground.tif"), "{error}");
    error.to_string()
}

#[test]
fn unusable_files_say_why() {
    let plain = Tags::default;
    assert!(refused(1, 3, &[1.0; 3], &plain()).contains("3 lines of 1 samples"));
    assert!(refused(2, 2, &[f32::NAN; 4], &plain()).contains("all 4 samples are void"));
    assert!(refused(2, 2, &[1.0, 2.0, f32::INFINITY, 4.0], &plain()).contains("line 1, column 0"));
    assert!(
        refused(2, 2, &[1.0; 4], &Tags { scale: None, tie: None, ..plain() }).contains("--spacing-m METRES")
    );
    assert!(refused(2, 2, &[1.0; 4], &Tags { scale: None, ..plain() }).contains("ModelPixelScaleTag"));
    assert!(refused(2, 2, &[1.0; 4], &Tags { no_data: Some("none"), ..plain() }).contains("GDAL_NODATA"));
    let rods = PROJECTED.iter().map(|&key| if key == 9001 { 9999 } else { key }).collect();
    assert!(refused(2, 2, &[1.0; 4], &Tags { keys: rods, ..plain() }).contains("geo key 3076"));
    let mut dangling = PROJECTED.to_vec();
    dangling[3] = 4;
    dangling.extend([3078, 34736, 1, 9]);
    assert!(refused(2, 2, &[1.0; 4], &Tags { keys: dangling, ..plain() }).contains("geo key 3078"));
    let turned = vec![2.0, 1.0, 0.0, 100.0, -1.0, -3.0, 0.0, 500.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    assert!(refused(2, 2, &[1.0; 4], &Tags { matrix: Some(turned), ..plain() }).contains("gdalwarp"));
    let with_row = |row: usize, numbers: [f64; 4]| {
        let mut matrix =
            vec![2.0, 0.0, 0.0, 100.0, 0.0, -3.0, 0.0, 500.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        matrix[4 * row..4 * row + 4].copy_from_slice(&numbers);
        Tags { matrix: Some(matrix), scale: None, tie: None, ..plain() }
    };
    let said = |row, numbers| refused(2, 2, &[1.0; 4], &with_row(row, numbers));
    assert!(said(2, [0.0, 0.0, 0.0, 700.0]).contains("--offset METRES"));
    assert!(said(2, [0.0, 0.0, 2.0, 0.0]).contains("--scale METRES"));
    assert!(said(2, [1.0, 0.0, 0.0, 0.0]).contains("heights that go by the place"));
    assert!(said(3, [0.0, 0.0, 0.0, 2.0]).contains("a last row"));
    let mut twice = PROJECTED.to_vec();
    twice[3] += 3;
    twice.extend([3075, 0, 1, 17, 3080, 34736, 1, 0, 3088, 34736, 1, 1]);
    let twice = Tags { keys: twice, numbers: vec![40.0, 30.0], ..plain() };
    assert!(refused(2, 2, &[1.0; 4], &twice).contains("both have one meaning"));
    let upside_down = Tags { scale: Some(vec![2.0, -3.0, 0.0]), ..plain() };
    assert!(refused(2, 2, &[1.0; 4], &upside_down).contains("two lengths above 0"));
    let flat = Tags { scale: Some(vec![2.0, 0.0, 0.0]), ..plain() };
    assert!(refused(2, 2, &[1.0; 4], &flat).contains("place of the samples"));
    let unknown = Tags { scale: Some(vec![f64::NAN, 1.0, 0.0]), ..plain() };
    assert!(refused(2, 2, &[1.0; 4], &unknown).contains("place of the samples"));
}

#[test]
fn every_truncation_is_an_error_and_no_byte_flip_panics() {
    let data: Vec<f32> = (0..36).map(|index| index as f32).collect();
    for compression in [Compression::Uncompressed, Compression::Lzw] {
        let tags = Tags { compression, no_data: Some("-1"), ..Tags::default() };
        let (_folder, path) = write::<Gray32Float>(6, 6, &data, &tags);
        let whole = fs::read(&path).unwrap();
        for length in (0..whole.len()).step_by(3) {
            fs::write(&path, &whole[..length]).unwrap();
            assert!(read(&path, &ReadOptions::default()).is_err(), "{length} of {}", whole.len());
        }
        for at in 0..whole.len() {
            for flip in [0x01, 0xff] {
                let mut damaged = whole.clone();
                damaged[at] ^= flip;
                fs::write(&path, &damaged).unwrap();
                let _ = read(&path, &ReadOptions::default());
            }
        }
    }
}

#[test]
fn a_header_that_asks_for_too_much_is_refused_before_memory_is_taken() {
    let (_folder, path) = write::<Gray32Float>(20, 20, &[1.0; 400], &Tags::default());
    let mut bytes = fs::read(&path).unwrap();
    // ImageLength (257) and ImageWidth (256), each one LONG or SHORT: the value stands 8 bytes into the entry.
    for tag in [256u16, 257] {
        let entry = [tag.to_le_bytes(), 4u16.to_le_bytes()].concat();
        let at = bytes.windows(4).position(|window| window == entry).unwrap();
        bytes[at + 8..at + 12].copy_from_slice(&2_000_000_000u32.to_le_bytes());
    }
    fs::write(&path, bytes).unwrap();
    let error = read(&path, &ReadOptions::default()).unwrap_err();
    assert!(matches!(error, SurveyError::Truncated { .. } | SurveyError::Tiff { .. }), "{error}");
}
