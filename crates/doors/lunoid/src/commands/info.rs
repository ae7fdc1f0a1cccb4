//! `lunoid info`: what a file or a run folder holds.

use std::path::PathBuf;

use clap::Args;
use file_info::Held;

use command_line::output::{print, print_json};
use command_line::{Failure, Verdict};

/// Say what a file or a run folder holds.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid info moon.bank\n\n\
    Knows banks, states of a machine, elevation files, scenarios, hardware models, landscapes, terrain databases,\n\
    pictures (PNG, JPEG), and run folders.")]
pub struct Info {
    /// File or folder to look into.
    file: PathBuf,
    /// Print the information as JSON.
    #[arg(long)]
    json: bool,
}

impl Info {
    /// Reads the file or folder and prints what it holds.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let held = Held::of(&self.file)?;
        if self.json {
            print_json(&held.document)?
        } else {
            print(&held.text)?
        }
        Ok(Verdict::Yes)
    }
}
