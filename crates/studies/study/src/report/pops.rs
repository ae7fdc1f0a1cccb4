//! Distances along the view axis and their pops: as text, document, tables and a plot.

use std::ops::Range;
use std::path::Path;

use ::plots::{Axis, Panel, Trace, TraceLook, trace_picture};
use serde_json::{Value, json};

use super::folder::{ReportError, save, write};
use crate::pops::{AtFrame, LEAST_POP, PopCurve, PopFigures};

/// What came of a study of pops.
pub struct PopReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// Name of the generator that drew.
    pub machine: String,
    /// Number of the first frame.
    pub first: u64,
    /// Time of each frame (s).
    pub times: Vec<f64>,
    /// Curves, the truth first.
    pub curves: Vec<PopCurve>,
}

impl PopReport {
    /// Figures of all curves against the first.
    pub fn figures(&self) -> Vec<PopFigures> {
        self.curves.iter().map(|curve| curve.figures(&self.curves[0], self.first)).collect()
    }

    /// Leaves `pops.json`, `pops.csv` with every frame, `pops.md` and a plot in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        write(folder, "pops", &self.json(), &self.csv(), &self.page())?;
        self.plot(folder)
    }

    /// A document of schema `lunoid.study-pops/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-pops/1",
            "commit": self.commit,
            "title": self.title,
            "machine": self.machine,
            "first_frame": self.first,
            "frames": self.times.len(),
            "least_pop_m": LEAST_POP,
            "curves": self.figures(),
        })
    }

    /// Returns the outcome as a table for people.
    pub fn text(&self) -> String {
        format!("{}\n\n{}", self.facts(), text::table(&self.table()))
    }

    /// Frames of its curves.
    pub fn frames(&self) -> Range<u64> {
        self.first..self.first + self.times.len() as u64
    }

    /// What was drawn by whom, in one line.
    pub fn facts(&self) -> String {
        let Range { start, end } = self.frames();
        format!("{}, {}, frames {start}..{end}, commit {}", self.title, self.machine, self.commit)
    }

    fn page(&self) -> String {
        format!("{}.\n\n{}", self.facts(), text::markdown(&self.table()))
    }

    fn table(&self) -> Vec<Vec<String>> {
        let head = [
            "curve",
            "rms off the finest (m)",
            "largest excess jump (m)",
            "at frame",
            "largest pop (m)",
            "at frame",
            "pops",
        ];
        let told = |found: Option<AtFrame>| match found {
            Some(found) => [format!("{:.9}", found.metres), found.frame.to_string()],
            None => ["-", "-"].map(str::to_owned),
        };
        let row = |figures: PopFigures| {
            let [jump, jump_at] = told(figures.largest_jump);
            let [pop, pop_at] = told(figures.largest_pop);
            let rms = format!("{:.9}", figures.rms_m);
            vec![figures.name, rms, jump, jump_at, pop, pop_at, figures.pops.to_string()]
        };
        [head.map(str::to_owned).into()].into_iter().chain(self.figures().into_iter().map(row)).collect()
    }

    fn csv(&self) -> String {
        let names = self
            .curves
            .iter()
            .flat_map(|curve| [format!("{}_distance_m", curve.name), format!("{}_pop_m", curve.name)]);
        let head = ["frame".to_owned(), "t_s".to_owned()].into_iter().chain(names);
        let mut text = format!("{}\n", head.collect::<Vec<_>>().join(","));
        for (index, time) in self.times.iter().enumerate() {
            let cells = self.curves.iter().flat_map(|curve| [curve.distances[index], curve.pops[index]]);
            let cells: Vec<String> = cells.map(|metres| metres.to_string()).collect();
            text += &format!("{},{time},{}\n", self.first + index as u64, cells.join(","));
        }
        text
    }

    /// What levels are off the finest ground, and their pops, over time.
    fn plot(&self, folder: &Path) -> Result<(), ReportError> {
        let off: Vec<Vec<f64>> = self.curves[1..].iter().map(|curve| curve.off(&self.curves[0])).collect();
        let trace = |name, y| Trace { name, x: &self.times, y };
        let named = || self.curves[1..].iter().map(|curve| curve.name.as_str());
        let mut panels = vec![Panel {
            axis: Axis::new("off the finest ground (m)"),
            traces: named().zip(&off).map(|(name, y)| trace(name, y)).collect(),
        }];
        // A generator without levels has no pops.
        let has_pops = |curve: &&PopCurve| curve.pops.iter().any(|pop| pop.is_finite());
        let popping: Vec<&PopCurve> = self.curves[1..].iter().filter(has_pops).collect();
        if !popping.is_empty() {
            panels.push(Panel {
                axis: Axis::new("pop (m)"),
                traces: popping.into_iter().map(|curve| trace(&curve.name, &curve.pops)).collect(),
            });
        }
        let x = Axis::new("time (s)");
        let look =
            TraceLook { facts: vec![self.facts()], ..TraceLook::titled("Distance along the view axis") };
        save(folder, "pops", trace_picture(&x, &panels, &[], &look))
    }
}
