//! `lunoid photo make`: a photograph of a scenario's landscape.

use std::path::PathBuf;

use clap::Args;
use generator::Stage;
use limits::Limit;
use photo_make::{ElevationGrid, FILES, Reach, Wishes, make, record, write_folder};
use picture::{Depth, Transfer};
use quantities::radians;
use serde_json::Value;

use command_line::loading::{StageArgs, StageOptions, Threads};
use command_line::output::{Place, expect_outputs, print, print_json, tell};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid photo make scenarios/first-light.toml --out runs/photo
  lunoid photo make scenarios/craters.toml --ground-sample-m 0.5 --height-m 2000 --bits 16 \\
    --out runs/photo
  lunoid photo make scenarios/craters.toml --heading-deg 30 --pitch-deg -40 --noise 0.01 \\
    --out runs/oblique

The generator `exact` draws the photograph. The folder gets photo.png, camera.json, ground.npy
(east, north, up of each pixel), elevation.asc, points.csv (control points) and photo.json.
docs/photo.md describes them.";

/// Draw a vertical or oblique photograph of a landscape, with its camera file, its truth and its elevations.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Make {
    /// Scenario whose landscape and sun are taken: a file, or the name of one in `scenarios/`.
    #[arg(value_parser = values::scenario)]
    scenario: PathBuf,
    /// Folder that gets the six files of the photograph.
    #[arg(short, long, value_name = "FOLDER")]
    out: PathBuf,
    /// Ground from this bank instead of the scenario's.
    #[arg(long, value_name = "FILE")]
    bank: Option<PathBuf>,
    /// Place in the picture's middle; the middle of the ground if left out.
    #[arg(long, value_name = "NORTH,EAST", value_parser = values::place)]
    centre_m: Option<[f64; 2]>,
    /// Size of the picture in pixels.
    #[arg(long, value_name = "COLUMNS,LINES", value_parser = size, default_value = "512,512")]
    size: [u32; 2],
    /// Side of a pixel on the ground in the picture's middle, across the line of sight.
    #[arg(long, value_name = "METRES", value_parser = values::metres, default_value = "1")]
    ground_sample_m: f64,
    /// Height of the camera above the ground in the picture's middle.
    #[arg(long, value_name = "METRES", value_parser = values::metres, conflicts_with = "field_deg")]
    height_m: Option<f64>,
    /// Angle between the left and the right edge, instead of a height.
    #[arg(long, value_name = "DEGREES", value_parser = field, default_value = "30")]
    field_deg: f64,
    /// Focal length; it decides the size of a pixel in the camera.
    #[arg(long, value_name = "MILLIMETRES", value_parser = values::positive, default_value = "150")]
    focal_length_mm: f64,
    /// Direction of view, clockwise from north. In a vertical picture it points to the upper edge.
    #[arg(long, value_name = "DEGREES", value_parser = values::finite, default_value = "0")]
    heading_deg: f64,
    /// Elevation of the direction of view, from -90, straight down, to below 0.
    #[arg(long, value_name = "DEGREES", value_parser = pitch, default_value = "-90")]
    pitch_deg: f64,
    /// Turn about the direction of view, positive for the right side down.
    #[arg(long, value_name = "DEGREES", value_parser = values::finite, default_value = "0")]
    roll_deg: f64,
    /// Time of the scenario, for its sun and what stands on the ground.
    #[arg(long, value_name = "SECONDS", value_parser = values::not_negative, default_value = "0")]
    time_s: f64,
    /// Bits of a code: 8 or 16.
    #[arg(long, value_parser = bits, default_value = "8")]
    bits: Depth,
    /// Light that is shown white; the scenario's if left out.
    #[arg(long, value_parser = values::positive)]
    white: Option<f64>,
    /// Exponent of the grey curve, 1 for a linear one; the scenario's if left out.
    #[arg(long, value_parser = values::positive)]
    gamma: Option<f64>,
    /// Standard deviation of the noise, as a share of white.
    #[arg(long, value_name = "SHARE", value_parser = values::not_negative, default_value = "0")]
    noise: f64,
    /// Seed of the noise.
    #[arg(long, value_parser = values::at_least(0_u64), default_value = "1")]
    seed: u64,
    /// Distance between the posts of elevation.asc; the ground sample if left out.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    elevation_spacing_m: Option<f64>,
    #[command(flatten)]
    threads: Threads,
    /// Say nothing but errors.
    #[arg(short, long)]
    quiet: bool,
    /// Print the record as JSON.
    #[arg(long)]
    json: bool,
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = values::pixel(text).ok().and_then(|sides| {
        let [columns, lines] =
            sides.map(|side| u32::try_from(side).ok().filter(|side| (1..=8192).contains(side)));
        Some([columns?, lines?])
    });
    sides.ok_or_else(|| "expected columns and lines, each from 1 to 8192, as 512,512".into())
}

fn field(text: &str) -> Result<f64, String> {
    let found = values::finite(text).ok().filter(|angle| (0.01..=170.0).contains(angle));
    found.ok_or_else(|| "expected degrees from 0.01 to 170".into())
}

fn pitch(text: &str) -> Result<f64, String> {
    let found = values::finite(text).ok().filter(|angle| (-90.0..=-0.1).contains(angle));
    found.ok_or_else(|| "expected degrees from -90 to -0.1".into())
}

fn bits(text: &str) -> Result<Depth, String> {
    match text {
        "8" => Ok(Depth::Eight),
        "16" => Ok(Depth::Sixteen),
        _ => Err("expected 8 or 16".into()),
    }
}

impl Make {
    /// Draws the photograph and writes its folder.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let is_ours = |name: &str| FILES.contains(&name);
        let stage_args = self.stage();
        expect_outputs(&[Place::folder("--out", &self.out, is_ours)], &stage_args.sources())?;
        self.expect_size()?;
        let opened = stage_args.load_any_view()?;
        let pool = self.threads.pool()?;
        let stage = pool.install(|| opened.stage())?;
        let wishes = self.wishes(&stage)?;
        if !self.quiet {
            let [columns, lines] = self.size;
            tell(&format!("drawing {columns} x {lines} pixels\n"));
        }
        let made = pool.install(|| make(&stage, &wishes))?;
        let grid = ElevationGrid::over(&made, self.elevation_spacing_m.unwrap_or(self.ground_sample_m));
        let record = record(&self.scenario.display().to_string(), &wishes, &made, &grid);
        write_folder(&self.out, &made, &grid, &record)?;
        if self.json {
            print_json(&record)?;
        } else if !self.quiet {
            print(&self.told(&record))?;
        }
        Ok(Verdict::Yes)
    }

    fn stage(&self) -> StageArgs {
        let options = StageOptions { bank: self.bank.clone(), ..StageOptions::default() };
        StageArgs { options, ..StageArgs::of(&self.scenario) }
    }

    fn expect_size(&self) -> Result<(), Failure> {
        let [columns, lines] = self.size;
        let pixels = u64::from(columns) * u64::from(lines);
        match Limit::Pixels.allows(pixels) {
            true => Ok(()),
            false => {
                let (most, advice) = (Limit::Pixels.value(), Limit::Pixels);
                Err(Failure::usage(format!("--size: {pixels} pixels, expected at most {most}; {advice}")))
            }
        }
    }

    fn wishes(&self, stage: &Stage) -> Result<Wishes, Failure> {
        let [south, west, north, east] = stage.landscape.level().extent();
        let display = stage.view.display;
        let [white, gamma] = [self.white.unwrap_or(display.white), self.gamma.unwrap_or(display.gamma)];
        let transfer = Transfer::new(white as f32, gamma as f32);
        Ok(Wishes {
            centre: self.centre_m.unwrap_or([0.5 * (south + north), 0.5 * (west + east)]),
            size: self.size,
            ground_sample: self.ground_sample_m,
            reach: self.height_m.map_or_else(|| Reach::Field(radians(self.field_deg)), Reach::Height),
            focal_length: 1e-3 * self.focal_length_mm,
            heading: radians(self.heading_deg),
            pitch: radians(self.pitch_deg),
            roll: radians(self.roll_deg),
            time: self.time_s,
            depth: self.bits,
            transfer: transfer.map_err(|error| Failure::usage(format!("grey curve: {error}")))?,
            noise: self.noise,
            seed: self.seed,
        })
    }

    fn told(&self, record: &Value) -> String {
        let figure = |key: &str| record[key].as_f64().unwrap_or(f64::NAN);
        format!(
            "{}: {} files\n\
             ground sample {} m from {:.1} m away; sun at {:.2}, {:.2} deg\n\
             {} of {} pixels show ground; {:.1e} pixels is the largest residual of their ground points\n",
            self.out.display(),
            FILES.len(),
            figure("ground_sample_m"),
            figure("distance_m"),
            figure("sun_azimuth_deg"),
            figure("sun_elevation_deg"),
            record["ground_pixels"],
            u64::from(self.size[0]) * u64::from(self.size[1]),
            figure("residual_px"),
        )
    }
}
