//! Prints the search for the set that the thesis must have timed, as the table of `docs/blocks/panels.md`.
//!
//! `cargo run -p panels --example timed_set`

#[path = "../tests/panels/timed_set.rs"]
#[allow(dead_code, reason = "the tests use the rest of the search")]
mod timed_set;

use std::error::Error;

use panels::Hardware;

fn main() -> Result<(), Box<dyn Error>> {
    let hardware = Hardware::shipped().map_err(|problems| problems.to_string())?;
    timed_set::table(&hardware).iter().for_each(|row| println!("{row}"));
    Ok(())
}
