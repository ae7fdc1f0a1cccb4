//! `lunoid photo check`: a photograph against an elevation file.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use landscape::Sun;
use photo_camera::check_by;
use photo_camera::voids::{Border, Fill, Wishes};
use photo_check::{
    FoundSun, Ground, Overlay, Relief, Report, drawing, fill_voids, find_sun, page, read_points,
};
use photograph::Photograph;
use picture::write_png;
use quantities::radians;

use crate::elevation::{ElevationArgs, sources};
use command_line::loading::Threads;
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid photo check runs/photo/photo.png --camera runs/photo/camera.json \\
    --ground runs/photo/elevation.asc --points runs/photo/points.csv --at-most 0.5
  lunoid photo check runs/photo/photo.png --camera runs/photo/camera.json \\
    --ground runs/photo/elevation.asc --page runs/check.html --lines runs/check.svg
  lunoid photo check runs/photo/photo.png --camera runs/photo/camera.json \\
    --ground runs/photo/elevation.asc --find-sun

Exit code 1: the root mean square of the control points is above --at-most. docs/photo.md
describes the files and the tables.";

/// Say how well a photograph and an elevation file agree.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Check {
    /// Picture to read: PNG, JPEG or TIFF of 8 or 16 bits.
    photo: PathBuf,
    /// Camera file or map file of the photograph.
    #[arg(long, value_name = "FILE")]
    camera: PathBuf,
    /// Elevation file of the ground.
    #[arg(long, value_name = "FILE")]
    ground: PathBuf,
    /// Table of control points.
    #[arg(long, value_name = "FILE")]
    points: Option<PathBuf>,
    /// Root mean square of the control points that still passes.
    #[arg(long, value_name = "PIXELS", value_parser = values::not_negative, requires = "points")]
    at_most: Option<f64>,
    /// Azimuth, from the grid's north, and elevation of the sun (degrees), instead of the photograph's.
    #[arg(long, value_name = "AZIMUTH,ELEVATION", value_parser = values::sun)]
    sun: Option<[f64; 2]>,
    /// Find the sun whose shadows over the elevations overlap best with the dark parts of the photograph.
    #[arg(long, conflicts_with = "sun")]
    find_sun: bool,
    /// How voids of the elevation file are filled.
    #[arg(long, value_enum, default_value = "harmonic")]
    fill: FillWord,
    /// Fill holes at the edge of the grid too; else they stay void.
    #[arg(long)]
    fill_border: bool,
    /// Fill holes of more than a quarter of the grid too; else they are refused.
    #[arg(long)]
    allow_large_holes: bool,
    /// Page to write: photograph and shaded elevations, to be flipped. One file.
    #[arg(long, value_name = "HTML")]
    page: Option<PathBuf>,
    /// Picture of the shaded elevations to write, north up.
    #[arg(long, value_name = "PNG")]
    relief: Option<PathBuf>,
    /// Picture of the voids to write: white where the file has no height, in the order of the file.
    #[arg(long, value_name = "PNG")]
    mask: Option<PathBuf>,
    /// Line drawing of the elevations in the photograph's pixels to write.
    #[arg(long, value_name = "SVG")]
    lines: Option<PathBuf>,
    /// How many times as large heights are in the line drawing.
    #[arg(long, value_name = "TIMES", value_parser = values::not_negative, requires = "lines", default_value = "10")]
    magnify: f64,
    #[command(flatten)]
    reading: ElevationArgs,
    #[command(flatten)]
    threads: Threads,
    /// Print the report as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum FillWord {
    /// Each void is the mean of its neighbours, at equilibrium.
    Harmonic,
    /// Mean of the posts around the hole, weighted by the inverse of the squared distance.
    InverseDistance,
    /// Height of the nearest post around the hole.
    Nearest,
    /// Mean of all known posts, cut to a whole metre, as the thesis's program has it. It makes cliffs.
    Mean,
    /// Voids stay void, and are only counted.
    Leave,
}

/// Azimuth and elevation (deg) of the relief's sun where none is known.
const ASSUMED_SUN_DEG: [f64; 2] = [315.0, 20.0];

impl Check {
    /// Reads all files, writes what is asked for, and prints the report.
    pub fn run(&self) -> Result<Verdict, Failure> {
        expect_outputs(&self.outputs(), &self.inputs())?;
        let photo = Photograph::read(&self.photo, &self.camera)?;
        let elevation = survey::read(&self.ground, &self.reading.options())?;
        self.reading.warn_of_unit(&elevation);
        let pool = self.threads.pool()?;
        let filled = fill_voids(&elevation, self.wishes()).map_err(|error| self.of_ground(error))?;
        let ground = Ground::new(&elevation, filled, &photo).map_err(|error| self.of_ground(error))?;
        let coverage = photo.coverage(ground.points())?;
        let found = pool.install(|| self.found(&photo, &ground))?;
        let sun = match &found {
            Some(found) => (found.sun, "found from its shadows"),
            None => self.sun_over(&photo, &ground),
        };
        let middle = ground.size().map(|count| 0.5 * (count - 1) as f64);
        let sample = ground.height_between(middle).and_then(|height| {
            let point = ground.point(middle, height)?;
            photo.placement().ground_sample(point)
        });
        let overlay = pool.install(|| {
            let relief = Relief::new(&ground, &sun.0);
            Overlay::new(&ground, &photo, &relief, sample.map(|[i, j]| i.min(j)))
        });
        let report = Report {
            files: [&self.photo, &self.ground].map(|path| path.display().to_string()),
            coverage,
            ground_sample: sample,
            sample_unit: photo.placement().unit(),
            sun,
            found: found.map(|found| (found, ground.true_north())),
            fill: self.fill.meant(),
            voids: Report::voids_of(&ground.filling),
            hidden: overlay.hidden(),
            likeness: pool.install(|| overlay.likeness()),
            residuals: self.residuals(&photo, &ground)?,
            at_most: self.at_most,
            notes: elevation.notes.iter().cloned().chain(ground.doubts(photo.placement())).collect(),
        };
        self.write(&photo, &ground, &overlay, &report)?;
        if self.json {
            print_json(&report.json())?;
        } else {
            print(&report.text())?;
        }
        Ok(if report.passes() { Verdict::Yes } else { Verdict::No })
    }

    fn inputs(&self) -> Vec<Place> {
        let files = [Place::file("the photograph", &self.photo), Place::file("--camera", &self.camera)];
        let points = Place::given([("--points", &self.points)]);
        files.into_iter().chain(points).chain(sources(&self.ground)).collect()
    }

    fn outputs(&self) -> Vec<Place> {
        let pictures = Place::given([("--relief", &self.relief), ("--mask", &self.mask)]);
        let pictures = pictures.into_iter().map(|place| place.ending_in(&["png"]));
        let page = Place::given([("--page", &self.page)]).into_iter().map(|place| place.ending_in(&["html"]));
        let lines =
            Place::given([("--lines", &self.lines)]).into_iter().map(|place| place.ending_in(&["svg"]));
        pictures.chain(page).chain(lines).collect()
    }

    fn wishes(&self) -> Wishes {
        let border = if self.fill_border { Border::Filled } else { Border::StaysVoid };
        Wishes { fill: self.fill.meant(), border, allow_large_holes: self.allow_large_holes }
    }

    /// A fault of the ground with the name of its file.
    fn of_ground(&self, error: impl std::fmt::Display) -> Failure {
        Failure::input(format!("{}: {error}", self.ground.display()))
    }

    /// The sun that shadows tell, if it is asked for.
    fn found(&self, photo: &Photograph, ground: &Ground) -> Result<Option<FoundSun>, Failure> {
        let found = self.find_sun.then(|| find_sun(ground, photo)).transpose();
        found.map_err(|error| Failure::input(format!("{}: {error}", self.photo.display())))
    }

    /// The sun of the relief, its azimuth from the grid's north, and where it comes from.
    fn sun_over(&self, photo: &Photograph, ground: &Ground) -> (Sun, &'static str) {
        let of =
            |[azimuth, elevation]: [f64; 2]| Sun { azimuth: radians(azimuth), elevation: radians(elevation) };
        match (self.sun, photo.sun()) {
            (Some(angles), _) => (of(angles), "as given"),
            (None, Some([azimuth, elevation])) => {
                (Sun { azimuth: azimuth + ground.true_north(), elevation }, "of the photograph")
            }
            (None, None) => (of(ASSUMED_SUN_DEG), "assumed: neither the camera file nor --sun has one"),
        }
    }

    fn residuals(
        &self,
        photo: &Photograph,
        ground: &Ground,
    ) -> Result<Option<(Vec<photo_check::Control>, photo_camera::Residuals)>, Failure> {
        let Some(path) = &self.points else { return Ok(None) };
        let controls = read_points(path, ground)?;
        let points: Vec<_> = controls.iter().map(|control| control.point).collect();
        let found = check_by(|point| photo.pixel(point), &points)
            .map_err(|error| Failure::input(format!("{}: {error}", path.display())))?;
        Ok(Some((controls, found)))
    }

    fn write(
        &self,
        photo: &Photograph,
        ground: &Ground,
        overlay: &Overlay,
        report: &Report,
    ) -> Result<(), Failure> {
        let text = |path: &Path, text: &str| {
            files::write_atomic(path, |out: &mut dyn Write| out.write_all(text.as_bytes()))
        };
        if let Some(path) = &self.relief {
            write_png(path, &overlay.relief().map_err(Failure::input)?, &[picture::SOFTWARE])?;
        }
        if let Some(path) = &self.mask {
            write_png(path, &ground.mask().map_err(Failure::input)?, &[picture::SOFTWARE])?;
        }
        if let Some(path) = &self.lines {
            text(path, &drawing(ground, photo, self.magnify))?;
        }
        if let Some(path) = &self.page {
            text(path, &page(overlay, report).map_err(Failure::input)?)?;
        }
        Ok(())
    }
}

impl FillWord {
    fn meant(self) -> Fill {
        match self {
            Self::Harmonic => Fill::Harmonic,
            Self::InverseDistance => Fill::InverseDistance,
            Self::Nearest => Fill::Nearest,
            Self::Mean => Fill::WrittenMean,
            Self::Leave => Fill::Leave,
        }
    }
}
