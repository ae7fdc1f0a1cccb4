//! `lunoid probe`: waveforms of some signals of some sweeps.

use std::path::{Path, PathBuf};

use clap::Args;
use generator::{Planes, Stage};
use scenario::PoseTable;
use signal::{Probe, Signal, write_csv, write_npz};

use crate::commands::scope::{RANGE, write_picture};
use crate::loading::{StageArgs, Threads};
use crate::output::{expect_writable, print, print_json};
use crate::values::Span;
use crate::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid probe scenarios/first-light.toml --frame 12 --sweep 500..502 --signals 'tg.*,dpp.y' --out tg.npz

  lunoid probe scenarios/first-light.toml --frame 60 --sweep 500 --signals 'sweep.x,tg.*,dpp.blank' --out tg.png

The file is numpy's .npz (one array [sweep, sample] a signal), .csv, or, for one sweep, a picture of the waveforms
against ground range as .png: as its name says.";

/// Values that are recorded without being asked twice: 2 GB of f64.
const MOST_VALUES: u64 = 250_000_000;

/// Record waveforms of some signals of some sweeps.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct ProbeCommand {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frame, counted at the update rate.
    #[arg(long)]
    frame: u64,
    /// Sweeps, from 0 at the left: S or S..T without T.
    #[arg(long, value_name = "S[..T]")]
    sweep: Span,
    /// Signals, separated by commas, with * for any run of characters; `lunoid signals` lists them.
    #[arg(long, value_delimiter = ',', default_value = "*", value_name = "NAMES")]
    signals: Vec<String>,
    /// File to write: .npz, .csv or .png.
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
    /// Print what was recorded as JSON.
    #[arg(long)]
    json: bool,
}

impl ProbeCommand {
    /// Records.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let format = Format::of(&self.out)?;
        expect_writable(&self.out)?;
        let mut loaded = self.stage.load()?;
        let raster = loaded.settings.raster;
        let sweeps = self.sweep.within(&(0..u64::from(raster.sweeps))).ok_or_else(|| {
            let (span, end) = (self.sweep, raster.sweeps);
            Failure::usage(format!("--sweep {span}: a frame has sweeps 0..{end}; expected a range inside"))
        })?;
        if self.frame >= loaded.frames() {
            let (frame, end) = (self.frame, loaded.frames());
            return Err(Failure::usage(format!(
                "--frame {frame}: the scenario has frames 0..{end}; expected one of them"
            )));
        }
        if format == Format::Picture && sweeps.end - sweeps.start != 1 {
            let sweep = self.sweep;
            return Err(Failure::usage(format!("--sweep {sweep}: a picture shows one sweep; expected one")));
        }
        let signals = self.chosen(loaded.generator.signals(), loaded.generator.name())?;
        check_size(&signals, sweeps.end - sweeps.start, raster.samples.max(raster.lines))?;
        let pool = self.threads.pool()?;
        let stage = loaded.stage(&pool)?;
        let mut patterns = self.signals.clone();
        if format == Format::Picture {
            patterns.push(RANGE.into());
        }
        let mut probe = Probe::new(patterns, sweeps.start as u32..sweeps.end as u32);
        let row = PoseTable::resolve(
            &loaded.scenario,
            &stage.landscape,
            stage.settings.timebase.update,
            stage.settings.yoke,
            self.frame..self.frame + 1,
        );
        let row = row.map_err(Failure::input)?.rows()[0];
        let Stage { settings, .. } = &stage;
        let mut planes = Planes::new(settings.raster.columns as usize, settings.raster.lines as usize, &[]);
        let session = loaded.generator.prepare(stage).map_err(Failure::input)?;
        pool.install(|| session.frame(self.frame, &row.pose, &mut planes, &mut probe))
            .map_err(Failure::input)?;
        let names: Vec<&str> = signals.iter().map(|signal| signal.name).collect();
        match format {
            Format::Npz => write_npz(&self.out, &probe.waveforms)?,
            Format::Csv => write_csv(&self.out, &probe.waveforms)?,
            Format::Picture => write_picture(&self.out, &probe.waveforms, &names)?,
        }
        self.tell(&signals, sweeps)?;
        Ok(Verdict::Yes)
    }

    /// Every pattern must name something.
    fn chosen(&self, signals: &'static [Signal], generator: &str) -> Result<Vec<&'static Signal>, Failure> {
        if signals.is_empty() {
            return Err(Failure::usage(format!(
                "machine {generator} has no signals; expected a hardware model"
            )));
        }
        let matches = |pattern: &String| signals.iter().any(|signal| signal.matches(pattern));
        if let Some(pattern) = self.signals.iter().find(|pattern| !matches(pattern)) {
            return Err(Failure::usage(format!(
                "--signals {pattern}: no signal of this name; `lunoid signals` lists them"
            )));
        }
        Ok(signals
            .iter()
            .filter(|signal| self.signals.iter().any(|pattern| signal.matches(pattern)))
            .collect())
    }

    fn tell(&self, signals: &[&Signal], sweeps: std::ops::Range<u64>) -> Result<(), Failure> {
        let names: Vec<&str> = signals.iter().map(|signal| signal.name).collect();
        if self.json {
            return print_json(&serde_json::json!({
                "schema": "lunoid.probe/1",
                "file": self.out.display().to_string(),
                "frame": self.frame,
                "sweeps": [sweeps.start, sweeps.end],
                "signals": names,
            }));
        }
        let (out, frame) = (self.out.display(), self.frame);
        print(&format!(
            "{out}: frame {frame}, sweeps {}..{}: {}\n",
            sweeps.start,
            sweeps.end,
            names.join(", ")
        ))
    }
}

/// What is written, by the name of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Npz,
    Csv,
    Picture,
}

impl Format {
    fn of(out: &Path) -> Result<Self, Failure> {
        match out.extension().and_then(|extension| extension.to_str()) {
            Some("npz") => Ok(Self::Npz),
            Some("csv") => Ok(Self::Csv),
            Some("png") => Ok(Self::Picture),
            _ => Err(Failure::usage(format!(
                "--out {}: expected a name that ends in .npz, .csv or .png",
                out.display()
            ))),
        }
    }
}

fn check_size(signals: &[&Signal], sweeps: u64, samples: u32) -> Result<(), Failure> {
    let values = signals.len() as u64 * sweeps * u64::from(samples);
    if values <= MOST_VALUES {
        return Ok(());
    }
    let gigabytes = values as f64 * 8e-9;
    Err(Failure::usage(format!(
        "{values} values, {gigabytes:.1} GB: expected at most {MOST_VALUES}; choose fewer sweeps or signals"
    )))
}
