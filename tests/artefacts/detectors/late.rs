//! What comes late: words, records, set-ups (A1 to A5, A26).

use std::collections::BTreeSet;

use timing::Deadline;

use crate::artefacts::look::{Crossing, Look, largest, mean, median};
use crate::artefacts::scenes::{level, row_height};

/// No gap or lateness of the overlays is longer than this (µs).
const SOON: f64 = 0.36;

/// A step in the error at a sample: what its neighbours do not lead up to (m).
fn step(error: &[f64], sample: usize) -> f64 {
    let rise = |k: usize| error[k] - error[k - 1];
    rise(sample) - 0.5 * (rise(sample - 1) + rise(sample + 1))
}

/// Largest step of the error between two times (samples, m).
fn largest_step(error: &[f64], [from, to]: [f64; 2]) -> f64 {
    let first = (from.ceil() as usize).max(2);
    let last = (to as usize).min(error.len() - 2);
    largest((first..=last).map(|sample| step(error, sample).abs()))
}

/// Steps behind crossings (m): where a line of the other axis was crossed just before, near a corner, and where the sweep
/// was by itself.
fn steps(look: &Look<'_>) -> [Vec<f64>; 2] {
    let soon = SOON / look.clean.sample();
    let (mut close, mut alone) = (Vec::new(), Vec::new());
    for sweep in look.own() {
        let (error, crossings) = (look.error(sweep), look.crossings(sweep));
        for (k, crossing) in crossings.iter().enumerate().skip(1) {
            let before = crossings[k - 1];
            let after = crossings.get(k + 1).map_or(f64::INFINITY, |next: &Crossing| next.time);
            let gap = crossing.time - before.time;
            if gap < soon && before.axis != crossing.axis {
                close.push(largest_step(&error, [crossing.time, before.time + soon]));
            } else if gap > 1.5 * soon {
                alone.push(largest_step(&error, [crossing.time, (crossing.time + soon).min(after)]));
            }
        }
    }
    [close, alone]
}

/// A1: mean step behind a crossing that follows on one of the other axis (m), less what others have.
pub fn tear(look: &Look<'_>) -> f64 {
    let [close, alone] = steps(look);
    (mean(&close) - 2.0 * mean(&alone)).max(0.0)
}

/// A4: share of the crossings near corners that tear, less the share of the others that do.
pub fn corner_comb(look: &Look<'_>) -> f64 {
    let torn = |steps: &[f64]| mean(&steps.iter().map(|&step| f64::from(step > TORN)).collect::<Vec<_>>());
    let [close, alone] = steps(look);
    (torn(&close) - 2.0 * torn(&alone)).max(0.0)
}

/// A step beyond all noise (m).
const TORN: f64 = 0.3;

/// An error that is none (m).
const NONE: f64 = 1e-6;

/// A2: the largest error in a sweep of a wedge that begins and ends without a step, on ground that is right elsewhere (m).
pub fn stale_corner(look: &Look<'_>) -> f64 {
    let wedges = look.own().map(|sweep| {
        let error = look.error(sweep);
        let right = error.iter().filter(|error| error.abs() < NONE).count();
        if right * 5 < error.len() { 0.0 } else { smooth_wedge(&error) }
    });
    median(&wedges.collect::<Vec<_>>())
}

fn smooth_wedge(error: &[f64]) -> f64 {
    let wedges = error.split(|error| error.abs() < NONE).filter(|wedge| wedge.len() > 2);
    largest(wedges.map(|wedge| {
        let height = largest(wedge.iter().map(|error| error.abs()));
        let ends = wedge[0].abs().max(wedge[wedge.len() - 1].abs());
        if ends < 0.02 * height { height } else { 0.0 }
    }))
}

/// Height (m) of the rows between which a place (regions) lies, by the basis function of heights.
pub fn of_rows(place: f64) -> f64 {
    let row = place.floor();
    let [near, far] = [row, row + 1.0].map(|row| row_height(row as usize));
    near + (far - near) * smooth(place - row)
}

/// The basis function of heights, 0..=1 (S0 of the hardware report).
pub fn smooth(z: f64) -> f64 {
    z * z * z * (10.0 + z * (-15.0 + 6.0 * z))
}

/// A3: how much of the difference between the ground and its mirror image beyond the first row the error makes up: 1 less
/// what is left of it, rms.
pub fn mirror_ghost(look: &Look<'_>) -> f64 {
    let (mut left, mut square) = (0.0, 0.0);
    for sweep in look.own() {
        for (sample, error) in look.error(sweep).into_iter().enumerate() {
            let place = look.place(sweep, sample as f64)[0];
            let first = look.place(sweep, -1.0)[0].ceil();
            // Up and down between the first two rows.
            let folded = (place - first).rem_euclid(2.0);
            let mirrored = first - if folded < 1.0 { folded } else { 2.0 - folded };
            if place > first {
                let ghost = of_rows(mirrored) - of_rows(place);
                left += (error - ghost) * (error - ghost);
                square += ghost * ghost;
            }
        }
    }
    if square == 0.0 { 0.0 } else { (1.0 - (left / square).sqrt()).max(0.0) }
}

/// A5: corners that sweeps ask for while the drum has not brought them, a frame.
pub fn drum_starvation(look: &Look<'_>) -> f64 {
    let missing = look.run.frames.iter().map(|frame| {
        let misses = frame.timing.iter().flat_map(|timing| &timing.misses);
        let corners = misses.filter(|missed| missed.deadline == Deadline::CORNER);
        corners.filter_map(|missed| missed.region).collect::<BTreeSet<_>>().len() as f64
    });
    mean(&missing.collect::<Vec<_>>())
}

/// A26: share of the sweeps that are drawn as the one before.
pub fn queue_jitter(look: &Look<'_>) -> f64 {
    let height = |sweep: u32| look.run.wave(sweep, "tg.height");
    let sweeps = look.sweeps().skip(1);
    mean(&sweeps.map(|sweep| f64::from(height(sweep) == height(sweep - 1))).collect::<Vec<_>>())
}

/// What the height is off by while a corner keeps a stale height: the difference of the heights times the corner's
/// weight at `place` (regions).
pub fn stale_error(look: &Look<'_>, corner: [i64; 2], stale: [i64; 2], place: [f64; 2]) -> f64 {
    let level = level(look.scene);
    let height = |[m, n]: [i64; 2]| level.words()[level.clamped_index(m, n)][0];
    let weight = |axis: usize| 1.0 - smooth((place[axis] - corner[axis] as f64).abs().min(1.0));
    (height(stale) - height(corner)) * weight(0) * weight(1)
}
