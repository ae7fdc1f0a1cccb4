//! Prints how the shipped scenarios agree with `exact` at their full raster: the table of `docs/measuring.md`.
//!
//! `cargo run --release -p lunoid-tests --example agreement [SCENARIO ...]`

use std::env;

use lunoid_tests::Shipped;
use lunoid_tests::shipped::{FULL_LANDSCAPE, TERRAIN};

fn main() {
    println!(
        "| scenario | frame | raster | off by more than 2 levels | masked | ridge, 99 % (lines) | ridge, at most (lines) | over columns |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut names: Vec<String> = env::args().skip(1).collect();
    if names.is_empty() {
        names.extend(TERRAIN.into_iter().chain(FULL_LANDSCAPE).map(str::to_owned));
    }
    for name in names {
        let shipped = Shipped::read(&name, None);
        let last = shipped.frames() - 1;
        for frame in [0, last / 2, last] {
            let found = shipped.agreement(frame);
            let raster = shipped.settings.raster;
            println!(
                "| {name} | {frame} | {} x {} | {:.3} % | {:.2} % | {} | {} | {} |",
                raster.columns,
                raster.lines,
                100.0 * found.off,
                100.0 * found.masked,
                found.ridge,
                found.ridge_at_most,
                found.lit_columns
            );
            if last == 0 {
                break;
            }
        }
    }
}
