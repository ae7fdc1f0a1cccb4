//! A state that stands in a file, and the machine that it is of.

use std::path::PathBuf;

use clap::{Args, Parser};
use deadlines::Rehearsal;
use front_door::Opened;
use state::{Bench, Mission, State};

use crate::rehearsing::rehearse;
use command_line::loading::{StageArgs, StageOptions, Threads};
use command_line::output::Place as Output;
use command_line::program::program;
use command_line::words::words;
use command_line::{Failure, values};

/// Words of a command line that choose a stage.
#[derive(Debug, Parser)]
struct Line {
    #[command(flatten)]
    stage: StageArgs,
}

/// A file with a state, and the scenario that it is of.
#[derive(Debug, Args)]
pub struct HeldArgs {
    /// File of the state.
    pub file: PathBuf,
    /// Scenario of the state; if left out, the scenario and the options with which the state was saved.
    #[arg(value_parser = values::scenario)]
    scenario: Option<PathBuf>,
    /// Hardware model by name or path, as it was given when the state was saved.
    #[arg(short, long, value_name = "MODEL")]
    machine: Option<String>,
    #[command(flatten)]
    options: StageOptions,
    #[command(flatten)]
    threads: Threads,
}

impl HeldArgs {
    /// Reads the state from its file.
    pub fn read(&self) -> Result<State, Failure> {
        Ok(State::read(&self.file)?)
    }

    /// The scenario and options that are asked for, or those of `state`.
    pub fn stage(&self, state: &State) -> Result<StageArgs, Failure> {
        let Self { scenario, machine, options, .. } = self;
        if let Some(scenario) = scenario {
            let (scenario, machine, options) = (scenario.clone(), machine.clone(), options.clone());
            return Ok(StageArgs { scenario, machine, options });
        }
        let asked = StageArgs { machine: machine.clone(), options: options.clone(), ..StageArgs::default() };
        if words(&asked).len() > 1 {
            return Err(Failure::usage(format!(
                "{}: a state has its own machine and settings; leave the options out, or give the scenario too",
                self.file.display()
            )));
        }
        self.saved(state)
    }

    /// The stage with which the state was saved.
    fn saved(&self, state: &State) -> Result<StageArgs, Failure> {
        let line =
            Line::try_parse_from(["lunoid"].into_iter().chain(state.head.words.iter().map(String::as_str)));
        let file = self.file.display();
        let mut stage = line
            .map_err(|_| {
                let words = state.head.words.join(" ");
                Failure::input(format!(
                    "{file}: header, words: found `{words}`, expected a scenario and options; give the scenario and its options"
                ))
            })?
            .stage;
        if !stage.scenario.is_file() {
            let scenario = stage.scenario.display();
            return Err(Failure::input(format!(
                "{file}: its scenario {scenario} is not here; run this where the state was saved, or give the scenario and its options"
            )));
        }
        // A file of somebody else must not have a folder written into.
        stage.options.shadow_cache = None;
        Ok(stage)
    }

    /// The mission of `stage`, which `state` may be of.
    pub fn rehearsal(&self, stage: &StageArgs, state: &State) -> Result<Rehearsal, Failure> {
        let frame = state.head.place.frame;
        let chosen = |opened: &Opened| Ok(vec![frame.min(opened.frames() - 1)]);
        Ok(rehearse(stage, &self.threads, chosen)?.0)
    }

    /// Files that no output may replace.
    pub fn sources(&self, stage: &StageArgs) -> Vec<Output> {
        let mut sources = stage.sources();
        sources.push(Output::file("the state", &self.file));
        sources
    }
}

/// The machine of a mission.
pub fn bench<'a>(rehearsal: &'a Rehearsal, stage: &StageArgs) -> Bench<'a> {
    let mut stage = stage.clone();
    stage.options.shadow_cache = None;
    rehearsal.pool.install(|| {
        Bench::new(Mission {
            program: program(),
            machine: &rehearsal.model.name,
            words: words(&stage),
            scenario: &rehearsal.scenario,
            stage: &rehearsal.stage,
            control: &rehearsal.control,
        })
    })
}
