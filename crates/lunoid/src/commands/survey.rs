//! `lunoid survey`: a bank fitted to an elevation file.

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::{Args, ValueEnum};
use landscape::{Sun, bank_file};
use plots::{Residuals, SurveyLook, survey_picture};
use quantities::{degrees, radians};
use serde_json::{Value, json};
use survey::{
    Area, Elevation, Frame, LevelReport, Plane, ReadOptions, Survey, SurveyOptions, SurveyReport, survey,
};

use crate::commands::bank::bank_at;
use crate::loading::Threads;
use crate::output::{Place, expect_outputs, print, print_json, tell};
use crate::{Failure, Verdict, values};
use text::{shortened, table};

const AFTER: &str = "Examples:
  lunoid survey pole.tif --region-size-m 40 -o pole.bank --picture pole.png
  lunoid survey global.lbl --centre 20.19,30.77 --size-m 20000,20000 -o valley.bank

Reads GeoTIFF, PDS3 images (image or label) and .npy arrays.
Coordinates of --area are metres of the file's own projection.";

/// Fit a bank to an elevation file.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct SurveyCommand {
    /// Elevation file.
    elevation: PathBuf,
    /// Bank to write; a text description is written beside it.
    #[arg(short, long, value_name = "BANK")]
    out: PathBuf,
    /// Side of a region of the finest level; four samples if left out.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    region_size_m: Option<f64>,
    /// Edges of the area in the file's projected metres. All of the file if left out.
    #[arg(long, value_name = "S,W,N,E", value_parser = values::edges, allow_hyphen_values = true)]
    area: Option<[f64; 4]>,
    /// Latitude and longitude of the middle of the area (degrees), with --size-m.
    #[arg(long, value_name = "LAT,LON", value_parser = values::pair, allow_hyphen_values = true,
          conflicts_with = "area", requires = "size_m")]
    centre: Option<[f64; 2]>,
    /// Size of the area to the north and to the east.
    #[arg(long, value_name = "NORTH,EAST", value_parser = values::two_metres, requires = "centre")]
    size_m: Option<[f64; 2]>,
    /// How a grid in degrees is laid onto the plane.
    #[arg(long, value_enum, default_value = "equirectangular", requires = "centre")]
    plane: PlaneWord,
    /// Region sizes of all levels in units of the finest, as 1,4.
    #[arg(long, value_delimiter = ',', default_value = "1", value_name = "FACTORS",
          value_parser = values::at_least(0_usize))]
    levels: Vec<usize>,
    /// Smoothing length in region sizes; shorter waves than about six times this are smoothed.
    #[arg(long, value_name = "REGIONS", value_parser = values::positive)]
    regularisation: Option<f64>,
    /// Share of the samples that is kept from the fit to test it, 0 to 0.5; 0.01 if left out.
    #[arg(long, value_name = "SHARE", value_parser = values::not_negative)]
    held_out: Option<f64>,
    /// Metres a stored unit, in place of the file's own.
    #[arg(long, value_parser = values::of_heights, allow_hyphen_values = true)]
    scale: Option<f64>,
    /// Metres added after scaling, in place of the file's own.
    #[arg(long, value_name = "METRES", value_parser = values::of_heights, allow_hyphen_values = true)]
    offset: Option<f64>,
    /// Stored value that marks a void, in place of the file's own.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    no_data: Option<f64>,
    /// Band with the heights, from 1.
    #[arg(long, value_parser = values::at_least(0_usize))]
    band: Option<usize>,
    /// Metres between samples of a file that does not say: one number, or NORTH,EAST.
    #[arg(long, value_name = "METRES", value_parser = spacing)]
    spacing_m: Option<[f64; 2]>,
    /// The first line of a file without a place is the southernmost.
    #[arg(long)]
    first_line_south: bool,
    /// What the ground is.
    #[arg(long)]
    title: Option<String>,
    /// Picture of the fitted ground with its residuals beside it.
    #[arg(long, value_name = "PNG|SVG")]
    picture: Option<PathBuf>,
    #[command(flatten)]
    threads: Threads,
    /// Print the report as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum PlaneWord {
    /// Samples as they are.
    Equirectangular,
    /// True at the centre in all directions, also near a pole.
    Orthographic,
}

fn spacing(text: &str) -> Result<[f64; 2], String> {
    if text.contains(',') { values::two_metres(text) } else { values::metres(text).map(|one| [one; 2]) }
}

/// Samples a region along each axis, where no region size is given: 16 samples for nine words. Exactly: a rounded side
/// leaves slivers of regions with few samples, and a condition 10^6 times as large.
const SAMPLES_A_REGION: f64 = 4.0;

/// What is read of an elevation file: a label and its image are two files, whichever of them is named.
fn sources(elevation: &Path) -> Vec<Place> {
    let beside = ["lbl", "LBL", "img", "IMG"].map(|ending| elevation.with_extension(ending));
    let both =
        beside.into_iter().filter(|path| path.is_file()).map(|path| Place::file("the label or image", path));
    [Place::file("the elevation file", elevation)].into_iter().chain(both).collect()
}

impl SurveyCommand {
    /// Surveys.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let outputs = [bank_at(&self.out).to_vec(), Place::pictures([("--picture", &self.picture)])].concat();
        expect_outputs(&outputs, &sources(&self.elevation))?;
        let pool = self.threads.pool()?;
        let start = Instant::now();
        let elevation = survey::read(&self.elevation, &self.read_options())?;
        self.warn_of_unit(&elevation);
        let options = self.survey_options(&elevation);
        let result = pool.install(|| survey(&elevation, &options, &mut |_| {}))?;
        bank_file::write(&self.out, &result.bank)?;
        if let Some(picture) = &self.picture {
            draw(&result)?.write(picture)?;
        }
        let seconds = start.elapsed().as_secs_f64();
        let places = Places::of(&elevation, &options.area, &result);
        if self.json {
            print_json(&self.document(&result.report, places.as_ref(), seconds))?;
        } else {
            print(&text(&result.report, places.as_ref(), seconds))?;
            print(&format!("written: {}\n", self.out.display()))?;
        }
        Ok(Verdict::Yes)
    }

    /// Whole numbers are how files of another unit than the metre look when they do not name their scale.
    fn warn_of_unit(&self, elevation: &Elevation) {
        let is_flat = elevation.range().is_none_or(|[low, high]| low == high);
        if self.scale.is_none() && !is_flat && is_whole(elevation) {
            tell(
                "warning: every height is a whole number and no --scale was given: heights taken as metres; give \
                 --scale if they are not\n",
            );
        }
    }

    fn read_options(&self) -> ReadOptions {
        ReadOptions {
            band: self.band,
            scale: self.scale,
            offset: self.offset,
            no_data: self.no_data,
            spacing: self.spacing_m,
            first_line_south: self.first_line_south,
        }
    }

    fn survey_options(&self, elevation: &Elevation) -> SurveyOptions {
        let metres = match elevation.frame {
            Frame::Plane(_) => 1.0,
            Frame::Geographic { radius } => radius,
        };
        let four_samples = SAMPLES_A_REGION * elevation.affine.step[0].abs() * metres;
        let mut options = SurveyOptions::new(self.region_size_m.unwrap_or(four_samples));
        options.area = self.area();
        options.levels = self.levels.clone();
        options.title = self.title.clone();
        options.stiffness.smoothing = self.regularisation.unwrap_or(options.stiffness.smoothing);
        options.held_out = self.held_out.unwrap_or(options.held_out);
        options
    }

    fn area(&self) -> Area {
        if let Some([south, west, north, east]) = self.area {
            return Area::Metres { south, west, north, east };
        }
        let plane = match self.plane {
            PlaneWord::Equirectangular => Plane::Equirectangular,
            PlaneWord::Orthographic => Plane::Orthographic,
        };
        match (self.centre, self.size_m) {
            (Some([latitude, longitude]), Some(size)) => {
                Area::Centred { latitude: radians(latitude), longitude: radians(longitude), size, plane }
            }
            _ => Area::Whole,
        }
    }

    fn document(&self, report: &SurveyReport, places: Option<&Places>, seconds: f64) -> Value {
        json!({
            "schema": "lunoid.survey/1",
            "bank": self.out.display().to_string(),
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
}

fn is_whole(elevation: &Elevation) -> bool {
    let whole = |line, column| elevation.height(line, column).is_none_or(|height| height.floor() == height);
    (0..elevation.lines).all(|line| (0..elevation.columns).all(|column| whole(line, column)))
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

/// Low light shows what a fit does to small forms.
const PICTURE_SUN_DEG: [f64; 2] = [315.0, 20.0];

fn draw(survey: &Survey) -> Result<plots::Drawing, Failure> {
    let [azimuth, elevation] = PICTURE_SUN_DEG.map(radians);
    let grid = &survey.residuals;
    let residuals = Residuals {
        first: grid.first,
        spacing: grid.step,
        samples: [grid.lines, grid.columns],
        values: &grid.values,
    };
    let look = SurveyLook::titled(survey.bank.title());
    Ok(survey_picture(survey.bank.finest(), Sun { azimuth, elevation }, &residuals, &look)?)
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

fn text(report: &SurveyReport, places: Option<&Places>, seconds: f64) -> String {
    let [lines, columns] = report.samples;
    let samples =
        places.map_or_else(|| format!("{lines} x {columns} samples, interpolated"), |places| places.text());
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
        let condition = level.condition_of_axes[0] * level.condition_of_axes[1] * level.condition_of_voids;
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

    use super::{Area, Elevation, Frame, Places, SurveyOptions, is_whole, north, survey};

    /// 20 lines of 30 samples 5 m apart, 100 m north and 200 m east of the origin, one of them void.
    fn ground(height: impl Fn(usize) -> f64) -> Elevation {
        let heights = (0..600).map(|index| if index == 77 { f64::NAN } else { height(index) }).collect();
        let place = survey::Affine { first: [195.0, 200.0], step: [-5.0, 5.0] };
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
        assert!(is_whole(&ground(|index| index as f64)));
        assert!(!is_whole(&ground(|index| index as f64 * 0.5)));
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
