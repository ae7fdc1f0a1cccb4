//! `lunoid probe`: waveforms of some signals of some sweeps.

mod lines;
mod raster;
mod target;

use std::collections::BTreeMap;
use std::fmt::Display;
use std::ops::Range;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use between::Between;
use clap::Args;
use files::Kind;
use front_door::Opened;
use generator::{Scan, Stage};
use limits::Limit;
use lockstep::Engines;
use rayon::ThreadPool;
use scope::{
    Choice, Look, Looking, Order, Recorded, ScopeError, ScopeWishes, Tracing, WINDOW, Written, columns_of,
    draw, expect_known, needs, size, trace,
};
use serde_json::json;
use signal::Wire;
use waveform::{Format, Header};

use crate::commands::scope::{AxisWord, ScopeArgs};
use crate::frame::FrameArgs;
use command_line::loading::{expect_machine, machine_stage};
use command_line::output::{expect_outputs, print, print_json, tell};
use command_line::{Failure, Verdict, values};
use text::{Span, named_signals};

use target::words;
pub use target::{Target, names};

/// Time between two lines of progress.
const EVERY: Duration = Duration::from_secs(5);

/// Instants of a sample at most.
const MOST_BETWEEN: u32 = 64;

const AFTER: &str = "Examples:
  lunoid probe scenarios/first-light.toml --frame 12 --sweep 500..502 \\
    --signals 'tg.*,dpp.y' --out tg.npz
  lunoid probe runs/first-light --frame 12 --sweep all \\
    --signals 'sweep.x,sweep.y,tg.*.hold,tg.height' --out tg.fst
  lunoid probe scenarios/first-light.toml --frame 60 --sweep 500 \\
    --signals 'sweep.x,tg.fn.x.*,tg.*height,dpp.blank' --out tg.png
  lunoid probe scenarios/full-drive.toml --machine pra-nominal --frame 60 --sweep 200 \\
    --signals 'sweep.*,tg.product.00' --between 8 --out fine.csv
  lunoid probe scenarios/full-drive.toml --machine pra-nominal --frame 60 --line 100..102 \\
    --signals tube.video --out video.vcd

A run folder stands for the scenario and the options with which it was drawn. The file is what
its name says, or --format. FST and VCD open in GTKWave (`gtkwave tg.fst.gtkw` draws curves at
once), FST in Surfer, NPZ in numpy, raw in ngspice, sr in PulseView; docs/waveform-files.md says
what each holds. PNG and SVG are a page of the scope, of one sweep; of several sweeps a PNG
shows one signal of the display, sm.write, a column a sweep. About how large the file will be is
said before it is written.";

/// Record waveforms of some signals of some sweeps.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct ProbeCommand {
    #[command(flatten)]
    chosen: FrameArgs,
    /// Sweeps, from 0 at the left: S, S..T without T, or all.
    #[arg(long, value_name = "S[..T]", value_parser = span, default_value = "..", hide_default_value = true,
          required_unless_present = "line")]
    sweep: Span,
    /// Lines that the read beam scans, in the order of time, instead of sweeps: L, L..M without M, or all. With two fields a picture
    /// the lines of the first field come first. The signal is tube.video.
    #[arg(long, value_name = "L[..M]", value_parser = span, conflicts_with_all = ["sweep", "between"])]
    line: Option<Span>,
    /// Signals, separated by commas, with * for any run of characters; `lunoid signals` lists them.
    #[arg(long, value_delimiter = ',', default_value = "*", value_name = "NAMES")]
    signals: Vec<String>,
    /// Tell every wire at so many instants a sample, up to 64: at the sample, and between it and the next by the law of its part.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = values::whole(1..=MOST_BETWEEN))]
    between: u32,
    /// File of waveforms or picture to write.
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
    /// What kind of file it is; as its name ends if left out.
    #[arg(long, value_name = "FORMAT", value_parser = words())]
    format: Option<String>,
    /// Write the file even if it has more than 2 GB.
    #[arg(long)]
    large: bool,
    /// Say how large the file of waveforms would be, and write nothing.
    #[arg(long)]
    dry_run: bool,
    /// Print what was recorded as JSON.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    scope: ScopeArgs,
}

/// `all`, or a span.
fn span(text: &str) -> Result<Span, String> {
    if text == "all" { "..".parse() } else { text.parse() }
}

/// How the signals of the generator run.
fn scan(opened: &Opened) -> Result<Scan, Failure> {
    opened.generator.scan(&opened.settings.view()).ok_or_else(|| {
        let name = opened.generator.name();
        Failure::usage(format!("--machine {name}: it has no signals; expected a hardware model"))
    })
}

impl ProbeCommand {
    /// Records the chosen signals and writes the file.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let target = Target::of(self.format.as_deref(), &self.out)?;
        if let Some(lines) = self.line {
            return self.run_lines(target, lines);
        }
        self.expect_fitting(target)?;
        let stage = self.chosen.stage()?;
        expect_outputs(&target.places("--out", &self.out), &stage.sources())?;
        let opened = self.chosen.load(&stage)?;
        let generator = &opened.generator;
        let table = generator.signals();
        self.expect_sweeps(generator.line_signals())?;
        expect_known(table, &self.signals, generator.name())?;
        let sweeps = self.sweeps(&opened)?;
        let is_of_display = raster::of_display(target, table, &self.signals).is_some();
        self.expect_one_sweep(target, sweeps.clone(), is_of_display)?;
        let pool = self.chosen.threads.pool()?;
        let stage = pool.install(|| opened.stage())?;
        let pose = self.pose(&opened, &stage)?;
        let columns = columns_of(stage.landscape.bank());
        let raster = [stage.view.columns as usize, stage.view.lines as usize];
        let session = generator.prepare(stage).map_err(Failure::input)?;
        let choice = Choice::of(table, &session.wires(), &self.signals);
        expect_signals(&choice)?;
        let at_samples =
            Look { session: &*session, pool: &pool, frame: self.chosen.frame, pose: &pose, raster };
        let engines = self.engines(&opened, &pool)?;
        let mut scan = scan(&opened)?;
        let clocks = scan.timebase;
        scan.timebase = clocks.divided(self.between).map_err(Failure::input)?;
        let between = engines
            .as_ref()
            .map(|engines| Between::new(engines, &pool, (self.chosen.frame, &pose), [clocks, scan.timebase]));
        let look: &dyn Looking = between.as_ref().map_or(&at_samples, |between| between);
        let written = match target {
            Target::Picture if sweeps.len() > 1 => {
                self.draw_raster(look, &choice, sweeps.clone(), &opened.settings.display)?
            }
            Target::Picture => {
                let seen = Seen { look, wires: &session.wires(), columns: &columns, scan };
                self.draw(&seen, &opened, &choice, sweeps.start)?
            }
            Target::Waveforms(format) => {
                let header = self.header(&opened, &choice, (scan, sweeps.clone()));
                let (out, mut last) = (self.out.display(), Instant::now());
                trace(look, header, &self.order(format), &mut |heard| say(&out, &mut last, heard))?
            }
        };
        if let Some(between) = &between {
            tell_straight(between);
        }
        self.tell(target, &choice, sweeps, &written)?;
        Ok(Verdict::Yes)
    }

    /// Both engines, if wires are to be told between samples.
    fn engines(&self, opened: &Opened, pool: &ThreadPool) -> Result<Option<Engines>, Failure> {
        if self.between == 1 {
            return Ok(None);
        }
        expect_machine(opened, "--between: only the hybrid machine has parts that move between samples")?;
        Ok(Some(Engines::new(machine_stage(opened, pool)?)))
    }

    /// Options that the file asked for has no use for are refused, not passed over.
    fn expect_fitting(&self, target: Target) -> Result<(), Failure> {
        let out = self.out.display();
        match (target, self.scope.given()) {
            (Target::Picture, _) if self.dry_run => Err(Failure::usage(format!(
                "--dry-run: nobody knows how large the picture {out} will be; expected a file of waveforms"
            ))),
            (Target::Waveforms(_), Some(option)) => Err(Failure::usage(format!(
                "{option}: {out} is no picture; expected a name that ends in .png or .svg"
            ))),
            _ => Ok(()),
        }
    }

    fn sweeps(&self, opened: &Opened) -> Result<Range<u32>, Failure> {
        let (span, all) = (self.sweep, scan(opened)?.timebase.sweeps);
        let sweeps = span.within(&(0..u64::from(all))).ok_or_else(|| {
            Failure::usage(format!("--sweep {span}: a frame has sweeps 0..{all}; expected a range inside"))
        })?;
        self.chosen.expect_in(opened)?;
        Ok(sweeps.start as u32..sweeps.end as u32)
    }

    fn pose(&self, opened: &Opened, stage: &Stage) -> Result<scenario::Pose, Failure> {
        let frames = self.chosen.frame..self.chosen.frame + 1;
        let table = opened.poses(stage, frames);
        Ok(table.map_err(Failure::input)?.rows()[0].pose)
    }

    fn header(&self, opened: &Opened, choice: &Choice, (scan, sweeps): (Scan, Range<u32>)) -> Header {
        let scenario = opened.inputs.scenario.as_ref();
        let hash = scenario.map(|scenario| ("scenario_blake3", scenario.blake3.clone()));
        let provenance = [
            ("program", format!("lunoid {}", env!("CARGO_PKG_VERSION"))),
            ("commit", command_line::program::COMMIT.to_owned()),
            ("scenario", opened.path().display().to_string()),
            ("machine", opened.drawn_by().to_owned()),
        ];
        Header {
            title: format!("{}: frame {}", opened.scenario.title, self.chosen.frame),
            provenance: provenance.into_iter().chain(hash).map(|(key, words)| (key.into(), words)).collect(),
            wires: choice.wires.clone(),
            timebase: scan.timebase,
            lines: opened.settings.raster.lines,
            frame: self.chosen.frame,
            sweeps,
        }
    }

    fn order(&self, format: Format) -> Order<'_> {
        let Self { large, dry_run, .. } = *self;
        Order { format, out: &self.out, large, dry_run, window: WINDOW }
    }

    fn draw(
        &self,
        seen: &Seen<'_>,
        opened: &Opened,
        choice: &Choice,
        sweep: u32,
    ) -> Result<Written, Failure> {
        let Seen { look, wires, columns, scan } = *seen;
        let wanted = choice.names();
        let needed = needs(&scan);
        let recorded = wanted.iter().chain(&needed).map(|name| (*name).to_owned()).collect();
        let waveforms = look.at(recorded, sweep..sweep + 1)?;
        let recorded = Recorded {
            title: &opened.scenario.title,
            waveforms: &waveforms,
            wires,
            wanted: &wanted,
            scan,
            display: opened.settings.display,
            columns,
        };
        draw(&recorded, &self.wishes()?)?.write(&self.out).map_err(ScopeError::Write)?;
        Ok(Written { estimate: 0, files: vec![self.out.clone()] })
    }

    /// How the page is asked for; in X-Y the two signals are those of `--signals`, in their order.
    fn wishes(&self) -> Result<ScopeWishes, Failure> {
        let mut wishes = self.scope.wishes();
        if self.scope.axis == AxisWord::Xy {
            let pair: Result<[String; 2], _> = self.signals.clone().try_into();
            wishes.xy =
                Some(pair.map_err(|names| ScopeError::NoPair(format!("--signals names {}", names.len())))?);
            if self.scope.linear {
                return Err(Failure::usage("--linear: --axis xy has no ground range; leave one of them out"));
            }
        }
        Ok(wishes)
    }

    fn tell(
        &self,
        target: Target,
        choice: &Choice,
        sweeps: Range<u32>,
        written: &Written,
    ) -> Result<(), Failure> {
        for name in &choice.left_out {
            tell(&format!(
                "{name}: this machine has no such wire; 0 throughout (`lunoid signals` tells which it has, and what is left out)\n"
            ));
        }
        let (out, frame) = (self.out.display(), self.chosen.frame);
        if self.json {
            return print_json(&json!({
                "schema": "lunoid.probe/1",
                "file": out.to_string(),
                "files": names(&written.files),
                "format": target.name(&self.out),
                "frame": frame,
                "sweeps": [sweeps.start, sweeps.end],
                "signals": choice.names(),
                "left_out": choice.left_out,
                "estimated_bytes": (written.estimate > 0).then_some(written.estimate),
            }));
        }
        let signals = named_signals(&choice.names(), &self.signals);
        let dry = if self.dry_run {
            format!("about {}, not written: ", size(written.estimate))
        } else {
            String::new()
        };
        let of = if self.line.is_some() { "lines" } else { "sweeps" };
        let line = format!("{out}: {dry}frame {frame}, {of} {}..{}: {signals}\n", sweeps.start, sweeps.end);
        if Kind::of(&self.out).is_ok_and(|kind| kind == Kind::Stream) {
            // The device may be standard output.
            tell(&line);
            return Ok(());
        }
        print(&line)
    }
}

/// Refuses to record more signals than memory and a file of waveforms hold.
fn expect_signals(choice: &Choice) -> Result<(), Failure> {
    let (count, limit) = (choice.names().len(), Limit::Signals);
    if limit.allows(count as u64) {
        return Ok(());
    }
    let most = limit.value();
    Err(Failure::usage(format!(
        "--signals: {count} signals, expected at most {most}; name fewer, or {limit}"
    )))
}

/// What a picture is drawn of.
#[derive(Clone, Copy)]
struct Seen<'a> {
    look: &'a dyn Looking,
    wires: &'a [Wire],
    columns: &'a [usize],
    scan: Scan,
}

/// Says which wires went straight from sample to sample, and why.
fn tell_straight(between: &Between<'_>) {
    let mut by_reason: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (name, why) in between.straight() {
        by_reason.entry(why).or_default().push(name);
    }
    for (why, names) in by_reason {
        tell(&format!("straight from sample to sample ({why}): {}\n", names.join(", ")));
    }
}

/// Says how large the file will be, and how far it is every few seconds.
fn say(out: &dyn Display, last: &mut Instant, heard: Tracing) {
    match heard {
        Tracing::Size(bytes) => tell(&format!("{out}: about {}\n", size(bytes))),
        Tracing::Sweeps { done, all } if last.elapsed() >= EVERY => {
            *last = Instant::now();
            tell(&format!("sweeps {done}/{all}  {} %\n", 100 * u64::from(done) / u64::from(all)));
        }
        Tracing::Sweeps { .. } => {}
    }
}
