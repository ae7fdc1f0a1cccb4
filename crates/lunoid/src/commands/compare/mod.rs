//! `lunoid compare`: how far one picture, or one run, is from another.

mod told;

use std::path::{Path, PathBuf};

use clap::Args;
use compare::{
    AnyComparison, EdgeLimits, EdgeMask, LinearComparison, RidgeError, compare_any, compare_linear,
    horizon_of_picture, linear_luminance, ridge_error, triptych_any,
};
use photographs::CURVE;
use picture::{AnyPicture, Curve, Limits, Transfer, read_any_png};
use replay::{HeldRun, is_run_file};
use serde_json::{Value, json};

use crate::commands::edges::{Edges, Kind};
use crate::loading::{StageArgs, Threads};
use crate::output::{Place, expect_outputs, print, print_json, tell};
use crate::{Failure, Verdict, values};
use text::table;

const AFTER: &str = "Examples:
  lunoid compare runs/first-light runs/exact
  lunoid compare a.png b.png --out difference.png --tolerance 2 --share 0.5
  lunoid compare runs/first-light runs/exact --edges scenarios/first-light.toml --tolerance 2 --share 0.5

Two pictures (PNG, JPEG, TIFF), or two run folders frame by frame. Exit code 1 when a tolerance is given and not met. RMSE is of grey
0 to 1 as displayed; linear is the RMSE of reflectivity, which runs say how to recover from their codes; the worst
pixel is the one that differs most. Pictures in colour are compared by luminance, and channel by channel if both are.";

/// Say how far one picture, or one run, is from another.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Compare {
    /// Picture or run folder under test.
    test: PathBuf,
    /// Picture or run folder to compare with.
    reference: PathBuf,
    /// Picture of both and their difference side by side (of runs: the worst frame); grey is equal.
    #[arg(short, long, value_name = "PNG")]
    out: Option<PathBuf>,
    /// How many times the difference is enlarged in the picture.
    #[arg(long, requires = "out", default_value_t = 8, value_parser = values::whole(1..=255_u32))]
    factor: u32,
    /// Largest RMSE that is still a yes.
    #[arg(long, value_name = "RMSE", value_parser = values::not_negative)]
    max_rmse: Option<f64>,
    /// Levels of 255 by which a pixel may be off.
    #[arg(long, value_name = "LEVELS", value_parser = values::whole(0..=255_u32))]
    tolerance: Option<u32>,
    /// Percent of the pixels that may be off by more.
    #[arg(long, value_name = "PERCENT", requires = "tolerance", default_value_t = 0.0,
          value_parser = values::percent)]
    share: f64,
    /// Picture; pixels that are not black in it are left out.
    #[arg(long, value_name = "PNG")]
    mask: Option<PathBuf>,
    /// Scenario of both runs: pixels along the ridge lines that `exact` sees in it are left out, and the error of
    /// the horizon is told.
    #[arg(long, value_name = "SCENARIO", group = "scene", conflicts_with = "mask")]
    ridges: Option<PathBuf>,
    /// The same, and pixels along outlines, boundaries of remote shadow and kinks of the ground are left out too.
    #[arg(long, value_name = "SCENARIO", group = "scene", conflicts_with = "mask")]
    edges: Option<PathBuf>,
    /// Step of range, in units of the nearer range, that makes a ridge.
    #[arg(long, value_name = "SHARE", requires = "scene", default_value_t = 0.2, value_parser = values::positive)]
    jump: f64,
    /// Turn of the normal from pixel to pixel, beyond that on either side, that makes a kink.
    #[arg(long, value_name = "TURN", requires = "edges", default_value_t = 0.02, value_parser = values::positive)]
    kink: f64,
    /// Lines by which the horizon may be off in any column.
    #[arg(long, value_name = "LINES", requires = "scene", value_parser = values::at_least(0_usize))]
    max_ridge: Option<usize>,
    #[command(flatten)]
    threads: Threads,
    /// Print the result as JSON.
    #[arg(long)]
    json: bool,
}

/// Code of the sky.
const SKY: u16 = 0;

/// A pair of pictures and what they come to.
struct Pair {
    frame: Option<u64>,
    test: PathBuf,
    reference: PathBuf,
    comparison: AnyComparison,
    is_colour: bool,
    linear: Option<LinearComparison>,
    edges: Option<EdgeMask>,
    ridges: Option<RidgeError>,
}

/// The display laws of both runs.
type Displays = Option<[Transfer; 2]>;

/// Frame, and the pictures of it.
type Paths = (Option<u64>, PathBuf, PathBuf);

impl Compare {
    /// Compares.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let picture = self.out.iter().map(|out| Place::file("--out", out).ending_in(&["png"]));
        expect_outputs(&picture.collect::<Vec<_>>(), &self.sources())?;
        let pairs = self.compare_all()?;
        if let Some(out) = &self.out {
            self.draw(worst(&pairs), out)?;
        }
        let pass = self.pass(&pairs);
        if self.json {
            print_json(&self.document(&pairs, pass))?
        } else {
            print(&self.text(&pairs, pass))?
        }
        Ok(if pass == Some(false) { Verdict::No } else { Verdict::Yes })
    }

    /// What is read.
    fn sources(&self) -> Vec<Place> {
        let side = |path: &PathBuf| match path.is_dir() {
            true => Place::folder("the run", path, is_run_file),
            false => Place::file("the picture", path),
        };
        let pictures = [&self.test, &self.reference].map(side);
        let mask = Place::given([("--mask", &self.mask)]);
        let scene = self.edges_of().map_or(Vec::new(), |(scenario, _)| StageArgs::of(scenario).sources());
        pictures.into_iter().chain(mask).chain(scene).collect()
    }

    fn compare_all(&self) -> Result<Vec<Pair>, Failure> {
        let pairs = self.pairs()?;
        let displays = self.displays()?;
        let Some((scenario, kind)) = self.edges_of() else {
            let mask = self.mask.as_deref().map(read_mask).transpose()?;
            let compare = |paths| self.compare(paths, mask.as_deref(), &displays);
            return pairs.into_iter().map(compare).collect();
        };
        let pool = self.threads.pool()?;
        let mut edges = Edges::of(scenario, kind, &pool)?;
        for folder in [&self.test, &self.reference] {
            edges.expect_run(folder, &HeldRun::read(folder)?)?;
        }
        let compare = |paths: Paths| {
            let mask = edges.mask(paths.0.unwrap_or_default(), &pool)?;
            let pair = self.compare(paths, Some(&mask.pixels), &displays)?;
            Ok(Pair { edges: matches!(kind, Kind::Edges(_)).then_some(mask), ..pair })
        };
        pairs.into_iter().map(compare).collect()
    }

    /// The scenario whose edges are left out, and which.
    fn edges_of(&self) -> Option<(&Path, Kind)> {
        let (jump, kink) = (self.jump as f32, self.kink as f32);
        match (&self.ridges, &self.edges) {
            (Some(scenario), _) => Some((scenario, Kind::Ridges { jump })),
            (_, Some(scenario)) => Some((scenario, Kind::Edges(EdgeLimits { jump, kink }))),
            _ => None,
        }
    }

    /// The pictures to compare: one pair, or a pair a frame.
    fn pairs(&self) -> Result<Vec<Paths>, Failure> {
        let has_edges = self.edges_of().is_some();
        if let Some(missing) = [&self.test, &self.reference].into_iter().find(|path| !path.exists()) {
            let path = missing.display();
            return Err(Failure::input(format!("{path}: no such file or folder; check the spelling")));
        }
        match (self.test.is_dir(), self.reference.is_dir()) {
            (false, false) if has_edges => Err(Failure::usage(
                "--ridges and --edges need run folders, which know the frame of each picture",
            )),
            (false, false) => Ok(vec![(None, self.test.clone(), self.reference.clone())]),
            (true, true) => frames_of_both(&self.test, &self.reference),
            _ => Err(Failure::input(format!(
                "{} and {}: one is a folder and one a file; expected two pictures or two run folders",
                self.test.display(),
                self.reference.display()
            ))),
        }
    }

    /// Runs say how codes came from reflectivity; a picture alone does not.
    fn displays(&self) -> Result<Displays, Failure> {
        match self.test.is_dir() {
            true => Ok(Some([display(&self.test)?, display(&self.reference)?])),
            false => Ok(None),
        }
    }

    fn compare(
        &self,
        (frame, test, reference): Paths,
        mask: Option<&[bool]>,
        displays: &Displays,
    ) -> Result<Pair, Failure> {
        let [a, b] = [self.read(&test)?, self.read(&reference)?];
        let curves = displays.map_or([CURVE; 2], |displays| displays.map(curve));
        let levels: Vec<u32> =
            [0, 1, 2].into_iter().chain(self.tolerance.filter(|levels| *levels > 2)).collect();
        let refused =
            |error| Failure::input(format!("{} against {}: {error}", test.display(), reference.display()));
        let comparison = compare_any([&a, &b], curves, mask, &levels).map_err(refused)?;
        let linear = displays.map(|[of_a, of_b]| {
            compare_linear(&linear_luminance(&a, &of_a), &linear_luminance(&b, &of_b), mask)
        });
        let linear = linear.transpose().map_err(refused)?;
        let horizons = [(&a, curves[0]), (&b, curves[1])]
            .map(|(picture, curve)| horizon_of_picture(&picture.to_grey(curve), SKY));
        let is_colour = a.is_colour() || b.is_colour();
        let ridges = self
            .edges_of()
            .map(|_| ridge_error(&horizons[0], &horizons[1], usize::from(self.edges.is_some())))
            .transpose()?;
        Ok(Pair { frame, test, reference, comparison, is_colour, linear, edges: None, ridges })
    }

    fn draw(&self, pair: &Pair, out: &Path) -> Result<(), Failure> {
        let [test, reference] = [self.read(&pair.test)?, self.read(&pair.reference)?];
        let shown = triptych_any(&test, &reference, self.factor)?.encode_png(&[]).map_err(Failure::output)?;
        Ok(files::write_atomic(out, |file| file.write_all(&shown))?)
    }

    /// A frame of a run is read as the program wrote it.
    fn read(&self, path: &Path) -> Result<AnyPicture, Failure> {
        match self.test.is_dir() {
            true => Ok(read_any_png(path, &Limits::default())?),
            false => Ok(photographs::read(path)?),
        }
    }

    /// Whether the tolerances are met, if there are any.
    fn pass(&self, pairs: &[Pair]) -> Option<bool> {
        if self.max_rmse.is_none() && self.tolerance.is_none() && self.max_ridge.is_none() {
            return None;
        }
        Some(pairs.iter().all(|pair| {
            let rmse_is_met =
                self.max_rmse.is_none_or(|most| pair.comparison.all().all(|found| found.rmse <= most));
            let share_is_met = self.tolerance.is_none_or(|levels| {
                pair.comparison.all().all(|found| {
                    let beyond = found.beyond.iter().find(|beyond| beyond.levels == levels);
                    beyond.is_some_and(|beyond| beyond.share * 100.0 <= self.share)
                })
            });
            let ridge_is_met =
                self.max_ridge.is_none_or(|most| pair.ridges.is_some_and(|error| error.maximum <= most));
            rmse_is_met && share_is_met && ridge_is_met
        }))
    }

    fn document(&self, pairs: &[Pair], pass: Option<bool>) -> Value {
        json!({
            "schema": "lunoid.compare/1",
            "test": self.test.display().to_string(),
            "reference": self.reference.display().to_string(),
            "pass": pass,
            "pictures": pairs.iter().map(Pair::document).collect::<Vec<_>>(),
        })
    }

    fn text(&self, pairs: &[Pair], pass: Option<bool>) -> String {
        let heading = [
            "frame",
            "rmse",
            "linear",
            "psnr",
            "ssim",
            "differ",
            ">1/255",
            ">2/255",
            "worst pixel (column, line: test, reference)",
        ];
        let heading = heading.map(str::to_owned).to_vec();
        let rows: Vec<Vec<String>> = [heading].into_iter().chain(pairs.iter().map(Pair::row)).collect();
        let mut text = table(&rows);
        if pairs.len() > 1 {
            let worst = worst(pairs);
            text += &format!(
                "worst of {}: frame {}\n",
                pairs.len(),
                worst.frame.map(|frame| frame.to_string()).unwrap_or_default()
            );
        }
        text.extend(pairs.iter().filter_map(Pair::colour_line));
        text.extend(pairs.iter().filter_map(Pair::edge_line));
        match pass {
            Some(true) => text += "within the tolerance\n",
            Some(false) => text += "beyond the tolerance\n",
            None => {}
        }
        text
    }
}

/// The pair of the largest RMSE, the first of several.
fn worst(pairs: &[Pair]) -> &Pair {
    let worse = |a: &&Pair, b: &&Pair| b.comparison.luminance.rmse > a.comparison.luminance.rmse;
    pairs.iter().reduce(|a, b| if worse(&a, &b) { b } else { a }).expect("there is a pair")
}

fn frames_of_both(test: &Path, reference: &Path) -> Result<Vec<Paths>, Failure> {
    let runs = [HeldRun::read(test)?, HeldRun::read(reference)?];
    let mut pairs = Vec::new();
    for frame in &runs[0].frames {
        let other = runs[1].frames.iter().find(|other| other.frame == frame.frame);
        if let (Some(a), Some(b)) = (frame.files.first(), other.and_then(|other| other.files.first())) {
            pairs.push((Some(frame.frame), test.join(&a.file), reference.join(&b.file)));
        }
    }
    let counts = runs.each_ref().map(|run| run.frames.len());
    if pairs.is_empty() {
        let [a, b] = [test, reference].map(|path| path.display().to_string());
        return Err(Failure::input(format!("{a} and {b}: no frame is in both runs; expected at least one")));
    }
    if counts != [pairs.len(); 2] {
        tell(&format!("frames in both runs: {}, of {} and {}\n", pairs.len(), counts[0], counts[1]));
    }
    Ok(pairs)
}

/// The display law of a run.
fn display(folder: &Path) -> Result<Transfer, Failure> {
    let run = HeldRun::read(folder)?;
    let display = run.view.display;
    let refused = |error| Failure::input(format!("{}: run.json, view.display: {error}", folder.display()));
    Transfer::new(display.white as f32, display.gamma as f32).map_err(refused)
}

/// The curve of a run's display, by which its colours become grey.
fn curve(display: Transfer) -> Curve {
    Curve::Power(display.gamma().into())
}

fn read_mask(path: &Path) -> Result<Vec<bool>, Failure> {
    Ok(photographs::read(path)?.is_lit())
}
