//! One strip or tile of a TIFF, whatever its picture means: a mask, colours or heights.
//!
//! The crate `tiff` refuses masks and some colours, and unpacks Zstandard (compression 50000) by a C library only. Here each
//! strip or tile becomes a TIFF of its own in memory, which says that black is zero; `ruzstd` unpacks Zstandard. Byte order,
//! predictor and bands stay with `tiff`.

use std::io::{self, Cursor, Read, Seek, SeekFrom};

use ruzstd::decoding::StreamingDecoder;
use tiff::decoder::{ChunkType, Decoder, DecodingResult, Limits};
use tiff::tags::{ByteOrder, Tag};
use tiff::{TiffError, TiffResult};

use super::file::Tiff;

/// The code of Zstandard.
const ZSTD: u32 = 50_000;
/// The code of samples that are not packed.
const PLAIN: u32 = 1;

/// Bytes in front of the directory of a TIFF.
const HEADER: usize = 8;
/// Bytes of an entry of the directory.
const ENTRY: usize = 12;

/// The values of strip or tile `index`, all that it stores: also what lies beyond the picture.
/// It begins at byte `place[0]` of the file and takes `place[1]` bytes.
pub fn read(
    tiff: &mut Tiff,
    index: u32,
    place: [u64; 2],
    how: Stored,
    mut limits: Limits,
) -> TiffResult<DecodingResult> {
    let stored = match tiff.get_chunk_type() {
        // The last strip ends where the picture does.
        ChunkType::Strip => tiff.chunk_data_dimensions(index).into(),
        ChunkType::Tile => tiff.chunk_dimensions().into(),
    };
    let mut chunk = Chunk { stored, how };
    if chunk.bytes() > limits.decoding_buffer_size as u64 {
        return Err(TiffError::LimitsExceeded);
    }
    let mut bytes = packed(tiff, place, &limits)?;
    if chunk.how.compression == ZSTD {
        bytes = unpacked(&bytes, chunk.bytes())?;
        chunk.how.compression = PLAIN;
    }
    limits.intermediate_buffer_size = bytes.len();
    let alone = chunk.alone(tiff.byte_order(), &bytes);
    Decoder::new(Cursor::new(alone))?.with_limits(limits).read_chunk(0)
}

/// How all strips or tiles of a picture are stored.
#[derive(Debug, Clone, Copy)]
pub struct Stored {
    /// Samples of a pixel.
    samples: u32,
    bits: u32,
    format: u32,
    predictor: u32,
    compression: u32,
}

impl Stored {
    /// From the tags of the picture that the decoder stands at.
    pub fn of(tiff: &mut Tiff) -> TiffResult<Self> {
        let mut first = |tag, usual| -> TiffResult<u32> {
            let values = tiff.find_tag_unsigned_vec::<u32>(tag)?;
            Ok(values.and_then(|values| values.first().copied()).unwrap_or(usual))
        };
        let is_planar = first(Tag::PlanarConfiguration, 1)? == 2;
        let samples = if is_planar { 1 } else { first(Tag::SamplesPerPixel, 1)? };
        let (bits, format) = (first(Tag::BitsPerSample, 1)?, first(Tag::SampleFormat, 1)?);
        let (predictor, compression) = (first(Tag::Predictor, 1)?, first(Tag::Compression, PLAIN)?);
        Ok(Self { samples, bits, format, predictor, compression })
    }
}

/// One strip or tile.
struct Chunk {
    /// Columns and lines that it stores.
    stored: [u32; 2],
    how: Stored,
}

impl Chunk {
    /// Bytes of the samples; each line begins with a byte of its own.
    fn bytes(&self) -> u64 {
        let [columns, lines] = self.stored.map(u64::from);
        let pixel = u64::from(self.how.samples).saturating_mul(self.how.bits.into());
        columns.saturating_mul(pixel).div_ceil(8).saturating_mul(lines)
    }

    /// A TIFF of one tile, this one.
    fn alone(&self, order: ByteOrder, samples: &[u8]) -> Vec<u8> {
        let tags = [
            (Tag::ImageWidth, self.stored[0]),
            (Tag::ImageLength, self.stored[1]),
            (Tag::BitsPerSample, self.how.bits),
            (Tag::Compression, self.how.compression),
            (Tag::PhotometricInterpretation, 1),
            (Tag::SamplesPerPixel, self.how.samples),
            (Tag::Predictor, self.how.predictor),
            (Tag::TileWidth, self.stored[0]),
            (Tag::TileLength, self.stored[1]),
            (Tag::TileOffsets, (HEADER + 2 + TAGS * ENTRY + 4) as u32),
            (Tag::TileByteCounts, samples.len() as u32),
            (Tag::SampleFormat, self.how.format),
        ];
        directory(order, tags).into_iter().chain(samples.iter().copied()).collect()
    }
}

/// Tags that tell how a tile is stored.
const TAGS: usize = 12;

/// Header and directory of a TIFF with these tags, each of one number of 32 bits.
fn directory(order: ByteOrder, tags: [(Tag, u32); TAGS]) -> Vec<u8> {
    let short = |number: u16| match order {
        ByteOrder::LittleEndian => number.to_le_bytes(),
        ByteOrder::BigEndian => number.to_be_bytes(),
    };
    let long = |number: u32| match order {
        ByteOrder::LittleEndian => number.to_le_bytes(),
        ByteOrder::BigEndian => number.to_be_bytes(),
    };
    let mark = if order == ByteOrder::LittleEndian { *b"II" } else { *b"MM" };
    let mut bytes = [&mark[..], &short(42), &long(HEADER as u32), &short(TAGS as u16)].concat();
    for (tag, number) in tags {
        const LONG: u16 = 4;
        bytes.extend([&short(tag.to_u16())[..], &short(LONG), &long(1), &long(number)].concat());
    }
    bytes.extend(long(0));
    bytes
}

/// The bytes of a strip or tile as they stand in the file.
fn packed(tiff: &mut Tiff, [offset, count]: [u64; 2], limits: &Limits) -> TiffResult<Vec<u8>> {
    if count > limits.intermediate_buffer_size as u64 {
        return Err(TiffError::LimitsExceeded);
    }
    let mut bytes = Vec::new();
    tiff.inner().seek(SeekFrom::Start(offset))?;
    tiff.inner().take(count).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What `packed` holds, which must be `expected` bytes.
fn unpacked(packed: &[u8], expected: u64) -> TiffResult<Vec<u8>> {
    let stream = StreamingDecoder::new(packed).map_err(broken)?;
    let mut bytes = Vec::new();
    stream.take(expected.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 != expected {
        let found = bytes.len();
        return Err(broken(format!("Zstandard holds {found} bytes, expected {expected}")));
    }
    Ok(bytes)
}

fn broken(what: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> TiffError {
    io::Error::new(io::ErrorKind::InvalidData, what).into()
}
