//! What a check found, in words and as a document.

use std::f64::consts::TAU;
use std::fmt::Write;

use landscape::Sun;
use photo_camera::Residuals;
use photo_camera::voids::{Fill, Filled};
use photograph::{Coverage, MapUnit};
use quantities::{degrees, fixed};
use serde_json::{Value, json};
use text::{shortened, table};

use crate::{Control, FoundSun, Likeness};

/// What a check found.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// Picture file and elevation file, as the user named them.
    pub files: [String; 2],
    /// Where the posts fall.
    pub coverage: Coverage,
    /// Ground sample at the middle of the grid: a step of I and a step of J, in `sample_unit`.
    pub ground_sample: Option<[f64; 2]>,
    /// Unit of the ground sample: metres, or degrees for a map in degrees.
    pub sample_unit: MapUnit,
    /// Sun of the relief, its azimuth from the grid's north, and where it comes from.
    pub sun: (Sun, &'static str),
    /// The sun that was found from shadows, where it was asked for, and the azimuth of true north from the grid's (rad).
    pub found: Option<(FoundSun, f64)>,
    /// Way in which voids were filled.
    pub fill: Fill,
    /// Number of posts of the grid: void, holes, the largest hole, still void.
    pub voids: [usize; 4],
    /// Share of the overlay within the photograph whose ground is hidden from the camera, 0 to 1.
    pub hidden: f64,
    /// How alike photograph and relief are, where both vary.
    pub likeness: Option<Likeness>,
    /// Control points and their residuals.
    pub residuals: Option<(Vec<Control>, Residuals)>,
    /// Largest root mean square that passes (pixels).
    pub at_most: Option<f64>,
    /// What the user should know.
    pub notes: Vec<String>,
}

impl Report {
    /// Counts of the voids of a grid after the fill.
    pub fn voids_of(filled: &Filled) -> [usize; 4] {
        let void = filled.was_void.iter().filter(|void| **void).count();
        [void, filled.holes, filled.largest_hole, filled.still_void]
    }

    /// Whether the residuals are as small as they must be; so without control points or threshold.
    pub fn passes(&self) -> bool {
        match (&self.residuals, self.at_most) {
            (Some((_, residuals)), Some(at_most)) => residuals.within(at_most),
            _ => true,
        }
    }

    /// The report as text.
    pub fn text(&self) -> String {
        let mut text = String::new();
        let mut say = |line: String| writeln!(text, "{line}").expect("a String takes everything");
        let Coverage { inside, outside, behind } = self.coverage;
        say(format!("posts: {inside} in the photograph, {outside} beside it, {behind} behind the camera"));
        if let Some([i, j]) = self.ground_sample {
            let unit = self.sample_unit.word();
            let [i, j] = [i, j].map(|side| shortened(side, 7));
            say(format!("ground sample: {i} x {j} {unit} at the middle of the grid"));
        }
        let (sun, source) = &self.sun;
        let angles = [sun.azimuth, sun.elevation].map(degrees);
        say(format!("sun: azimuth {:.3}, elevation {:.3} deg ({source})", angles[0], angles[1]));
        if let Some((found, true_north)) = &self.found {
            say(of_found(found, *true_north));
        }
        let [void, holes, largest, left] = self.voids;
        if void > 0 {
            let fill = word(self.fill);
            say(format!(
                "voids: {void} posts in {holes} holes, the largest of {largest}; {fill} fill, {left} left"
            ));
        }
        if self.hidden > 0.0 {
            say(format!(
                "hidden from the camera: {:.2} % of the ground in the photograph",
                100.0 * self.hidden
            ));
        }
        if let Some(likeness) = &self.likeness {
            say(of_likeness(likeness));
        }
        if let Some((controls, residuals)) = &self.residuals {
            say(of_points(controls, residuals));
            if let Some(at_most) = self.at_most {
                let word = if self.passes() { "passes" } else { "fails" };
                say(format!(
                    "{word}: root mean square {:.3} pixels, at most {at_most}",
                    residuals.root_mean_square
                ));
            }
        }
        self.notes.iter().for_each(|note| say(format!("note: {note}")));
        text
    }

    /// The report as a document.
    pub fn json(&self) -> Value {
        let Coverage { inside, outside, behind } = self.coverage;
        let [void, holes, largest, left] = self.voids;
        let (sun, source) = &self.sun;
        json!({
            "schema": "lunoid.photo-check/1",
            "photo": self.files[0],
            "ground": self.files[1],
            "posts": { "inside": inside, "outside": outside, "behind": behind },
            "ground_sample": self.ground_sample,
            "ground_sample_unit": self.sample_unit.word(),
            "sun": {
                "azimuth_deg": degrees(sun.azimuth), "elevation_deg": degrees(sun.elevation), "source": source,
            },
            "found_sun": self.found.as_ref().map(|(found, true_north)| sun_document(found, *true_north)),
            "voids": {
                "fill": word(self.fill), "posts": void, "holes": holes, "largest_hole": largest, "still_void": left,
            },
            "hidden_share": self.hidden,
            "likeness": self.likeness.as_ref().map(|likeness| json!({
                "correlation": likeness.correlation,
                "offset_east_north_m": likeness.offset,
                "best_correlation": likeness.best_correlation,
                "at_the_end": likeness.at_the_end,
            })),
            "control_points": self.residuals.as_ref().map(|(controls, residuals)| document(controls, residuals)),
            "at_most_px": self.at_most,
            "passes": self.passes(),
            "notes": self.notes,
        })
    }
}

fn of_likeness(likeness: &Likeness) -> String {
    let Likeness { correlation, offset: [east, north], best_correlation, at_the_end } = likeness;
    let [east, north] = [fixed(*east, 2), fixed(*north, 2)];
    let more = if *at_the_end { ", the end of what is tried" } else { "" };
    format!(
        "correlation of photograph and relief: {correlation:.3}; {best_correlation:.3} with features of the photograph {east} m \
         east and {north} m north of the relief's{more}"
    )
}

fn of_found(found: &FoundSun, true_north: f64) -> String {
    let FoundSun { sun, uncertainty, overlap, common, dark } = found;
    let [azimuth, elevation] = uncertainty.map(degrees);
    let [photo, ground] = dark.map(|share| 100.0 * share);
    let angles = [(sun.azimuth - true_north).rem_euclid(TAU), sun.elevation].map(|angle| shortened(angle, 6));
    format!(
        "  found within {azimuth:.2} deg of azimuth and {elevation:.2} deg of elevation (two standard errors)\n  \
         dark posts: {photo:.2} % of the photograph's, {ground:.2} % under this sun, {:.1} % of either in both; correlation \
         {overlap:.3}\n  for the camera file: \"sun_azimuth_elevation_rad\": [{}]",
        100.0 * common,
        angles.join(", "),
    )
}

fn sun_document(found: &FoundSun, true_north: f64) -> Value {
    let FoundSun { sun, uncertainty, overlap, common, dark } = found;
    let [azimuth, elevation] = uncertainty.map(degrees);
    json!({
        "azimuth_deg": degrees(sun.azimuth),
        "true_azimuth_deg": degrees((sun.azimuth - true_north).rem_euclid(TAU)),
        "elevation_deg": degrees(sun.elevation),
        "azimuth_uncertainty_deg": azimuth,
        "elevation_uncertainty_deg": elevation,
        "overlap_correlation": overlap,
        "dark_in_both_of_either": common,
        "dark_share_photo": dark[0],
        "dark_share_ground": dark[1],
    })
}

fn of_points(controls: &[Control], found: &Residuals) -> String {
    let row = |(control, [i, j]): (&Control, &[f64; 2])| {
        let distance = libm::hypot(*i, *j);
        vec![control.name.clone(), fixed(*i, 3), fixed(*j, 3), fixed(distance, 3)]
    };
    let header = ["point", "dI", "dJ", "distance"].map(str::to_owned).to_vec();
    let rows = controls.iter().zip(&found.residuals).map(row);
    let rows: Vec<_> = [header].into_iter().chain(rows).collect();
    let [i, j] = found.best_shift.map(|shift| fixed(shift, 3));
    format!(
        "{}root mean square {:.3} pixels; {:.3} after the best shift of {i}, {j}; worst: {}",
        table(&rows),
        found.root_mean_square,
        found.root_mean_square_shifted,
        controls[found.worst].name,
    )
}

fn document(controls: &[Control], found: &Residuals) -> Value {
    let point = |(control, residual): (&Control, &[f64; 2])| json!({ "name": control.name, "pixel": control.point.pixel, "residual_px": residual });
    json!({
        "points": controls.iter().zip(&found.residuals).map(point).collect::<Vec<_>>(),
        "root_mean_square_px": found.root_mean_square,
        "best_shift_px": found.best_shift,
        "root_mean_square_after_shift_px": found.root_mean_square_shifted,
        "worst": controls[found.worst].name,
    })
}

/// The word for a way to fill, as the command has it.
fn word(fill: Fill) -> &'static str {
    match fill {
        Fill::Harmonic => "harmonic",
        Fill::InverseDistance => "inverse-distance",
        Fill::Nearest => "nearest",
        Fill::WrittenMean => "mean",
        Fill::Leave => "leave",
    }
}
