//! A finished picture.

use crate::PlotError;
use std::io::Write;
use std::path::Path;

/// Pixels of 8-bit red, green, blue, line by line from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Drawing {
    columns: u32,
    lines: u32,
    rgb: Vec<u8>,
}

impl Drawing {
    pub(crate) fn new(columns: u32, lines: u32, rgb: Vec<u8>) -> Self {
        Self { columns, lines, rgb }
    }

    /// Pixels to the right.
    pub fn columns(&self) -> u32 {
        self.columns
    }

    /// Pixels down.
    pub fn lines(&self) -> u32 {
        self.lines
    }

    /// Red, green, blue of every pixel, three bytes each.
    pub fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// The bytes of a PNG file.
    pub fn png(&self) -> Vec<u8> {
        let mut bytes = vec![];
        self.encode(&mut bytes).expect("a vector takes every byte, and the size is that of the pixels");
        bytes
    }

    /// Writes a PNG file, whole or not at all.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let bytes = self.png();
        Ok(files::write_atomic(path, |out: &mut dyn Write| out.write_all(&bytes))?)
    }

    fn encode(&self, out: &mut Vec<u8>) -> Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(out, self.columns, self.lines);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.rgb)?;
        writer.finish()
    }
}
