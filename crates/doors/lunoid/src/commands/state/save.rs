//! `lunoid state save`: the machine at the start of a sweep, into a file.

use std::path::PathBuf;

use clap::Args;
use deadlines::Rehearsal;
use serde_json::json;
use state::Place;

use super::held::bench;
use crate::frame::FrameArgs;
use command_line::loading::of_models;
use command_line::output::{Place as Output, expect_outputs, print, print_json};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid state save scenarios/first-light.toml --frame 60 --sweep 500 --out there.state
  lunoid state save scenarios/nominal-drive.toml --machine pra-overloaded --frame 40 \\
    --sweep 0 --out there.state --json

The file has the rows of the sweep memory that the frame has written, the earlier stores that a
storage tube still holds, the earlier pictures that the picture tube still shows, and the
digital side. docs/state-format.md describes it.";

/// Write the machine at the start of a sweep into a file.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct Save {
    #[command(flatten)]
    chosen: FrameArgs,
    /// Sweep of the frame at whose start the machine stands, from 0 at the left.
    #[arg(long, value_name = "S", value_parser = values::at_least(0_u32))]
    sweep: u32,
    /// File of the state.
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
    /// Print what was written as JSON.
    #[arg(long)]
    json: bool,
}

impl Save {
    /// Draws what the machine remembers at the place, and writes it.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let stage = self.chosen.stage()?;
        expect_outputs(&[Output::file("--out", &self.out)], &stage.sources())?;
        let opened = self.chosen.load(&stage)?;
        let rehearsal = self.chosen.rehearse(opened, |opened| {
            let sweeps = opened.settings.raster.sweeps;
            match self.sweep < sweeps {
                true => Ok(()),
                false => Err(Failure::usage(format!(
                    "--sweep {}: a frame has sweeps 0..{sweeps}; expected one of them",
                    self.sweep
                ))),
            }
        })?;
        let Rehearsal { pool, .. } = &rehearsal;
        let bench = bench(&rehearsal, &stage);
        let place = Place::start(self.chosen.frame, self.sweep);
        let state = pool.install(|| bench.save(place))?;
        state.write(&self.out)?;
        let out = self.out.display();
        match self.json {
            true => {
                let mut document = state.json();
                document["schema"] = json!("lunoid.state.save/1");
                document["file"] = json!(out.to_string());
                print_json(&document)?;
            }
            false => print(&format!("{out}: {}", state.text()))?,
        }
        Ok(Verdict::Yes)
    }
}
