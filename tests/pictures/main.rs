//! Hashes of pictures of every shipped scenario under everything that draws, kept from commit to commit.
//!
//! ```text
//! scenarios x (models, generators), two scenarios x (economies, faults) --> first, middle, last frame --> hashes.json
//! ```
//!
//! A hash covers the bits of the plane `intensity` on the scenario's own raster. Where a machine refuses a scenario or a
//! frame, the text of the refusal stands in place of the hash.

mod cases;
mod draw;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;

use cases::{Case, cases};
use draw::hashes;

/// The record: from the name of a picture to its hash or refusal.
type Record = BTreeMap<String, String>;

/// Draw pictures of every shipped scenario under every machine, and keep or compare their hashes.
#[derive(Debug, Parser)]
#[command(
    name = "pictures",
    after_help = "Example: cargo run --release -p lunoid-tests --bin pictures -- --against tests/pictures/hashes.json"
)]
struct Options {
    /// Write the hashes to this file
    #[arg(long, value_name = "FILE", conflicts_with = "against")]
    record: Option<PathBuf>,
    /// Compare with the hashes of this file; the exit code is 1 if one differs
    #[arg(long, value_name = "FILE")]
    against: Option<PathBuf>,
    /// Draw only every N-th case, counted over all scenarios
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    every: u64,
    /// Draw only cases whose names contain this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

fn main() -> ExitCode {
    let options = Options::parse();
    match run(&options) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Draws the chosen cases, scenario by scenario; whether all that was compared is equal.
fn run(options: &Options) -> Result<bool, String> {
    let chosen: Vec<Case> = cases()?
        .into_iter()
        .enumerate()
        .filter(|(index, _)| (*index as u64).is_multiple_of(options.every))
        .map(|(_, case)| case)
        .filter(|case| options.only.as_ref().is_none_or(|text| case.name().contains(text)))
        .collect();
    let mut found = Record::new();
    for of_one in chosen.chunk_by(|a, b| a.scenario == b.scenario) {
        eprintln!("{}: {} cases", of_one[0].scenario, of_one.len());
        found.extend(hashes(of_one)?);
    }
    match (&options.record, &options.against) {
        (Some(path), _) => write(path, &found).map(|()| true),
        (None, Some(path)) => Ok(compare(&read(path)?, &found)),
        (None, None) => {
            found.iter().for_each(|(name, hash)| println!("{name}  {hash}"));
            Ok(true)
        }
    }
}

fn read(path: &Path) -> Result<Record, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))
}

fn write(path: &Path, record: &Record) -> Result<(), String> {
    let text = serde_json::to_string_pretty(record).map_err(|error| error.to_string())? + "\n";
    files::write_atomic(path, |out| out.write_all(text.as_bytes())).map_err(|error| error.to_string())
}

/// Prints each picture of `found` that `kept` has differently or not at all, and the count of all.
fn compare(kept: &Record, found: &Record) -> bool {
    let differs = |(name, hash): &(&String, &String)| kept.get(*name) != Some(hash);
    let different: Vec<_> = found.iter().filter(differs).collect();
    for (name, hash) in &different {
        let kept = kept.get(*name).map_or("nothing", String::as_str);
        println!("{name}: expected {kept}, found {hash}");
    }
    println!("{} of {} pictures are equal", found.len() - different.len(), found.len());
    different.is_empty()
}
