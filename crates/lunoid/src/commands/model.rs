//! `lunoid model`: hardware models, where their values came from, what they are made of and what they can do in time.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use hardware_model::{
    Asked, Budget, BudgetLine, Finding, Grade, Ground, HardwareModel, LoadedModel, PartCounts,
};
use serde_json::{Map, Value, json};

use crate::commands::list;
use crate::output::{print, print_json};
use crate::{Failure, Verdict, values};
use front_door::read_model;
use text::table;

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
    /// List the models and overlays that can be named.
    List(List),
}

/// A model with what is laid over it.
#[derive(Debug, Args)]
struct Named {
    /// Name or path.
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
    /// Print as JSON.
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
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:\n  lunoid model list --json")]
struct List {
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

impl ModelCommand {
    /// Shows, checks or lists.
    pub fn run(&self) -> Result<Verdict, Failure> {
        match &self.what {
            What::Show(show) => show.run(),
            What::Check(check) => check.run(),
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

impl GroundArgs {
    fn of(&self, model: &HardwareModel) -> Ground {
        let usual = model.usual_ground();
        Ground {
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
            print_json(&with_figures(document(&loaded), parts.as_ref(), budget.as_ref()))?;
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
        if self.json {
            print_json(&check_document(&loaded, ground, &found))?;
        } else if found.is_empty() {
            print(&format!("{}: nothing against it\n", loaded.model.name))?;
        } else {
            print(&table(&found.iter().map(finding_row).collect::<Vec<_>>()))?;
        }
        Ok(if can_be(&found) { Verdict::Yes } else { Verdict::No })
    }
}

fn can_be(found: &[Finding]) -> bool {
    found.iter().all(|finding| finding.grade != Grade::Refuse)
}

fn finding_row(finding: &Finding) -> Vec<String> {
    let grade = match finding.grade {
        Grade::Refuse => "refused".into(),
        Grade::Warn(artefact) => format!("warning {}", artefact.unwrap_or_default()).trim_end().to_owned(),
    };
    vec![grade, finding.keys.join(", "), finding.message.clone()]
}

fn check_document(loaded: &LoadedModel, ground: Ground, found: &[Finding]) -> Value {
    let rows = found.iter().map(|finding| {
        let (grade, artefact) = match finding.grade {
            Grade::Refuse => ("refuse", None),
            Grade::Warn(artefact) => ("warn", artefact),
        };
        json!({ "grade": grade, "artefact": artefact, "keys": finding.keys, "message": finding.message })
    });
    json!({
        "schema": "lunoid.model.check/1",
        "name": loaded.model.name,
        "region_size_m": ground.region_size,
        "range_m": ground.range,
        "ok": can_be(found),
        "findings": rows.collect::<Vec<_>>(),
    })
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

/// The document with what was asked for beside the values.
fn with_figures(mut document: Value, parts: Option<&PartCounts>, budget: Option<&Budget>) -> Value {
    if let Some(parts) = parts {
        let counts = parts.rows().into_iter().map(|(name, count)| (name.to_owned(), json!(count)));
        document["parts"] = Value::Object(counts.collect());
    }
    if let Some(budget) = budget {
        let lines = budget.lines().into_iter();
        let figures: Map<String, Value> =
            lines.map(|BudgetLine { key, value, .. }| (key.to_owned(), json!(value))).collect();
        document["budget"] = Value::Object(figures);
    }
    document
}
