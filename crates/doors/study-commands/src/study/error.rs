//! `lunoid study error`: ladders of settings against `exact`.

use std::path::Path;

use clap::Args;
use exact::Columns;
use front_door::Opened;
use generator::ErrorLadder;
use hardware_model::{BUILT_IN, HardwareModel, ModelSource, Settings};
use study::ladder::{Extent, Ladder, ladders};
use study::polynomial::{POLYNOMIAL, polynomial_ladder};
use study::report::{ErrorReport, is_of};
use study::solver::{Chain, NOT_BUILT, SOLVER, solver_ladders};
use study::{
    Effort, ExactPictures, REGION_LADDERS, Rehearsed, StudyError, Subject, advise, climb, fronts,
    parameter_ladder, regions,
};

use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, machine_stage, of_models};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict, values};

/// The model whose parts make the chain that is solved.
const CHAIN_OF: &str = "pra-nominal";
/// Frames of a point: more would repeat what the first ones say.
const MOST_FRAMES: usize = 3;
/// Repetitions that are timed.
const REPETITIONS: u32 = 5;
const QUICK_REPETITIONS: u32 = 3;
/// A quick study has so many times fewer sweeps, columns and lines.
const QUICK_SHARE: u32 = 4;

const AFTER: &str = "Examples:
  lunoid study error scenarios/first-light.toml --quick
  lunoid study error scenarios/showpiece.toml --frame 0 --out studies/showpiece
  lunoid study error scenarios/first-light.toml --only samples --only scalar --json
  lunoid study error scenarios/lunsim-roving.toml --only grid
  lunoid study error scenarios/dust-curtain.toml --quick --only sampling --only stack

--out gets error.json, error.csv, error.md, a plot of error against time of all ladders and of
every ladder by itself, exact/ and shadows/, where pictures of exact and boundaries of shadow
are kept: the next study of the same ground takes them from there. docs/error-and-time.md says
how to read them.";

/// Error against run time: ladders of one factor about the settings of the scenario, and of some pairs.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct ErrorStudy {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frame to look at; up to three times. The middle of the mission if left out.
    #[arg(long, value_name = "F", value_parser = values::at_least(0_u64))]
    frame: Vec<u64>,
    /// Repetitions of each frame that are timed.
    #[arg(long, value_name = "N", value_parser = values::whole(1..=1000_u32))]
    repetitions: Option<u32>,
    /// This ladder alone; may be given several times.
    #[arg(long, value_name = "LADDER")]
    only: Vec<String>,
    /// A few rungs of each ladder, on a quarter of the sweeps, columns and lines.
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    outputs: Outputs,
}

impl ErrorStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.stage.expect_machine("a study holds a machine against the closed form")?;
        self.outputs.expect_apart(|file| is_of("error", file), &self.stage.sources())?;
        let mut opened = self.stage.load()?;
        if self.quick {
            quarter(&mut opened)?;
        }
        self.outputs.keep_shadows(&mut opened);
        let frames = frames(&self.frame, opened.frames())?;
        let pool = self.threads.pool()?;
        let stage = machine_stage(&opened, &pool)?;
        let subject = Subject::new(opened.scenario.clone(), opened.model.clone(), stage, &frames)
            .map_err(Failure::input)?;
        let outcome = pool.install(|| self.study(&opened, &subject))?;
        if let Some(folder) = &self.outputs.out {
            outcome.leave(folder)?;
        }
        self.outputs.print(&outcome.json(), &outcome.text())?;
        Ok(Verdict::Yes)
    }

    fn study(&self, opened: &Opened, subject: &Subject) -> Result<ErrorReport, Failure> {
        let extent = if self.quick { Extent::Quick } else { Extent::Whole };
        let chosen = self.chosen(opened, ladders(subject, &self.models()?, extent))?;
        let usual = if self.quick { QUICK_REPETITIONS } else { REPETITIONS };
        let effort = Effort { repetitions: self.repetitions.unwrap_or(usual) };
        let base = subject.stage.stage();
        let folder = self.outputs.out.as_ref().map(|out| out.join("exact"));
        let pictures = ExactPictures::new(COMMIT, &subject.scenario, &base, folder);
        let mut exact = pictures.map_err(StudyError::from).map_err(failure)?;
        let columns = Columns::new(subject.stage.stage());
        self.outputs.say("exact, and exact with its limits halved");
        let own = exact.self_error(&base, &subject.frames).map_err(failure)?;
        let mut study = Rehearsed { subject, exact: &mut exact, columns: &columns };
        let mut outcomes = Vec::with_capacity(chosen.len());
        for ladder in &chosen {
            self.outputs.say(&format!("{}: {} rungs", ladder.name, ladder.rungs.len()));
            let mut hear = |label: &str| self.outputs.say(&format!("  {label}"));
            outcomes.push(climb(&mut study, ladder, effort, &mut hear).map_err(failure)?);
        }
        for own in own_ladders(opened).iter().filter(|own| self.wants(own.name)) {
            self.outputs.say(own.what);
            let configure =
                |sets: &[(&str, &str)]| opened.configure_with(sets).map_err(|error| error.to_string());
            let climbed = parameter_ladder((own, &configure), subject, study.exact, effort, extent);
            outcomes.push(climbed.map_err(failure)?);
        }
        if REGION_LADDERS.into_iter().any(|name| self.wants(name)) {
            self.outputs.say("banks of several region sizes");
            let mut banks = regions(subject, extent, effort).map_err(failure)?;
            banks.retain(|ladder| self.wants(ladder.name));
            outcomes.extend(banks);
        }
        if self.wants(POLYNOMIAL) {
            self.outputs.say("ways to evaluate the ground along a sweep");
            outcomes.push(polynomial_ladder(subject, effort, extent).map_err(failure)?);
        }
        if self.wants(SOLVER) {
            self.outputs.say("solvers of an analog chain");
            let models = self.models()?;
            let real = models.iter().find(|model| model.name == CHAIN_OF).unwrap_or(&subject.model);
            outcomes.extend(solver_ladders(&Chain::of(real), effort, extent));
        }
        Ok(ErrorReport {
            commit: COMMIT.into(),
            title: subject.scenario.title.clone(),
            frames: subject.frames.iter().map(|(frame, _)| *frame).collect(),
            threads: rayon::current_num_threads(),
            exact: own,
            advice: advise(&outcomes),
            fronts: fronts(&outcomes),
            not_built: NOT_BUILT.filter(|_| self.wants(SOLVER)),
            ladders: outcomes,
        })
    }

    /// The shipped models, whose parts are a ladder.
    fn models(&self) -> Result<Vec<HardwareModel>, Failure> {
        let folder = self.stage.scenario.parent().unwrap_or(Path::new(""));
        let load = |name: &str| Ok(HardwareModel::load(&ModelSource::find(name, folder)?, &[], &[])?.model);
        BUILT_IN.iter().map(|(name, _)| load(name)).collect()
    }

    fn chosen(&self, opened: &Opened, mut all: Vec<Ladder>) -> Result<Vec<Ladder>, Failure> {
        let known = all.iter().map(|ladder| ladder.name).chain(REGION_LADDERS).chain([POLYNOMIAL, SOLVER]);
        let known: Vec<&str> = known.chain(own_ladders(opened).iter().map(|own| own.name)).collect();
        if let Some(unknown) = self.only.iter().find(|name| !known.contains(&name.as_str())) {
            return Err(Failure::usage(format!(
                "--only {unknown}: no such ladder for this scenario; known: {}",
                known.join(", ")
            )));
        }
        all.retain(|ladder| self.wants(ladder.name));
        Ok(all)
    }

    fn wants(&self, ladder: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|name| name == ladder)
    }
}

/// The ladders of the generator that the scenario names.
fn own_ladders(opened: &Opened) -> &'static [ErrorLadder] {
    opened.row.map_or(&[], |row| row.ladders)
}

/// The frames asked for, of `all`; the middle one if there are none.
pub(super) fn frames(asked: &[u64], all: u64) -> Result<Vec<u64>, Failure> {
    let mut frames = if asked.is_empty() { vec![all / 2] } else { asked.to_vec() };
    frames.sort_unstable();
    frames.dedup();
    if frames.len() > MOST_FRAMES {
        let found = frames.len();
        return Err(Failure::usage(format!("--frame: {found} frames; expected at most {MOST_FRAMES}")));
    }
    match frames.iter().find(|frame| **frame >= all) {
        Some(frame) => Err(Failure::usage(format!(
            "--frame {frame}: the scenario has frames 0..{all}; expected one of them"
        ))),
        None => Ok(frames),
    }
}

/// A quarter of the sweeps, columns and lines: a sixteenth of `exact`, a quarter of the machine.
pub(super) fn quarter(opened: &mut Opened) -> Result<(), Failure> {
    let settings = &opened.settings;
    let share = |count: u32| Some((count / QUICK_SHARE).max(1));
    let raster = &mut opened.scenario.raster;
    raster.sweeps = share(settings.raster.sweeps);
    raster.columns = share(settings.raster.columns);
    raster.lines = share(settings.raster.lines);
    let smaller = front_door::settings(&opened.scenario, &opened.model).map_err(Failure::input)?;
    opened.settings =
        Settings { economy: settings.economy, shadow_cache: settings.shadow_cache.clone(), ..smaller };
    Ok(())
}

/// Pictures that cannot be kept are a failure of an output; everything else comes of what was read.
pub(super) fn failure(error: StudyError) -> Failure {
    match error {
        StudyError::Reference(error) => Failure::output(error),
        other => Failure::input(other),
    }
}
