//! The page of trust: what its commands printed, and the page made of it.
//!
//! ```sh
//! cargo run -p lunoid-tests --bin trust                                  # the page from what is kept in docs/trust/
//! cargo run -p lunoid-tests --bin trust -- --measure all                 # every command again first; an hour or so
//! cargo run -p lunoid-tests --bin trust -- --measure kills,disks
//! ```

use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use lunoid_tests::trust::{EVIDENCE, Evidence, measure, page};

/// Make docs/trust.md from the kept results, after running commands again if asked to.
#[derive(Debug, Parser)]
struct Arguments {
    /// Evidence to measure again: names, or `all`.
    #[arg(long, value_delimiter = ',', value_name = "NAME")]
    measure: Vec<String>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let known = |name: &String| name == "all" || EVIDENCE.iter().any(|evidence| evidence.name == name);
    if let Some(name) = arguments.measure.iter().find(|name| !known(name)) {
        let names: Vec<&str> = EVIDENCE.iter().map(|evidence| evidence.name).collect();
        return Err(format!("no evidence {name}; there are: {}, all", names.join(", ")));
    }
    let house = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let is_meant =
        |evidence: &&Evidence| arguments.measure.iter().any(|name| name == "all" || name == evidence.name);
    for evidence in EVIDENCE.iter().filter(is_meant) {
        eprintln!("{}: {}", evidence.name, evidence.command);
        measure(&house, evidence)?;
    }
    let text = page(&house.join("docs/trust"))?;
    files::write_atomic(house.join("docs/trust.md"), |out| out.write_all(text.as_bytes()))
        .map_err(|error| error.to_string())
}
