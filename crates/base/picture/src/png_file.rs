//! PNG as the program writes it: grey or RGB of 8 or 16 bits.

use std::io::Cursor;
use std::path::Path;

use files::{Most, read_all, write_atomic};
use limits::Limit;
use png::{BitDepth, ColorType, Decoder, Encoder, Writer};

use crate::any::AnyPicture;
use crate::error::{PictureError, PictureFileError};
use crate::pixels::{Depth, GreyPicture, Picture};

/// What a reader allows before anything is allocated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Largest file in bytes; [`Limit::PictureBytes`] by default.
    pub file_bytes: u64,
    /// Most pixels; [`Limit::Pixels`] by default, twice the largest raster.
    pub pixels: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { file_bytes: Limit::PictureBytes.value(), pixels: Limit::Pixels.value() }
    }
}

/// The deflate format packs at most 1032 bytes into one.
const MOST_PACKED: usize = 1032;

/// How every PNG of the program is packed. Measured on a shaded frame of 1000 x 575, 8 bits (16 bits): this
/// 0.8 ms and 299 kB (2.1 ms, 725 kB); zlib's level 1 2.7 ms and 278 kB (5.0 ms, 621 kB); level 6 15 ms and
/// 273 kB (28 ms, 614 kB). A frame is computed in milliseconds, so a tenth of its size is not worth more.
pub(crate) fn set_packing<W: std::io::Write>(encoder: &mut Encoder<'_, W>) {
    encoder.set_deflate_compression(png::DeflateCompression::FdeflateUltraFast);
    encoder.set_filter(png::Filter::Adaptive);
}

/// The bytes of a PNG with these text chunks (keyword and text in Latin-1).
///
/// # Errors
/// [`PictureError::Encode`] for a text that PNG cannot hold.
pub fn encode_png<const CHANNELS: usize>(
    picture: &Picture<CHANNELS>,
    texts: &[(&str, &str)],
) -> Result<Vec<u8>, PictureError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, picture.columns() as u32, picture.lines() as u32);
    encoder.set_color(if CHANNELS == 1 { ColorType::Grayscale } else { ColorType::Rgb });
    encoder.set_depth(match picture.depth() {
        Depth::Eight => BitDepth::Eight,
        Depth::Sixteen => BitDepth::Sixteen,
    });
    set_packing(&mut encoder);
    for (keyword, text) in texts {
        encoder.add_text_chunk((*keyword).to_owned(), (*text).to_owned())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.bytes(u16::to_be_bytes))?;
    Writer::finish(writer)?;
    Ok(bytes)
}

/// Writes a PNG, whole or not at all.
///
/// # Errors
/// [`PictureFileError`].
pub fn write_png<const CHANNELS: usize>(
    path: impl AsRef<Path>,
    picture: &Picture<CHANNELS>,
    texts: &[(&str, &str)],
) -> Result<(), PictureFileError> {
    let path = path.as_ref();
    let bytes = encode_png(picture, texts).map_err(|source| at(path, source))?;
    Ok(write_atomic(path, |out| out.write_all(&bytes))?)
}

/// Reads the bytes of a grey PNG; of an animated one the first picture.
///
/// # Errors
/// [`PictureError::NotGrey`], [`PictureError::TooManyPixels`], [`PictureError::Decode`].
pub fn decode_png(bytes: &[u8], limits: &Limits) -> Result<GreyPicture, PictureError> {
    let (reader, layout) = open(bytes)?;
    match layout {
        Some((1, depth)) => decode(reader, depth, bytes.len(), limits),
        _ => Err(PictureError::NotGrey { found: layout_of(reader.info()) }),
    }
}

/// Reads the bytes of a grey or RGB PNG as the program writes it; of an animated one the first picture.
///
/// # Errors
/// [`PictureError::NotAFrame`], [`PictureError::TooManyPixels`], [`PictureError::Decode`].
pub fn decode_any_png(bytes: &[u8], limits: &Limits) -> Result<AnyPicture, PictureError> {
    let (reader, layout) = open(bytes)?;
    match layout {
        Some((1, depth)) => Ok(decode::<1>(reader, depth, bytes.len(), limits)?.into()),
        Some((_, depth)) => Ok(decode::<3>(reader, depth, bytes.len(), limits)?.into()),
        None => Err(PictureError::NotAFrame { found: layout_of(reader.info()) }),
    }
}

/// A PNG whose header is read.
type PngReader<'b> = png::Reader<Cursor<&'b [u8]>>;

/// Reads the header; channels and depth, if a frame can have them.
fn open(bytes: &[u8]) -> Result<(PngReader<'_>, Option<(usize, Depth)>), PictureError> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::IDENTITY);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let reader = decoder.read_info()?;
    let channels = match reader.info().color_type {
        ColorType::Grayscale => Some(1),
        ColorType::Rgb => Some(3),
        _ => None,
    };
    let depth = match reader.info().bit_depth {
        BitDepth::Eight => Some(Depth::Eight),
        BitDepth::Sixteen => Some(Depth::Sixteen),
        _ => None,
    };
    Ok((reader, channels.zip(depth)))
}

fn layout_of(info: &png::Info) -> String {
    format!("{:?} of {} bits", info.color_type, info.bit_depth as u8)
}

fn decode<const CHANNELS: usize>(
    mut reader: PngReader,
    depth: Depth,
    bytes: usize,
    limits: &Limits,
) -> Result<Picture<CHANNELS>, PictureError> {
    let (columns, lines) = (reader.info().width, reader.info().height);
    if u64::from(columns) * u64::from(lines) > limits.pixels {
        return Err(PictureError::TooManyPixels { columns, lines, limit: limits.pixels });
    }
    let sample_bytes = columns as usize * lines as usize * CHANNELS * (depth.bits() / 8) as usize;
    if sample_bytes / MOST_PACKED > bytes {
        return Err(PictureError::Hollow { columns, lines, bytes });
    }
    let mut samples = vec![0; sample_bytes];
    reader.next_frame(&mut samples)?;
    let codes = match depth {
        Depth::Eight => samples.iter().map(|sample| u16::from(*sample)).collect(),
        Depth::Sixteen => samples.as_chunks().0.iter().map(|pair| u16::from_be_bytes(*pair)).collect(),
    };
    Picture::new(columns as usize, lines as usize, depth, codes)
}

/// The text chunk by which a picture tells that this program made it: keyword, and the text or its beginning.
pub const SOFTWARE: (&str, &str) = ("Software", "lunoid");

/// Text chunks in front of a PNG's pixels, keyword and text; none of a file that is no PNG.
pub fn png_texts(bytes: &[u8]) -> Vec<(String, String)> {
    let Ok(reader) = Decoder::new(Cursor::new(bytes)).read_info() else { return Vec::new() };
    let texts = reader.info().uncompressed_latin1_text.iter();
    texts.map(|chunk| (chunk.keyword.clone(), chunk.text.clone())).collect()
}

/// Reads a grey PNG file.
///
/// # Errors
/// [`PictureFileError`], which names the file.
pub fn read_png(path: impl AsRef<Path>, limits: &Limits) -> Result<GreyPicture, PictureFileError> {
    let path = path.as_ref();
    decode_png(&read_bytes(path, limits)?, limits).map_err(|source| at(path, source))
}

/// Reads a grey or RGB PNG file as the program writes it.
///
/// # Errors
/// [`PictureFileError`], which names the file.
pub fn read_any_png(path: impl AsRef<Path>, limits: &Limits) -> Result<AnyPicture, PictureFileError> {
    let path = path.as_ref();
    decode_any_png(&read_bytes(path, limits)?, limits).map_err(|source| at(path, source))
}

fn read_bytes(path: &Path, limits: &Limits) -> Result<Vec<u8>, PictureFileError> {
    let most = Most { bytes: limits.file_bytes, raised_by: Some(Limit::PictureBytes) };
    Ok(read_all(path, most)?)
}

fn at(path: &Path, source: PictureError) -> PictureFileError {
    PictureFileError::Picture { path: path.to_owned(), source }
}
