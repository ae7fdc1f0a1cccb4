//! `lunoid survey`: a bank fitted to an elevation file.

use std::path::PathBuf;
use std::time::Instant;

use clap::{Args, ValueEnum};
use landscape::{Sun, bank_file};
use plots::{Residuals, SurveyLook, survey_picture};
use quantities::radians;
use survey::{Area, Frame, Opened, Plane, Survey, SurveyOptions, SurveyTold, survey};

use crate::bank::bank_at;
use crate::elevation::{ElevationArgs, sources};
use command_line::loading::Threads;
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid survey pole.tif --region-size-m 40 -o pole.bank --picture pole.png
  lunoid survey global.lbl --centre 20.19,30.77 --size-m 20000,20000 -o valley.bank

Reads GeoTIFF (also BigTIFF and cloud-optimised), PDS3 images and PDS4 arrays (data or label),
ISIS cubes, ENVI rasters (samples or header), Arc ASCII grids, DTED cells, SRTM tiles (.hgt) and
.npy arrays. Coordinates of --area are metres of the file's own projection. With --area or
--centre only the blocks of the file are read that the area needs, so the file may be larger
than memory.";

/// Fit a bank to an elevation file.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct SurveyCommand {
    /// Elevation file to read.
    elevation: PathBuf,
    /// Bank to write; a text description is written beside it.
    #[arg(short, long, value_name = "BANK")]
    out: PathBuf,
    /// Side of a region of the finest level; four samples if left out.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    region_size_m: Option<f64>,
    /// Edges of the area in the file's projected metres. All of the file if left out.
    #[arg(long, value_name = "S,W,N,E", value_parser = values::edges)]
    area: Option<[f64; 4]>,
    /// Latitude and longitude of the middle of the area (degrees), with --size-m.
    #[arg(long, value_name = "LAT,LON", value_parser = values::pair,
          conflicts_with = "area", requires = "size_m")]
    centre: Option<[f64; 2]>,
    /// Size of the area to the north and to the east.
    #[arg(long, value_name = "NORTH,EAST", value_parser = values::two_metres, requires = "centre")]
    size_m: Option<[f64; 2]>,
    /// How a grid in degrees is laid onto the plane.
    #[arg(long, value_enum, default_value = "equirectangular", requires = "centre")]
    plane: PlaneWord,
    /// Region sizes of all levels in units of the finest, as 1,4.
    #[arg(long, value_delimiter = ',', default_value = "1", value_name = "FACTOR[,FACTOR]",
          value_parser = values::at_least(0_usize))]
    levels: Vec<usize>,
    /// Smoothing length in region sizes; shorter waves than about six times this are smoothed.
    #[arg(long, value_name = "REGIONS", value_parser = values::positive)]
    regularisation: Option<f64>,
    /// Share of the samples that is kept from the fit to test it, 0 to 0.5; 0.01 if left out.
    #[arg(long, value_name = "SHARE", value_parser = values::not_negative)]
    held_out: Option<f64>,
    #[command(flatten)]
    reading: ElevationArgs,
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

/// Samples a region along each axis, where no region size is given: 16 samples for nine words. Exactly: a rounded side
/// leaves slivers of regions with few samples, and a condition 10^6 times as large.
const SAMPLES_A_REGION: f64 = 4.0;

impl SurveyCommand {
    /// Fits a bank to the elevation file and writes it.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let outputs = [bank_at(&self.out).to_vec(), Place::pictures([("--picture", &self.picture)])].concat();
        expect_outputs(&outputs, &sources(&self.elevation))?;
        let pool = self.threads.pool()?;
        let start = Instant::now();
        let file = survey::open(&self.elevation, &self.reading.options())?;
        let options = self.survey_options(&file);
        // A file may be larger than memory: only what the area needs is read.
        let window = options.window(&file)?;
        let elevation = file.window(&window)?;
        self.reading.warn_of_unit(&elevation);
        let result = pool.install(|| survey(&elevation, &options, &mut |_| {}))?;
        bank_file::write(&self.out, &result.bank)?;
        if let Some(picture) = &self.picture {
            draw(&result)?.write(picture)?;
        }
        let seconds = start.elapsed().as_secs_f64();
        let told = SurveyTold::new(&elevation, &options.area, &result, seconds);
        if self.json {
            print_json(&told.json(&self.out))?;
        } else {
            print(&told.text())?;
            print(&format!("written: {}\n", self.out.display()))?;
        }
        Ok(Verdict::Yes)
    }

    fn survey_options(&self, file: &Opened) -> SurveyOptions {
        let metres = match file.frame() {
            Frame::Plane(_) => 1.0,
            Frame::Geographic { radius } => radius,
        };
        let four_samples = SAMPLES_A_REGION * file.affine().step[0].abs() * metres;
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
