//! How the samples of a picture in a TIFF are stored, and the stored numbers of one band.

use std::path::Path;

use tiff::decoder::{ChunkType, DecodingResult, Limits};
use tiff::tags::Tag;
use tiff::{TiffError, TiffResult};

use super::block::{self, Stored};
use super::file::{MOST_EXPANSION, Tiff};
use super::tags;
use crate::error::SurveyError;
use crate::read::kind::{Stored as Kind, integer_can_hold};
use crate::read::refusal::field;
use crate::read::stretch::Window;

/// Most samples a byte of a file: each takes eight bytes of memory.
const MOST_PIXELS: u64 = 1024;

/// How the samples are stored.
#[derive(Clone)]
pub struct Layout {
    /// Lines of the picture.
    pub lines: usize,
    /// Samples of a line.
    pub columns: usize,
    /// Samples of a pixel.
    pub bands: usize,
    /// Lines and columns of a strip or tile.
    chunk: [usize; 2],
    planar: bool,
    bits: u32,
    format: u32,
    is_packed: bool,
    /// First byte of each strip or tile, and its bytes; a sparse file leaves some out.
    places: Vec<[u64; 2]>,
    how: Stored,
    limits: Limits,
}

/// The stored numbers of one band.
pub struct Band {
    /// Of the window, line by line; NaN where the file leaves a strip or tile out.
    pub samples: Vec<f64>,
    /// Strips and tiles that the file leaves out.
    pub left_out: usize,
}

impl Layout {
    /// Of the picture that the decoder stands at.
    pub fn of(tiff: &mut Tiff, limits: Limits) -> TiffResult<Self> {
        let (columns, lines) = tiff.dimensions()?;
        let (width, height) = tiff.chunk_dimensions();
        let [offsets, counts] = match tiff.get_chunk_type() {
            ChunkType::Strip => [Tag::StripOffsets, Tag::StripByteCounts],
            ChunkType::Tile => [Tag::TileOffsets, Tag::TileByteCounts],
        };
        let mut all = |tag| Ok::<_, TiffError>(tiff.find_tag_unsigned_vec::<u64>(tag)?.unwrap_or_default());
        let places = all(offsets)?.into_iter().zip(all(counts)?).map(|(at, bytes)| [at, bytes]).collect();
        let mut first = |tag| Ok::<_, TiffError>(all(tag)?.first().map_or(1, |number| *number as u32));
        Ok(Self {
            lines: lines as usize,
            columns: columns as usize,
            bands: first(Tag::SamplesPerPixel)?.max(1) as usize,
            // The last strip may be stored as high as the others or end where the picture does.
            chunk: [height.max(1) as usize, width.max(1) as usize],
            planar: first(Tag::PlanarConfiguration)? == 2,
            bits: first(Tag::BitsPerSample)?,
            format: first(Tag::SampleFormat)?,
            is_packed: first(Tag::Compression)? != 1,
            places,
            how: Stored::of(tiff)?,
            limits,
        })
    }

    /// Whether a sample can hold a number.
    pub fn can_hold(&self, number: f64) -> bool {
        self.format == 3 || integer_can_hold(self.bits, self.format == 2, number)
    }

    /// The kind of the samples as far as it matters for what they mean.
    pub fn kind(&self) -> Kind {
        Kind::of(self.bits, self.format == 3)
    }

    /// Refuses samples that are not read here.
    pub fn check_samples(&self, path: &Path) -> Result<(), SurveyError> {
        let known: &[u32] = match self.format {
            1 => &[1, 2, 4, 8, 16, 32, 64],
            2 => &[8, 16, 32, 64],
            _ => &[16, 32, 64],
        };
        if known.contains(&self.bits) {
            return Ok(());
        }
        let listed = known.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
        let advice = "write it again with gdal_translate -ot Float32";
        Err(field(path, tags::place(258), self.bits.to_string(), listed, advice))
    }

    /// Before anything is allocated: can a file of `found` bytes hold the raster?
    pub fn check_size(&self, path: &Path, found: u64) -> Result<(), SurveyError> {
        let pixels = (self.lines as u64).saturating_mul(self.columns as u64);
        let bytes = pixels.saturating_mul(self.bands as u64).saturating_mul(self.bits.into()) / 8;
        let is_whole = !self.is_packed && self.places.iter().all(is_held);
        let packed = (bytes / MOST_EXPANSION).max(pixels / MOST_PIXELS);
        let expected = if is_whole { bytes.max(packed) } else { packed };
        if found < expected {
            let place = format!("{} x {} samples of {} bands", self.lines, self.columns, self.bands);
            return Err(SurveyError::Truncated { path: path.to_path_buf(), place, found, expected });
        }
        Ok(())
    }

    fn across(&self) -> usize {
        self.columns.div_ceil(self.chunk[1])
    }

    fn chunks(&self) -> usize {
        self.across() * self.lines.div_ceil(self.chunk[0])
    }

    /// The stored numbers of `band`, from 0, in a window. Only the strips and tiles that it touches are read.
    pub fn read(
        &self,
        path: &Path,
        tiff: &mut Tiff,
        band: usize,
        window: &Window,
    ) -> Result<Band, SurveyError> {
        let mut out = Band { samples: vec![f64::NAN; window.count()], left_out: 0 };
        for place in window.blocks(self.chunk) {
            let chunk = place[0] * self.across() + place[1];
            let stored = if self.planar { chunk + band * self.chunks() } else { chunk };
            let Some(held) = self.places.get(stored).filter(|place| is_held(place)) else {
                out.left_out += 1;
                continue;
            };
            let failed = |source| SurveyError::Tiff {
                path: path.to_path_buf(),
                place: format!("strip or tile {stored}"),
                source,
            };
            let index = u32::try_from(stored).map_err(|_| failed(TiffError::IntSizeError))?;
            let values = block::read(tiff, index, *held, self.how, self.limits.clone()).map_err(failed)?;
            let numbers = numbers(values);
            window.put(self.chunk, place, &mut out.samples, |sample| self.sample(&numbers, sample, band));
        }
        Ok(out)
    }

    /// Decoded numbers that a row of so many samples takes: samples below a byte come packed, each row from a byte on.
    fn row(&self, samples: usize) -> usize {
        if self.bits < 8 { (samples * self.bits as usize).div_ceil(8) } else { samples }
    }

    /// Sample `index` of a strip or tile, NaN where it ends early. Samples below a byte begin at its highest bit (TIFF 6.0,
    /// FillOrder 1).
    fn sample(&self, numbers: &[f64], index: usize, band: usize) -> f64 {
        let (pixel, first) = if self.planar { (1, 0) } else { (self.bands, band) };
        let (line, column) = (index / self.chunk[1], index % self.chunk[1]);
        let (start, at) = (line * self.row(self.chunk[1] * pixel), column * pixel + first);
        if self.bits >= 8 {
            return numbers.get(start + at).copied().unwrap_or(f64::NAN);
        }
        let bits = self.bits as usize;
        let byte = numbers.get(start + at * bits / 8).map(|byte| *byte as u8);
        let shift = 8 - bits - at * bits % 8;
        byte.map_or(f64::NAN, |byte| f64::from(byte >> shift & ((1 << bits) - 1)))
    }
}

/// Whether a file holds a strip or tile of this place and size.
fn is_held([at, bytes]: &[u64; 2]) -> bool {
    *at != 0 && *bytes != 0
}

/// Decoded numbers, each exact; integers beyond 2^53 are rounded, which no height is.
fn numbers(values: DecodingResult) -> Vec<f64> {
    macro_rules! exact {
        ($values:expr) => {
            $values.into_iter().map(f64::from).collect()
        };
    }
    match values {
        DecodingResult::I8(v) => exact!(v),
        DecodingResult::U8(v) => exact!(v),
        DecodingResult::I16(v) => exact!(v),
        DecodingResult::U16(v) => exact!(v),
        DecodingResult::I32(v) => exact!(v),
        DecodingResult::U32(v) => exact!(v),
        DecodingResult::F16(v) => v.into_iter().map(|x| x.to_f64()).collect(),
        DecodingResult::F32(v) => exact!(v),
        DecodingResult::F64(v) => v,
        DecodingResult::I64(v) => v.into_iter().map(|x| x as f64).collect(),
        DecodingResult::U64(v) => v.into_iter().map(|x| x as f64).collect(),
    }
}
