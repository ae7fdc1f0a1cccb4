//! Which overlay moves which signal: no wire is told in front of its fault.
//!
//! A machine draws a frame in which every block works, without a fault and under each overlay of one fault. A signal moves if any
//! of its waveforms differs by a bit. The drawing says which signals lie behind a fault ([`drawing`]); one that lies behind it
//! and does not move is a failure, unless [`exceptions`] says why. The table is docs/overlays.md.

mod drawing;
mod exceptions;
mod listed;
mod runs;
mod table;

use std::collections::BTreeSet;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::overlays::drawing::behind;
use crate::overlays::exceptions::why_still;
use crate::overlays::listed::{OVERLAYS, Overlay};
use crate::overlays::runs::Scene;

/// An overlay, and the families of signals that move under it.
struct Row {
    overlay: &'static Overlay,
    moved: BTreeSet<String>,
}

fn rows() -> Vec<Row> {
    let scene = Scene::new();
    let clean = scene.waveforms(None);
    let row = |overlay: &'static Overlay| Row {
        overlay,
        moved: runs::moved(&clean, &scene.waveforms(Some(overlay))),
    };
    OVERLAYS.into_par_iter().map(row).collect()
}

#[test]
fn what_lies_behind_a_fault_moves_under_it() {
    let rows = rows();
    let found = table::page(&rows);
    let mut still = Vec::new();
    for Row { overlay, moved } in &rows {
        for signal in behind(overlay.at) {
            let why = why_still(overlay.name, &signal);
            match (moved.contains(&signal), why) {
                (false, None) => still.push(format!("{}: {signal} does not move", overlay.name)),
                (true, Some(why)) => still.push(format!("{}: {signal} moves, though {why}", overlay.name)),
                _ => {}
            }
        }
    }
    assert!(still.is_empty(), "{} signals:\n{}", still.len(), still.join("\n"));
    let page = include_str!("../../docs/overlays.md");
    assert!(page.contains(&found), "docs/overlays.md has another table than this:\n{found}");
}

/// The overlay `roll` on a scenario with a yoke: the wire has the angle by which the read-out turns, step by step.
#[test]
fn a_yoke_that_steps_is_told() {
    let roll = OVERLAYS.iter().find(|overlay| overlay.name == "roll").expect("an overlay that ships");
    let angles = |overlay: Option<&Overlay>| runs::yoke_angles(overlay, 40..52);
    let (smooth, stepped) = (angles(None), angles(Some(roll)));
    assert!(smooth.windows(2).any(|pair| pair[0] != pair[1]), "{smooth:?}: the ride is rough");
    assert_ne!(smooth, stepped);
}
