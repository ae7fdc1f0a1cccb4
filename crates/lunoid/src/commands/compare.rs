//! `lunoid compare`: how far one picture, or one run, is from another.

use std::path::{Path, PathBuf};

use clap::Args;
use compare::{
    Comparison, EdgeLimits, EdgeMask, LinearComparison, RidgeError, compare, compare_linear,
    horizon_of_picture, linear_intensity, ridge_error, triptych,
};
use picture::{GreyPicture, Limits, Transfer, read_png, write_png};
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

Two PNGs, or two run folders frame by frame. Exit code 1 when a tolerance is given and not met. RMSE is of grey
0 to 1 as displayed; linear is the RMSE of reflectivity, which runs say how to recover from their codes; the worst
pixel is the one that differs most.";

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
    /// Grey PNG; pixels that are not black in it are left out.
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
    comparison: Comparison,
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
                "{} and {}: one is a folder and one a file; expected two PNGs or two run folders",
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
        let [a, b] = [read(&test)?, read(&reference)?];
        let levels: Vec<u32> =
            [0, 1, 2].into_iter().chain(self.tolerance.filter(|levels| *levels > 2)).collect();
        let refused = |error| Failure::input(format!("{}: {error}", test.display()));
        let comparison = compare(&a, &b, mask, &levels).map_err(refused)?;
        let linear = displays.map(|[of_a, of_b]| {
            compare_linear(&linear_intensity(&a, &of_a), &linear_intensity(&b, &of_b), mask)
        });
        let linear = linear.transpose().map_err(refused)?;
        let horizons = [&a, &b].map(|picture| horizon_of_picture(picture, SKY));
        let ridges = self
            .edges_of()
            .map(|_| ridge_error(&horizons[0], &horizons[1], usize::from(self.edges.is_some())))
            .transpose()?;
        Ok(Pair { frame, test, reference, comparison, linear, edges: None, ridges })
    }

    fn draw(&self, pair: &Pair, out: &Path) -> Result<(), Failure> {
        let picture = triptych(&read(&pair.test)?, &read(&pair.reference)?, self.factor)?;
        Ok(write_png(out, &picture, &[])?)
    }

    /// Whether the tolerances are met, if there are any.
    fn pass(&self, pairs: &[Pair]) -> Option<bool> {
        if self.max_rmse.is_none() && self.tolerance.is_none() && self.max_ridge.is_none() {
            return None;
        }
        Some(pairs.iter().all(|pair| {
            let rmse_is_met = self.max_rmse.is_none_or(|most| pair.comparison.rmse <= most);
            let share_is_met = self.tolerance.is_none_or(|levels| {
                let beyond = pair.comparison.beyond.iter().find(|beyond| beyond.levels == levels);
                beyond.is_some_and(|beyond| beyond.share * 100.0 <= self.share)
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
        text.extend(pairs.iter().filter_map(Pair::edge_line));
        match pass {
            Some(true) => text += "within the tolerance\n",
            Some(false) => text += "beyond the tolerance\n",
            None => {}
        }
        text
    }
}

impl Pair {
    fn document(&self) -> Value {
        let Comparison { compared, masked, differing, rmse, psnr_db, ssim, worst, beyond } = &self.comparison;
        let beyond: Vec<Value> = beyond
            .iter()
            .map(|beyond| json!({ "levels": beyond.levels, "count": beyond.count, "share": beyond.share }))
            .collect();
        json!({
            "frame": self.frame,
            "compared": compared,
            "masked": masked,
            "differing": differing,
            "rmse": rmse,
            "psnr_db": psnr_db,
            "linear": self.linear.map(|linear| json!({
                "rmse": linear.rmse, "psnr_db": linear.psnr_db, "bias": linear.bias, "maximum": linear.maximum,
            })),
            "ssim": ssim,
            "worst": {
                "column": worst.column, "line": worst.line, "test": worst.test, "reference": worst.reference,
            },
            "beyond": beyond,
            "edges": self.edges.as_ref().map(|edges| json!({
                "masked": edges.masked(), "share": edges.share(), "ridges": edges.ridges,
                "outlines": edges.outlines, "shadows": edges.shadows, "kinks": edges.kinks,
            })),
            "horizon_lines": self.ridges.map(|error| json!({
                "columns": error.compared, "only_one_sees_ground": error.only_one, "median": error.median,
                "percentile_99": error.percentile_99, "maximum": error.maximum,
            })),
        })
    }

    fn edge_line(&self) -> Option<String> {
        let RidgeError { compared, only_one, median, percentile_99, maximum } = self.ridges?;
        let frame = self.frame.unwrap_or_default();
        Some(format!(
            "frame {frame}: {} left out; horizon off by {median} lines (median), {percentile_99} (99 %), {maximum} \
             (most) in {compared} columns, {only_one} columns see ground in one only\n",
            self.left_out()
        ))
    }

    fn left_out(&self) -> String {
        let masked = self.comparison.masked;
        let Some(edges) = &self.edges else { return format!("{masked} pixels along ridges") };
        format!(
            "{masked} pixels ({:.2} %) along edges (ridges {}, outlines {}, shadows {}, kinks {})",
            100.0 * edges.share(),
            edges.ridges,
            edges.outlines,
            edges.shadows,
            edges.kinks
        )
    }

    fn row(&self) -> Vec<String> {
        let c = &self.comparison;
        let share = |levels: u32| {
            let beyond = c.beyond.iter().find(|beyond| beyond.levels == levels);
            beyond.map_or(String::new(), |beyond| format!("{:.3} %", beyond.share * 100.0))
        };
        vec![
            self.frame.map_or("-".into(), |frame| frame.to_string()),
            format!("{:.5}", c.rmse),
            self.linear.map_or("-".into(), |linear| format!("{:.5}", linear.rmse)),
            c.psnr_db.map_or("equal".into(), |psnr| format!("{psnr:.1} dB")),
            c.ssim.map_or("-".into(), |ssim| format!("{ssim:.4}")),
            share(0),
            share(1),
            share(2),
            format!("{}, {}: {:.3}, {:.3}", c.worst.column, c.worst.line, c.worst.test, c.worst.reference),
        ]
    }
}

/// The pair of the largest RMSE, the first of several.
fn worst(pairs: &[Pair]) -> &Pair {
    let worse = |a: &&Pair, b: &&Pair| b.comparison.rmse > a.comparison.rmse;
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
    let number = |key: &str| run.document["settings"]["display"][key].as_f64().unwrap_or(f64::NAN) as f32;
    let refused =
        |error| Failure::input(format!("{}: run.json, settings.display: {error}", folder.display()));
    Transfer::new(number("white"), number("gamma")).map_err(refused)
}

fn read(path: &Path) -> Result<GreyPicture, Failure> {
    Ok(read_png(path, &Limits::default())?)
}

fn read_mask(path: &Path) -> Result<Vec<bool>, Failure> {
    Ok(read(path)?.codes().iter().map(|code| *code > 0).collect())
}
