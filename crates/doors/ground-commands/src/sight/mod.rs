//! `lunoid sight`: what ground hides from an observer.

mod area;
mod elevation;
mod ground;
mod lines;
mod options;
mod path;
mod profile;
mod rows;
mod shown;

use std::path::PathBuf;

use clap::Args;
use sight::{Height, Point, SightError};

use self::ground::{Site, Source};
use self::options::{Bending, Layer, Surface};
use self::path::targets;
use self::shown::ShownArgs;
use crate::elevation::{ElevationArgs, sources};
use command_line::loading::{StageArgs, Threads};
use command_line::output::{Place, expect_outputs};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid sight first-light --from 1000,1000 --to 2500,1800 --out runs/sight-line.png
  lunoid sight scenarios/own-ground/site.asc --from 612200,0 --out runs/sight.tif \\
    --out runs/sight.png
  lunoid sight lod-landing --surface shown --frame 20 --from 2500,2500 --out runs/sight-shown.png

Between two points (--to), from the observer to the places of a path (--path), or over an area
(--area, or all of the ground). GROUND is a scenario, a bank, or an elevation file that `lunoid
survey` reads. Places are metres north and east: of the bank's axes for scenarios and banks, of
the map for elevation files. A path is a CSV file with the columns north_m, east_m and, where
wanted, height_m. Ground that only touches the line does not hide the target.";

/// Say what ground hides from an observer.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct SightCommand {
    /// Scenario, bank or elevation file.
    #[arg(value_parser = values::scenario)]
    ground: PathBuf,
    /// Place of the observer.
    #[arg(long, value_name = "NORTH,EAST", value_parser = values::place)]
    from: [f64; 2],
    /// Place of one target.
    #[arg(long, value_name = "NORTH,EAST", value_parser = values::place, conflicts_with_all = ["path", "area"])]
    to: Option<[f64; 2]>,
    /// File with the targets of a path.
    #[arg(long, value_name = "CSV", conflicts_with = "area")]
    path: Option<PathBuf>,
    /// Edges of the area with the targets; all of the ground if left out.
    #[arg(long, value_name = "S,W,N,E", value_parser = values::edges)]
    area: Option<[f64; 4]>,
    /// Height of the observer: metres above the ground, or datum:METRES above the datum.
    #[arg(long, value_name = "HEIGHT", value_parser = options::height, default_value = "2", allow_hyphen_values = true)]
    observer_height: Height,
    /// Height of the targets: metres above the ground, or datum:METRES above the datum.
    #[arg(long, value_name = "HEIGHT", value_parser = options::height, default_value = "0", allow_hyphen_values = true)]
    target_height: Height,
    /// Surface: landscape (the closed form), mesh (triangles between posts), level:N (between every 2^N-th post), shown (triangles as a
    /// generator draws them in a frame). If left out: the landscape for scenarios and banks, the mesh for elevation files.
    #[arg(long, value_name = "SURFACE", value_parser = options::surface)]
    surface: Option<Surface>,
    /// Size of a cell of an area, and distance of the posts of a mesh, for scenarios and banks; a quarter of a region if left out.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    cell_m: Option<f64>,
    #[command(flatten)]
    shown: ShownArgs,
    #[command(flatten)]
    bending: Bending,
    /// Answer for each place of an area.
    #[arg(long, value_enum, default_value = "seen", conflicts_with_all = ["to", "path"])]
    layer: Layer,
    /// File to write, may be given several times. Of an area: .tif, .npy, .csv, .png, .svg; of one line: .csv, .png, .svg; of a path:
    /// .csv.
    #[arg(short, long, value_name = "FILE")]
    out: Vec<PathBuf>,
    #[command(flatten)]
    reading: ElevationArgs,
    #[command(flatten)]
    threads: Threads,
    /// Do not show any progress.
    #[arg(long)]
    no_progress: bool,
    /// Print what was found as JSON.
    #[arg(long)]
    json: bool,
}

/// Endings of files of an area, of one line and of a path.
const OF_AREA: [&str; 6] = ["tif", "tiff", "npy", "csv", "png", "svg"];
const OF_LINE: [&str; 3] = ["csv", "png", "svg"];
const OF_PATH: [&str; 1] = ["csv"];

impl SightCommand {
    /// Looks along the line, to the places of the path, or over the area.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.expect_outputs()?;
        if let Some(option) = self.shown.given().filter(|_| self.surface != Some(Surface::Shown)) {
            return Err(Failure::usage(format!(
                "{option}: only with --surface shown; leave it out, or ask for that surface"
            )));
        }
        let pool = self.threads.pool()?;
        pool.install(|| match (&self.to, &self.path) {
            (Some(to), _) => lines::one(self, *to),
            (None, Some(path)) => lines::many(self, &targets(path, self.target_height)?),
            (None, None) => area::over(self),
        })?;
        Ok(Verdict::Yes)
    }

    fn expect_outputs(&self) -> Result<(), Failure> {
        let endings: &'static [&'static str] = match (&self.to, &self.path) {
            (Some(_), _) => &OF_LINE,
            (None, Some(_)) => &OF_PATH,
            (None, None) => &OF_AREA,
        };
        let outputs: Vec<Place> =
            self.out.iter().map(|out| Place::file("--out", out).ending_in(endings)).collect();
        let is_scenario = self.ground.extension().is_some_and(|ending| ending == "toml");
        let ground = if is_scenario { StageArgs::of(&self.ground).sources() } else { sources(&self.ground) };
        expect_outputs(&outputs, &[ground, Place::given([("--path", &self.path)])].concat())
    }

    /// The ground with room for the observer and some targets.
    fn site(&self, targets: &[Point]) -> Result<Site, Failure> {
        if self.surface == Some(Surface::Shown) {
            return self.drawn();
        }
        match (Source::of(&self.ground)?, self.surface) {
            (Source::Landscape(landscape, title), surface) => {
                self.expect_no_reading()?;
                let level = match surface {
                    None | Some(Surface::Landscape | Surface::Shown) => None,
                    Some(Surface::Mesh(level)) => Some(level),
                };
                Site::of_landscape(*landscape, title, self.area, self.cell_m, level)
            }
            (Source::Elevation, Some(Surface::Landscape)) => Err(Failure::usage(format!(
                "--surface landscape: {} is an elevation file, which has no closed form; expected mesh or level:N; or make a bank of \
                 it with `lunoid survey`",
                self.ground.display()
            ))),
            (Source::Elevation, _) if self.cell_m.is_some() => Err(Failure::usage(
                "--cell-m: an elevation file has posts of its own; leave the option out, or name a coarser --surface level:N",
            )),
            (Source::Elevation, surface) => self.posts(surface, targets),
        }
    }

    /// Refuses options that say how an elevation file is read.
    fn expect_no_reading(&self) -> Result<(), Failure> {
        self.reading.given().map_or(Ok(()), |option| {
            let ground = self.ground.display();
            Err(Failure::usage(format!(
                "{option}: {ground} is a scenario or a bank, whose heights are known; leave the option out, or name an elevation file"
            )))
        })
    }

    /// The ground of a scenario as it is drawn in a frame.
    fn drawn(&self) -> Result<Site, Failure> {
        if self.ground.extension().is_none_or(|ending| ending != "toml") {
            return Err(Failure::usage(format!(
                "--surface shown: {} has no frames; expected a scenario under a generator with levels of detail",
                self.ground.display()
            )));
        }
        self.expect_no_reading()?;
        if self.cell_m.is_some() {
            return Err(Failure::usage("--cell-m: drawn ground has posts of its own; leave the option out"));
        }
        let (posts, landscape, title) = self.shown.posts(&self.ground)?;
        Site::of_posts(posts, 0, self.area, Site::map_of(&landscape, title))
    }

    /// The mesh of an elevation file; of its finest level only the part that lines can cross is read.
    fn posts(&self, surface: Option<Surface>, targets: &[Point]) -> Result<Site, Failure> {
        let level = match surface {
            Some(Surface::Mesh(level)) => level,
            None | Some(Surface::Landscape | Surface::Shown) => 0,
        };
        let hull = (level == 0).then(|| self.hull(targets)).flatten();
        let (posts, frame, title) = elevation::posts(&self.ground, &self.reading.options(), hull)?;
        Site::of_posts(posts, level, self.area, ([0.0; 2], frame, title))
    }

    /// Edges around the observer and all targets; `None` where the whole ground is looked at.
    fn hull(&self, targets: &[Point]) -> Option<[f64; 4]> {
        let corners = self.area.map(|[south, west, north, east]| [[south, west], [north, east]]);
        if corners.is_none() && targets.is_empty() {
            return None;
        }
        let places = targets.iter().map(|target| target.place).chain(corners.into_iter().flatten());
        let [x, y] = self.from;
        Some(places.fold([x, y, x, y], |[south, west, north, east], [x, y]| {
            [south.min(x), west.min(y), north.max(x), east.max(y)]
        }))
    }

    fn observer(&self) -> Point {
        options::point(self.from, self.observer_height)
    }

    /// Name of the surface.
    fn surface_word(&self, site: &Site) -> String {
        match (&site.ground, self.surface) {
            (ground::Ground::Landscape(_), _) => "landscape".into(),
            (_, Some(Surface::Mesh(level))) if level > 0 => format!("level {level}"),
            (_, Some(Surface::Shown)) => format!("frame {} as it is drawn", self.shown.frame.unwrap_or(0)),
            _ => "mesh".into(),
        }
    }
}

/// What a line of sight refuses is a wish that the ground does not meet.
fn refused(error: SightError) -> Failure {
    let advice = match error {
        SightError::NoGround { .. } | SightError::Below { .. } => {
            "; move the point, or give --observer-height or --target-height datum:METRES above the ground"
        }
        _ => "",
    };
    Failure::usage(format!("{error}{advice}"))
}
