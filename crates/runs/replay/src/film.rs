//! Frames put together: contact sheet and films.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use picture::{
    AnyPicture, Apng, ColourPicture, GreyPicture, Limits, SOFTWARE, Y4m, Y4mColour, contact_sheet,
    read_any_png,
};
use quantities::Rate;

use crate::held::write_changed;
use crate::names::{ANIMATION, CONTACT_SHEET};
use crate::{HeldRun, ReplayError, RunFolder};
use run_record::{FileRecord, file_hash};

/// Most frames on a contact sheet.
const SHEET_FRAMES: usize = 24;
/// Frames a row of it.
const SHEET_COLUMNS: usize = 4;
/// Columns of one of its frames, at most.
const CELL_COLUMNS: usize = 320;

/// Some frames, evenly spread from the first to the last.
fn sheet(pictures: &[PathBuf]) -> Result<Vec<u8>, ReplayError> {
    let count = pictures.len().min(SHEET_FRAMES);
    let spread = |index: usize| index * (pictures.len() - 1) / (count - 1).max(1);
    let chosen: Result<Vec<_>, _> = (0..count).map(|index| read(&pictures[spread(index)])).collect();
    let chosen = chosen?;
    let cell = chosen[0].columns().min(CELL_COLUMNS);
    let refused = |source| ReplayError::Film { path: CONTACT_SHEET.into(), source };
    let sheet: AnyPicture = match alike(&chosen) {
        Alike::Grey(all) => contact_sheet(&all, SHEET_COLUMNS, cell).map_err(refused)?.into(),
        Alike::Colour(all) => {
            contact_sheet(&all.iter().collect::<Vec<_>>(), SHEET_COLUMNS, cell).map_err(refused)?.into()
        }
    };
    sheet.to_eight_bits().encode_png(&[SOFTWARE]).map_err(refused)
}

/// Pictures of one layout.
enum Alike<'a> {
    Grey(Vec<&'a GreyPicture>),
    Colour(Vec<ColourPicture>),
}

/// Grey if all are, else all in colour.
fn alike(pictures: &[AnyPicture]) -> Alike<'_> {
    match pictures.iter().map(AnyPicture::grey).collect() {
        Some(all) => Alike::Grey(all),
        None => Alike::Colour(pictures.iter().map(AnyPicture::to_colour).collect()),
    }
}

fn read(path: &Path) -> Result<AnyPicture, ReplayError> {
    Ok(read_any_png(path, &Limits::default())?)
}

/// Writes the contact sheet of all `pictures` into `folder`.
pub(crate) fn write_sheet(folder: &RunFolder, pictures: &[PathBuf]) -> Result<FileRecord, ReplayError> {
    write_changed(folder.path(), CONTACT_SHEET, &sheet(pictures)?)
}

/// Writes all `pictures` as the film of `folder` that a browser plays, `rate` a second.
pub(crate) fn write_animation(
    folder: &RunFolder,
    pictures: &[PathBuf],
    rate: Rate,
) -> Result<FileRecord, ReplayError> {
    let path = folder.join(ANIMATION);
    files::write_atomic(&path, |out| write_film(out, pictures, rate))?;
    Ok(FileRecord { file: ANIMATION.into(), blake3: file_hash(&path)? })
}

/// Writes all pictures as an animated PNG, one in memory at a time.
fn write_film(out: &mut dyn Write, pictures: &[PathBuf], rate: Rate) -> io::Result<()> {
    write_apng(out, pictures.len(), rate, pictures.iter().map(|path| read_eight_bits(path)))
}

/// Writes `count` pictures of 8 bits and of one size as an animated PNG, one in memory at a time, `rate` a second. Without pictures nothing is written.
///
/// # Errors
/// If a picture is an error or unlike the first, there are more or fewer of them, or `out` cannot be written.
pub fn write_apng(
    out: &mut dyn Write,
    count: usize,
    rate: Rate,
    mut pictures: impl Iterator<Item = io::Result<AnyPicture>>,
) -> io::Result<()> {
    let Some(first) = pictures.next().transpose()? else { return Ok(()) };
    let begin = if first.is_colour() { Apng::colour } else { Apng::new };
    let mut film = begin(out, first.columns(), first.lines(), count as u32, delay(rate))?;
    let mut add = |frame: &AnyPicture| match frame {
        AnyPicture::Grey(frame) => film.add(frame),
        AnyPicture::Colour(frame) => film.add(frame),
    };
    add(&first)?;
    pictures.try_for_each(|picture| add(&picture?))?;
    film.finish()
}

/// Writes the pictures of a finished run as Y4M (grey alone, or 4:4:4 by the matrix of BT.709, all of full range), one in memory at a time, `rate` a second.
///
/// # Errors
/// If a picture cannot be read or `out` not be written.
pub fn write_y4m(out: &mut dyn Write, folder: &Path, run: &HeldRun, rate: Rate) -> io::Result<()> {
    let mut pictures = run.pictures(folder);
    let Some(first) = pictures.next().map(|path| read_eight_bits(&path)).transpose()? else { return Ok(()) };
    let rate = fraction(rate).ok_or(io::ErrorKind::InvalidInput)?;
    let layout = if first.is_colour() { Y4mColour::Planes444 } else { Y4mColour::Mono };
    let mut film = Y4m::new(out, first.columns(), first.lines(), rate, layout)?;
    let mut add = |frame: &AnyPicture| match frame {
        AnyPicture::Grey(frame) => film.add(frame),
        AnyPicture::Colour(frame) => film.add(frame),
    };
    add(&first)?;
    pictures.try_for_each(|path| add(&read_eight_bits(&path)?))?;
    film.finish().map(|_| ())
}

fn read_eight_bits(path: &Path) -> io::Result<AnyPicture> {
    Ok(read_any_png(path, &Limits::default()).map_err(io::Error::other)?.to_eight_bits())
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
