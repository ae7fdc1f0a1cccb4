//! `lunoid state step`: from place to place.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use serde_json::json;
use state::{Look, State, Unit};

use super::held::{HeldArgs, bench};
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict};

const AFTER: &str = "Examples:
  lunoid state step there.state --by event
  lunoid state step there.state --by sample --count 400
  lunoid state step there.state --by sweep --count -10 --out before.state

A step leads to the next place of its kind. A sweep's start is a place of every kind: its first
tick, its first sample, and an event. So N steps and N steps back lead to the same place, and
--out writes the same file again.";

/// Move a machine that stands in a file, forwards or backwards, and show what is there.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Step {
    #[command(flatten)]
    held: HeldArgs,
    /// What is stepped by.
    #[arg(long, value_enum, default_value_t = By::Sweep)]
    by: By,
    /// Number of steps; below 0 they lead backwards, and 0 shows where the machine is.
    #[arg(long, value_name = "N", default_value = "1")]
    count: i64,
    /// Write the state at the new place into this file.
    #[arg(short, long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Print what is there as JSON.
    #[arg(long)]
    json: bool,
}

/// What is stepped by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum By {
    /// Ticks of the master clock.
    Tick,
    /// Ticks at which something happens on the digital side, or a sweep begins.
    Event,
    /// Samples that are drawn.
    Sample,
    /// Starts of the sweeps.
    Sweep,
    /// Starts of the same sweep in other frames.
    Frame,
}

impl By {
    fn unit(self) -> Unit {
        match self {
            Self::Tick => Unit::Tick,
            Self::Event => Unit::Event,
            Self::Sample => Unit::Sample,
            Self::Sweep => Unit::Sweep,
            Self::Frame => Unit::Frame,
        }
    }
}

impl Step {
    /// Steps, writes the state there if asked for, and shows the place.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let state = self.held.read()?;
        let stage = self.held.stage(&state)?;
        let outputs: Vec<Place> = self.out.iter().map(|out| Place::file("--out", out)).collect();
        expect_outputs(&outputs, &self.held.sources(&stage))?;
        let rehearsal = self.held.rehearsal(&stage, &state)?;
        let bench = bench(&rehearsal, &stage);
        let unit = self.by.unit();
        let (look, moved) = rehearsal.pool.install(|| -> Result<_, Failure> {
            bench.restore(&state, &self.held.file)?;
            let place = bench.step(state.head.place, unit, self.count)?;
            let moved = self.out.as_ref().map(|_| bench.moved(&state, place)).transpose()?;
            Ok((bench.look(place, unit)?, moved))
        })?;
        if let (Some(moved), Some(out)) = (moved, &self.out) {
            moved.write(out)?;
        }
        self.tell(&state, &look)?;
        Ok(Verdict::Yes)
    }

    fn tell(&self, from: &State, look: &Look) -> Result<(), Failure> {
        let out = self.out.as_ref().map(|out| out.display().to_string());
        if self.json {
            let mut document = look.json();
            document["schema"] = json!("lunoid.state.step/1");
            document["from"] = json!(from.head.place);
            document["written"] = json!(out);
            return print_json(&document);
        }
        let written = out.map_or_else(String::new, |out| format!("{out}\n"));
        print(&format!("{}{written}", look.text()))
    }
}
