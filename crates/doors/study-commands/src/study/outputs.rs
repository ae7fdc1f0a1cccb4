//! What a study leaves: text or a document on standard output, tables in a folder.

use std::path::PathBuf;

use clap::Args;
use front_door::Opened;
use hardware_model::ShadowCache;
use serde_json::Value;

use command_line::Failure;
use command_line::output::{Place, expect_outputs, expect_replaceable, print, print_json, tell};

/// Options that say where the results of a study go.
#[derive(Debug, Args)]
pub struct Outputs {
    /// Folder for tables and plots.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Do not show any progress.
    #[arg(long)]
    no_progress: bool,
    /// Print the result as JSON.
    #[arg(long)]
    json: bool,
}

impl Outputs {
    /// Tells of progress, to whoever wants to hear.
    pub fn say(&self, text: &str) {
        if !self.no_progress {
            tell(&format!("{text}\n"));
        }
    }

    /// Sees that nothing in the folder of which `writes` says that the study writes it is one of `inputs`, and that all of it can be replaced.
    pub fn expect_apart(&self, writes: fn(&str) -> bool, inputs: &[Place]) -> Result<(), Failure> {
        let folder = self.out.iter().map(|out| Place::folder("--out", out, writes));
        expect_outputs(&folder.collect::<Vec<_>>(), inputs)?;
        self.out.iter().try_for_each(|out| expect_replaceable(out, writes))
    }

    /// Every machine of a study wants the same shadow boundaries: they are found once if there is a place for them.
    pub fn keep_shadows(&self, opened: &mut Opened) {
        self.out.iter().for_each(|out| opened.keep_shadows(ShadowCache::shared(out.join("shadows"))));
    }

    /// Prints a result: `document` with `--json`, otherwise `text`.
    pub fn print(&self, document: &Value, text: &str) -> Result<(), Failure> {
        if self.json { print_json(document) } else { print(text) }
    }
}
