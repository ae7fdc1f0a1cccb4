//! `lunoid study stability`: parts and whole frames at their limits.

use std::path::{Path, PathBuf};

use clap::Args;
use hardware_model::{HardwareModel, ModelSource};
use scenario::Scenario;
use study::Subject;
use study::ladder::Extent;
use study::report::{StabilityReport, is_of, make_folder};
use study::stability::{BASE, Choice, StabilityScene, matrix, rows, survey_fits};

use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, machine_stage};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid study stability --quick
  lunoid study stability --out studies/stability
  lunoid study stability scenarios/first-light.toml --only light --only corner
  lunoid study stability --only eye --pairs
  lunoid study stability --mixtures 1000 --seed 7

Without a scenario a small one that the program carries is pushed to its limits; of a scenario
it is the ground of the finest level, the eye and the light of its first frame. --out gets
stability.json, stability.csv, stability.md, and the matrix as a picture, matrix.svg and
matrix.png. The exit code is 1 if a method of the machine has a cell that does not hold.
docs/stability.md says how to read it.";

/// The models of the matrix: ideal parts and real ones.
const MODELS: [&str; 2] = ["ideal", "pra-nominal"];

/// Stability: stiff parts and extreme scenes, each by every method.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct StabilityStudy {
    /// Scenario file; a small scene of its own if left out.
    #[arg(value_parser = values::scenario)]
    scenario: Option<PathBuf>,
    #[command(flatten)]
    threads: Threads,
    /// Short runs: drift over a million samples, not a thousand million.
    #[arg(long)]
    quick: bool,
    /// Every pair of extremes of different rows as well.
    #[arg(long, conflicts_with = "quick")]
    pairs: bool,
    /// So many random mixtures of extremes as well.
    #[arg(long, value_name = "N", default_value_t = 0, conflicts_with = "quick", value_parser = values::at_least(0_u32))]
    mixtures: u32,
    /// Seed of the mixtures.
    #[arg(long, value_name = "SEED", default_value_t = 1, requires = "mixtures", value_parser = values::at_least(0_u64))]
    seed: u64,
    /// This row alone; may be given several times.
    #[arg(long, value_name = "ROW")]
    only: Vec<String>,
    #[command(flatten)]
    outputs: Outputs,
}

/// The row of the survey fit, which is a table of its own.
const SURVEY: &str = "survey";

impl StabilityStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.check_rows()?;
        let sources = self.scenario.as_deref().map_or(Vec::new(), |file| StageArgs::of(file).sources());
        self.outputs.expect_apart(|file| is_of("stability", file), &sources)?;
        self.outputs.out.as_deref().map_or(Ok(()), make_folder)?;
        let pool = self.threads.pool()?;
        let outcome = pool.install(|| self.study())?;
        if let Some(folder) = &self.outputs.out {
            outcome.leave(folder)?;
        }
        self.outputs.print(&outcome.json(), &outcome.text())?;
        Ok(if outcome.holds() { Verdict::Yes } else { Verdict::No })
    }

    fn check_rows(&self) -> Result<(), Failure> {
        let known: Vec<&str> = rows().into_iter().chain([SURVEY]).collect();
        match self.only.iter().find(|row| !known.contains(&row.as_str())) {
            Some(row) => {
                Err(Failure::usage(format!("--only {row}: no such row; known: {}", known.join(", "))))
            }
            None => Ok(()),
        }
    }

    fn study(&self) -> Result<StabilityReport, Failure> {
        let subject = self.subject()?;
        let folder = self.scenario.as_deref().and_then(Path::parent).unwrap_or(Path::new(""));
        let load = |name: &str| -> Result<HardwareModel, Failure> {
            Ok(HardwareModel::load(&ModelSource::find(name, folder)?, &[], &[])?.model)
        };
        let [ideal, parts] = [load(MODELS[0])?, load(MODELS[1])?];
        let choice = Choice {
            extent: if self.quick { Extent::Quick } else { Extent::Whole },
            rows: self.only.clone(),
            pairs: self.pairs,
            mixtures: self.mixtures,
            seed: self.seed,
        };
        let cells = matrix(&StabilityScene::of(&subject), [&ideal, &parts], &choice, &mut |name| {
            self.outputs.say(name)
        });
        let is_wanted = self.only.is_empty() || self.only.iter().any(|row| row == SURVEY);
        let fits = if is_wanted { survey_fits() } else { Vec::new() };
        let (commit, title) = (COMMIT.into(), subject.scenario.title.clone());
        Ok(StabilityReport { commit, title, seed: self.seed, cells, fits })
    }

    fn subject(&self) -> Result<Subject, Failure> {
        let (scenario, model, stage) = match &self.scenario {
            Some(file) => {
                let opened = StageArgs::of(file).load()?;
                let stage = machine_stage(&opened, &self.threads.pool()?)?;
                (opened.scenario, opened.model, stage)
            }
            None => {
                let scenario = Scenario::parse("small", BASE)?;
                let source = ModelSource::find(MODELS[0], Path::new(""))?;
                let model = HardwareModel::load(&source, &[], &[])?.model;
                let settings = front_door::settings(&scenario, &model).map_err(Failure::input)?;
                let stage = front_door::build(&scenario, settings).map_err(Failure::input)?;
                (scenario, model, stage)
            }
        };
        Subject::new(scenario, model, stage, &[0]).map_err(Failure::input)
    }
}
