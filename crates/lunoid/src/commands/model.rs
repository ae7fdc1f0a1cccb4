//! `lunoid model`: hardware models and where each of their values came from.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use hardware_model::{HardwareModel, LoadedModel, ModelSource};
use serde_json::{Value, json};

use crate::commands::list;
use crate::output::{print, print_json};
use crate::{Failure, Verdict, values};

/// Show hardware models.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid model show ideal --set raster.sweeps=525")]
pub struct ModelCommand {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Show every value of a model and where it came from.
    Show(Show),
    /// List the models that can be named.
    List {
        /// Print as JSON.
        #[arg(long)]
        json: bool,
    },
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid model show ideal --overlay mine.toml")]
struct Show {
    /// Name or path.
    model: String,
    /// Merge a TOML file of differences over it; may be given several times.
    #[arg(long, value_name = "FILE")]
    overlay: Vec<PathBuf>,
    /// Set one key; may be given several times.
    #[arg(long, value_name = "PART.KEY=VALUE", value_parser = values::setting)]
    set: Vec<(String, String)>,
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

impl ModelCommand {
    /// Shows.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::Show(show) => show.run()?,
            What::List { json } => list::models(*json)?,
        }
        Ok(Verdict::Yes)
    }
}

impl Show {
    fn run(&self) -> Result<(), Failure> {
        let source = ModelSource::find(&self.model, Path::new(""))?;
        let loaded = HardwareModel::load(&source, &self.overlay, &self.set)?;
        if self.json { print_json(&document(&loaded)) } else { print(&loaded.effective()) }
    }
}

/// A model as JSON.
pub fn document(loaded: &LoadedModel) -> Value {
    let values = loaded
        .values
        .iter()
        .map(|value| json!({ "key": value.key, "value": value.value, "origin": value.origin }));
    json!({
        "schema": "lunoid.model/1",
        "name": loaded.model.name,
        "files": loaded.files.iter().map(|path| path.display().to_string()).collect::<Vec<_>>(),
        "values": values.collect::<Vec<_>>(),
    })
}
