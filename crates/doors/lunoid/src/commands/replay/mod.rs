//! `lunoid replay`: a scenario into a folder of frames.

mod live;
mod logs;
mod several;
mod share;
mod summary;

use std::io::{self, BufWriter, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use clap::{Args, ValueEnum};
use front_door::Opened;
use generator::Stage;
use hardware_model::ShadowCache;
use picture::Depth;
use quantities::Rate;
use rayon::ThreadPool;
use replay::{
    CONTACT_SHEET, Control, HeldRun, Job, Outcome, PAGE, PAGE_DATA, Performance, Phases, Pictures,
    ReplayError, RunFolder, TruthItems, TruthOutcome, is_run_file, run, write_truth, write_y4m,
};
use run_page::{Making, Request, check};
use serde_json::json;

use command_line::interrupt;
use command_line::loading::{QualityArgs, StageArgs, StageOptions, Threads, choose_frames, machine_help};
use command_line::output::{Place, expect_outputs, print, print_json, tell};
use command_line::program::program;
use command_line::progress::Saying;
use command_line::sharing::Sharing;
use command_line::words::words;
use command_line::{Failure, Verdict, values};
use live::{LiveArgs, LiveRun, stay};
use logs::{LogArgs, Logged};
use share::of_one;
use summary::{Summary, losses};
use text::{Span, visible};

const AFTER: &str = "Examples:
  lunoid replay scenarios/first-light.toml
  lunoid replay scenarios/first-light.toml --frames 0..2 --machine exact --out runs/exact
  lunoid replay scenarios/first-light.toml --y4m - | ffmpeg -i - film.mp4
  lunoid replay scenarios/first-light.toml --frames 0..2 --truth range,normal,label,pose
  lunoid replay scenarios/first-light.toml --probe 60:500 --probe '12:300..303:tg.*height,dpp.y'
  lunoid replay scenarios/first-light.toml --machine ideal --machine pra-nominal --frames 0..4
  lunoid replay scenarios/first-light.toml --frames 0..12 --mcap runs/first-light.mcap
  lunoid replay scenarios/first-light.toml --live
  lunoid replay scenarios/first-light.toml --shard 2/7

The same command again goes on where it was interrupted. Open index.html in the folder to look
at the run. Several machines draw into sub-folders of one folder, exact among them, and one page
holds them against it. The channels of a scenario draw into sub-folders too, unless --channel
names one of them.";

/// Draw a scenario into a folder of frames.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Replay {
    /// Scenario to draw: a file, or the name of one in `scenarios/`.
    #[arg(value_parser = values::scenario)]
    scenario: PathBuf,
    #[arg(short, long, value_name = "MODEL", help = several_help())]
    machine: Vec<String>,
    #[command(flatten)]
    options: StageOptions,
    #[command(flatten)]
    quality: QualityArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to draw, counted at the update rate: A..B without B. All if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    #[command(flatten)]
    sharing: Sharing,
    /// Share frames out by cost: by the time that each took in the run in this folder, drawn once with a small raster. Every
    /// worker must get the same folder. Each shard has equally many frames if left out.
    #[arg(long, value_name = "FOLDER", requires = "shard")]
    costs: Option<PathBuf>,
    /// Folder of the run; runs/NAME-OF-THE-SCENARIO if left out, of several machines with -side-by-side behind, of all channels with -channels, of one with its
    /// name, of a shard with -shard-K-of-N.
    #[arg(short, long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// One file for each showing of the display, with noise and lines of its own, instead of one for each frame that the machine
    /// computes.
    #[arg(long)]
    refresh: bool,
    /// Bits of a pixel.
    #[arg(long, value_enum, default_value = "8")]
    depth: DepthWord,
    /// An animated PNG as well, which a browser plays.
    #[arg(long)]
    apng: bool,
    /// A Y4M film as well; - is standard output.
    #[arg(long, value_name = "FILE")]
    y4m: Option<PathBuf>,
    /// Ground truth as well, by `exact` at the centre of every pixel, in the folder `truth` of the run: `all`, or some
    /// of range, height, normal, reflectivity, shadow, label, pose, distance, joined by commas. docs/truth-format.md has the
    /// format.
    #[arg(long, value_name = "LIST")]
    truth: Option<TruthItems>,
    #[command(flatten)]
    logs: LogArgs,
    /// Record sweeps for the page of the run, as waveforms that a click on their column leads to: of one frame a sweep or
    /// S..T, and signals separated by commas, with * for any run of characters; may be given several times. Sweeps
    /// recorded before stay.
    #[arg(long, value_name = "FRAME:SWEEP[:SIGNALS]")]
    probe: Vec<Request>,
    /// Check N sweeps, drawn at random and spread over the frames, against `exact`: error and its confidence stand in
    /// run.json and on the page, the time that it took in performance.json. docs/run-page.md says how.
    #[arg(long, value_name = "N", default_value = "0", hide_default_value = true,
          value_parser = values::at_least(0_u32), conflicts_with = "shard")]
    check: u32,
    /// Write no page: frames, records and what else is asked for.
    #[arg(long, conflicts_with = "probe")]
    no_page: bool,
    #[command(flatten)]
    live: LiveArgs,
    /// Remove the run that the folder holds, and nothing else, and start anew.
    #[arg(long)]
    fresh: bool,
    #[command(flatten)]
    saying: Saying,
}

/// What a session came to.
struct Made {
    outcome: Outcome,
    truth: Option<TruthOutcome>,
    logged: Logged,
}

/// Help of `--machine` where it may be given several times.
fn several_help() -> String {
    let judge = registry::judge().name;
    format!("{}; given several times, they stand side by side, with `{judge}` among them", machine_help())
}

/// Bits of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum DepthWord {
    /// 256 levels of grey.
    #[value(name = "8")]
    Eight,
    /// 65536 levels of grey.
    #[value(name = "16")]
    Sixteen,
}

impl Replay {
    /// Draws the scenario with one machine, or with several side by side. `start` is when the program began.
    pub fn run(&self, start: Instant) -> Result<Verdict, Failure> {
        let mut phases = Phases::since(start);
        phases.mark("start");
        match self.machine.as_slice() {
            [] => self.one(None, phases),
            [machine] => self.one(Some(machine.clone()), phases),
            machines => self.machines(machines, &phases),
        }
    }

    /// One machine: the channel that is asked for, or all that the scenario has.
    fn one(&self, machine: Option<String>, phases: Phases) -> Result<Verdict, Failure> {
        let mut stage = self.stage(machine);
        stage.options.quality = self.quality.asked();
        let opened = stage.load_any_view()?;
        match self.options.channel.is_none() && !opened.scenario.channels.is_empty() {
            true => self.channels(&stage, &opened, &phases),
            false => self.alone(&stage, opened, phases),
        }
    }

    fn alone(&self, stage: &StageArgs, mut opened: Opened, mut phases: Phases) -> Result<Verdict, Failure> {
        self.expect_one_on_stdout()?;
        self.logs.expect_possible(self.truth.as_ref())?;
        self.expect_live_possible()?;
        let shard = self.sharing.asked()?;
        let out = self.out(&of_one(self.options.channel.as_deref(), shard));
        self.expect_apart(stage, &out)?;
        let frames = choose_frames(&opened, self.frames)?;
        let part = shard.map(|shard| self.part(shard, &frames)).transpose()?;
        let generator = &*opened.generator;
        self.expect_sweeps(&opened)?;
        let lines = generator.scan(&opened.settings.view()).map_or(0, |scan| scan.timebase.sweeps);
        check(&self.probe, &frames, lines, generator)?;
        let pool = self.threads.pool()?;
        let folder = self.claim(&out)?;
        opened.keep_shadows(ShadowCache::of_run(folder.shadows()));
        let opened = &opened;
        interrupt::listen();
        phases.mark("read");
        let built = pool.install(|| opened.stage())?;
        phases.mark("landscape");
        let job = self.job(opened, built, frames);
        let job = match shard.zip(part) {
            None => job,
            Some((shard, frames)) => self.share(shard, job, frames, stage),
        };
        let live = self.begin_live(stage, opened, &job, &folder)?;
        let made = self.draw(stage, opened, &job, &folder, (&pool, &mut phases), live.as_deref())?;
        let verdict = self.tell(opened, &folder, made, phases)?;
        // Others may extend the run while its page is shown.
        drop(folder);
        if let (Some(live), Verdict::Yes) = (&live, verdict) {
            stay(live)?;
        }
        Ok(verdict)
    }

    /// The run folder, with room for the run's page where one is to be written.
    fn claim(&self, out: &Path) -> Result<RunFolder, ReplayError> {
        let folder = RunFolder::claim(out, self.fresh)?;
        let page = if self.no_page { &[][..] } else { &[PAGE, PAGE_DATA] };
        folder.expect_own(page.iter().map(|name| (*name).to_owned()))?;
        Ok(folder)
    }

    fn stage(&self, machine: Option<String>) -> StageArgs {
        StageArgs { scenario: self.scenario.clone(), machine, options: self.options.clone() }
    }

    /// What one machine is to draw.
    fn job<'a>(&self, opened: &'a Opened, stage: Stage, frames: Range<u64>) -> Job<'a> {
        let pictures = self.pictures(opened.generator.draws_colour(&stage));
        Job {
            program: program(),
            inputs: opened.inputs.clone(),
            scenario: &opened.scenario,
            generator: Arc::clone(&opened.generator),
            stage,
            frames,
            shard: None,
            pictures,
            check: self.check,
        }
    }

    /// Pictures, page and truth of one machine.
    fn draw(
        &self,
        stage: &StageArgs,
        opened: &Opened,
        job: &Job,
        folder: &RunFolder,
        (pool, phases): (&ThreadPool, &mut Phases),
        live: Option<&LiveRun>,
    ) -> Result<Made, Failure> {
        let cancel = interrupt::listen();
        let display = self.saying.display();
        let progress = |progress| {
            display.hear(progress);
            live.iter().for_each(|live| live.hear(progress));
        };
        let control = Control { pool, cancel, progress: &progress };
        let made = self.make(stage, (job, opened), folder, &control, phases);
        display.end();
        made
    }

    /// The pictures, and then, unless told to end, their page, the truth, and logs.
    fn make(
        &self,
        stage: &StageArgs,
        (job, opened): (&Job, &Opened),
        folder: &RunFolder,
        control: &Control,
        phases: &mut Phases,
    ) -> Result<Made, Failure> {
        let outcome = run(job, folder, control, phases)?;
        if matches!(outcome, Outcome::Finished { .. }) && !self.no_page {
            // Of sweeps to be recorded a shard has those of its own frames.
            let own = self.probe.iter().filter(|request| job.frames.contains(&request.frame));
            let (words, requests) = (words(stage), &own.cloned().collect::<Vec<_>>());
            Making { job, words, opened, requests, pool: control.pool }.write(folder, phases)?;
        }
        let items = self.truth_items();
        let truth = match (&outcome, &items) {
            (Outcome::Finished { .. }, Some(items)) => {
                let truth = write_truth(job, items, folder, control)?;
                phases.mark("truth");
                Some(truth)
            }
            _ => None,
        };
        let is_whole = matches!(outcome, Outcome::Finished { .. })
            && truth.is_none_or(|truth: TruthOutcome| truth.done == truth.frames);
        let logged = match is_whole && self.logs.is_asked() {
            true => {
                let logged = self.logs.write((job, opened), items.as_ref(), folder, control)?;
                phases.mark("logs");
                logged
            }
            false => Logged::default(),
        };
        Ok(Made { outcome, truth, logged })
    }

    /// The truth that is made: what was asked for, or what a robot log needs.
    fn truth_items(&self) -> Option<TruthItems> {
        self.logs.truth(self.truth.as_ref())
    }

    /// Only a machine has sweeps that can be checked.
    fn expect_sweeps(&self, opened: &Opened) -> Result<(), Failure> {
        if self.check > 0 && !opened.is_machine() {
            let (asked, name) = (self.check, opened.drawn_by());
            return Err(Failure::usage(format!(
                "--check {asked}: {name} has no sweeps to hold against the closed form; expected a hardware model"
            )));
        }
        Ok(())
    }

    fn expect_one_on_stdout(&self) -> Result<(), Failure> {
        if self.saying.json && self.y4m.as_deref().is_some_and(is_stdout) {
            return Err(Failure::usage(
                "--json and --y4m - both want standard output; give the film a file name",
            ));
        }
        Ok(())
    }

    /// Run and film replace nothing that `stage` is made of, and the film nothing of the run in `folder`.
    fn expect_apart(&self, stage: &StageArgs, folder: &Path) -> Result<(), Failure> {
        let run = Place::folder("--out", folder, is_run_file);
        let film = self.y4m.iter().filter(|path| !is_stdout(path)).map(|path| Place::file("--y4m", path));
        let outputs: Vec<Place> = [run].into_iter().chain(film).chain(self.logs.place()).collect();
        expect_outputs(&outputs, &stage.sources())
    }

    /// The folder asked for, or the usual one; `of` is what stands behind its name.
    fn out(&self, of: &str) -> PathBuf {
        let stem = self.scenario.file_stem().unwrap_or_default().to_string_lossy();
        self.out.clone().unwrap_or_else(|| Path::new("runs").join(format!("{stem}{of}")))
    }

    fn pictures(&self, colour: bool) -> Pictures {
        let depth = match self.depth {
            DepthWord::Eight => Depth::Eight,
            DepthWord::Sixteen => Depth::Sixteen,
        };
        Pictures { depth, colour, refresh: self.refresh, film: self.apng }
    }

    fn tell(
        &self,
        opened: &Opened,
        folder: &RunFolder,
        Made { outcome, truth, logged }: Made,
        mut phases: Phases,
    ) -> Result<Verdict, Failure> {
        if let Some((what, made)) = logged.unfinished() {
            return Ok(interrupted(what, made.done, made.frames));
        }
        match (outcome, truth) {
            (Outcome::Interrupted { done, of }, _) => Ok(interrupted("frames", done, of)),
            (_, Some(TruthOutcome { frames, done, .. })) if done < frames => {
                Ok(interrupted("frames' ground truth", done, frames))
            }
            (Outcome::Finished { frames, drawn, limits, performance }, truth) => {
                self.write_film(opened, folder, &mut phases)?;
                let held = HeldRun::read(folder.path())?;
                let performance = ended(performance, phases, folder)?;
                let first = if self.no_page { CONTACT_SHEET } else { PAGE };
                let summary = Summary {
                    folder: folder.path(),
                    frames: [frames.start, frames.end],
                    drawn,
                    truth,
                    logs: self.logs.told(&logged, folder.path()),
                    check: held.check.as_ref().filter(|_| self.check > 0).map(|check| json!(check)),
                    losses: losses(&held),
                    open: Some(folder.path().join(first)),
                    limits: limits.iter().map(ToString::to_string).collect(),
                    performance: performance.document(),
                };
                self.print(&summary)?;
                Ok(Verdict::Yes)
            }
        }
    }

    fn write_film(&self, opened: &Opened, folder: &RunFolder, phases: &mut Phases) -> Result<(), Failure> {
        let Some(path) = &self.y4m else { return Ok(()) };
        let held = HeldRun::read(folder.path())?;
        let view = opened.settings.view();
        let rate: Rate = if self.refresh { view.refresh } else { view.update };
        if is_stdout(path) {
            let mut out = BufWriter::new(io::stdout().lock());
            write_y4m(&mut out, folder.path(), &held, rate)
                .and_then(|()| out.flush())
                .map_err(Failure::stdout)?;
        } else {
            files::write_atomic(path, |out| write_y4m(out, folder.path(), &held, rate))?;
        }
        phases.mark("film");
        Ok(())
    }

    fn print(&self, summary: &Summary) -> Result<(), Failure> {
        let pipes = self.y4m.as_deref().is_some_and(is_stdout);
        match (self.saying.json, self.saying.quiet, pipes) {
            (true, _, _) => print_json(&summary.document()),
            (_, true, _) => Ok(()),
            (_, _, true) => {
                tell(&visible(&summary.text()));
                Ok(())
            }
            _ => print(&summary.text()),
        }
    }
}

/// The wall times of a session that has nothing left to do but to print, as `folder` keeps them.
fn ended(
    mut performance: Performance,
    mut phases: Phases,
    folder: &RunFolder,
) -> Result<Performance, ReplayError> {
    phases.mark("summary");
    performance.follow(&phases, folder)?;
    Ok(performance)
}

/// Says that the same command goes on.
fn interrupted(what: &str, done: u64, of: u64) -> Verdict {
    tell(&format!("interrupted: {done} of {of} {what} are whole; the same command again draws the rest\n"));
    Verdict::Interrupted
}

fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}
