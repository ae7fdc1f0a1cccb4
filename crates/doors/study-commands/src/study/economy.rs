//! `lunoid study economy`: what is left out, what that saves, what remains.

use clap::Args;
use study::Subject;
use study::economy::economy;
use study::report::{EconomyReport, is_of};

use super::error::{failure, frames, quarter};
use super::outputs::Outputs;
use command_line::loading::{StageArgs, Threads, expect_machine, machine_stage, of_models};
use command_line::program::COMMIT;
use command_line::{Failure, Verdict, values};

/// Repetitions that are timed.
const REPETITIONS: u32 = 5;
const QUICK_REPETITIONS: u32 = 3;

const AFTER: &str = "Examples:
  lunoid study economy scenarios/first-light.toml --quick
  lunoid study economy scenarios/showpiece.toml --frame 0 --frame 150 --out studies/economy

--out gets economy.json, economy.csv, economy.md, a plot, and shadows/, where boundaries are
kept for the next study. The exit status is 1 if a machine that claims to draw the same bits
does not. docs/economy.md says how to read it.";

/// What the scenario does not need: left out, saved, and still wasted.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct EconomyStudy {
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
    /// A quarter of the sweeps, columns and lines.
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    outputs: Outputs,
}

impl EconomyStudy {
    /// Runs the study and prints its result.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let options = &self.stage.options;
        if options.lossless || options.everything {
            let advice = "the study draws with both and without; leave them out";
            return Err(Failure::usage(format!("--lossless, --everything: {advice}")));
        }
        self.outputs.expect_apart(|file| is_of("economy", file), &self.stage.sources())?;
        let mut opened = self.stage.load()?;
        expect_machine(&opened, "it leaves nothing out")?;
        if self.quick {
            quarter(&mut opened)?;
        }
        let frames = frames(&self.frame, opened.frames())?;
        let pool = self.threads.pool()?;
        self.outputs.keep_shadows(&mut opened);
        let stage = machine_stage(&opened, &pool)?;
        let subject = Subject::new(opened.scenario, opened.model, stage, &frames).map_err(Failure::input)?;
        let usual = if self.quick { QUICK_REPETITIONS } else { REPETITIONS };
        let repetitions = self.repetitions.unwrap_or(usual);
        let mut hear = |what: &str| self.outputs.say(what);
        let found = pool.install(|| economy(&subject, repetitions, &mut hear)).map_err(failure)?;
        let threads = pool.current_num_threads();
        let (commit, title) = (COMMIT.into(), subject.scenario.title.clone());
        let outcome = EconomyReport { commit, title, frames, threads, found };
        if let Some(folder) = &self.outputs.out {
            outcome.leave(folder)?;
        }
        self.outputs.print(&outcome.json(), &outcome.text())?;
        Ok(if outcome.found.holds() { Verdict::Yes } else { Verdict::No })
    }
}
