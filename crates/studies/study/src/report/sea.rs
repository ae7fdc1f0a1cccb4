//! A sea of false normals beside a sea of waves: as text, document, tables and a plot.

use std::path::Path;

use ::plots::{Axis, Panel, Trace, TraceLook, trace_picture};
use serde_json::{Value, json};

use super::folder::{ReportError, save, write};
use crate::sea::{SeaFigures, WaveTheory};

/// What came of a study of a sea.
pub struct SeaReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// First and last frame, and how many of them are looked at.
    pub frames: [u64; 3],
    /// Number of pixels that are looked at.
    pub pixels: usize,
    /// Step of the spectra (Hz).
    pub step_hz: f64,
    /// Figures of the imitation and of the waves.
    pub figures: [SeaFigures; 2],
    /// What theory says of the waves.
    pub theory: WaveTheory,
}

impl SeaReport {
    /// Leaves `sea.json`, `sea.csv` with the spectra, `sea.md` and a plot in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        let page = format!("{}.\n\n{}", self.facts(), text::markdown(&self.table()));
        write(folder, "sea", &self.json(), &self.csv(), &page)?;
        self.plot(folder)
    }

    /// A document of schema `lunoid.study-sea/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-sea/1",
            "commit": self.commit,
            "title": self.title,
            "frames": self.frames,
            "pixels": self.pixels,
            "step_hz": self.step_hz,
            "imitation": self.figures[0],
            "waves": self.figures[1],
            "spread_of_theory": self.theory.spread(),
        })
    }

    /// Returns the outcome as a table for people.
    pub fn text(&self) -> String {
        format!("{}\n\n{}", self.facts(), text::table(&self.table()))
    }

    fn facts(&self) -> String {
        let [first, last, count] = self.frames;
        format!(
            "{}, {count} frames from {first} to {last}, {} pixels, commit {}",
            self.title, self.pixels, self.commit
        )
    }

    fn table(&self) -> Vec<Vec<String>> {
        let head = ["sea", "drawn by", "mean", "contrast", "spread", "in time", "peak (Hz)", "mean (Hz)"];
        let row = |sea: &str, of: &SeaFigures| {
            let figures = [of.mean, of.contrast, of.spread, of.spread_in_time, of.peak_hz, of.mean_hz];
            let cells = figures.map(|figure| format!("{figure:.4}"));
            [sea.into(), of.name.clone()].into_iter().chain(cells).collect()
        };
        let [imitation, waves] = &self.figures;
        let spread = format!("{:.4}", self.theory.spread());
        let theory = ["theory of the waves", "", "", "", &spread, &spread, "", ""].map(str::to_owned);
        vec![
            head.map(str::to_owned).into(),
            row("false normals", imitation),
            row("waves", waves),
            theory.into(),
        ]
    }

    /// Frequency of a bin (Hz).
    fn hertz(&self, bin: usize) -> f64 {
        (bin + 1) as f64 * self.step_hz
    }

    fn csv(&self) -> String {
        let [imitation, waves] = &self.figures;
        let row = |bin: usize| {
            let hertz = self.hertz(bin);
            let [normals, waves] = [imitation.spectrum[bin], waves.spectrum[bin]];
            format!("{hertz},{normals},{waves},{}\n", self.theory.at(hertz))
        };
        let rows: String = (0..imitation.spectrum.len()).map(row).collect();
        format!("frequency_hz,false_normals_per_hz,waves_per_hz,theory_per_hz\n{rows}")
    }

    /// Spectra of both seas and of theory over frequency.
    fn plot(&self, folder: &Path) -> Result<(), ReportError> {
        let x: Vec<f64> = (0..self.figures[0].spectrum.len()).map(|bin| self.hertz(bin)).collect();
        let theory: Vec<f64> = x.iter().map(|&hertz| self.theory.at(hertz)).collect();
        let trace = |name, y| Trace { name, x: &x, y };
        let [imitation, waves] = &self.figures;
        let traces = vec![
            trace("false normals", &imitation.spectrum),
            trace("waves", &waves.spectrum),
            trace("theory of the waves", &theory),
        ];
        let most = traces.iter().flat_map(|trace| trace.y).fold(0.0, |most: f64, power| most.max(*power));
        let axis = Axis::new("power of light over its mean (1/Hz)");
        let axis = axis.logarithmic().over([most.max(1e-300) * 1e-6, most.max(1e-300) * 2.0]);
        let panels = [Panel { axis, traces }];
        let look = TraceLook { facts: vec![self.facts()], ..TraceLook::titled("Light of a sea over time") };
        save(folder, "sea", trace_picture(&Axis::new("frequency (Hz)"), &panels, &[], &look))
    }
}
