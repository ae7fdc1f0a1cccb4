//! Corners that are followed while levels change: as text, document, tables and plots.

use std::path::Path;

use ::plots::{Axis, Panel, Trace, TraceLook, trace_picture};
use serde::Serialize;
use serde_json::{Value, json};

use super::folder::{ReportError, save, write};
use crate::tracks::{FrameTracks, JUMP, MOSTLY, TrackFigures, TrackOutcome, WITHIN};

/// What came of a study of tracks.
pub struct TrackReport {
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
    /// The camera stands at the middle frame while levels go on: one outcome a way.
    pub held: Vec<TrackOutcome>,
    /// The camera flies: one outcome a way.
    pub flown: Vec<TrackOutcome>,
    /// The camera flies: one outcome a rung of each ladder.
    pub ladders: Vec<LadderTracks>,
}

/// Tracks of a flight over the rungs of a ladder, the coarsest first.
pub struct LadderTracks {
    /// Name of the ladder.
    pub name: &'static str,
    /// What its rungs are, in words.
    pub what: &'static str,
    /// Outcomes of the rungs that can be drawn.
    pub rungs: Vec<TrackOutcome>,
}

/// A ladder in the document.
#[derive(Serialize)]
struct LadderFigures {
    name: &'static str,
    what: &'static str,
    coarsest_within: Option<String>,
    rungs: Vec<TrackFigures>,
}

impl TrackReport {
    /// Leaves `tracks.json`, `tracks.csv` with every frame, `tracks.md` and a plot in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        write(folder, "tracks", &self.json(), &self.csv(), &self.page())?;
        self.plot(folder)
    }

    /// A document of schema `lunoid.study-tracks/1`.
    pub fn json(&self) -> Value {
        let figures = |outcomes: &[TrackOutcome]| self.figures(outcomes);
        let ladder = |ladder: &LadderTracks| LadderFigures {
            name: ladder.name,
            what: ladder.what,
            coarsest_within: self.coarsest_within(ladder),
            rungs: figures(&ladder.rungs),
        };
        json!({
            "schema": "lunoid.study-tracks/1",
            "commit": self.commit,
            "title": self.title,
            "machine": self.machine,
            "first_frame": self.first,
            "frames": self.times.len(),
            "held_at_frame": self.middle(),
            "jump_above_px": JUMP,
            "within_px": WITHIN,
            "share_that_must_stay": MOSTLY,
            "held": figures(&self.held),
            "flown": figures(&self.flown),
            "ladders": self.ladders.iter().map(ladder).collect::<Vec<_>>(),
        })
    }

    /// Returns the outcome as tables for people.
    pub fn text(&self) -> String {
        let parts = self
            .parts()
            .into_iter()
            .map(|(title, rows, remark)| format!("\n{title}\n{}{remark}", text::table(&rows)));
        format!("{}\n{}", self.facts(), parts.collect::<String>())
    }

    fn page(&self) -> String {
        let parts = self.parts().into_iter().map(|(title, rows, remark)| {
            let apart = if remark.is_empty() { "" } else { "\n" };
            format!("\n### {title}\n\n{}{apart}{remark}", text::markdown(&rows))
        });
        format!("{}.\n{}", self.facts(), parts.collect::<String>())
    }

    /// All tables: title, rows, and a remark below.
    fn parts(&self) -> Vec<(String, Vec<Vec<String>>, String)> {
        let held = format!("The camera stands at frame {}, levels go on", self.middle());
        let mut parts = vec![
            (held, self.table("way", &self.held), String::new()),
            ("The camera flies".to_owned(), self.table("way", &self.flown), String::new()),
        ];
        parts.extend(self.ladders.iter().map(|ladder| {
            let percent = 100.0 * MOSTLY;
            let remark = match self.coarsest_within(ladder) {
                Some(rung) => format!(
                    "{rung} is the coarsest rung on which {percent} % as many tracks stay within {WITHIN} px as on the finest.\n"
                ),
                None => "No track was begun on the finest rung.\n".to_owned(),
            };
            let title = format!("The camera flies, {}: {}", ladder.name, ladder.what);
            (title, self.table(ladder.name, &ladder.rungs), remark)
        }));
        parts
    }

    fn middle(&self) -> u64 {
        self.first + self.times.len() as u64 / 2
    }

    fn facts(&self) -> String {
        let last = self.first + self.times.len() as u64;
        format!("{}, {}, frames {}..{last}, commit {}", self.title, self.machine, self.first, self.commit)
    }

    fn figures(&self, outcomes: &[TrackOutcome]) -> Vec<TrackFigures> {
        outcomes.iter().map(|outcome| outcome.figures(self.first)).collect()
    }

    /// The coarsest rung on which, as on all finer ones, nearly as many tracks stay within [`WITHIN`] as on the finest rung.
    fn coarsest_within(&self, ladder: &LadderTracks) -> Option<String> {
        let figures = self.figures(&ladder.rungs);
        let least = MOSTLY * figures.last()?.share_within?;
        let stays = |figures: &&TrackFigures| figures.share_within.is_some_and(|share| share >= least);
        figures.iter().rev().take_while(stays).last().map(|figures| figures.name.clone())
    }

    fn table(&self, name: &str, outcomes: &[TrackOutcome]) -> Vec<Vec<String>> {
        let head = [
            name,
            "tracks",
            "median frames",
            "mean",
            "broken",
            "left",
            "rms off (px)",
            "worst (px)",
            "largest step (px)",
            "at frame",
            "jumps",
            "in frames",
            "level changes in frames",
            "stay within half a pixel",
        ];
        let row = |figures: TrackFigures| {
            let [step, at] = match figures.largest_step {
                Some(step) => [format!("{:.4}", step.pixels), step.frame.to_string()],
                None => ["-", "-"].map(str::to_owned),
            };
            let share = figures.share_within.map_or("-".into(), |share| format!("{:.1} %", 100.0 * share));
            vec![
                figures.name,
                figures.begun.to_string(),
                figures.median_frames.to_string(),
                format!("{:.1}", figures.mean_frames),
                figures.broken.to_string(),
                figures.left.to_string(),
                format!("{:.4}", figures.rms_px),
                format!("{:.4}", figures.worst_px),
                step,
                at,
                figures.jumps.to_string(),
                figures.jump_frames.len().to_string(),
                figures.level_change_frames.to_string(),
                share,
            ]
        };
        let rows = self.figures(outcomes).into_iter().map(row);
        [head.map(str::to_owned).into()].into_iter().chain(rows).collect()
    }

    fn csv(&self) -> String {
        let mut text = String::from(
            "test,way,frame,t_s,tracks,broken,left,rms_px,worst_px,largest_step_px,jumps,level_changes\n",
        );
        let own = [("held", &self.held), ("flown", &self.flown)];
        let ladders = self.ladders.iter().map(|ladder| (ladder.name, &ladder.rungs));
        for (test, outcomes) in own.into_iter().chain(ladders) {
            for outcome in outcomes {
                for ((frame, time), found) in (self.first + 1..).zip(&self.times[1..]).zip(&outcome.frames) {
                    let FrameTracks { alive, broken, left, worst, step, jumps, level_changes, .. } = found;
                    let rms = found.rms();
                    text += &format!(
                        "{test},{},{frame},{time},{alive},{broken},{left},{rms},{worst},{step},{jumps},{level_changes}\n",
                        outcome.name
                    );
                }
            }
        }
        text
    }

    /// The largest step of a track with a camera that stands; what tracks are off and how many are left with one that flies.
    fn plot(&self, folder: &Path) -> Result<(), ReportError> {
        let times = &self.times[1..];
        let curves = |outcomes: &[TrackOutcome], of: &dyn Fn(&FrameTracks) -> f64| -> Vec<Vec<f64>> {
            outcomes.iter().map(|outcome| outcome.frames.iter().map(of).collect()).collect()
        };
        let shown = [
            ("held: largest step (px)", &self.held, curves(&self.held, &|found| found.step)),
            ("flown: largest step (px)", &self.flown, curves(&self.flown, &|found| found.step)),
            ("flown: rms off (px)", &self.flown, curves(&self.flown, &FrameTracks::rms)),
        ];
        let panels: Vec<Panel<'_>> = shown
            .iter()
            .map(|(label, outcomes, curves)| Panel {
                axis: Axis::new(*label),
                traces: outcomes
                    .iter()
                    .zip(curves)
                    .map(|(outcome, y)| Trace { name: &outcome.name, x: times, y })
                    .collect(),
            })
            .collect();
        let look = TraceLook {
            facts: vec![self.facts()],
            ..TraceLook::titled("Corners that are followed while levels change")
        };
        save(folder, "tracks", trace_picture(&Axis::new("time (s)"), &panels, &[], &look))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tracks::{Lost, Track};

    fn outcome(name: &str, worst: [f64; 4]) -> TrackOutcome {
        let track = |worst: f64| {
            let mut track = Track::begun([5, 5]);
            (track.length, track.worst) = (3, worst);
            track.lost = (worst > 9.0).then_some(Lost::Broken);
            track
        };
        let frame = FrameTracks {
            alive: 2,
            squares: 0.5,
            worst: worst[0],
            step: 0.25,
            jumps: 1,
            ..FrameTracks::default()
        };
        TrackOutcome {
            name: name.into(),
            tracks: worst.map(track).into(),
            frames: vec![FrameTracks { step: 0.125, jumps: 0, ..frame }, frame],
        }
    }

    fn report() -> TrackReport {
        let rungs = vec![
            outcome("3", [0.6, 0.1, 0.1, 0.1]),
            outcome("2", [0.4, 0.1, 0.1, 0.5]),
            outcome("1", [0.1; 4]),
        ];
        TrackReport {
            commit: "none".into(),
            title: "Ground".into(),
            machine: "tiles".into(),
            first: 7,
            times: vec![0.0, 0.5, 1.0],
            held: vec![outcome("switching", [0.1, 0.2, 0.3, 9.5])],
            flown: vec![outcome("morphing", [0.1; 4])],
            ladders: vec![LadderTracks { name: "one-level", what: "levels", rungs }],
        }
    }

    #[test]
    fn figures_are_those_of_the_tracks() {
        let told = report().json();
        let held = &told["held"][0];
        assert_eq!(
            (held["begun"].as_u64(), held["broken"].as_u64(), told["held_at_frame"].as_u64()),
            (Some(4), Some(1), Some(8))
        );
        assert_eq!((held["rms_px"].as_f64(), held["share_within"].as_f64()), (Some(0.5), Some(0.75)));
        assert_eq!((held["jumps"].as_u64(), held["jump_frames"][0].as_u64()), (Some(1), Some(9)));
        assert_eq!(held["largest_step"]["frame"].as_u64(), Some(9));
        // A track that is off by exactly half a pixel stays within it.
        assert_eq!(told["ladders"][0]["coarsest_within"], "2");
    }

    #[test]
    fn every_frame_of_every_way_has_its_line() {
        let report = report();
        assert_eq!(report.csv().lines().count(), 1 + 5 * 2);
        assert!(report.csv().contains("\none-level,2,9,1,2,0,0,0.5,0.4,0.25,1,0\n"), "{}", report.csv());
        assert!(report.text().contains("2 is the coarsest rung on which 95 % as many tracks"));
        let folder = tempfile::tempdir().unwrap();
        report.leave(folder.path()).unwrap();
        assert!(folder.path().join("tracks.svg").exists() && folder.path().join("tracks.md").exists());
    }
}
