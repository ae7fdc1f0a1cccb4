//! GeoTIFF: decoded by the `tiff` crate, geo tags by [`super::geo_keys`].

use std::fs::File;
use std::io::{BufReader, Seek};
use std::path::Path;

use tiff::decoder::ifd::Value;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;
use tiff::{TiffError, TiffResult};

use super::geo_keys::GeoTags;
use super::samples::Conversion;
use super::tiff_directory::{TooLarge, too_large};
use super::zstd::{self, ZSTD};
use super::{ReadOptions, check_raster, field};
use crate::elevation::Elevation;
use crate::error::SurveyError;

const GDAL_METADATA: Tag = Tag::Unknown(42112);

/// Most decoded bytes a byte of a compressed file; flat ground packs well, but not without limit.
const MOST_EXPANSION: u64 = 4096;

type Tiff = Decoder<BufReader<File>>;

/// Reads one band of the first image.
pub fn read(path: &Path, options: &ReadOptions) -> Result<Elevation, SurveyError> {
    let at = |place: &'static str| {
        move |source| SurveyError::Tiff { path: path.to_path_buf(), place: place.into(), source }
    };
    let failed = |source| SurveyError::Read { path: path.to_path_buf(), source };
    let mut file = BufReader::new(File::open(path).map_err(failed)?);
    let bytes = file.get_ref().metadata().map_err(failed)?.len();
    if let Some(claim) = too_large(&mut file, bytes) {
        return Err(impossible(path, claim, bytes));
    }
    file.rewind().map_err(failed)?;
    let tiff = Decoder::new(file).map_err(at("header"))?;
    let mut tiff = tiff.with_limits(limits(bytes));
    let (columns, lines) = tiff.dimensions().map_err(at("header"))?;
    check_raster(path, lines.into(), columns.into())?;
    refuse_inverted(path, &mut tiff)?;
    let layout = Layout::of(&mut tiff, limits(bytes)).map_err(at("header"))?;
    layout.check_size(path, bytes)?;
    let metadata = text(&mut tiff, GDAL_METADATA).map_err(at("tag 42112"))?.unwrap_or_default();
    let band = chosen_band(path, options, layout.bands, &metadata)?;

    let mut notes = Vec::new();
    let tags = geo_tags(&mut tiff).map_err(at("geo tags"))?;
    let (affine, frame) = match (tags.place(path, &mut notes)?, options.own_place(lines as usize)) {
        (Some(place), _) => {
            options.expect_no_place()?;
            place
        }
        (None, Some(affine)) => (affine, crate::Frame::Plane(None)),
        (None, None) => {
            let advice = "give --spacing-m METRES, or add a place with gdal_translate -a_ullr";
            return Err(field(path, "geo tags", "none", "ModelPixelScaleTag and ModelTiepointTag", advice));
        }
    };
    let conversion = conversion(path, options, &mut tiff, &metadata, band)?;
    let heights = read_band(path, &mut tiff, &layout, band, &conversion)?;
    let mut elevation = Elevation::new(lines as usize, columns as usize, heights, affine, frame);
    elevation.title = item(&metadata, "DESCRIPTION", band).unwrap_or_default().to_string();
    elevation.sources = vec![path.to_path_buf()];
    elevation.notes = notes;
    Ok(elevation)
}

fn impossible(path: &Path, TooLarge { tag, bytes }: TooLarge, size: u64) -> SurveyError {
    let place = tag.map_or_else(|| "directory".to_owned(), |tag| format!("tag {tag}"));
    let expected = format!("at most {size}, the bytes of the file");
    field(path, place, format!("{bytes} bytes"), expected, "the header is damaged: fetch the file again")
}

/// What a strip or a value of a file of so many bytes may take, whatever its header claims.
fn limits(bytes: u64) -> Limits {
    let usual = Limits::default();
    let most = |bytes: u64, usual: usize| usize::try_from(bytes).map_or(usual, |bytes| bytes.min(usual));
    let mut limits = usual.clone();
    limits.decoding_buffer_size = most(bytes.saturating_mul(MOST_EXPANSION), usual.decoding_buffer_size);
    limits.intermediate_buffer_size = most(bytes, usual.intermediate_buffer_size);
    limits.ifd_value_size = most(bytes, usual.ifd_value_size);
    limits
}

/// How the samples are stored.
struct Layout {
    lines: usize,
    columns: usize,
    chunk: [usize; 2],
    bands: usize,
    planar: bool,
    bits: u64,
    compression: u16,
    limits: Limits,
}

impl Layout {
    fn of(tiff: &mut Tiff, limits: Limits) -> TiffResult<Self> {
        let (columns, lines) = tiff.dimensions()?;
        let (width, height) = tiff.chunk_dimensions();
        let mut number = |tag| Ok::<_, TiffError>(tiff.find_tag_unsigned::<u16>(tag)?.unwrap_or(1));
        let (bands, planar) = (number(Tag::SamplesPerPixel)?, number(Tag::PlanarConfiguration)?);
        let compression = number(Tag::Compression)?;
        let bits =
            tiff.find_tag_unsigned_vec::<u16>(Tag::BitsPerSample)?.and_then(|bits| bits.first().copied());
        Ok(Self {
            lines: lines as usize,
            columns: columns as usize,
            chunk: [height.max(1) as usize, width.max(1) as usize],
            bands: usize::from(bands.max(1)),
            planar: planar == 2,
            bits: bits.unwrap_or(1).into(),
            compression,
            limits,
        })
    }

    /// Before anything is allocated: can a file of this size hold the raster?
    fn check_size(&self, path: &Path, found: u64) -> Result<(), SurveyError> {
        let samples =
            [self.lines, self.columns, self.bands].iter().fold(1u64, |n, &k| n.saturating_mul(k as u64));
        let needed = samples.saturating_mul(self.bits) / 8;
        let expected = if self.compression == 1 { needed } else { needed / MOST_EXPANSION };
        if found < expected {
            let place = format!("{} x {} samples of {} bands", self.lines, self.columns, self.bands);
            return Err(SurveyError::Truncated { path: path.to_path_buf(), place, found, expected });
        }
        Ok(())
    }

    /// The values of a strip or tile.
    fn read_chunk(&self, tiff: &mut Tiff, index: u32) -> TiffResult<DecodingResult> {
        match self.compression {
            ZSTD => zstd::read_chunk(tiff, index, self.limits.clone()),
            _ => tiff.read_chunk(index),
        }
    }

    fn across(&self) -> usize {
        self.columns.div_ceil(self.chunk[1])
    }

    fn chunks(&self) -> usize {
        self.across() * self.lines.div_ceil(self.chunk[0])
    }
}

fn read_band(
    path: &Path,
    tiff: &mut Tiff,
    layout: &Layout,
    band: usize,
    conversion: &Conversion,
) -> Result<Vec<f64>, SurveyError> {
    let mut heights = vec![f64::NAN; layout.lines * layout.columns];
    for chunk in 0..layout.chunks() {
        let stored = if layout.planar { chunk + band * layout.chunks() } else { chunk };
        let failed = |source| SurveyError::Tiff {
            path: path.to_path_buf(),
            place: format!("strip or tile {stored}"),
            source,
        };
        let index = u32::try_from(stored).map_err(|_| failed(TiffError::IntSizeError))?;
        let values = layout.read_chunk(tiff, index).map_err(failed)?;
        let (line, column) =
            (chunk / layout.across() * layout.chunk[0], chunk % layout.across() * layout.chunk[1]);
        let width = layout.chunk[1].min(layout.columns - column);
        let (pixel, first) = if layout.planar { (1, 0) } else { (layout.bands, band) };
        let numbers = to_f64(path, values, first, pixel)?;
        for (row, numbers) in numbers.chunks(width).enumerate().take(layout.lines - line) {
            for (k, &stored) in numbers.iter().enumerate() {
                let (line, column) = (line + row, column + k);
                heights[line * layout.columns + column] = conversion.height(stored).ok_or_else(|| {
                    SurveyError::NotFinite { path: path.to_path_buf(), line, column, value: stored }
                })?;
            }
        }
    }
    Ok(heights)
}

/// Every `pixel`-th value from `first` on.
fn to_f64(path: &Path, values: DecodingResult, first: usize, pixel: usize) -> Result<Vec<f64>, SurveyError> {
    macro_rules! pick {
        ($values:expr, $as:expr) => {
            $values.iter().skip(first).step_by(pixel).map($as).collect()
        };
    }
    Ok(match values {
        DecodingResult::I8(v) => pick!(v, |&x| f64::from(x)),
        DecodingResult::U8(v) => pick!(v, |&x| f64::from(x)),
        DecodingResult::I16(v) => pick!(v, |&x| f64::from(x)),
        DecodingResult::U16(v) => pick!(v, |&x| f64::from(x)),
        DecodingResult::I32(v) => pick!(v, |&x| f64::from(x)),
        DecodingResult::U32(v) => pick!(v, |&x| f64::from(x)),
        DecodingResult::F32(v) => pick!(v, |&x| f64::from(x)),
        DecodingResult::F64(v) => pick!(v, |&x| x),
        _ => {
            let advice = "convert it with gdal_translate -ot Float32";
            return Err(field(
                path,
                "sample type",
                "64-bit integers or 16-bit floats",
                "8 to 32-bit integers, 32 or 64-bit floats",
                advice,
            ));
        }
    })
}

/// White-is-zero turns heights upside down in some decoders and not in others.
fn refuse_inverted(path: &Path, tiff: &mut Tiff) -> Result<(), SurveyError> {
    match tiff.find_tag_unsigned::<u16>(Tag::PhotometricInterpretation) {
        Ok(Some(0)) => {
            let advice = "write it again with gdal_translate -co PHOTOMETRIC=MINISBLACK";
            Err(field(path, "PhotometricInterpretation", "white is zero", "black is zero", advice))
        }
        _ => Ok(()),
    }
}

fn chosen_band(
    path: &Path,
    options: &ReadOptions,
    count: usize,
    metadata: &str,
) -> Result<usize, SurveyError> {
    let list = || {
        let name = |band| item(metadata, "DESCRIPTION", band).unwrap_or("no description");
        (0..count).map(|band| format!("{} ({})", band + 1, name(band))).collect::<Vec<_>>().join(", ")
    };
    match options.band {
        Some(chosen) if (1..=count).contains(&chosen) => Ok(chosen - 1),
        Some(chosen) => {
            Err(SurveyError::NoSuchBand { path: path.to_path_buf(), chosen, count, list: list() })
        }
        None if count == 1 => Ok(0),
        None => Err(SurveyError::BandNotChosen { path: path.to_path_buf(), count, list: list() }),
    }
}

fn conversion(
    path: &Path,
    options: &ReadOptions,
    tiff: &mut Tiff,
    metadata: &str,
    band: usize,
) -> Result<Conversion, SurveyError> {
    let failed = |source| SurveyError::Tiff { path: path.to_path_buf(), place: "GDAL_NODATA".into(), source };
    let number = |place: &str, found: &str| {
        found
            .trim()
            .parse::<f64>()
            .map_err(|_| field(path, place, format!("{found:?}"), "a number", "give it as an option"))
    };
    let void = match text(tiff, Tag::GdalNodata).map_err(failed)? {
        Some(void) if options.no_data.is_none() && !void.trim().is_empty() => {
            vec![number("GDAL_NODATA", &void)?]
        }
        _ => Vec::new(),
    };
    let of_item = |name: &str| item(metadata, name, band).map(|text| number(name, text)).transpose();
    let conversion = Conversion::new(path, options, void, of_item("SCALE")?, of_item("OFFSET")?)?;
    let bits = tiff.find_tag_unsigned_vec::<u16>(Tag::BitsPerSample).map_err(failed)?;
    let format = tiff.find_tag_unsigned_vec::<u16>(Tag::SampleFormat).map_err(failed)?;
    let is = |found: Option<Vec<u16>>, wanted| found.is_some_and(|found| found.first() == Some(&wanted));
    Ok(if is(bits, 32) && is(format, 3) { conversion.rounded_to_f32() } else { conversion })
}

fn geo_tags(tiff: &mut Tiff) -> TiffResult<GeoTags> {
    let mut numbers = |tag| tiff.find_tag(tag)?.map(Value::into_f64_vec).transpose();
    let (pixel_scale, tie_point) = (numbers(Tag::ModelPixelScaleTag)?, numbers(Tag::ModelTiepointTag)?);
    let transformation = numbers(Tag::ModelTransformationTag)?;
    let numbers = numbers(Tag::GeoDoubleParamsTag)?.unwrap_or_default();
    let directory = tiff.find_tag_unsigned_vec::<u16>(Tag::GeoKeyDirectoryTag)?.unwrap_or_default();
    Ok(GeoTags { pixel_scale, tie_point, transformation, directory, numbers })
}

fn text(tiff: &mut Tiff, tag: Tag) -> TiffResult<Option<String>> {
    let value = tiff.find_tag(tag)?.map(Value::into_string).transpose()?;
    Ok(value.map(|text| text.trim_end_matches('\0').to_string()))
}

/// Text of an item of GDAL's metadata for one band (from 0).
fn item<'a>(metadata: &'a str, name: &str, band: usize) -> Option<&'a str> {
    let band = band.to_string();
    metadata.split("<Item").skip(1).find_map(|item| {
        let (attributes, rest) = item.split_once('>')?;
        let value = |key: &str| {
            let (_, after) = attributes.split_once(&format!("{key}=\""))?;
            after.split_once('"').map(|(value, _)| value)
        };
        let this = value("name").is_some_and(|found| found.eq_ignore_ascii_case(name));
        (this && value("sample") == Some(&band)).then(|| rest.split("</Item>").next().unwrap_or_default())
    })
}
