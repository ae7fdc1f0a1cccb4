//! What is left out, what that saves, what remains: as text, document, tables and a plot.

use std::path::Path;

use ::plots::{Bars, TraceLook, bar_picture};
use serde_json::{Value, json};
use text::rate;

use super::folder::{ReportError, save, write};
use crate::economy::{EconomyOutcome, LeftOut, ModeOutcome, Waste};

/// What came of a study of economy.
pub struct EconomyReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// Frames that were looked at.
    pub frames: Vec<u64>,
    /// Number of threads that drew.
    pub threads: usize,
    /// What is left out, what that saves, what remains.
    pub found: EconomyOutcome,
}

fn percent(some: u64, all: u64) -> String {
    format!("{:.1} %", 100.0 * some as f64 / all.max(1) as f64)
}

impl EconomyReport {
    /// Leaves `economy.json`, `economy.csv`, `economy.md` and a plot in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        write(folder, "economy", &self.json(), &self.csv(), &self.page())?;
        self.plot(folder)
    }

    /// A document of schema `lunoid.study-economy/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-economy/1",
            "commit": self.commit,
            "title": self.title,
            "frames": self.frames,
            "threads": self.threads,
            "bits_are_equal": self.found.holds(),
            "economy": self.found,
        })
    }

    fn facts(&self) -> String {
        let commit = &self.commit;
        format!(
            "{}, {}, {} threads, commit {commit}",
            self.title,
            text::named_frames(&self.frames),
            self.threads
        )
    }

    /// Titles and tables, each with the names of its columns first.
    fn tables(&self) -> [(&'static str, Vec<Vec<String>>); 3] {
        [
            ("Time and bits", self.modes()),
            ("What is left out", self.left_out()),
            ("What is computed and touches no pixel", self.waste()),
        ]
    }

    fn modes(&self) -> Vec<Vec<String>> {
        let base = self.found.modes[1].cpu_s;
        let lossless = &self.found.modes[1].blake3;
        let head =
            ["machine", "ms a frame", "least", "most", "processor, ms", "against lossless", "bits", "pixels"];
        let row = |mode: &ModeOutcome| {
            let [median, least, most] = mode.time_s.map(|time| rate(1e3 * time));
            let cpu = mode.cpu_s.map_or_else(|| "-".to_owned(), |cpu| rate(1e3 * cpu));
            let share = mode.cpu_s.zip(base).map(|(cpu, base)| 100.0 * (cpu / base - 1.0));
            let against = share.map_or_else(|| "-".to_owned(), |share| format!("{share:+.1} %"));
            let [rms, max] = mode.off;
            let bits = match (mode.blake3 == *lossless, mode.claims_equal) {
                (true, _) => "equal".to_owned(),
                (false, true) => format!("NOT EQUAL: RMS {rms:.1e}"),
                (false, false) => format!("RMS {rms:.1e}, at most {max:.2}"),
            };
            vec![mode.name.clone(), median, least, most, cpu, against, bits, mode.blake3[..12].to_owned()]
        };
        [head.map(str::to_owned).into()].into_iter().chain(self.found.modes.iter().map(row)).collect()
    }

    fn left_out(&self) -> Vec<Vec<String>> {
        let head = ["level", "block", "what", "left out", "of", "share", "weight", "why"];
        let row = |left: &LeftOut| {
            let [some, all, share] = match left.count {
                Some([some, all]) => [some.to_string(), all.to_string(), percent(some, all)],
                None => ["all", "", ""].map(str::to_owned),
            };
            let [level, block] = [left.level.name(), left.block].map(str::to_owned);
            vec![level, block, left.what.clone(), some, all, share, left.weight.clone(), left.why.clone()]
        };
        [head.map(str::to_owned).into()].into_iter().chain(self.found.left_out.iter().map(row)).collect()
    }

    fn waste(&self) -> Vec<Vec<String>> {
        let head = ["block", "what", "wasted", "of", "share", "why it is done"];
        let row = |waste: &Waste| {
            let [some, all] = [waste.wasted, waste.of];
            let [block, what, why] = [waste.block, waste.what, waste.why].map(str::to_owned);
            vec![block, what, some.to_string(), all.to_string(), percent(some, all), why]
        };
        [head.map(str::to_owned).into()].into_iter().chain(self.found.waste.iter().map(row)).collect()
    }

    /// Returns the outcome as tables for people.
    pub fn text(&self) -> String {
        let tables = self.tables();
        let text = tables.iter().map(|(title, rows)| format!("\n{title}\n{}", text::table(rows)));
        format!("{}\n{}", self.facts(), text.collect::<String>())
    }

    /// The same as a page of Markdown.
    fn page(&self) -> String {
        let mut text = format!("{}.\n", self.facts());
        for (title, rows) in self.tables() {
            text += &format!("\n### {title}\n\n{}", text::markdown(&rows));
        }
        text
    }

    /// All tables, each row with its table in front.
    fn csv(&self) -> String {
        let quoted = |cell: &String| format!("\"{}\"", cell.replace('"', "\"\""));
        let mut text = String::new();
        for (title, rows) in self.tables() {
            for row in rows {
                let cells: Vec<String> = [title.to_owned()].iter().chain(&row).map(quoted).collect();
                text += &format!("{}\n", cells.join(","));
            }
        }
        text
    }

    /// Samples by what becomes of them.
    fn plot(&self, folder: &Path) -> Result<(), ReportError> {
        let fates = self
            .found
            .waste
            .iter()
            .filter(|waste| waste.block == "machine" && waste.what.starts_with("samples"));
        let panels: Vec<Bars> = fates
            .map(|waste| Bars {
                name: waste.what.to_owned(),
                counts: vec![waste.wasted as f64, (waste.of - waste.wasted) as f64],
                edges: vec!["these | others".to_owned()],
                wrong: 1,
                kinds: ["touch no pixel", "all others"],
            })
            .collect();
        let look = TraceLook {
            title: "What becomes of samples".into(),
            facts: vec![self.facts()],
            width: 600,
            height: 120,
        };
        save(folder, "waste", bar_picture("what becomes of them", "samples", &panels, &look))
    }
}
