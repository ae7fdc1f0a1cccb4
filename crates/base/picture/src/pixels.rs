//! Codes in columns and lines: grey, or red, green and blue.

use std::fmt;

use crate::error::PictureError;

/// Bits of a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Codes 0 to 255.
    Eight,
    /// Codes 0 to 65 535.
    Sixteen,
}

impl Depth {
    /// The code of white.
    pub const fn white(self) -> u16 {
        match self {
            Self::Eight => 255,
            Self::Sixteen => 65_535,
        }
    }

    /// How many bits a code has.
    pub const fn bits(self) -> u32 {
        match self {
            Self::Eight => 8,
            Self::Sixteen => 16,
        }
    }
}

/// A picture of display codes, line by line from the top, each line from left to right. Never empty. A pixel has one code
/// (grey) or three (red, green, blue, side by side); there are no others.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture<const CHANNELS: usize> {
    columns: usize,
    lines: usize,
    depth: Depth,
    codes: Vec<u16>,
}

/// A picture of grey codes.
pub type GreyPicture = Picture<1>;

/// A picture of red, green and blue codes under Rec. 709 primaries.
pub type ColourPicture = Picture<3>;

impl<const CHANNELS: usize> Picture<CHANNELS> {
    /// Refuses other layouts when the program is compiled.
    const IS_KNOWN: () = assert!(CHANNELS == 1 || CHANNELS == 3, "a pixel has one code or three");

    /// A picture of these codes, [`CHANNELS`](Self) for each pixel.
    ///
    /// # Errors
    /// [`PictureError::Size`] for an empty picture or a wrong number of codes, [`PictureError::Code`].
    pub fn new(columns: usize, lines: usize, depth: Depth, codes: Vec<u16>) -> Result<Self, PictureError> {
        let wanted = columns.checked_mul(lines).and_then(|pixels| pixels.checked_mul(CHANNELS));
        if wanted != Some(codes.len()) || codes.is_empty() {
            return Err(PictureError::Size { columns, lines, codes: codes.len().div_ceil(CHANNELS) });
        }
        match codes.iter().position(|code| *code > depth.white()) {
            Some(at) => {
                let (pixel, code) = (at / CHANNELS, codes[at]);
                Err(PictureError::Code { column: pixel % columns, line: pixel / columns, code, depth })
            }
            None => Ok(Self::from_parts(columns, lines, depth, codes)),
        }
    }

    /// For codes that are right by construction.
    pub(crate) fn from_parts(columns: usize, lines: usize, depth: Depth, codes: Vec<u16>) -> Self {
        let () = Self::IS_KNOWN;
        debug_assert_eq!(columns * lines * CHANNELS, codes.len());
        Self { columns, lines, depth, codes }
    }

    /// Pixels in a line.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Returns the number of lines.
    pub fn lines(&self) -> usize {
        self.lines
    }

    /// Bits of a code.
    pub fn depth(&self) -> Depth {
        self.depth
    }

    /// All codes, line by line; those of a pixel side by side.
    pub fn codes(&self) -> &[u16] {
        &self.codes
    }

    /// All pixels, line by line.
    pub fn pixels(&self) -> &[[u16; CHANNELS]] {
        self.codes.as_chunks().0
    }

    /// The codes of one pixel.
    ///
    /// # Panics
    /// Outside the picture.
    pub fn pixel(&self, column: usize, line: usize) -> [u16; CHANNELS] {
        self.pixels()[line * self.columns..][..self.columns][column]
    }

    /// The codes of one line, those of a pixel side by side.
    ///
    /// # Panics
    /// Outside the picture.
    pub fn line(&self, line: usize) -> &[u16] {
        let width = self.columns * CHANNELS;
        &self.codes[line * width..][..width]
    }

    /// The codes as 0 to 1.
    pub fn levels(&self) -> impl Iterator<Item = f64> + '_ {
        let max = f64::from(self.depth.white());
        self.codes.iter().map(move |code| f64::from(*code) / max)
    }

    /// The same picture in 8 bits, each code rounded to the nearest.
    pub fn to_eight_bits(&self) -> Self {
        let max = u32::from(self.depth.white());
        let reduce = |code: &u16| ((u32::from(*code) * 255 + max / 2) / max) as u16;
        let codes = self.codes.iter().map(reduce).collect();
        Self { depth: Depth::Eight, codes, ..*self }
    }

    /// Codes as bytes: one each, or two each with the larger place first or last.
    pub(crate) fn bytes(&self, two_bytes: impl Fn(u16) -> [u8; 2]) -> Vec<u8> {
        match self.depth {
            Depth::Eight => self.codes.iter().map(|code| *code as u8).collect(),
            Depth::Sixteen => self.codes.iter().flat_map(|code| two_bytes(*code)).collect(),
        }
    }

    /// BLAKE3 of columns, lines and bits (u32 little-endian each; of a colour picture the number of its channels, 3,
    /// behind them) followed by all codes (one byte each, or two little-endian), in hexadecimal. Independent of how a
    /// file packs the picture.
    pub fn pixel_hash(&self) -> String {
        let mut hasher = blake3::Hasher::new();
        let figures = [self.columns as u32, self.lines as u32, self.depth.bits(), CHANNELS as u32];
        let told = if CHANNELS == 1 { &figures[..3] } else { &figures[..] };
        for figure in told {
            hasher.update(&figure.to_le_bytes());
        }
        hasher.update(&self.bytes(u16::to_le_bytes));
        hasher.finalize().to_hex().to_string()
    }

    /// Size and depth in words, and that it is in colour.
    pub(crate) fn kind(&self) -> String {
        let colour = if CHANNELS == 1 { "" } else { ", colour" };
        format!("{} columns, {} lines, {} bits{colour}", self.columns, self.lines, self.depth.bits())
    }
}

impl GreyPicture {
    /// One code.
    ///
    /// # Panics
    /// Outside the picture.
    pub fn code(&self, column: usize, line: usize) -> u16 {
        self.line(line)[column]
    }

    /// The same picture with red, green and blue alike.
    pub fn to_colour(&self) -> ColourPicture {
        let codes = self.codes.iter().flat_map(|code| [*code; 3]).collect();
        Picture::from_parts(self.columns, self.lines, self.depth, codes)
    }
}

impl<const CHANNELS: usize> fmt::Debug for Picture<CHANNELS> {
    /// Size and hash: the codes of a frame would fill a screen a thousand times.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = if CHANNELS == 1 { "GreyPicture" } else { "ColourPicture" };
        write!(f, "{name}({}, {})", self.kind(), &self.pixel_hash()[..16])
    }
}
