//! An elevation file whose header is understood: what it holds and where, before any sample is read.

use std::ops::Range;
use std::path::PathBuf;

use limits::Limit;

use super::refusal::visible;
use super::samples::Conversion;
use super::stretch::Window;
use crate::elevation::{Affine, Elevation, Frame, Grid};
use crate::error::SurveyError;

/// Where the stored numbers of a file come from.
pub trait Samples {
    /// Stored numbers of a window, line by line; NaN where the file masks them or leaves them out. The window lies in the
    /// file. Notes tell what the user should know.
    ///
    /// # Errors
    /// If the file cannot be read, or its samples are damaged.
    fn read(&mut self, window: &Window, notes: &mut Vec<String>) -> Result<Vec<f64>, SurveyError>;
}

/// An elevation file whose header is understood; its samples are read by [`Opened::all`] or [`Opened::window`].
pub struct Opened {
    /// Place and number of the samples.
    pub(crate) grid: Grid,
    /// The file that was asked for.
    pub(crate) path: PathBuf,
    /// What the heights are, for people.
    pub(crate) title: String,
    /// Files that are read; the last one has the samples.
    pub(crate) sources: Vec<PathBuf>,
    /// What was assumed so far.
    pub(crate) notes: Vec<String>,
    pub(crate) conversion: Conversion,
    pub(crate) samples: Box<dyn Samples>,
}

impl Opened {
    /// Lines of the file and samples of a line.
    pub fn size(&self) -> [usize; 2] {
        [self.grid.lines, self.grid.columns]
    }

    /// Place of the samples.
    pub fn affine(&self) -> Affine {
        self.grid.affine
    }

    /// Meaning of the places.
    pub fn frame(&self) -> Frame {
        self.grid.frame
    }

    /// Reads all samples.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged, or has a sample that is no height, or none that is one.
    pub fn all(self) -> Result<Elevation, SurveyError> {
        let whole = Window { lines: 0..self.grid.lines, columns: 0..self.grid.columns };
        self.window(&whole)
    }

    /// Reads the samples of a window; only the blocks of the file that it needs are read.
    ///
    /// # Errors
    /// As [`Opened::all`], and if the window does not lie in the file or holds more than [`Limit::ElevationBytes`].
    pub fn window(mut self, window: &Window) -> Result<Elevation, SurveyError> {
        let parts = self.parts(window)?;
        self.check_size(window)?;
        let mut notes = std::mem::take(&mut self.notes);
        let mut read = Vec::new();
        for part in &parts {
            read.push((part, self.samples.read(part, &mut notes)?));
        }
        notes.dedup();
        let mut heights = joined(window, read);
        let path = self.sources.last().cloned().unwrap_or_default();
        notes.extend(self.conversion.convert(&path, &mut heights, window)?);
        let mut read = Elevation::of_window(self.grid, window, heights, self.title, self.sources, notes);
        let seams = read.seams();
        if seams > 0 {
            read.notes.push(format!(
                "the last column stands where the first does, and has other heights in {seams} lines: the first counts"
            ));
        }
        read.notes.iter_mut().for_each(|note| *note = visible(note));
        match read.range() {
            Some(_) => Ok(read),
            None => {
                Err(SurveyError::AllVoid { what: self.path.display().to_string(), count: window.count() })
            }
        }
    }

    /// Refuses more heights than may be in memory, before any is read.
    fn check_size(&self, window: &Window) -> Result<(), SurveyError> {
        let bytes = (window.count() as u64).saturating_mul(size_of::<f64>() as u64);
        if Limit::ElevationBytes.allows(bytes) {
            return Ok(());
        }
        let (path, most) = (self.path.clone(), Limit::ElevationBytes.value());
        let [lines, columns] = [window.lines.len(), window.columns.len()];
        Err(SurveyError::TooLarge { path, lines, columns, bytes, most })
    }

    /// The window as pieces that each lie in the file: two where it crosses the seam of a globe.
    fn parts(&self, window: &Window) -> Result<Vec<Window>, SurveyError> {
        let turn = self.grid.turn();
        let most = turn.map_or(self.grid.columns, |turn| window.columns.start.min(turn - 1) + turn);
        let most = most.max(self.grid.columns);
        let fits = |range: &Range<usize>, most: usize| range.start < range.end && range.end <= most;
        let is_inside = fits(&window.lines, self.grid.lines) && fits(&window.columns, most);
        let goes_around = window.columns.end > self.grid.columns;
        let first = turn.filter(|_| goes_around).unwrap_or(self.grid.columns);
        if !is_inside || window.columns.start >= first {
            return Err(SurveyError::Option {
                option: "window",
                found: format!("lines {:?}, columns {:?}", window.lines, window.columns),
                expected: format!("some of {} lines and {most} columns", self.grid.lines),
            });
        }
        let Some(turn) = turn.filter(|_| goes_around) else {
            return Ok(vec![window.clone()]);
        };
        let part = |columns| Window { lines: window.lines.clone(), columns };
        let behind = 0..window.columns.end - turn;
        Ok(vec![part(window.columns.start..turn), part(behind)])
    }
}

/// The samples of windows side by side, as those of one.
fn joined(window: &Window, mut parts: Vec<(&Window, Vec<f64>)>) -> Vec<f64> {
    if let [(_, _)] = parts.as_slice() {
        return parts.remove(0).1;
    }
    let mut out = Vec::with_capacity(window.count());
    for line in 0..window.lines.len() {
        for (part, samples) in &parts {
            let width = part.columns.len();
            out.extend_from_slice(&samples[line * width..(line + 1) * width]);
        }
    }
    out
}
