//! `lunoid lockstep`: machine and interpreter side by side.

mod tell;

use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::Args;
use front_door::Opened;
use hardware_model::{HardwareModel, Settings};
use lockstep::{Engines, Report, Trials, trials};
use machine::MachineStage;
use rayon::ThreadPool;
use scenario::{PoseTable, Scalar};

use command_line::loading::{
    ScalarWord, StageArgs, StageOptions, Threads, expect_machine, machine_stage, of_models,
};
use command_line::sharing::{Sharing, numbers, part};
use command_line::{Failure, Verdict, values};
use text::Span;

use tell::Told;

const AFTER: &str = "Examples:
  lunoid lockstep scenarios/first-light.toml
  lunoid lockstep scenarios/craters.toml --frame 12 --sweep 500..508 --scalar f32
  lunoid lockstep scenarios/nominal-drive.toml --machine pra-nominal --ideal-parts --every 50
  lunoid lockstep --random 1000 --seed 7
  lunoid lockstep --random 1000 --shard 2/4

The interpreter is a second engine in double precision that shares no code with the machine:
docs/lockstep.md says what is compared, within which bounds, and what it does not model. The
machine runs in f64 too; --scalar f32 has it run in what frames are drawn in. Without --frame
the first, the middle and the last frame run; without --sweep or --every eight sweeps of each.
The exit code is 1 if anything differs, and the first difference is told with signal, sweep,
sample, tick and both values; of a random scene the smallest one that still differs is told too.";

/// Run machine and interpreter side by side and compare every signal and every event.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct LockstepCommand {
    /// Scenario to draw: a file, or the name of one in `scenarios/`.
    #[arg(required_unless_present = "random", value_parser = values::scenario)]
    scenario: Option<PathBuf>,
    /// Hardware model by name or path; the scenario's own if left out.
    #[arg(short, long, value_name = "MODEL")]
    machine: Option<String>,
    #[command(flatten)]
    options: StageOptions,
    #[command(flatten)]
    threads: Threads,
    /// One frame, from 0, counted at the update rate.
    #[arg(long, conflicts_with = "random", value_parser = values::at_least(0_u64))]
    frame: Option<u64>,
    /// Sweeps, from 0 at the left: S or S..T without T.
    #[arg(long, value_name = "S[..T]", conflicts_with = "random")]
    sweep: Option<Span>,
    /// Compare only every K-th sweep.
    #[arg(long, value_name = "K", value_parser = values::at_least(1_u32), conflicts_with_all = ["sweep", "random"])]
    every: Option<u32>,
    /// Ideal parts in place of the model's; its raster, range programme, loader and processor stay.
    #[arg(long, conflicts_with = "random")]
    ideal_parts: bool,
    /// So many random scenes instead of a scenario.
    #[arg(long, value_name = "N", value_parser = values::at_least(1_u64), conflicts_with_all = [
        "scenario", "machine", "overlay", "set", "bank", "sweeps", "samples", "lossless", "everything",
        "shadow_cache"
    ])]
    random: Option<u64>,
    /// Seed of the first of them, 0 if left out; the next have the next.
    #[arg(long, value_parser = values::at_least(0_u64))]
    seed: Option<u64>,
    #[command(flatten)]
    sharing: Sharing,
    /// Print the tables as JSON.
    #[arg(long)]
    json: bool,
}

/// Sweeps of a frame if nobody says which.
const SWEEPS: u32 = 8;

impl LockstepCommand {
    /// Runs machine and interpreter, compares them and prints the report.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let pool = self.threads.pool()?;
        let told = match (self.random, self.seed, &self.scenario) {
            (Some(count), seed, _) => self.random(count, seed.unwrap_or(0), &pool)?,
            (None, Some(seed), _) => {
                return Err(Failure::usage(format!(
                    "--seed {seed}: a scenario is not drawn at random; leave it out, or give --random N in place of the \
                     scenario"
                )));
            }
            (None, None, Some(scenario)) => self.of(scenario, &pool)?,
            (None, None, None) => return Err(Failure::usage("expected a scenario file, or --random N")),
        };
        told.print(self.json)?;
        Ok(if told.agrees() { Verdict::Yes } else { Verdict::No })
    }

    fn of(&self, scenario: &Path, pool: &ThreadPool) -> Result<Told, Failure> {
        let stage = StageArgs {
            scenario: scenario.to_owned(),
            machine: self.machine.clone(),
            options: self.options.clone(),
        };
        let mut opened = stage.load()?;
        expect_machine(&opened, "there is no interpreter of it")?;
        opened.settings.scalar = self.scalar();
        if self.ideal_parts {
            opened.settings = Settings { analog: HardwareModel::ideal().analog, ..opened.settings };
        }
        let frames = self.frames(&opened)?;
        let stage = machine_stage(&opened, pool)?;
        let report = pool.install(|| self.compare(&opened, stage, &frames))?;
        let what = format!("{}, {}", opened.scenario.title, opened.inputs.model);
        Ok(Told { what, frames, report, faults: Vec::new() })
    }

    fn random(&self, count: u64, seed: u64, pool: &ThreadPool) -> Result<Told, Failure> {
        let end = seed.checked_add(count).ok_or_else(|| {
            Failure::usage(format!(
                "--random {count} --seed {seed}: expected a last seed of at most {}",
                u64::MAX - 1
            ))
        })?;
        let scalar = self.scalar();
        let shard = self.sharing.asked()?;
        let seeds = shard.map_or(Ok(seed..end), |shard| numbers(shard, &(seed..end), "seeds"))?;
        let Trials { scenes, refused, report, faults } = pool.install(|| trials(seeds.clone(), scalar));
        let Range { start, end } = seeds;
        let what = format!(
            "{scenes} random scenes of seeds {start}..{end} in {scalar:?}; {refused} could not be drawn"
        );
        Ok(Told { what, frames: Vec::new(), report, faults })
    }

    /// That of the interpreter, if nobody asks for another.
    fn scalar(&self) -> Scalar {
        match self.options.scalar {
            Some(ScalarWord::F32) => Scalar::F32,
            Some(ScalarWord::F64) | None => Scalar::F64,
        }
    }

    fn frames(&self, opened: &Opened) -> Result<Vec<u64>, Failure> {
        let all = opened.frames();
        match self.frame {
            None => {
                let mut frames = vec![0, all / 2, all - 1];
                frames.dedup();
                Ok(frames)
            }
            Some(frame) if frame < all => Ok(vec![frame]),
            Some(frame) => Err(Failure::usage(format!(
                "--frame {frame}: the scenario has frames 0..{all}; expected one of them"
            ))),
        }
    }

    fn sweeps(&self, all: u32) -> Result<Vec<u32>, Failure> {
        if let Some(span) = self.sweep {
            let sweeps = span.within(&(0..u64::from(all))).ok_or_else(|| {
                Failure::usage(format!(
                    "--sweep {span}: a frame has sweeps 0..{all}; expected a range inside"
                ))
            })?;
            return self.part((sweeps.start as u32..sweeps.end as u32).collect());
        }
        let every = self.every.unwrap_or(all.div_ceil(SWEEPS));
        if every > all {
            return Err(Failure::usage(format!(
                "--every {every}: a frame has {all} sweeps; expected no more"
            )));
        }
        self.part((0..all).skip(every as usize / 2).step_by(every as usize).collect())
    }

    /// The sweeps of the shard that is asked for.
    fn part(&self, sweeps: Vec<u32>) -> Result<Vec<u32>, Failure> {
        part(self.sharing.asked()?, sweeps, "sweeps of a frame to compare")
    }

    fn compare(&self, opened: &Opened, stage: MachineStage, frames: &[u64]) -> Result<Report, Failure> {
        let sweeps = self.sweeps(opened.settings.raster.sweeps)?;
        let MachineStage { landscape, settings, .. } = &stage;
        let (update, yoke) = (settings.timebase.update, settings.yoke);
        let poses =
            |frame: u64| PoseTable::resolve(&opened.scenario, landscape, update, yoke, frame..frame + 1);
        let tables: Vec<_> = frames.iter().map(|&frame| poses(frame)).collect();
        let engines = Engines::new(stage.clone());
        let mut sum = Report::default();
        for (&frame, table) in frames.iter().zip(tables) {
            let pose = table.map_err(Failure::input)?.rows()[0].pose;
            let report = engines.compare(frame, &pose, sweeps.iter().copied());
            sum.add(report.map_err(Failure::input)?);
        }
        Ok(sum)
    }
}
