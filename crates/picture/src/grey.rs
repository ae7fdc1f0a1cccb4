//! Grey codes in columns and lines.

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

/// A picture of grey codes, line by line from the top, each from left to right. Never empty.
#[derive(Clone, PartialEq, Eq)]
pub struct GreyPicture {
    columns: usize,
    lines: usize,
    depth: Depth,
    codes: Vec<u16>,
}

impl GreyPicture {
    /// A picture of these codes.
    ///
    /// # Errors
    /// [`PictureError::Size`] for an empty picture or a wrong number of codes, [`PictureError::Code`].
    pub fn new(columns: usize, lines: usize, depth: Depth, codes: Vec<u16>) -> Result<Self, PictureError> {
        if columns.checked_mul(lines) != Some(codes.len()) || codes.is_empty() {
            return Err(PictureError::Size { columns, lines, codes: codes.len() });
        }
        match codes.iter().position(|code| *code > depth.white()) {
            Some(at) => {
                let (column, line, code) = (at % columns, at / columns, codes[at]);
                Err(PictureError::Code { column, line, code, depth })
            }
            None => Ok(Self { columns, lines, depth, codes }),
        }
    }

    /// For codes that are right by construction.
    pub(crate) fn from_parts(columns: usize, lines: usize, depth: Depth, codes: Vec<u16>) -> Self {
        debug_assert_eq!(columns * lines, codes.len());
        Self { columns, lines, depth, codes }
    }

    /// Pixels in a line.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of lines.
    pub fn lines(&self) -> usize {
        self.lines
    }

    /// Bits of a code.
    pub fn depth(&self) -> Depth {
        self.depth
    }

    /// All codes, line by line.
    pub fn codes(&self) -> &[u16] {
        &self.codes
    }

    /// One code.
    ///
    /// # Panics
    /// Outside the picture.
    pub fn code(&self, column: usize, line: usize) -> u16 {
        self.line(line)[column]
    }

    /// The codes of one line.
    ///
    /// # Panics
    /// Outside the picture.
    pub fn line(&self, line: usize) -> &[u16] {
        &self.codes[line * self.columns..][..self.columns]
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

    /// BLAKE3 of columns, lines and bits (u32 little-endian each) followed by all codes (one byte each, or
    /// two little-endian), in hexadecimal. Independent of how a file packs the picture.
    pub fn pixel_hash(&self) -> String {
        let mut hasher = blake3::Hasher::new();
        for figure in [self.columns as u32, self.lines as u32, self.depth.bits()] {
            hasher.update(&figure.to_le_bytes());
        }
        hasher.update(&self.bytes(u16::to_le_bytes));
        hasher.finalize().to_hex().to_string()
    }

    /// Size and depth in words.
    pub(crate) fn kind(&self) -> String {
        format!("{} columns, {} lines, {} bits", self.columns, self.lines, self.depth.bits())
    }
}

impl fmt::Debug for GreyPicture {
    /// Size and hash: the codes of a frame would fill a screen a thousand times.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "GreyPicture({}, {})", self.kind(), &self.pixel_hash()[..16])
    }
}
