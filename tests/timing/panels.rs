//! The program of the thesis held to its baseline: the block of `moffett` from observer 1.

use timing::{Comparison, Tolerance, compare};

use crate::timing::baselines::{of_generator, path};

fn held(sets: &[(&str, &str)]) -> Comparison {
    let baseline = timing::read(path("moffett", "panels")).unwrap_or_else(|e| panic!("{e}"));
    compare(&baseline, &of_generator("moffett", &baseline, sets), &Tolerance::default())
}

#[test]
fn the_block_holds_its_baseline() {
    let comparison = held(&[]);
    assert!(comparison.is_met(), "{}", comparison.text(20));
    assert_eq!(comparison.frames.len(), 1);
}

/// A slower part changes the routines that use it, and no piece. A finding that is lifted changes pieces.
#[test]
fn whatever_changes_is_named() {
    let slower = held(&[("minicomputer.root_us", "61")]).text(1000);
    assert!(slower.contains("+tasks.cpu.node-depth.ticks") && !slower.contains("pieces"), "{slower}");
    assert!(slower.contains("inputs") && !slower.contains("+tasks.cpu.fill"), "{slower}");
    let lifted = held(&[("panels.box_average", "false")]).text(1000);
    assert!(lifted.contains("+tasks.cpu.im-refavg.pixels.pieces"), "{lifted}");
    assert!(lifted.contains("+events_blake3"), "{lifted}");
}
