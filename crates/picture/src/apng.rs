//! A film that every browser plays: animated PNG.

use std::io::{self, Write};

use png::{ColorType, Encoder, Writer};

use crate::grey::{Depth, GreyPicture};
use crate::png_file::set_packing;

/// Writes 8-bit frames one after the other; only one is in memory at a time.
pub struct Apng<W: Write> {
    writer: Writer<W>,
    columns: usize,
    lines: usize,
}

impl<W: Write> Apng<W> {
    /// Begins a film of `frames` pictures that repeats for ever. Each is shown for `delay_s` =
    /// (numerator, denominator) seconds.
    ///
    /// # Errors
    /// Those of `out`; a film without frames or a frame without pixels.
    pub fn new(out: W, columns: usize, lines: usize, frames: u32, delay_s: (u16, u16)) -> io::Result<Self> {
        let mut encoder = Encoder::new(out, columns as u32, lines as u32);
        encoder.set_color(ColorType::Grayscale);
        set_packing(&mut encoder);
        encoder.set_animated(frames, 0)?;
        encoder.set_frame_delay(delay_s.0, delay_s.1)?;
        encoder.validate_sequence(true);
        Ok(Self { writer: encoder.write_header()?, columns, lines })
    }

    /// Adds the next frame.
    ///
    /// # Errors
    /// Those of `out`; a frame of another size or depth; more frames than announced.
    pub fn add(&mut self, frame: &GreyPicture) -> io::Result<()> {
        let bytes = frame_bytes(frame, self.columns, self.lines)?;
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

/// The bytes of a film's frame, which must be of 8 bits and of the film's size.
pub(crate) fn frame_bytes(frame: &GreyPicture, columns: usize, lines: usize) -> io::Result<Vec<u8>> {
    if (frame.columns(), frame.lines(), frame.depth()) != (columns, lines, Depth::Eight) {
        let expected = format!("{columns} columns, {lines} lines, 8 bits");
        let message = format!("a frame of {} in a film of {expected}", frame.kind());
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    }
    Ok(frame.bytes(u16::to_le_bytes))
}
