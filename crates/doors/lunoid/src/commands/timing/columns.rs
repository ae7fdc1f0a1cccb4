//! `lunoid timing columns`: from every column that differs from the ideal machine to its cause.

use std::path::PathBuf;

use clap::Args;
use deadlines::columns::{FrameByFour, Limits, remembered};
use front_door::Opened;

use crate::frame::FrameArgs;
use crate::rehearsing::{record, rehearse_opened};
use command_line::loading::of_models;
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Example:
  lunoid timing columns scenarios/far-mountains.toml --machine pra-frugal --frame 3 \\
    --out columns.png

The ideal machine keeps the raster, the clocks, the range programme, the laws and the seed of
the run. Exit code 0 if every column that differs is traced to lines of the timing record or is
the work of the parts alone, 1 if not.";

/// Trace every column that differs from the ideal machine to lines of the timing record.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct Columns {
    #[command(flatten)]
    chosen: FrameArgs,
    /// A column differs if any pixel of it is off by more levels of 255 than this.
    #[arg(long, default_value_t = 8, value_parser = values::whole(0..=254_u32))]
    levels: u32,
    /// Lines of the record that are listed of each column, the last before its pixel; `timing show --misses` has all.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = values::at_least(0_usize))]
    lines: usize,
    /// Draw both pictures, their difference, and a strip with the class of every column.
    #[arg(short, long, value_name = "PNG|SVG")]
    out: Option<PathBuf>,
    /// Do not show any progress.
    #[arg(long)]
    no_progress: bool,
    /// Print columns, their lines and the totals as JSON.
    #[arg(long)]
    json: bool,
}

impl Columns {
    /// Draws the frame, traces its differing columns and prints them.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let stage = self.chosen.stage()?;
        expect_outputs(&Place::pictures([("--out", &self.out)]), &stage.sources())?;
        let opened = self.chosen.load(&stage)?;
        let (rehearsal, frames) =
            rehearse_opened(opened, &self.chosen.threads, |opened| self.choose(opened))?;
        let record = record(!self.no_progress, |hear| rehearsal.record(&frames, hear))?;
        let drawn = FrameByFour::draw(&rehearsal, self.chosen.frame)?;
        let columns = drawn.trace(&record, Limits { levels: self.levels, lines: self.lines })?;
        if let Some(path) = &self.out {
            columns.draw(path)?;
        }
        if self.json {
            print_json(&columns.json())?
        } else {
            print(&columns.text())?
        }
        Ok(if columns.are_accounted_for() { Verdict::Yes } else { Verdict::No })
    }

    /// The frame, behind those that its tube still shows.
    fn choose(&self, opened: &Opened) -> Result<Vec<u64>, Failure> {
        let frame = self.chosen.frame;
        self.chosen.expect_in(opened)?;
        let earlier = remembered(&opened.settings, frame);
        Ok(earlier.into_iter().rev().chain([frame]).collect())
    }
}
