//! Raw film for other programs: YUV4MPEG2.

use std::io::{self, Write};

use crate::apng::frame_bytes;
use crate::grey::GreyPicture;

/// What a frame carries beside its grey.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Y4mColour {
    /// Grey alone (`Cmono`), which ffmpeg and mpv know.
    Mono,
    /// Two planes of no colour at half the size (`C420jpeg`), which every player knows.
    Planes420,
}

/// Writes 8-bit frames of full range one after the other.
#[derive(Debug)]
pub struct Y4m<W: Write> {
    out: W,
    columns: usize,
    lines: usize,
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
        let tag = match colour {
            Y4mColour::Mono => "Cmono",
            Y4mColour::Planes420 => "C420jpeg",
        };
        let (numerator, denominator) = rate_hz;
        // Without the extension players take 420 for studio range (16 to 235).
        writeln!(
            out,
            "YUV4MPEG2 W{columns} H{lines} F{numerator}:{denominator} Ip A1:1 {tag} XCOLORRANGE=FULL"
        )?;
        Ok(Self { out, columns, lines, colour })
    }

    /// Adds the next frame.
    ///
    /// # Errors
    /// Those of `out`; a frame of another size or depth.
    pub fn add(&mut self, frame: &GreyPicture) -> io::Result<()> {
        let mut bytes = frame_bytes(frame, self.columns, self.lines)?;
        if self.colour == Y4mColour::Planes420 {
            let plane = self.columns.div_ceil(2) * self.lines.div_ceil(2);
            bytes.resize(bytes.len() + 2 * plane, 128);
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
