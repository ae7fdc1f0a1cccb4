//! Draws the pictures of `docs/link-study.md`, and prints the rows of its table.
//!
//! `cargo run --release -p lunoid-tests --example link_figures [FOLDER]`

use std::env;
use std::path::PathBuf;

use lunoid_tests::link::figures;

fn main() {
    let to = PathBuf::from(env::args().nth(1).unwrap_or_else(|| "docs/pictures/link".into()));
    std::fs::create_dir_all(&to).unwrap_or_else(|error| panic!("{}: {error}", to.display()));
    for figure in figures() {
        let stills = figure.stills();
        figure.leave(&to, &stills).unwrap_or_else(|error| panic!("{error}"));
        figure.rows(&stills).iter().for_each(|row| println!("{row}"));
    }
}
