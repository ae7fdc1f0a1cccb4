//! Raw film for other programs: YUV4MPEG2.

use std::io::{self, Write};

use quantities::LUMINANCE_WEIGHTS;

use crate::apng::Form;
use crate::pixels::Picture;

/// What a frame carries beside its grey.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Y4mColour {
    /// Grey alone (`Cmono`), which ffmpeg and mpv know.
    Mono,
    /// Two planes of no colour at half the size (`C420jpeg`), which every player knows.
    Planes420,
    /// Colour: luma and two planes of colour at full size (`C444`), by the matrix of ITU-R BT.709.
    Planes444,
}

impl Y4mColour {
    /// Its word in the header. The format has no word of its own for the matrix: an extension tells it.
    fn tag(self) -> &'static str {
        match self {
            Self::Mono => "Cmono XCOLORRANGE=FULL",
            Self::Planes420 => "C420jpeg XCOLORRANGE=FULL",
            Self::Planes444 => "C444 XCOLORRANGE=FULL XMATRIX=BT709",
        }
    }

    fn channels(self) -> usize {
        if self == Self::Planes444 { 3 } else { 1 }
    }
}

/// Writes 8-bit frames of full range one after the other.
#[derive(Debug)]
pub struct Y4m<W: Write> {
    out: W,
    form: Form,
    colour: Y4mColour,
}

impl<W: Write> Y4m<W> {
    /// Begins a film of `rate_hz` = (numerator, denominator) frames a second.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn new(
        mut out: W,
        columns: usize,
        lines: usize,
        rate_hz: (u32, u32),
        colour: Y4mColour,
    ) -> io::Result<Self> {
        let (tag, (numerator, denominator)) = (colour.tag(), rate_hz);
        // Without the extension players take 420 for studio range (16 to 235).
        writeln!(out, "YUV4MPEG2 W{columns} H{lines} F{numerator}:{denominator} Ip A1:1 {tag}")?;
        Ok(Self { out, form: Form { columns, lines, channels: colour.channels() }, colour })
    }

    /// Adds the next frame.
    ///
    /// # Errors
    /// Those of `out`; a frame of another size, depth or layout.
    pub fn add<const CHANNELS: usize>(&mut self, frame: &Picture<CHANNELS>) -> io::Result<()> {
        let mut bytes = self.form.bytes(frame)?;
        match self.colour {
            Y4mColour::Mono => {}
            Y4mColour::Planes420 => {
                let plane = self.form.columns.div_ceil(2) * self.form.lines.div_ceil(2);
                bytes.resize(bytes.len() + 2 * plane, 128);
            }
            Y4mColour::Planes444 => bytes = planes(&bytes),
        }
        self.out.write_all(b"FRAME\n")?;
        self.out.write_all(&bytes)
    }

    /// Ends the film and gives the output back.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }
}

/// Red, green and blue side by side into planes of luma and of two differences of colour, all 0 to 255:
/// `Y = Kr R + Kg G + Kb B`, `Cb = 128 + (B - Y) / (2 - 2 Kb)`, `Cr = 128 + (R - Y) / (2 - 2 Kr)`, rounded to the nearest.
/// R, G and B are the codes as displayed, as the matrix of ITU-R BT.709 has it.
fn planes(colours: &[u8]) -> Vec<u8> {
    let [of_red, _, of_blue] = LUMINANCE_WEIGHTS;
    let code = |value: f64| (value + 0.5).floor().clamp(0.0, 255.0) as u8;
    let converted = colours.as_chunks().0.iter().map(|pixel: &[u8; 3]| {
        let colour = pixel.map(f64::from);
        let luma = quantities::luminance(colour);
        let [red, _, blue] = colour;
        let differences = [(blue - luma) / (2.0 - 2.0 * of_blue), (red - luma) / (2.0 - 2.0 * of_red)];
        [luma, 128.0 + differences[0], 128.0 + differences[1]].map(code)
    });
    let pixels: Vec<[u8; 3]> = converted.collect();
    (0..3).flat_map(|plane| pixels.iter().map(move |pixel| pixel[plane])).collect()
}
