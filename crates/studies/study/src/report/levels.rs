//! Levels of detail against what is lost: as text, document, tables and plots.

use std::path::Path;

use ::plots::{PointSeries, TraceLook, ladder_picture};
use serde_json::{Value, json};

use super::folder::{ReportError, save, write};
use crate::levels::{LevelFigures, LevelLadder, LevelRung};

/// Size of a plot (pixels).
const SIZE: [u32; 2] = [860, 460];

/// What came of a study of levels.
pub struct LevelReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// Name of the generator that drew.
    pub machine: String,
    /// Numbers of the frames.
    pub frames: Vec<u64>,
    /// Turns that were timed.
    pub repetitions: u32,
    /// Ladders, with the rungs on a front marked.
    pub ladders: Vec<LevelLadder>,
}

impl LevelReport {
    /// Leaves `levels.json`, `levels.csv`, `levels.md` and two plots in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        write(folder, "levels", &self.json(), &self.csv(), &self.page())?;
        let time = |figures: &LevelFigures| 1e3 * figures.time_s[0];
        let on_time = |rung: &LevelRung| rung.is_on_time_front;
        self.plot(folder, "levels-time", "time (ms a frame, median)", &time, &on_time)?;
        let triangles = |figures: &LevelFigures| figures.triangles;
        let on_triangles = |rung: &LevelRung| rung.is_on_triangle_front;
        self.plot(folder, "levels-triangles", "triangles a frame", &triangles, &on_triangles)
    }

    /// A document of schema `lunoid.study-levels/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-levels/1",
            "commit": self.commit,
            "title": self.title,
            "machine": self.machine,
            "frames": self.frames,
            "repetitions": self.repetitions,
            "threads": 1,
            "ladders": self.ladders,
        })
    }

    /// Returns the outcome as tables for people.
    pub fn text(&self) -> String {
        let ladders = self
            .ladders
            .iter()
            .map(|ladder| format!("\n{}: {}\n{}", ladder.name, ladder.what, text::table(&table(ladder))));
        format!("{}\n{}{}\n", self.facts(), ladders.collect::<String>(), FRONTS)
    }

    fn facts(&self) -> String {
        format!(
            "{}, {}, {}, {} turns of one thread of this computer, commit {}",
            self.title,
            self.machine,
            text::named_frames(&self.frames),
            self.repetitions,
            self.commit
        )
    }

    fn page(&self) -> String {
        let ladders = self.ladders.iter().map(|ladder| {
            format!("\n### {}: {}\n\n{}", ladder.name, ladder.what, text::markdown(&table(ladder)))
        });
        format!("{}.\n{}\n{FRONTS}\n", self.facts(), ladders.collect::<String>())
    }

    fn csv(&self) -> String {
        let mut text = String::from(
            "ladder,rung,tiles,vertices,triangles,posts,rms_m,worst_m,rms_px,worst_px,moved_rms_px,moved_worst_px,\
             time_median_s,time_min_s,time_max_s,on_time_front,on_triangle_front,refused\n",
        );
        for (ladder, rung) in
            self.ladders.iter().flat_map(|ladder| ladder.rungs.iter().map(move |rung| (ladder, rung)))
        {
            let cells = match &rung.figures {
                Some(figures) => numbers(figures).map(|number| number.to_string()).join(","),
                None => ",".repeat(12),
            };
            let refused = rung.refused.as_deref().unwrap_or_default().replace('"', "\"\"");
            let fronts = format!("{},{}", rung.is_on_time_front, rung.is_on_triangle_front);
            text += &format!("{},{},{cells},{fronts},\"{refused}\"\n", ladder.name, rung.label);
        }
        text
    }

    /// Error against a cost, with the front.
    fn plot(
        &self,
        folder: &Path,
        name: &str,
        x: &str,
        cost: &dyn Fn(&LevelFigures) -> f64,
        is_on_front: &dyn Fn(&LevelRung) -> bool,
    ) -> Result<(), ReportError> {
        // A logarithm has no place for the finest ground, which has no error.
        let point = |rung: &LevelRung| {
            let figures = rung.figures.filter(|figures| figures.pixels.rms > 0.0)?;
            Some([cost(&figures), figures.pixels.rms])
        };
        let all: Vec<PointSeries<'_>> = self
            .ladders
            .iter()
            .map(|ladder| PointSeries {
                name: ladder.name,
                points: ladder.rungs.iter().filter_map(point).collect(),
                labels: ladder
                    .rungs
                    .iter()
                    .filter(|rung| point(rung).is_some())
                    .map(|rung| rung.label.as_str())
                    .collect(),
                joined: true,
            })
            .collect();
        if all.iter().all(|series| series.points.is_empty()) {
            return Ok(());
        }
        let rungs = self.ladders.iter().flat_map(|ladder| &ladder.rungs);
        let mut front: Vec<[f64; 2]> = rungs.filter(|rung| is_on_front(rung)).filter_map(point).collect();
        front.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let look = TraceLook {
            facts: vec![self.facts()],
            width: SIZE[0],
            height: SIZE[1],
            ..TraceLook::titled("Levels of detail against what is lost")
        };
        let axes = [x, "rms off the finest mesh (pixels)"];
        save(folder, name, ladder_picture(axes, &all, &front, &[], &look))
    }
}

/// What the marks of a table mean.
const FRONTS: &str = "\nOn a front is what no other rung beats in both rms pixels and time (t), or rms pixels and triangles (n).";

/// All figures of a rung, in the order of the columns of the CSV file.
fn numbers(figures: &LevelFigures) -> [f64; 13] {
    let LevelFigures { tiles, vertices, triangles, posts, metres, pixels, moved_px, time_s } = figures;
    let [median, least, most] = *time_s;
    [
        *tiles,
        *vertices,
        *triangles,
        *posts,
        metres.rms,
        metres.worst,
        pixels.rms,
        pixels.worst,
        moved_px.rms,
        moved_px.worst,
        median,
        least,
        most,
    ]
}

/// A ladder as rows, the first with the names of the columns.
fn table(ladder: &LevelLadder) -> Vec<Vec<String>> {
    let head = [
        ladder.name,
        "triangles",
        "rms (m)",
        "worst (m)",
        "rms (px)",
        "worst (px)",
        "moved, rms (px)",
        "worst (px)",
        "ms a frame",
        "front",
    ];
    let row = |rung: &LevelRung| {
        let Some(figures) = &rung.figures else {
            return vec![
                rung.label.clone(),
                format!("refused: {}", rung.refused.as_deref().unwrap_or_default()),
            ];
        };
        let LevelFigures { metres, pixels, moved_px, .. } = figures;
        let front = [(rung.is_on_time_front, "t"), (rung.is_on_triangle_front, "n")];
        let front = front.into_iter().filter(|(is_on, _)| *is_on).map(|(_, mark)| mark);
        let mut cells = vec![rung.label.clone(), format!("{:.0}", figures.triangles)];
        cells.extend([metres.rms, metres.worst].map(|metres| format!("{metres:.3}")));
        cells.extend(
            [pixels, moved_px]
                .into_iter()
                .flat_map(|size| [size.rms, size.worst].map(|pixels| format!("{pixels:.4}"))),
        );
        cells.push(format!("{:.1}", 1e3 * figures.time_s[0]));
        cells.push(front.collect::<Vec<_>>().join(" "));
        cells
    };
    [head.map(str::to_owned).into()].into_iter().chain(ladder.rungs.iter().map(row)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::levels::Size;

    #[test]
    fn every_rung_has_its_line_in_every_table() {
        let size = Size { rms: 0.25, worst: 2.0 };
        let figures = LevelFigures {
            tiles: 4.0,
            vertices: 90.0,
            triangles: 128.0,
            posts: 64.0,
            metres: size,
            pixels: size,
            moved_px: size,
            time_s: [0.02, 0.01, 0.03],
        };
        let rung = LevelRung {
            label: "2".into(),
            figures: Some(figures),
            refused: None,
            is_on_time_front: true,
            is_on_triangle_front: false,
        };
        let refused = LevelRung {
            label: "9".into(),
            figures: None,
            refused: Some("7 at \"most\"".into()),
            ..rung.clone()
        };
        let report = LevelReport {
            commit: "none".into(),
            title: "Ground".into(),
            machine: "tiles".into(),
            frames: vec![3, 5],
            repetitions: 2,
            ladders: vec![LevelLadder { name: "levels", what: "how many", rungs: vec![rung, refused] }],
        };
        let text = report.text();
        assert!(text.contains("128") && text.contains("20.0") && text.contains("refused: 7 at"), "{text}");
        let csv = report.csv();
        let lines: Vec<&str> = csv.lines().collect();
        assert_eq!(lines[1], "levels,2,4,90,128,64,0.25,2,0.25,2,0.25,2,0.02,0.01,0.03,true,false,\"\"");
        assert_eq!(lines[2].matches(',').count(), lines[0].matches(',').count(), "{csv}");
        assert_eq!(report.json()["ladders"][0]["rungs"][0]["pixels"]["worst"], 2.0);
        let folder = tempfile::tempdir().unwrap();
        report.leave(folder.path()).unwrap();
        assert!(
            folder.path().join("levels-triangles.svg").exists() && folder.path().join("levels.md").exists()
        );
    }
}
