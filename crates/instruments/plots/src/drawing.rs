//! A finished picture, as pixels or SVG.

use std::io::Write;
use std::path::Path;
use std::sync::OnceLock;

use crate::PlotError;
use crate::colour::Colour;
use crate::mark::{Mark, Surface};
use crate::pixels::Pixels;
use crate::svg::Svg;

/// A finished picture: its strokes, as pixels or as SVG.
#[derive(Debug, Clone)]
pub struct Drawing {
    columns: u32,
    lines: u32,
    paper: Colour,
    title: String,
    marks: Vec<Mark>,
    rgb: OnceLock<Vec<u8>>,
}

impl PartialEq for Drawing {
    /// Whether both are the same strokes on the same paper.
    fn eq(&self, other: &Self) -> bool {
        let sheet = |drawing: &Self| (drawing.columns, drawing.lines, drawing.paper);
        sheet(self) == sheet(other) && self.title == other.title && self.marks == other.marks
    }
}

impl Drawing {
    pub(crate) fn new([columns, lines]: [u32; 2], paper: Colour, title: String, marks: Vec<Mark>) -> Self {
        Self { columns, lines, paper, title, marks, rgb: OnceLock::new() }
    }

    /// Returns the width of the picture (pixels).
    pub fn columns(&self) -> u32 {
        self.columns
    }

    /// Returns the height of the picture (pixels).
    pub fn lines(&self) -> u32 {
        self.lines
    }

    /// Red, green, blue of every pixel, three bytes each.
    pub fn rgb(&self) -> &[u8] {
        self.rgb.get_or_init(|| {
            let mut pixels = Pixels::new(self.columns, self.lines, self.paper);
            self.draw(&mut pixels);
            pixels.rgb()
        })
    }

    /// The bytes of a PNG file.
    pub fn png(&self) -> Vec<u8> {
        let mut bytes = vec![];
        self.encode(&mut bytes).expect("a vector takes every byte, and the size is that of the pixels");
        bytes
    }

    /// The text of an SVG file, without fonts, scripts or links; it may stand within a page as it is.
    pub fn svg(&self) -> String {
        let mut svg = Svg::new(self.columns, self.lines, self.paper, &self.title);
        self.draw(&mut svg);
        svg.finish()
    }

    /// The same, in the colours of `dark` where the reader, or the page that shows it as an image, prefers dark. `dark` is
    /// the same strokes on dark paper.
    pub(crate) fn svg_or_dark(&self, dark: &Self) -> String {
        let mut svg = Svg::new(self.columns, self.lines, self.paper, &self.title);
        svg.in_the_dark(self.paper, dark.paper);
        for (mark, dark) in self.marks.iter().zip(&dark.marks) {
            if let (Some(colour), Some(dark)) = (mark.colour(), dark.colour()) {
                svg.in_the_dark(colour, dark);
            }
        }
        self.draw(&mut svg);
        svg.finish()
    }

    /// Writes an SVG file if `path` ends in `.svg`, a PNG file otherwise, whole or not at all.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), PlotError> {
        let is_svg = path.as_ref().extension().is_some_and(|end| end.eq_ignore_ascii_case("svg"));
        let bytes = if is_svg { self.svg().into_bytes() } else { self.png() };
        Ok(files::write_atomic(path, |out: &mut dyn Write| out.write_all(&bytes))?)
    }

    fn draw(&self, on: &mut dyn Surface) {
        self.marks.iter().for_each(|mark| on.take(mark));
    }

    fn encode(&self, out: &mut Vec<u8>) -> Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(out, self.columns, self.lines);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.rgb())?;
        writer.finish()
    }
}
