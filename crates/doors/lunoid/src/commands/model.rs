//! `lunoid model`: hardware models, where their values came from, what they are made of and what they can do in time.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use file_info::{can_be_built, findings_document, findings_text, model_document_with};
use hardware_model::{Asked, EffectiveValue, GroundScale, HardwareModel, LoadedModel, PartCounts};
use serde_json::json;
use text::table;

use crate::commands::list;
use command_line::output::{print, print_json, warn};
use command_line::{Failure, Verdict, values};
use front_door::read_model;

/// Show, check and list hardware models.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid model show pra-nominal --budget --region-size-m 300")]
pub struct ModelCommand {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Show every value of a model and where it came from, its block diagram, or its timing budget.
    Show(Show),
    /// Say what in a model cannot hold together, and which artefacts it will show.
    Check(Check),
    /// List the keys whose values differ between two models.
    Diff(Diff),
    /// List the models and overlays that can be named.
    List(List),
}

/// A model with what is laid over it.
#[derive(Debug, Args)]
struct Named {
    /// Name or path of the model.
    model: String,
    /// Merge a TOML file of differences over it, or an overlay that the program carries, by name; may be given several
    /// times.
    #[arg(long, value_name = "FILE")]
    overlay: Vec<PathBuf>,
    /// Set one key; may be given several times.
    #[arg(long, value_name = "PART.KEY=VALUE", value_parser = values::setting)]
    set: Vec<(String, String)>,
}

/// The ground that a model is held against.
#[derive(Debug, Args)]
struct GroundArgs {
    /// Side of a region; 300 m if left out.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    region_size_m: Option<f64>,
    /// Ground range of a sweep; the model's own if left out.
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    range_m: Option<f64>,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:
  lunoid model show ideal --overlay mine.toml
  lunoid model show pra-nominal --diagram
  lunoid model show pra-nominal --budget --region-size-m 200 --range-m 5000

The budget is for straight sweeps over one level at a constant rate of ground range, averaged over azimuth.",
    mut_arg("region_size_m", |ground| ground.requires("budget")),
    mut_arg("range_m", |ground| ground.requires("budget")))]
struct Show {
    #[command(flatten)]
    named: Named,
    /// Print the block diagram with part counts instead.
    #[arg(long)]
    diagram: bool,
    /// Print the timing budget instead.
    #[arg(long)]
    budget: bool,
    #[command(flatten)]
    ground: GroundArgs,
    /// Print the model as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:
  lunoid model check pra-nominal --overlay tear

Exit code 0 if such a machine can be built, whatever it will show; 1 if it cannot; 3 if the model cannot be read.
Artefacts have the numbers of docs/hardware-model-format.md.")]
struct Check {
    #[command(flatten)]
    named: Named,
    #[command(flatten)]
    ground: GroundArgs,
    /// Print the findings as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:
  lunoid model diff pra-nominal pra-frugal

Exit code 0 if no value differs, 1 if one does, 3 if a model cannot be read.")]
struct Diff {
    /// Name or path of the first model.
    first: String,
    /// Name or path of the second.
    second: String,
    /// Print the differences as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid model list --json")]
struct List {
    /// Print the list as JSON.
    #[arg(long)]
    json: bool,
}

impl ModelCommand {
    /// Shows, checks or lists.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::Show(show) => show.run(),
            What::Check(check) => check.run(),
            What::Diff(diff) => diff.run(),
            What::List(List { json }) => list::models(*json).map(|()| Verdict::Yes),
        }
    }
}

impl Named {
    fn load(&self) -> Result<LoadedModel, Failure> {
        Ok(read_model(
            Asked { place: "MODEL", others: &[] },
            &self.model,
            Path::new(""),
            &self.overlay,
            &self.set,
        )?)
    }
}

impl Diff {
    fn run(&self) -> Result<Verdict, Failure> {
        let load = |place: &'static str, name: &str| {
            let asked = Asked { place, others: &[] };
            read_model(asked, name, Path::new(""), &[], &[]).map(|loaded| loaded.values)
        };
        let [first, second] = [load("FIRST", &self.first)?, load("SECOND", &self.second)?];
        let differences = differing_values(&first, &second);
        if self.json {
            let row = |(key, [first, second]): &(String, [Option<String>; 2])| json!({ "key": key, "first": first, "second": second });
            print_json(&json!({
                "schema": "lunoid.model.diff/1",
                "first": self.first,
                "second": self.second,
                "differences": differences.iter().map(row).collect::<Vec<_>>(),
            }))?;
        } else if differences.is_empty() {
            print(&format!("{} and {} have the same values\n", self.first, self.second))?;
        } else {
            let head = vec!["key".to_owned(), self.first.clone(), self.second.clone()];
            let told = |value: &Option<String>| value.clone().unwrap_or_else(|| "not there".to_owned());
            let rows = differences.iter().map(|(key, [a, b])| vec![key.clone(), told(a), told(b)]);
            print(&table(&[head].into_iter().chain(rows).collect::<Vec<_>>()))?;
        }
        Ok(if differences.is_empty() { Verdict::Yes } else { Verdict::No })
    }
}

/// Keys that say what a file is, not what a machine is.
const OF_THE_FILE: [&str; 3] = ["base", "format", "name"];

/// Keys whose values differ, with both, in alphabetical order.
fn differing_values(
    first: &[EffectiveValue],
    second: &[EffectiveValue],
) -> Vec<(String, [Option<String>; 2])> {
    let mut all = BTreeMap::<String, [Option<String>; 2]>::new();
    for (side, values) in [first, second].into_iter().enumerate() {
        for value in values.iter().filter(|value| !OF_THE_FILE.contains(&value.key.as_str())) {
            all.entry(value.key.clone()).or_default()[side] = Some(value.value.clone());
        }
    }
    all.into_iter().filter(|(_, [a, b])| a != b).collect()
}

impl GroundArgs {
    fn of(&self, model: &HardwareModel) -> GroundScale {
        let usual = model.usual_ground();
        GroundScale {
            region_size: self.region_size_m.unwrap_or(usual.region_size),
            range: self.range_m.unwrap_or(usual.range),
        }
    }
}

impl Show {
    fn run(&self) -> Result<Verdict, Failure> {
        let loaded = self.named.load()?;
        let parts = self.diagram.then(|| PartCounts::of(&loaded.model));
        let budget = self.budget.then(|| loaded.model.budget(self.ground.of(&loaded.model)));
        if self.json {
            print_json(&model_document_with(&loaded, parts.as_ref(), budget.as_ref()))?;
        } else if parts.is_none() && budget.is_none() {
            print(&loaded.effective())?;
        } else {
            let texts = parts.map(|parts| parts.to_string()).into_iter();
            let texts = texts.chain(budget.map(|budget| budget.to_string()));
            print(&texts.collect::<Vec<_>>().join("\n"))?;
        }
        Ok(Verdict::Yes)
    }
}

impl Check {
    fn run(&self) -> Result<Verdict, Failure> {
        let loaded = self.named.load()?;
        let ground = self.ground.of(&loaded.model);
        let found = loaded.model.check_over(ground);
        loaded.remarks.iter().for_each(|remark| warn(remark));
        if self.json {
            print_json(&findings_document(&loaded, ground, &found))?;
        } else if found.is_empty() {
            print(&format!("{}: nothing against it\n", loaded.model.name))?;
        } else {
            print(&findings_text(&found))?;
        }
        Ok(if can_be_built(&found) { Verdict::Yes } else { Verdict::No })
    }
}
