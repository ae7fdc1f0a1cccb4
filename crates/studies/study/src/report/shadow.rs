//! The vehicle's shadow on flat ground and on true, as text, document, tables and plots.

use std::path::Path;

use serde_json::{Value, json};
use vehicle_shadow::Mast;

use super::folder::{ReportError, write};
use super::shadow_plots::write_plots;
use crate::shadow::{FlatGroundOutcome, LawOutcome, csv, laws_table, table};

/// What came of a study of the vehicle's shadow.
pub struct ShadowReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// Top of the vehicle and its eye.
    pub mast: Mast,
    /// Height of a line of the picture, at its middle (rad).
    pub line_rad: f64,
    /// Flat ground against true ground, sun by sun.
    pub suns: Vec<FlatGroundOutcome>,
    /// Laws and methods, if they were asked for.
    pub laws: Vec<LawOutcome>,
}

impl ShadowReport {
    /// Whether every error is what the formula says.
    pub fn holds(&self) -> bool {
        self.suns.iter().all(FlatGroundOutcome::holds)
    }

    /// Leaves `shadow.json`, `shadow.csv`, `shadow.md` and plots in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        write(folder, "shadow", &self.json(), &csv(&self.suns), &self.page())?;
        write_plots(folder, self)
    }

    /// A document of schema `lunoid.study-shadow/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-shadow/1",
            "commit": self.commit,
            "title": self.title,
            "top_m": self.mast.top,
            "eye_m": self.mast.eye,
            "line_rad": self.line_rad,
            "holds": self.holds(),
            "suns": self.suns,
            "laws": self.laws,
        })
    }

    pub(super) fn facts(&self) -> String {
        let commit = &self.commit;
        let (Mast { top, eye }, line) = (self.mast, 1e3 * self.line_rad);
        format!("{}, top {top:.3} m, eye {eye:.3} m, a line {line:.2} mrad, commit {commit}", self.title)
    }

    fn rows(&self) -> Vec<Vec<String>> {
        table(&self.suns, self.line_rad)
    }

    /// Returns the outcome as tables for people.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n\n{}", self.facts(), text::table(&self.rows()));
        if !self.laws.is_empty() {
            text +=
                &format!("\nlaws and methods\n{}{}", text::table(&laws_table(&self.laws)), self.warning());
        }
        text
    }

    /// The same as a page of Markdown.
    fn page(&self) -> String {
        let plot =
            if self.seen().is_some() { "![Error over height of the ground](shadow.svg)\n\n" } else { "" };
        let mut text = format!("{}.\n\n{plot}{}", self.facts(), text::markdown(&self.rows()));
        if !self.laws.is_empty() {
            let rows = text::markdown(&laws_table(&self.laws));
            text += &format!("\n### Laws and methods\n\n{rows}{}", self.warning());
        }
        text
    }

    /// A line where no law has anything to be off by.
    fn warning(&self) -> &'static str {
        let is_empty = self.laws.iter().all(|law| law.dark == 0.0);
        if is_empty { "\nThe shadow is in none of these pictures; choose others by --frame.\n" } else { "" }
    }

    /// Suns of one elevation under which edges are seen; none where there is nothing to draw.
    pub(super) fn seen(&self) -> Option<Vec<&FlatGroundOutcome>> {
        let seen: Vec<_> =
            self.suns.iter().filter(|sun| sun.elevation_deg.is_some() && sun.seen > 0).collect();
        (!seen.is_empty()).then_some(seen)
    }
}
