//! Are the tests awake? Breaks the code on purpose, one break at a time, and reports which test notices.
//!
//! ```text
//! breaks.toml ─▶ tests pass unbroken? ─▶ break ─▶ cargo test, narrowest first ─▶ restore ─▶ table, JSON
//! ```
//!
//! A break that does not compile, or that ends a test program without naming a test, is a fault of the list: it does
//! not count as caught.

mod checkout;
mod record;
mod run;

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use clap::Parser;
use lunoid_tests::breaks::{Break, breaks};

use checkout::Checkout;
use record::{Outcome, Record};
use run::{check_unbroken, verdict};

/// Share of the list that tests must catch.
const ENOUGH: f64 = 0.95;

/// Set by Ctrl-C; whatever is broken is restored before the program ends.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Breaks the code on purpose, one break at a time, and reports which test notices.
#[derive(Debug, Parser)]
#[command(name = "awake", after_help = "Example: cargo run -p lunoid-tests --bin awake -- --only lag-gain")]
struct Options {
    /// Only the break of this name; may be given more than once
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,
    /// Only the first N breaks of the list
    #[arg(long, value_name = "N")]
    first: Option<usize>,
    /// Break this checkout and restore it, instead of a clone of its last commit in the target folder
    #[arg(long)]
    in_place: bool,
    /// Write what was found to this file as well; what it says of other breaks stays
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run_list(&Options::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Whether enough is caught.
fn run_list(options: &Options) -> Result<bool, String> {
    ctrlc::set_handler(|| INTERRUPTED.store(true, Ordering::Relaxed)).map_err(|error| error.to_string())?;
    let chosen = chosen(options)?;
    let checkout = if options.in_place { Checkout::here() } else { Checkout::cloned()? };
    checkout.check(&chosen)?;
    check_unbroken(&checkout, &chosen)?;
    println!("{:<34} {:>5}  caught by", "break", "s");
    let mut outcomes = Vec::new();
    for one in &chosen {
        let begun = Instant::now();
        let verdict = {
            let _restored_at_the_end = checkout.apply(one)?;
            verdict(&checkout, one)?
        };
        let seconds = begun.elapsed().as_secs_f64();
        println!("{:<34} {seconds:>5.1}  {verdict}", one.name);
        outcomes.push(Outcome { of: one.clone(), verdict, seconds });
    }
    let record = Record::new(&checkout, outcomes)?;
    if let Some(path) = &options.json {
        record.write(path)?;
    }
    println!("{}", record.summary());
    Ok(record.share() >= ENOUGH)
}

fn chosen(options: &Options) -> Result<Vec<Break>, String> {
    let mut chosen = breaks()?;
    for name in &options.only {
        if !chosen.iter().any(|one| one.name == *name) {
            return Err(format!("--only {name}: expected a name of the list tests/awake/breaks.toml"));
        }
    }
    chosen.retain(|one| options.only.is_empty() || options.only.contains(&one.name));
    chosen.truncate(options.first.unwrap_or(usize::MAX));
    if chosen.is_empty() {
        return Err("no break is chosen: expected --first of at least 1".into());
    }
    Ok(chosen)
}

/// An error once Ctrl-C was pressed.
fn go_on() -> Result<(), String> {
    if INTERRUPTED.load(Ordering::Relaxed) {
        Err("interrupted; what was broken is restored".into())
    } else {
        Ok(())
    }
}
