//! Frames put together: contact sheet, films, the page that plays them.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use generator::{FrameCounts, Omission, Weight};
use picture::{Apng, GreyPicture, Limits, Y4m, Y4mColour, contact_sheet, encode_png, read_png};
use quantities::Rate;

use crate::{HeldRun, ReplayError};

/// Most frames on a contact sheet.
const SHEET_FRAMES: usize = 24;
/// Frames a row of it.
const SHEET_COLUMNS: usize = 4;
/// Columns of one of its frames, at most.
const CELL_COLUMNS: usize = 320;

/// The page that steps through the frames of a run.
const PLAYER: &str = include_str!("player.html");

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

/// What the page has to know.
pub(crate) struct Show<'a> {
    pub title: &'a str,
    pub shows: &'a str,
    pub first: u64,
    pub end: u64,
    pub rate: Rate,
    pub film: bool,
    pub work: FrameCounts,
    pub omissions: &'a [Omission],
}

/// The page: it needs the frames beside it and nothing else.
pub(crate) fn player(show: &Show) -> String {
    let film = match show.film {
        true => "<p><a href=\"animation.png\">animation.png</a>: the same as one file.</p>",
        false => "",
    };
    // Texts of the scenario come last: what they hold is not looked at again.
    PLAYER
        .replace("{{first}}", &show.first.to_string())
        .replace("{{end}}", &show.end.to_string())
        .replace("{{rate}}", &show.rate.hertz().to_string())
        .replace("{{film}}", film)
        .replace("{{work}}", &work(&show.work))
        .replace("{{omissions}}", &omissions(show.omissions))
        .replace("{{shows}}", &escaped(show.shows))
        .replace("{{title}}", &escaped(show.title))
}

/// What the run took; blocks that had nothing to do are not named.
fn work(counts: &FrameCounts) -> String {
    let rows = counts.named().filter(|(_, count)| *count > 0);
    let rows = rows.map(|(name, count)| format!("<tr><th>{}<td>{count}", name.replace('_', " ")));
    format!("<table>{}</table>", rows.collect::<String>())
}

fn omissions(omissions: &[Omission]) -> String {
    if omissions.is_empty() {
        return "<p>Nothing was left out.</p>".into();
    }
    let row = |omission: &Omission| {
        let weight = match omission.weight {
            Weight::Lossless => "the same to the bit".into(),
            Weight::NotModelled => "not modelled".into(),
            Weight::Bounded(levels) => format!("at most {levels} grey levels of 255"),
        };
        let cells = [omission.block, &omission.what, &omission.why, &weight].map(escaped);
        format!("<tr><td>{}", cells.join("<td>"))
    };
    let rows: String = omissions.iter().map(row).collect();
    format!("<table><tr><th>block<th>left out<th>why<th>difference{rows}</table>")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace('{', "&#123;")
}

#[cfg(test)]
mod tests {
    use generator::{FrameCounts, Omission, Weight};
    use quantities::Rate;

    use super::{Show, delay, fraction, player};

    #[test]
    fn rates_become_fractions() {
        let ntsc = Rate::new(30_000, 1001).expect("a rate");
        assert_eq!(fraction(ntsc), Some((30_000, 1001)));
        assert_eq!(delay(ntsc), (1001, 30_000));
        assert_eq!(delay(Rate::new(1_000_000, 3).expect("a rate")), (1, 1000));
    }

    #[test]
    fn titles_cannot_become_markup() {
        let rate = Rate::new(10, 1).expect("a rate");
        let (title, shows) = ("a {{end}} <b>", "\"<script>");
        let work = FrameCounts { late_words: 12, ..FrameCounts::default() };
        let omissions = [
            Omission::lossless("texture-generator", "<all>", "there is none"),
            Omission {
                weight: Weight::Bounded(0.5),
                ..Omission::lossless("mixing-unit", "VS3", "no {{title}}")
            },
        ];
        let omissions = &omissions;
        let page = player(&Show { title, shows, first: 3, end: 9, rate, film: false, work, omissions });
        assert!(page.contains("a &#123;&#123;end}} &lt;b&gt;") && page.contains("&quot;&lt;script&gt;"));
        assert!(page.contains("first = 3, end = 9, rate = 10") && !page.contains("{{"));
        assert!(page.contains("<th>late words<td>12") && !page.contains("sweeps"));
        let row = "<td>texture-generator<td>&lt;all&gt;<td>there is none<td>the same to the bit";
        assert!(page.contains(row) && page.contains("at most 0.5 grey levels of 255"));
    }
}
