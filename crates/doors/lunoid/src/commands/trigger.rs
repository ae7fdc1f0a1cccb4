//! `lunoid trigger`: where in a mission a signal does what is waited for.

use std::path::{Path, PathBuf};

use clap::Args;
use scope::ScopeError;
use signal::Signal;
use trigger::{Condition, ConditionError, Which};
use trigger_search::{Area, Around, BEAM, Finder, Found, Report, page, write_waveforms};

use crate::commands::again::command;
use crate::commands::probe::{Target, names};
use crate::rehearsing::rehearse;
use command_line::interrupt;
use command_line::loading::{StageArgs, Threads, choose_frames, of_models};
use command_line::output::{Place, expect_outputs, print, tell};
use command_line::progress::Display;
use command_line::{Failure, Verdict, values};
use text::Span;

const AFTER: &str = "Examples:
  lunoid trigger scenarios/first-light.toml --on 'rising tg.height 12'
  lunoid trigger scenarios/nominal-drive.toml --on late-load --frames 40..50 --all
  lunoid trigger scenarios/first-light.toml --on 'blank and tg.height > 5' --nth 3 --around 4
  lunoid trigger scenarios/first-light.toml --on 'slope mu.height > 0.4/m' --out there.png

CONDITION, clauses joined by `and`:
  SIGNAL > V   also >= < <= = !=             SIGNAL in A..B          SIGNAL outside A..B
  slope SIGNAL > V/m   also /sample /us      rising SIGNAL V [by H]  falling SIGNAL V [by H]
  SIGNAL enters A..B   SIGNAL leaves A..B    GATE                    GATE shorter W   GATE longer W [m, us]
  EVENT [= V]          fold [x, y] [= STOP]  late-load               blank   unblank
  saturation [SIGNAL]
docs/trigger-and-trace.md has the grammar; `lunoid signals` lists the signals.

Exit code 0: found; 1: not found.";

/// Find where in a mission a condition on signals is met: first, n-th, or all.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct TriggerCommand {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// What is waited for.
    #[arg(long, value_name = "CONDITION", value_parser = condition)]
    on: Condition,
    /// Frames, half-open; all if left out.
    #[arg(long, value_name = "A..B")]
    frames: Option<Span>,
    /// Sweeps of each frame that are looked at. (How many a frame has is --sweeps.)
    #[arg(long, value_name = "S..T")]
    sweep: Option<Span>,
    /// Samples of each sweep at which the trigger is armed. (How many a sweep has is --samples.)
    #[arg(long, value_name = "A..B")]
    sample: Option<Span>,
    /// The n-th place, from 1.
    #[arg(long, value_name = "N", value_parser = values::at_least(1_u64), conflicts_with = "all")]
    nth: Option<u64>,
    /// Show every place, not only the first.
    #[arg(long)]
    all: bool,
    /// Show so many samples before and after it.
    #[arg(long, value_name = "K", conflicts_with = "all", value_parser = values::whole(0..=100_000_u32))]
    around: Option<u32>,
    /// Show, and write, so many sweeps to the left and to the right of it.
    #[arg(long, value_name = "N", conflicts_with = "all", value_parser = values::whole(0..=8192_u32))]
    around_sweeps: Option<u32>,
    /// Write the sweep of the place: what the name ends in says how, as in `lunoid probe`.
    #[arg(short, long, value_name = "FILE", conflicts_with = "all")]
    out: Option<PathBuf>,
    /// Signals that are written beside those of the condition, separated by commas, with * for any run of characters.
    #[arg(long, value_delimiter = ',', value_name = "NAMES", requires = "out")]
    signals: Vec<String>,
    /// Print the places as JSON.
    #[arg(long)]
    json: bool,
    /// Do not show any progress.
    #[arg(short, long)]
    quiet: bool,
}

fn condition(text: &str) -> Result<Condition, ConditionError> {
    Condition::parse(text, machine::signals())
}

impl TriggerCommand {
    /// Searches the frames and prints the places found.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.check_signals(machine::signals())?;
        let file =
            self.out.as_deref().map(|out| File::named(out, self.around_sweeps.unwrap_or(0))).transpose()?;
        let outputs = file.as_ref().map_or(Vec::new(), File::places);
        expect_outputs(&outputs, &self.stage.sources())?;
        let mut places = None;
        let (rehearsal, frames) = rehearse(&self.stage, &self.threads, |opened| {
            let raster = &opened.settings.raster;
            let samples = if self.on.is_of_display() { raster.lines } else { raster.samples };
            let sweeps = within("--sweep", "sweeps", self.sweep, raster.sweeps)?;
            places = Some((sweeps, within("--sample", "samples", self.sample, samples)?));
            Ok(choose_frames(opened, self.frames)?.collect())
        })?;
        let (sweeps, samples) = places.unwrap_or_default();
        let cancel = interrupt::listen();
        let area = Area { frames, sweeps, samples };
        let display = Display::new(!self.quiet);
        let finder = Finder::new(&rehearsal, &self.on)?;
        let mut report = Report::new(&finder, self.json);
        print(&report.begin(self.on.text()))?;
        let sweeps = area.sweeps.clone();
        let progress = |progress| display.hear(progress);
        let ended = finder.search(&area, self.which(), &progress, cancel, |found| -> Result<(), Failure> {
            let around = self.look_around(&finder, &found, sweeps.clone(), file.as_ref())?;
            let next = around.as_ref().map_or_else(Vec::new, |around| next(&found, around, &self.stage));
            print(&report.add(&found, around.as_ref(), &next))
        });
        display.end();
        let ended = ended?;
        print(&report.end(&ended))?;
        if let Some(frame) = ended.interrupted_at {
            tell(&format!("interrupted: --frames {frame}.. goes on\n"));
            return Ok(Verdict::Interrupted);
        }
        Ok(if ended.shown > 0 { Verdict::Yes } else { Verdict::No })
    }

    fn which(&self) -> Which {
        if self.all { Which::All } else { Which::Nth(self.nth.unwrap_or(1)) }
    }

    /// Every pattern must name something.
    fn check_signals(&self, table: &[Signal]) -> Result<(), Failure> {
        let names = |pattern: &&String| table.iter().any(|signal| signal.matches(pattern));
        match self.signals.iter().find(|pattern| !names(pattern)) {
            None => Ok(()),
            Some(pattern) => Err(Failure::usage(format!(
                "--signals {pattern}: no signal of this name; `lunoid signals` lists them"
            ))),
        }
    }

    /// The neighbourhood of a place, where one place is wanted.
    fn look_around(
        &self,
        finder: &Finder<'_>,
        found: &Found,
        sweeps: std::ops::Range<u32>,
        file: Option<&File>,
    ) -> Result<Option<Around>, Failure> {
        if self.all {
            return Ok(None);
        }
        let beside = self.around_sweeps.unwrap_or(0);
        let near =
            found.sweep.saturating_sub(beside).max(sweeps.start)..(found.sweep + beside + 1).min(sweeps.end);
        let around = Around::record(
            finder,
            found,
            near,
            self.around,
            &self.signals,
            file.is_some_and(File::is_picture),
        )?;
        if let Some(file) = file {
            let title = format!("{}: {}", finder.title(), self.on.text());
            let written = file.write(finder, found, &around, title)?;
            tell(&format!("{}\n", names(&written).join(", ")));
        }
        Ok(Some(around))
    }
}

fn within(
    option: &str,
    what: &str,
    asked: Option<Span>,
    count: u32,
) -> Result<std::ops::Range<u32>, Failure> {
    let Some(span) = asked else { return Ok(0..count) };
    let found = span.within(&(0..u64::from(count))).ok_or_else(|| {
        Failure::usage(format!("{option} {span}: there are {what} 0..{count}; expected a range inside"))
    })?;
    Ok(found.start as u32..found.end as u32)
}

/// Commands that go on from a place.
fn next(found: &Found, around: &Around, stage: &StageArgs) -> Vec<String> {
    let Found { frame, sweep, hit, .. } = found;
    let of = |name: &str, rest: String| command(name, stage, *frame, &rest);
    let cursor = hit.range.map_or_else(String::new, |range| format!(" --cursor {:.4}", range.max(0.0)));
    let beam = BEAM.into_iter().filter(|name| !around.named.contains(name));
    let names = around.columns().chain(beam).collect::<Vec<_>>().join(",");
    let mut commands =
        vec![of("probe", format!("--sweep {sweep} --signals {names}{cursor} --out sweep.png"))];
    commands.extend(around.pixel.map(|[x, y]| of("explain", format!("--pixel {x},{y}"))));
    if hit.range.is_some() {
        commands.push(of("trace", format!("--at {sweep}:{}", hit.sample)));
    }
    commands
}

/// A file that is to be written.
struct File {
    path: PathBuf,
    target: Target,
}

impl File {
    /// The kind of file that its name says; `beside` is how many sweeps it has to each side.
    fn named(path: &Path, beside: u32) -> Result<Self, Failure> {
        let target = Target::of_name(path)?;
        if target == Target::Picture && beside > 0 {
            return Err(Failure::usage(
                "--around-sweeps: a picture shows one sweep; leave it out, or write another format",
            ));
        }
        Ok(Self { path: path.to_owned(), target })
    }

    /// All files that come of it.
    fn places(&self) -> Vec<Place> {
        self.target.places("--out", &self.path)
    }

    /// Whether it is a page of the scope.
    fn is_picture(&self) -> bool {
        self.target == Target::Picture
    }

    /// Writes it under `title`; the files that were written.
    fn write(
        &self,
        finder: &Finder<'_>,
        found: &Found,
        around: &Around,
        title: String,
    ) -> Result<Vec<PathBuf>, Failure> {
        let path = &self.path;
        match self.target {
            Target::Picture => {
                page(finder, found, around, &title)?.write(path).map_err(ScopeError::Write)?;
                Ok(vec![path.clone()])
            }
            Target::Waveforms(format) => Ok(write_waveforms((format, path), finder, found, around, title)?),
        }
    }
}
