//! `lunoid cartridge`: scenes whose answer is known in closed form.

mod run;

use std::path::PathBuf;

use cartridge::{Cartridge, CartridgeError, SCHEMA, carried, of_folder};
use clap::{Args, Subcommand};
use serde_json::{Value, json};

use command_line::output::{print, print_json};
use command_line::{Failure, Verdict};
use text::table;

const AFTER: &str = "Examples:
  lunoid cartridge run
  lunoid cartridge run 'crater*' --json
  lunoid cartridge run --folder my-cartridges --junit cartridges.xml
  lunoid cartridge list
  lunoid cartridge schema > cartridge.schema.json

tests/cartridges/README.md describes the file.";

/// Run test cartridges: scenes whose answer is known in closed form.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct CartridgeCommand {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Run cartridges, and see that each notices its overlays.
    Run(run::Run),
    /// List cartridges with their titles.
    List(List),
    /// Print the JSON schema of cartridge.toml.
    #[command(after_help = "Example:\n  lunoid cartridge schema > cartridge.schema.json")]
    Schema,
}

impl CartridgeCommand {
    /// Runs, lists, or prints the schema.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.action {
            Action::Run(run) => run.run(),
            Action::List(list) => list.run(),
            Action::Schema => print(SCHEMA).map(|()| Verdict::Yes),
        }
    }
}

/// Options that choose cartridges: name pattern and folder.
#[derive(Debug, Args)]
struct Choice {
    /// Name of cartridges, `*` for any run of characters; all if left out.
    pattern: Option<String>,
    /// Folder of cartridges, a folder with a cartridge.toml each; those that the program carries if left out.
    #[arg(long, value_name = "DIR")]
    folder: Option<PathBuf>,
}

impl Choice {
    /// Reads them; a pattern that names none is wrong usage.
    fn read(&self) -> Result<Vec<Cartridge>, Failure> {
        let all = self.folder.as_deref().map_or_else(carried, of_folder);
        let mut all = all.map_err(|error: CartridgeError| Failure::input(error))?;
        let Some(pattern) = &self.pattern else { return Ok(all) };
        all.retain(|cartridge| signal::name_matches(pattern, &cartridge.name));
        if all.is_empty() {
            return Err(Failure::usage(format!(
                "{pattern}: no cartridge has such a name; see lunoid cartridge list"
            )));
        }
        Ok(all)
    }
}

/// List cartridges with their titles.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid cartridge list")]
struct List {
    #[command(flatten)]
    choice: Choice,
    /// Print the list as JSON.
    #[arg(long)]
    json: bool,
}

impl List {
    fn run(&self) -> Result<Verdict, Failure> {
        let cartridges = self.choice.read()?;
        if self.json {
            let row = |cartridge: &Cartridge| json!({ "name": cartridge.name, "title": cartridge.title, "engines": cartridge.engines() });
            let rows: Vec<Value> = cartridges.iter().map(row).collect();
            print_json(&json!({ "schema": "lunoid.cartridge.list/1", "cartridges": rows }))?;
        } else {
            let heading = ["name", "engines", "shows"].map(str::to_owned).to_vec();
            let row = |cartridge: &Cartridge| {
                let engines: Vec<&str> = cartridge.engines().iter().map(|engine| engine.word()).collect();
                vec![cartridge.name.clone(), engines.join(", "), cartridge.title.clone()]
            };
            let rows: Vec<Vec<String>> = [heading].into_iter().chain(cartridges.iter().map(row)).collect();
            print(&table(&rows))?;
        }
        Ok(Verdict::Yes)
    }
}
