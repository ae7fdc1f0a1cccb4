//! Frames put together: contact sheet and films.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use picture::{Apng, GreyPicture, Limits, Y4m, Y4mColour, contact_sheet, encode_png, read_png};
use quantities::Rate;

use crate::{HeldRun, ReplayError};

/// Most frames on a contact sheet.
const SHEET_FRAMES: usize = 24;
/// Frames a row of it.
const SHEET_COLUMNS: usize = 4;
/// Columns of one of its frames, at most.
const CELL_COLUMNS: usize = 320;

/// Some frames, evenly spread from the first to the last.
pub(crate) fn sheet(pictures: &[PathBuf]) -> Result<Vec<u8>, ReplayError> {
    let count = pictures.len().min(SHEET_FRAMES);
    let spread = |index: usize| index * (pictures.len() - 1) / (count - 1).max(1);
    let chosen: Result<Vec<_>, _> = (0..count).map(|index| read(&pictures[spread(index)])).collect();
    let chosen = chosen?;
    let cell = chosen[0].columns().min(CELL_COLUMNS);
    let refused = |source| ReplayError::Film { path: crate::folder::CONTACT_SHEET.into(), source };
    let sheet = contact_sheet(&chosen.iter().collect::<Vec<_>>(), SHEET_COLUMNS, cell).map_err(refused)?;
    encode_png(&sheet.to_eight_bits(), &[]).map_err(refused)
}

fn read(path: &Path) -> Result<GreyPicture, ReplayError> {
    Ok(read_png(path, &Limits::default())?)
}

/// Writes all pictures as an animated PNG, one in memory at a time.
pub(crate) fn write_film(out: &mut dyn Write, pictures: &[PathBuf], rate: Rate) -> io::Result<()> {
    let Some(first) = pictures.first().map(|path| read_eight_bits(path)).transpose()? else { return Ok(()) };
    let count = pictures.len() as u32;
    let mut film = Apng::new(out, first.columns(), first.lines(), count, delay(rate))?;
    film.add(&first)?;
    pictures[1..].iter().try_for_each(|path| film.add(&read_eight_bits(path)?))?;
    film.finish()
}

/// Writes the pictures of a finished run as Y4M (grey alone), one in memory at a time, `rate` a second.
///
/// # Errors
/// If a picture cannot be read or `out` not be written.
pub fn write_y4m(out: &mut dyn Write, folder: &Path, run: &HeldRun, rate: Rate) -> io::Result<()> {
    let mut pictures = run.pictures(folder);
    let Some(first) = pictures.next().map(|path| read_eight_bits(&path)).transpose()? else { return Ok(()) };
    let rate = fraction(rate).ok_or(io::ErrorKind::InvalidInput)?;
    let mut film = Y4m::new(out, first.columns(), first.lines(), rate, Y4mColour::Mono)?;
    film.add(&first)?;
    pictures.try_for_each(|path| film.add(&read_eight_bits(&path)?))?;
    film.finish().map(|_| ())
}

fn read_eight_bits(path: &Path) -> io::Result<GreyPicture> {
    Ok(read_png(path, &Limits::default()).map_err(io::Error::other)?.to_eight_bits())
}

/// A rate as numerator and denominator (hertz).
fn fraction(rate: Rate) -> Option<(u32, u32)> {
    let hertz = Rate::new(1, 1)?;
    (1..=1_000_000).find_map(|denominator: u32| {
        let numerator = rate.times(u64::from(denominator))?.whole_ratio(hertz)?;
        Some((u32::try_from(numerator).ok()?, denominator))
    })
}

/// Seconds that a picture is shown, as the fraction of two small numbers that the format has.
fn delay(rate: Rate) -> (u16, u16) {
    let exact = fraction(rate).and_then(|(numerator, denominator)| {
        Some((u16::try_from(denominator).ok()?, u16::try_from(numerator).ok()?))
    });
    exact.unwrap_or_else(|| ((1000.0 / rate.hertz()).round().clamp(1.0, 65_535.0) as u16, 1000))
}

#[cfg(test)]
mod tests {
    use quantities::Rate;

    use super::{delay, fraction};

    #[test]
    fn rates_become_fractions() {
        let ntsc = Rate::new(30_000, 1001).expect("a rate");
        assert_eq!(fraction(ntsc), Some((30_000, 1001)));
        assert_eq!(delay(ntsc), (1001, 30_000));
        assert_eq!(delay(Rate::new(1_000_000, 3).expect("a rate")), (1, 1000));
    }
}
