//! Whole frames that are part of the page, byte for byte: it plays from any place, without its folder.

use std::fs;
use std::path::Path;

use maud::{Markup, html};
use replay::picture_name;

use crate::ReportError;
use crate::run::Run;

/// Bytes of frames that are part of a page, at most. Where all frames of a run take more it has every second of them,
/// or every third, and so on: as many as fit.
pub const FILM_BYTES: u64 = 96 << 20;

const KIND: &str = "image/png";
const MAX_BYTES: u64 = 1 << 30;

/// The frames that a page holds.
#[derive(Debug)]
pub(crate) struct Film {
    /// Indices of their pictures, ascending; none where one alone is too large.
    pub pictures: Vec<u64>,
    /// Where the first picture of the run is read from.
    pub first: String,
    /// The other frames, as base64.
    others: Vec<(u64, String)>,
}

/// Frames of `run` in `folder`.
pub(crate) fn film(folder: &Path, run: &Run) -> Result<Film, ReportError> {
    let first = run.first_picture();
    let all = first..first + run.pictures();
    let size = |picture: u64| fs::metadata(folder.join(picture_name(picture))).map_or(0, |found| found.len());
    let sizes: Vec<u64> = all.map(size).collect();
    let pictures: Vec<u64> = kept(&sizes, FILM_BYTES).map(|index| first + index as u64).collect();
    let bytes = |picture: u64| files::read_all(folder.join(picture_name(picture)), MAX_BYTES);
    let Some((_, others)) = pictures.split_first() else {
        return Ok(Film { pictures, first: picture_name(first), others: Vec::new() });
    };
    let other = |&picture: &u64| Ok((picture, text::base64(&bytes(picture)?)));
    let others = others.iter().map(other).collect::<Result<_, ReportError>>()?;
    Ok(Film { first: text::data_url(KIND, &bytes(first)?), others, pictures })
}

/// Indices of the frames that are kept: every n-th, n as small as `most` allows; the first is among them.
fn kept(sizes: &[u64], most: u64) -> impl Iterator<Item = usize> + use<> {
    let fits = |step: &usize| sizes.iter().step_by(*step).sum::<u64>() <= most;
    let step = (1..=sizes.len()).find(fits);
    let count = sizes.len();
    step.into_iter().flat_map(move |step| (0..count).step_by(step))
}

impl Film {
    /// Which frames are part of the page, in words.
    pub fn in_words(&self, run: &Run) -> String {
        let (held, all) = (self.pictures.len() as u64, run.pictures());
        match self.pictures.as_slice() {
            [] => "The frames are too large to be part of this file: it reads them from beside it.".into(),
            _ if held == all => "All frames are part of this file, byte for byte.".into(),
            [first, second, ..] => format!(
                "{held} of {all} frames, each {}, are part of this file, byte for byte; it reads the others from beside it.",
                nth(second - first)
            ),
            [_] => format!(
                "One of {all} frames is part of this file, byte for byte; it reads the others from beside it."
            ),
        }
    }

    /// The end of the page: the frames after the first, in elements that a browser keeps as they are.
    pub fn elements(&self) -> Markup {
        html! {
            @for (picture, text) in &self.others {
                script id=(format!("film-{picture}")) type="text/plain" { (maud::PreEscaped(text)) }
            }
        }
    }
}

fn nth(step: u64) -> String {
    match step {
        2 => "second".into(),
        3 => "third".into(),
        _ => format!("{step}th"),
    }
}

#[cfg(test)]
mod tests {
    use super::kept;

    #[test]
    fn as_many_frames_as_fit_evenly_spread() {
        let of = |sizes: &[u64], most: u64| kept(sizes, most).collect::<Vec<_>>();
        assert_eq!(of(&[10; 5], 50), [0, 1, 2, 3, 4]);
        assert_eq!(of(&[10; 5], 49), [0, 2, 4]);
        assert_eq!(of(&[10; 5], 29), [0, 3]);
        assert_eq!(of(&[10; 5], 10), [0]);
        assert!(of(&[11, 1, 1], 10).is_empty());
        assert_eq!(of(&[1, 90, 1, 90, 1], 10), [0, 2, 4]);
    }
}
