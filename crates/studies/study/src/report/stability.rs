//! Parts and whole frames at their limits, as text, document, tables and a picture.

use std::path::Path;

use serde_json::{Value, json};

use super::folder::{ReportError, write};
use super::matrix_plot::write_matrix;
use crate::stability::{Cell, FitOutcome, table};

/// What came of a study of stability.
pub struct StabilityReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// Seed of the mixtures.
    pub seed: u64,
    /// Cases, each by every method.
    pub cells: Vec<Cell>,
    /// Fits of hostile elevation files.
    pub fits: Vec<FitOutcome>,
}

impl StabilityReport {
    /// Whether every cell of a method of the machine holds.
    pub fn holds(&self) -> bool {
        table::faults(&self.cells).is_empty()
    }

    /// Leaves `stability.json`, `stability.csv`, `stability.md` and the matrix as a picture in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        write(folder, "stability", &self.json(), &table::csv(&self.cells), &self.page())?;
        write_matrix(folder, &self.facts(), &self.cells)
    }

    /// A document of schema `lunoid.study-stability/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-stability/1",
            "commit": self.commit,
            "title": self.title,
            "seed": self.seed,
            "cells": self.cells,
            "survey": self.fits,
        })
    }

    fn facts(&self) -> String {
        let own = self.cells.iter().filter(|cell| cell.own).count();
        let faults = table::faults(&self.cells).len();
        let commit = &self.commit;
        format!("{}, {own} cells of the machine, {faults} do not hold, commit {commit}", self.title)
    }

    /// Returns the outcome as tables for people.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n\n{}", self.facts(), text::table(&table::summary(&self.cells)));
        if !self.fits.is_empty() {
            text += &format!("\nsurvey fit\n{}", text::table(&table::fits(&self.fits)));
        }
        table::faults(&self.cells).iter().for_each(|fault| text += &format!("\n{fault}"));
        text + "\n"
    }

    /// The same as a page of Markdown.
    fn page(&self) -> String {
        let mut text = format!("{}.\n\n", self.facts());
        if !self.cells.is_empty() {
            text += "![Cases by methods](matrix.svg)\n\n";
        }
        text += &text::markdown(&table::summary(&self.cells));
        if !self.fits.is_empty() {
            text += &format!("\n### Survey fit\n\n{}", text::markdown(&table::fits(&self.fits)));
        }
        let faults = table::faults(&self.cells);
        if !faults.is_empty() {
            text += "\n### What does not hold\n\n";
            faults.iter().for_each(|fault| text += &format!("- {fault}\n"));
        }
        text
    }
}
