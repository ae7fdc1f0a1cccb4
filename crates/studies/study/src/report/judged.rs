//! A generator against the judge, frame by frame: as text, document, tables and a plot.

use std::path::Path;

use ::plots::{Axis, Panel, Trace, TraceLook, trace_picture};
use serde_json::{Value, json};

use super::folder::{ReportError, save, write};
use crate::judged::JudgedFrame;

/// What came of a study of frames against the judge.
pub struct JudgedReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// Name of the generator that drew.
    pub machine: String,
    /// Name of the judge.
    pub judge: String,
    /// Frames in their order, at least one.
    pub frames: Vec<JudgedFrame>,
}

/// Heads of the columns that a frame has in the tables.
const COLUMNS: [&str; 10] = [
    "frame",
    "time (s)",
    "distance (m)",
    "rms (m)",
    "worst (m)",
    "column",
    "line",
    "rms (grey levels)",
    "worst (grey levels)",
    "outline (pixels)",
];

impl JudgedReport {
    /// Leaves `judge.json`, `judge.csv` and `judge.md` with every frame, and a plot, in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        let page = format!("{}.\n\n{}", self.facts(), text::markdown(&self.table()));
        write(folder, "judge", &self.json(), &self.csv(), &page)?;
        self.plot(folder)
    }

    /// A document of schema `lunoid.study-judge/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-judge/1",
            "commit": self.commit,
            "title": self.title,
            "machine": self.machine,
            "judge": self.judge,
            "frames": self.frames,
        })
    }

    /// Returns the outcome as a table for people, a row a frame; then the worst of all.
    pub fn text(&self) -> String {
        format!("{}\n\n{}\n{}\n", self.facts(), text::table(&self.table()), self.worst())
    }

    /// What was drawn by whom, in one line.
    fn facts(&self) -> String {
        let frames = self.frames.len();
        format!(
            "{}, {} against {}, {frames} frames, commit {}",
            self.title, self.machine, self.judge, self.commit
        )
    }

    /// The worst frames, in words.
    fn worst(&self) -> String {
        let most = |what: &str, unit: &str, of: fn(&JudgedFrame) -> f64| {
            let frame = self.frames.iter().max_by(|a, b| of(a).total_cmp(&of(b)));
            frame.map(|frame| format!("{what} {} {unit} in frame {}", told(of(frame)), frame.frame))
        };
        let all = [
            most("largest rms", "m", |frame| frame.metres.rms),
            most("worst", "m", |frame| frame.metres.worst),
            most("largest rms", "grey levels", |frame| frame.greys.rms),
            most("worst", "grey levels", |frame| frame.greys.worst),
        ];
        all.into_iter().flatten().collect::<Vec<_>>().join("; ")
    }

    fn rows(&self) -> impl Iterator<Item = [String; 10]> {
        self.frames.iter().map(|of| {
            [
                of.frame.to_string(),
                of.t_s.to_string(),
                told(of.distance_m),
                told(of.metres.rms),
                told(of.metres.worst),
                of.worst_at[0].to_string(),
                of.worst_at[1].to_string(),
                told(of.greys.rms),
                told(of.greys.worst),
                of.outline.to_string(),
            ]
        })
    }

    fn table(&self) -> Vec<Vec<String>> {
        [COLUMNS.map(str::to_owned).to_vec()].into_iter().chain(self.rows().map(Vec::from)).collect()
    }

    fn csv(&self) -> String {
        let head = "frame,t_s,distance_m,rms_m,worst_m,column,line,rms_greys,worst_greys,outline\n";
        self.frames.iter().fold(head.to_owned(), |text, of| {
            let JudgedFrame {
                frame, t_s, distance_m, metres, worst_at: [column, line], greys, outline, ..
            } = of;
            format!(
                "{text}{frame},{t_s},{distance_m},{},{},{column},{line},{},{},{outline}\n",
                metres.rms, metres.worst, greys.rms, greys.worst
            )
        })
    }

    /// Errors of distance and of light over time.
    fn plot(&self, folder: &Path) -> Result<(), ReportError> {
        let of = |value: fn(&JudgedFrame) -> f64| self.frames.iter().map(value).collect::<Vec<f64>>();
        let times = of(|frame| frame.t_s);
        let metres = [of(|frame| frame.metres.worst), of(|frame| frame.metres.rms)];
        let greys = [of(|frame| frame.greys.worst), of(|frame| frame.greys.rms)];
        let panels =
            [panel("distance off (m)", &times, &metres), panel("light off (grey levels)", &times, &greys)];
        let title = format!("{} against {}", self.machine, self.judge);
        let look = TraceLook { facts: vec![self.facts()], ..TraceLook::titled(&title) };
        save(folder, "judge", trace_picture(&Axis::new("time (s)"), &panels, &[], &look))
    }
}

/// The worst and the rms of each frame over its time (s).
fn panel<'a>(title: &str, times: &'a [f64], values: &'a [Vec<f64>; 2]) -> Panel<'a> {
    let traces = ["worst", "rms"].into_iter().zip(values);
    Panel { axis: Axis::new(title), traces: traces.map(|(name, y)| Trace { name, x: times, y }).collect() }
}

/// A figure with the digits that tell.
fn told(figure: f64) -> String {
    format!("{figure:.4}")
}
