//! The light of a lamp over a mission: as text, document, tables and a plot.

use std::path::Path;

use ::plots::{Axis, Panel, Trace, TraceLook, trace_picture};
use serde_json::{Value, json};

use super::folder::{ReportError, save, write};
use crate::lights::{ClosedForm, IN_SIGHT, LightCurve, LightFigures, MOSTLY};

/// What came of a study of a lamp.
pub struct LightReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// Name of the generator that drew.
    pub machine: String,
    /// Name of the light.
    pub light: String,
    /// Number of the first frame.
    pub first: u64,
    /// Time of each frame (s).
    pub times: Vec<f64>,
    /// What it shows with nothing in front.
    pub whole: ClosedForm,
    /// What it shows in each way.
    pub curves: Vec<LightCurve>,
    /// What the generator lacks of the scene, each with the reason.
    pub not_modelled: Vec<String>,
}

impl LightReport {
    /// Figures of all curves.
    pub fn figures(&self) -> Vec<LightFigures> {
        self.curves.iter().map(|curve| curve.figures(&self.whole, self.first)).collect()
    }

    /// Leaves `lights.json`, `lights.csv` with every frame, `lights.md` and a plot in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        write(folder, "lights", &self.json(), &self.csv(), &self.page())?;
        self.plot(folder)
    }

    /// A document of schema `lunoid.study-lights/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-lights/1",
            "commit": self.commit,
            "title": self.title,
            "machine": self.machine,
            "light": self.light,
            "first_frame": self.first,
            "frames": self.times.len(),
            "in_sight_above": IN_SIGHT,
            "shares_above": MOSTLY,
            "ways": self.figures(),
            "not_modelled": self.not_modelled,
        })
    }

    /// Returns the outcome as a table for people.
    pub fn text(&self) -> String {
        let lacking = self.not_modelled.iter().map(|what| format!("not drawn: {what}\n")).collect::<String>();
        format!("{}\n\n{}{}{lacking}", self.facts(), text::table(&self.table()), self.remarks())
    }

    /// What the table does not say, a line each.
    fn remarks(&self) -> String {
        let figures = self.figures();
        let mut text = String::new();
        if figures.iter().all(|figures| figures.in_sight == 0) {
            text += "The light is in sight in no frame.\n";
        } else if figures.iter().any(|figures| figures.share.is_none()) {
            text += &format!("A way without shares never shows more than {MOSTLY} of the closed form.\n");
        }
        text
    }

    fn facts(&self) -> String {
        let last = self.first + self.times.len() as u64;
        format!(
            "{}, light {}, {}, frames {}..{last}, commit {}",
            self.title, self.light, self.machine, self.first, self.commit
        )
    }

    fn page(&self) -> String {
        let remarks = self.remarks();
        let apart = if remarks.is_empty() { "" } else { "\n" };
        format!("{}.\n\n{}{apart}{remarks}", self.facts(), text::markdown(&self.table()))
    }

    fn table(&self) -> Vec<Vec<String>> {
        let head =
            ["way", "frames in sight", "appears", "vanishes", "least share", "mean", "most", "twinkle"];
        let share = |value: Option<f64>| value.map_or("-".into(), |value| format!("{value:.6}"));
        let row = |figures: LightFigures| {
            let LightFigures { name, in_sight, appears, vanishes, share: shares, twinkle } = figures;
            let cells = (0..3).map(|index| share(shares.map(|all| all[index])));
            let turns = [turns(&appears), turns(&vanishes)];
            [name, in_sight.to_string()]
                .into_iter()
                .chain(turns)
                .chain(cells)
                .chain([share(twinkle)])
                .collect()
        };
        [head.map(str::to_owned).into()].into_iter().chain(self.figures().into_iter().map(row)).collect()
    }

    fn csv(&self) -> String {
        let names = self.curves.iter().map(|curve| format!("{}_white_px", curve.name));
        let head = ["frame", "t_s", "distance_m", "closed_form_white_px"].map(str::to_owned);
        let mut text = format!("{}\n", head.into_iter().chain(names).collect::<Vec<_>>().join(","));
        for (index, time) in self.times.iter().enumerate() {
            let known = [*time, self.whole.distances[index], self.whole.light[index]];
            let cells = known.into_iter().chain(self.curves.iter().map(|curve| curve.light[index]));
            // A star has no distance.
            let told = |cell: f64| if cell.is_finite() { cell.to_string() } else { String::new() };
            let cells: Vec<String> = cells.map(told).collect();
            text += &format!("{},{}\n", self.first + index as u64, cells.join(","));
        }
        text
    }

    /// Light, share of the closed form, and the distance that it has, over time.
    fn plot(&self, folder: &Path) -> Result<(), ReportError> {
        let shares: Vec<Vec<f64>> = self.curves.iter().map(|curve| curve.shares(&self.whole)).collect();
        let trace = |name, y| Trace { name, x: &self.times, y };
        let light = self.curves.iter().map(|curve| trace(curve.name.as_str(), &curve.light));
        let parts = self.curves.iter().zip(&shares).map(|(curve, shares)| trace(curve.name.as_str(), shares));
        let mut panels = vec![
            Panel {
                axis: Axis::new("light (pixels of white)"),
                traces: light.chain([trace("closed form", &self.whole.light)]).collect(),
            },
            Panel { axis: Axis::new("share of the closed form"), traces: parts.collect() },
        ];
        if self.whole.distances.iter().any(|distance| distance.is_finite()) {
            let traces = vec![trace("distance", &self.whole.distances)];
            panels.push(Panel { axis: Axis::new("distance (m)"), traces });
        }
        let x = Axis::new("time (s)");
        let look = TraceLook { facts: vec![self.facts()], ..TraceLook::titled("Light of a lamp") };
        save(folder, "lights", trace_picture(&x, &panels, &[], &look))
    }
}

/// The first frames of many.
fn turns(frames: &[u64]) -> String {
    const MOST: usize = 4;
    let told: Vec<String> = frames.iter().take(MOST).map(u64::to_string).collect();
    match frames.len() {
        0 => "-".into(),
        count if count > MOST => format!("{} and {} more", told.join(" "), count - MOST),
        _ => told.join(" "),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_has_no_distance() {
        let report = LightReport {
            commit: "none".into(),
            title: "Star".into(),
            machine: "exact".into(),
            light: "star".into(),
            first: 7,
            times: vec![0.0, 0.5],
            whole: ClosedForm { light: vec![2.0; 2], distances: vec![f64::INFINITY; 2] },
            curves: vec![LightCurve { name: "exact".into(), light: vec![2.0, 0.0] }],
            not_modelled: vec!["lamps: it has none".into()],
        };
        assert!(report.text().ends_with("not drawn: lamps: it has none\n"), "{}", report.text());
        let head = "frame,t_s,distance_m,closed_form_white_px,exact_white_px";
        assert_eq!(report.csv(), format!("{head}\n7,0,,2,2\n8,0.5,,2,0\n"));
        let folder = tempfile::tempdir().unwrap();
        report.leave(folder.path()).unwrap();
        assert!(folder.path().join("lights.svg").exists());
    }

    #[test]
    fn a_light_that_is_hidden_is_told_in_words() {
        let report = |light: Vec<f64>| LightReport {
            commit: "none".into(),
            title: "Lamp".into(),
            machine: "exact".into(),
            light: "lamp".into(),
            first: 0,
            times: vec![0.0, 0.5],
            whole: ClosedForm { light: vec![2.0; 2], distances: vec![9.0; 2] },
            curves: vec![LightCurve { name: "exact".into(), light }],
            not_modelled: Vec::new(),
        };
        assert!(report(vec![0.0; 2]).text().ends_with("The light is in sight in no frame.\n"));
        assert!(
            report(vec![0.4, 0.0])
                .page()
                .ends_with("\n\nA way without shares never shows more than 0.5 of the closed form.\n")
        );
        assert!(report(vec![2.0; 2]).remarks().is_empty());
    }

    #[test]
    fn many_turns_are_told_by_the_first() {
        assert_eq!(turns(&[]), "-");
        assert_eq!(turns(&[3, 8]), "3 8");
        assert_eq!(turns(&[1, 2, 3, 4, 5, 6]), "1 2 3 4 and 2 more");
    }
}
