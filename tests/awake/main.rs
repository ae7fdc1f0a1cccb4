//! Are the tests awake? Breaks the code on purpose, one break at a time, and reports which test notices.
//!
//! ```text
//! breaks.toml ─▶ tests pass unbroken? ─▶ break ─▶ cargo test, narrowest first ─▶ restore ─▶ table, JSON
//! ```
//!
//! A break that does not compile, or that ends a test program without naming a test, is a fault of the list: it does
//! not count as caught. A record is of one commit: what it says already is not run again, so that a run that was
//! interrupted goes on where it ended.

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
use record::Record;
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
    /// Only breaks of files whose paths begin so; may be given more than once
    #[arg(long, value_name = "PATH")]
    of: Vec<String>,
    /// Only the first N breaks of the list
    #[arg(long, value_name = "N")]
    first: Option<usize>,
    /// Break this checkout and restore it, instead of a clone of its last commit in the target folder
    #[arg(long, conflicts_with = "json")]
    in_place: bool,
    /// Profile of cargo to compile by, instead of the one with debug assertions and overflow checks; `release` has
    /// neither
    #[arg(long, value_name = "NAME")]
    profile: Option<String>,
    /// Keep what is found in this file, break by break; breaks that it has of the same commit are not run again
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
    let checkout = if options.in_place { Checkout::here() } else { Checkout::cloned()? };
    let checkout = match &options.profile {
        Some(profile) => Checkout { profile: profile.clone(), ..checkout },
        None => checkout,
    };
    let list = breaks(&checkout.root)?;
    let chosen = chosen(options, &list)?;
    let mut record = match &options.json {
        Some(path) => Record::resumed(path, checkout.commit()?, list.len())?,
        None => Record::new(checkout.commit()?, list.len())?,
    };
    let left: Vec<Break> = chosen.into_iter().filter(|one| !record.has(one)).collect();
    checkout.check(&left)?;
    check_unbroken(&checkout, &left)?;
    println!("{:<34} {:>5}  caught by", "break", "s");
    for one in &left {
        let begun = Instant::now();
        let verdict = {
            let _restored_at_the_end = checkout.apply(one)?;
            verdict(&checkout, one)?
        };
        let seconds = begun.elapsed().as_secs_f64();
        println!("{:<34} {seconds:>5.1}  {verdict}", one.name);
        record.add(one, verdict, seconds);
        if let Some(path) = &options.json {
            record.write(path)?;
        }
    }
    println!("{}", record.summary());
    Ok(record.share() >= ENOUGH)
}

fn chosen(options: &Options, list: &[Break]) -> Result<Vec<Break>, String> {
    for name in &options.only {
        if !list.iter().any(|one| one.name == *name) {
            return Err(format!("--only {name}: expected a name of the list tests/awake/breaks.toml"));
        }
    }
    let mut chosen = list.to_vec();
    chosen.retain(|one| options.only.is_empty() || options.only.contains(&one.name));
    let is_of = |one: &Break| {
        options.of.is_empty() || options.of.iter().any(|begin| one.file.to_string_lossy().starts_with(begin))
    };
    chosen.retain(is_of);
    chosen.truncate(options.first.unwrap_or(usize::MAX));
    if chosen.is_empty() {
        return Err(
            "no break is chosen: expected --first of at least 1, and --of a file that has breaks".into()
        );
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
