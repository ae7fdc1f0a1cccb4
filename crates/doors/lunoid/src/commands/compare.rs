//! `lunoid compare`: how far one picture, or one run, is from another.

use std::path::{Path, PathBuf};

use clap::Args;
use compare::EdgeLimits;
use replay::is_run_file;
use run_compare::{Compared, EdgeKind, LeftOut, Pictures, Tolerances};

use command_line::loading::{StageArgs, Threads};
use command_line::output::{Place, expect_outputs, print, print_json, tell};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid compare runs/first-light runs/exact
  lunoid compare a.png b.png --out difference.png --tolerance 2 --share 0.5
  lunoid compare runs/first-light runs/exact --edges scenarios/first-light.toml \\
    --tolerance 2 --share 0.5

Two pictures (PNG, JPEG, TIFF), or two run folders frame by frame. Exit code 1 when a tolerance
is given and not met. RMSE is of grey 0 to 1 as displayed; linear is the RMSE of reflectivity,
which runs say how to recover from their codes; the worst pixel is the one that differs most.
Pictures in colour are compared by luminance, and channel by channel if both are.";

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

impl Compare {
    /// Compares pictures or runs and prints their differences.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let picture = self.out.iter().map(|out| Place::file("--out", out).ending_in(&["png"]));
        expect_outputs(&picture.collect::<Vec<_>>(), &self.sources())?;
        let compared = self.compare_all()?;
        if let Some(out) = &self.out {
            let shown = compared.worst_picture(self.factor)?.encode_png(&[]).map_err(Failure::output)?;
            files::write_atomic(out, |file| file.write_all(&shown))?;
        }
        let pass = compared.pass(&self.tolerances());
        if self.json {
            print_json(&compared.json(pass))?
        } else {
            print(&compared.text(pass))?
        }
        Ok(if pass == Some(false) { Verdict::No } else { Verdict::Yes })
    }

    /// Files and folders that the command reads.
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

    fn compare_all(&self) -> Result<Compared, Failure> {
        let edges = self.edges_of();
        let pictures = Pictures::of(&self.test, &self.reference, edges.is_some())?;
        if let Some([both, test, reference]) = pictures.common {
            tell(&format!("frames in both runs: {both}, of {test} and {reference}\n"));
        }
        let Some((scenario, kind)) = edges else {
            return Ok(pictures.compare(LeftOut::Mask(self.mask.as_deref()), self.tolerance)?);
        };
        let left_out = LeftOut::Edges { scenario, kind, pool: &self.threads.pool()? };
        Ok(pictures.compare(left_out, self.tolerance)?)
    }

    fn tolerances(&self) -> Tolerances {
        Tolerances {
            rmse: self.max_rmse,
            levels: self.tolerance.map(|levels| (levels, self.share)),
            ridge: self.max_ridge,
        }
    }

    /// The scenario whose edges are left out, and which.
    fn edges_of(&self) -> Option<(&Path, EdgeKind)> {
        let (jump, kink) = (self.jump as f32, self.kink as f32);
        match (&self.ridges, &self.edges) {
            (Some(scenario), _) => Some((scenario, EdgeKind::Ridges { jump })),
            (_, Some(scenario)) => Some((scenario, EdgeKind::Edges(EdgeLimits { jump, kink }))),
            _ => None,
        }
    }
}
