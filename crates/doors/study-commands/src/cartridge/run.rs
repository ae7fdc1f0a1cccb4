//! `lunoid cartridge run`: runs cartridges and reports their answers.

use std::path::PathBuf;

use cartridge::{Answer, Cartridge, CartridgeError, Outcome, Summary, junit};
use clap::Args;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde_json::json;

use super::Choice;
use command_line::loading::Threads;
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::program::COMMIT;
use command_line::sharing::{Sharing, part};
use command_line::{Failure, Verdict};
use text::table;

const AFTER: &str = "Examples:
  lunoid cartridge run 'one-coefficient*' --junit cartridges.xml
  lunoid cartridge run --shard 2/4 --junit runs/2-of-4.xml

An answer uses its tolerance up to 1. An overlay is a change of the scene under which an answer
must not come out. The exit code is 1 if an answer is wrong or an overlay is not noticed.";

/// Run cartridges, and see that each notices its overlays.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Run {
    #[command(flatten)]
    choice: Choice,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    sharing: Sharing,
    /// Write the result as JUnit XML as well.
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Print as JSON, with the derivation of every answer.
    #[arg(long)]
    json: bool,
}

impl Run {
    /// Runs the chosen cartridges and prints their answers.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let folder = self.choice.folder.iter().map(|folder| Place::folder("--folder", folder, is_cartridge));
        expect_outputs(&Place::given([("--junit", &self.junit)]), &folder.collect::<Vec<_>>())?;
        let cartridges = part(self.sharing.asked()?, self.choice.read()?, "cartridges")?;
        let run = || cartridges.par_iter().map(Cartridge::run).collect::<Result<Vec<Outcome>, _>>();
        let outcomes = self.threads.pool()?.install(run);
        let outcomes = outcomes.map_err(|error: CartridgeError| Failure::input(error))?;
        if let Some(file) = &self.junit {
            files::write_atomic(file, |out| out.write_all(junit(&outcomes).as_bytes()))?;
        }
        let summary = Summary::of(&outcomes);
        if self.json {
            let schema = "lunoid.cartridge.run/1";
            let document =
                json!({ "schema": schema, "commit": COMMIT, "summary": summary, "cartridges": outcomes });
            print_json(&document)?;
        } else {
            print(&text(&outcomes, &summary))?;
        }
        Ok(if summary.passed == summary.cartridges { Verdict::Yes } else { Verdict::No })
    }
}

/// Whether a name from the folder of cartridges on is that of a cartridge.
fn is_cartridge(name: &str) -> bool {
    name.ends_with("/cartridge.toml")
}

const HEADING: [&str; 8] = [
    "cartridge",
    "engine",
    "reading",
    "found",
    "expected",
    "worst error",
    "tolerance used",
    "overlays caught",
];

fn text(outcomes: &[Outcome], summary: &Summary) -> String {
    let heading = HEADING.map(str::to_owned).to_vec();
    let rows =
        outcomes.iter().flat_map(|outcome| outcome.answers.iter().map(move |answer| row(outcome, answer)));
    let mut text = table(&[heading].into_iter().chain(rows).collect::<Vec<_>>());
    let Summary { cartridges, passed, answers, worst_tolerance_used, worst, overlays, overlays_caught } =
        summary;
    text += &format!(
        "\n{passed} of {cartridges} cartridges passed, {answers} answers; {overlays_caught} of {overlays} overlays \
         caught; most of a tolerance used: {worst_tolerance_used:.3} ({worst})\n"
    );
    for fault in outcomes.iter().flat_map(Outcome::faults) {
        text += &format!("\n{fault}");
    }
    if passed < cartridges { text + "\n" } else { text }
}

/// One answer; the overlays are those of the cartridge on the same engine.
fn row(outcome: &Outcome, answer: &Answer) -> Vec<String> {
    let overlays = || outcome.overlays.iter().filter(|overlay| overlay.engine == answer.engine);
    let caught = overlays().filter(|overlay| overlay.caught).count();
    let mark = if answer.passed { "" } else { " WRONG" };
    vec![
        outcome.name.clone(),
        answer.engine.word().to_owned(),
        answer.reading.clone(),
        short(answer.found),
        short(answer.expected),
        format!("{:.2e}", answer.worst_error),
        format!("{:.3}{mark}", answer.tolerance_used),
        format!("{caught} of {}", overlays().count()),
    ]
}

/// A number in a column.
fn short(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-3..1e6).contains(&size) {
        let text = format!("{value:.6}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{value:.3e}")
}
