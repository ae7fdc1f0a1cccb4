//! Figures of Link's study of sea states, remade: pictures, and what is measured in them.
//!
//! ```text
//!  shipped scenario, change, run parameters, frame --> Shot --> Still --> picture, measured numbers
//! ```
//!
//! `docs/link-study.md` has the pictures and the numbers; the example `link_figures` draws the pictures, and a test measures again.

mod exhibits;
mod figures;
mod measured;
mod still;

pub use still::Still;

use std::path::{Path, PathBuf};

use picture::{PictureFileError, beside, write_png};
use scenario::Scenario;

use still::sea_faces;

/// A frame of a shipped scenario after a change.
pub struct Shot {
    /// Name of the scenario.
    pub scenario: &'static str,
    /// Number of the frame.
    pub frame: u64,
    /// Run parameters of the generator (key, value).
    pub sets: &'static [(&'static str, &'static str)],
    /// What is other than in the scenario.
    pub change: fn(&mut Scenario),
}

/// Something that is measured, with its value as the page prints it.
pub type Measured = (&'static str, String);

/// A figure: shots side by side.
pub struct Figure {
    /// Name of its file.
    pub name: &'static str,
    /// The shots, from left to right.
    pub shots: Vec<Shot>,
    /// What is measured in them.
    pub measure: fn(&[Still]) -> Vec<Measured>,
}

/// Figures of the study by number, then what it dropped beside what replaced that.
pub fn figures() -> Vec<Figure> {
    figures::all().into_iter().chain(exhibits::all()).collect()
}

impl Figure {
    /// The shots as they are drawn.
    ///
    /// # Panics
    /// If a shipped scenario cannot be drawn.
    pub fn stills(&self) -> Vec<Still> {
        self.shots.iter().map(sea_faces).collect()
    }

    /// Its rows of the page: file, what is measured, value.
    pub fn rows(&self, stills: &[Still]) -> Vec<String> {
        let row = |(what, value): Measured| format!("| {} | {what} | {value} |", self.name);
        (self.measure)(stills).into_iter().map(row).collect()
    }

    /// Leaves the shots side by side in a folder and returns the file.
    ///
    /// # Errors
    /// If the file cannot be written.
    ///
    /// # Panics
    /// If there is no still.
    pub fn leave(&self, folder: &Path, stills: &[Still]) -> Result<PathBuf, PictureFileError> {
        let pictures: Vec<_> = stills.iter().map(|still| &still.picture).collect();
        let file = folder.join(format!("{}.png", self.name));
        write_png(&file, &beside(&pictures).expect("pictures of one size"), &[])?;
        Ok(file)
    }
}
