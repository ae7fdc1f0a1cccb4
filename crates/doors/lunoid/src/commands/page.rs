//! `lunoid page`: the page of a run, written again from its folder.

use std::path::PathBuf;

use clap::Args;
use replay::{HeldRun, PAGE, RunFolder};
use report::write_page;
use serde_json::json;

use command_line::output::{print, print_json};
use command_line::{Failure, Verdict};

const AFTER: &str = "Example:
  lunoid page runs/first-light

A replay writes the page by itself. This writes it again, from run.json, poses.csv, page.json
and the frames, after an update of the program or where index.html was lost. Sweeps are recorded
by `lunoid replay --probe 60:500`.";

/// Write the page of a run again, from its folder.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct PageCommand {
    /// Folder of a finished run.
    run: PathBuf,
    /// Print where the page is as JSON.
    #[arg(long)]
    json: bool,
}

impl PageCommand {
    /// Writes the page of the run and prints its path.
    pub fn run(&self) -> Result<Verdict, Failure> {
        // Before the folder is claimed: a claim would make one that is not there.
        HeldRun::read(&self.run)?;
        let folder = RunFolder::claim(&self.run, false)?;
        folder.expect_own([PAGE.to_owned()])?;
        let page = write_page(folder.path())?;
        let page = page.display().to_string();
        match self.json {
            true => print_json(&json!({ "schema": "lunoid.page-written/1", "page": page }))?,
            false => print(&format!("{page}\n"))?,
        }
        Ok(Verdict::Yes)
    }
}
