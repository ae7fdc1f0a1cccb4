//! What is told of a survey, in words and as a document.

use std::path::Path;

use quantities::degrees;
use serde_json::{Value, json};
use text::{shortened, table};

use crate::report::LevelReport;
use crate::{Area, Elevation, Frame, Plane, Survey, SurveyReport};

/// What is told of a survey.
pub struct SurveyTold<'a> {
    report: &'a SurveyReport,
    places: Option<Places>,
    /// Time that it took (s).
    seconds: f64,
}

impl<'a> SurveyTold<'a> {
    /// Of `survey`, made of `area` of `elevation` within `seconds`.
    pub fn new(elevation: &Elevation, area: &Area, survey: &'a Survey, seconds: f64) -> Self {
        Self { report: &survey.report, places: Places::of(elevation, area, survey), seconds }
    }

    /// A document of schema `lunoid.survey/1`; the bank is in the file `bank`.
    pub fn json(&self, bank: &Path) -> Value {
        let Self { report, places, seconds } = self;
        let places = places.as_ref();
        json!({
            "schema": "lunoid.survey/1",
            "bank": bank.display().to_string(),
            "title": report.title,
            "area": report.area,
            "samples": report.samples,
            "file": places.map(|places| json!({
                "samples": places.in_file, "no_data": places.no_data, "places_beyond": places.beyond,
            })),
            "spacing_m": report.spacing,
            "heights_m": report.height,
            "true_north_deg": report.true_north.map(degrees),
            "levels": report.levels.iter().map(level).collect::<Vec<_>>(),
            "warnings": report.warnings,
            "peak_memory_bytes": report.peak_memory,
            "seconds": seconds,
        })
    }

    /// What is said of it, for people.
    pub fn text(&self) -> String {
        let Self { report, places, seconds } = self;
        let [lines, columns] = report.samples;
        let samples = places
            .as_ref()
            .map_or_else(|| format!("{lines} x {columns} samples, interpolated"), Places::text);
        let mut text =
            format!("{}: {samples}; {seconds:.1} s, about {} MB\n", report.title, report.peak_memory >> 20);
        let heading = [
            "regions",
            "size",
            "words",
            "samples used",
            "RMS",
            "held out",
            "their RMS",
            "largest (line, column)",
            "condition",
            "steps",
        ];
        let rows = report.levels.iter().map(|level| {
            let [line, column] = level.worst.in_file;
            let condition =
                level.condition_of_axes[0] * level.condition_of_axes[1] * level.condition_of_voids;
            vec![
                format!("{} x {}", level.corners[0] - 1, level.corners[1] - 1),
                format!("{} m", shortened(level.region_size, 3)),
                level.coefficients.to_string(),
                level.used.to_string(),
                format!("{:.4} m", level.rms),
                level.held_out.to_string(),
                level.held_out_rms.map_or("-".into(), |rms| format!("{rms:.4} m")),
                format!("{:.3} m ({line}, {column})", level.worst.residual),
                format!("{condition:.1e}"),
                level.iterations.to_string(),
            ]
        });
        text += &table(&[heading.map(str::to_owned).to_vec()].into_iter().chain(rows).collect::<Vec<_>>());
        text.extend(report.levels.first().map(ground));
        text.extend(report.true_north.map(north));
        for voids in report.levels.iter().filter_map(|level| level.in_voids) {
            let [low, high] = voids.height;
            text += &format!(
                "in voids, {} regions: heights {low:.1} to {high:.1} m, steepest {:.2} (rise over run)\n",
                voids.regions, voids.slope
            );
        }
        text.extend(report.warnings.iter().map(|warning| format!("note: {warning}\n")));
        text
    }
}

/// Sample places of the finest level: in the file, and under the regions that reach beyond it.
struct Places {
    /// Lines and columns of the file.
    in_file: [usize; 2],
    /// Of these, the samples without a height.
    no_data: usize,
    /// Places that the file does not hold.
    beyond: usize,
}

impl Places {
    /// `None` where samples are interpolated onto a plane.
    fn of(elevation: &Elevation, area: &Area, survey: &Survey) -> Option<Self> {
        let is_plane = matches!(elevation.frame, Frame::Plane(_));
        if !is_plane && matches!(area, Area::Centred { plane: Plane::Orthographic, .. }) {
            return None;
        }
        let finest = survey.report.levels.first()?;
        let in_file = survey.report.held_by_file(elevation, &survey.residuals);
        let beyond = finest.used + finest.held_out + finest.void - in_file[0] * in_file[1];
        Some(Self { in_file, no_data: finest.void.saturating_sub(beyond), beyond })
    }

    fn text(&self) -> String {
        let [lines, columns] = self.in_file;
        let beyond = match self.beyond {
            0 => String::new(),
            beyond => format!(", {beyond} places of the last regions beyond it"),
        };
        format!("{lines} x {columns} samples of the file, {} without data{beyond}", self.no_data)
    }
}

fn level(level: &LevelReport) -> Value {
    let in_voids = level
        .in_voids
        .map(|voids| json!({ "regions": voids.regions, "heights_m": voids.height, "steepest": voids.slope }));
    json!({
        "region_size_m": level.region_size,
        "corners": level.corners,
        "coefficients": level.coefficients,
        "samples": { "used": level.used, "void": level.void, "held_out": level.held_out },
        "rms_m": level.rms,
        "held_out_rms_m": level.held_out_rms,
        "worst": {
            "residual_m": level.worst.residual,
            "line_column": level.worst.in_file,
            "at_m": level.worst.place,
        },
        "condition": { "axes": level.condition_of_axes, "voids": level.condition_of_voids },
        "iterations": level.iterations,
        "relative_residual": level.relative_residual,
        "fitted_heights_m": level.height,
        "steepest": level.slope,
        "in_voids": in_voids,
    })
}

fn ground(finest: &LevelReport) -> String {
    let [low, high] = finest.height;
    let steepest = degrees(finest.steepest());
    format!("fitted ground: heights {low:.2} to {high:.2} m, steepest slope {steepest:.1} deg\n")
}

/// Where true north lies, `turn` clockwise from the bank's north (rad).
fn north(turn: f64) -> String {
    let (angle, side, sign) = match degrees(turn) {
        turn if turn.abs() < 0.005 => return "true north: the bank's north\n".into(),
        turn if turn < 0.0 => (-turn, "west", "plus"),
        turn => (turn, "east", "less"),
    };
    format!(
        "true north: {angle:.2} deg {side} of the bank's north; a true heading is the bank's {sign} {angle:.2} deg\n"
    )
}

#[cfg(test)]
mod tests {
    use quantities::radians;

    use super::{Places, north};
    use crate::{Affine, Area, Elevation, Frame, SurveyOptions, survey};

    /// 20 lines of 30 samples 5 m apart, 100 m north and 200 m east of the origin, one of them void.
    fn ground(height: impl Fn(usize) -> f64) -> Elevation {
        let heights = (0..600).map(|index| if index == 77 { f64::NAN } else { height(index) }).collect();
        let place = Affine { first: [195.0, 200.0], step: [-5.0, 5.0] };
        Elevation::new(20, 30, heights, place, Frame::Plane(None))
    }

    fn places(area: Area) -> ([usize; 2], usize, usize) {
        let elevation = ground(|index| (index / 30) as f64 * 0.1);
        let options = SurveyOptions { area, ..SurveyOptions::new(40.0) };
        let survey = survey(&elevation, &options, &mut |_| {}).unwrap();
        let Places { in_file, no_data, beyond } = Places::of(&elevation, &area, &survey).unwrap();
        (in_file, no_data, beyond)
    }

    #[test]
    fn places_beyond_the_file_are_no_voids() {
        // 95 m x 145 m under 3 x 4 regions of 40 m: 25 x 33 places.
        assert_eq!(places(Area::Whole), ([20, 30], 1, 25 * 33 - 600));
        // 40 m x 80 m from 150 m, 220 m on: 9 x 17 places, the void among them.
        let inside = Area::Metres { south: 150.0, west: 220.0, north: 190.0, east: 300.0 };
        assert_eq!(places(inside), ([9, 17], 1, 0));
    }

    #[test]
    fn whole_numbers_are_seen() {
        assert!(ground(|index| index as f64).is_whole());
        assert!(!ground(|index| index as f64 * 0.5).is_whole());
    }

    #[test]
    fn true_north_in_words() {
        let west =
            "true north: 5.77 deg west of the bank's north; a true heading is the bank's plus 5.77 deg\n";
        assert_eq!(north(radians(-5.77)), west);
        assert!(
            north(radians(1.5))
                .contains("1.50 deg east of the bank's north; a true heading is the bank's less")
        );
        assert_eq!(north(0.0), "true north: the bank's north\n");
    }
}
