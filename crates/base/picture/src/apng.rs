//! A film that every browser plays: animated PNG.

use std::io::{self, Write};

use png::{ColorType, Encoder, Writer};

use crate::pixels::{Depth, Picture};
use crate::png_file::{SOFTWARE, set_packing};

/// Writes 8-bit frames one after the other; only one is in memory at a time.
pub struct Apng<W: Write> {
    writer: Writer<W>,
    form: Form,
}

/// What all frames of a film are like; each has 8 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Form {
    pub columns: usize,
    pub lines: usize,
    pub channels: usize,
}

impl<W: Write> Apng<W> {
    /// Begins a film of `frames` grey pictures that repeats for ever. Each is shown for `delay_s` =
    /// (numerator, denominator) seconds.
    ///
    /// # Errors
    /// Those of `out`; a film without frames or a frame without pixels.
    pub fn new(out: W, columns: usize, lines: usize, frames: u32, delay_s: (u16, u16)) -> io::Result<Self> {
        Self::begin(out, Form { columns, lines, channels: 1 }, frames, delay_s)
    }

    /// The same of colour pictures.
    ///
    /// # Errors
    /// As [`Apng::new`].
    pub fn colour(
        out: W,
        columns: usize,
        lines: usize,
        frames: u32,
        delay_s: (u16, u16),
    ) -> io::Result<Self> {
        Self::begin(out, Form { columns, lines, channels: 3 }, frames, delay_s)
    }

    fn begin(out: W, form: Form, frames: u32, delay_s: (u16, u16)) -> io::Result<Self> {
        let mut encoder = Encoder::new(out, form.columns as u32, form.lines as u32);
        encoder.set_color(if form.channels == 1 { ColorType::Grayscale } else { ColorType::Rgb });
        set_packing(&mut encoder);
        encoder.add_text_chunk(SOFTWARE.0.into(), SOFTWARE.1.into())?;
        encoder.set_animated(frames, 0)?;
        encoder.set_frame_delay(delay_s.0, delay_s.1)?;
        encoder.validate_sequence(true);
        Ok(Self { writer: encoder.write_header()?, form })
    }

    /// Adds the next frame.
    ///
    /// # Errors
    /// Those of `out`; a frame of another size, depth or layout; more frames than announced.
    pub fn add<const CHANNELS: usize>(&mut self, frame: &Picture<CHANNELS>) -> io::Result<()> {
        let bytes = self.form.bytes(frame)?;
        Ok(self.writer.write_image_data(&bytes)?)
    }

    /// Ends the film.
    ///
    /// # Errors
    /// Those of `out`; fewer frames than announced.
    pub fn finish(self) -> io::Result<()> {
        Ok(self.writer.finish()?)
    }
}

impl Form {
    /// The bytes of a film's frame, which must be of 8 bits and like the others.
    pub fn bytes<const CHANNELS: usize>(self, frame: &Picture<CHANNELS>) -> io::Result<Vec<u8>> {
        let found = Self { columns: frame.columns(), lines: frame.lines(), channels: CHANNELS };
        if (found, frame.depth()) == (self, Depth::Eight) {
            return Ok(frame.bytes(u16::to_le_bytes));
        }
        let colour = if self.channels == 1 { "" } else { ", colour" };
        let expected = format!("{} columns, {} lines, 8 bits{colour}", self.columns, self.lines);
        let message = format!("a frame of {} in a film of {expected}", frame.kind());
        Err(io::Error::new(io::ErrorKind::InvalidInput, message))
    }
}
