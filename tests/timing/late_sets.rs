//! Urgent sets that come too late (hardware section 4.5, number 3 of section 8).

use control_plane::ControlPlane;
use hardware_model::CrossingServer;
use lunoid_tests::{ComparedScene, Dice};
use scenario::Pose;
use timing::{Cause, FrameTiming};

use crate::timing::rig::{RANGE, SIZE, flat, frame, loader, thrown};

/// 525 sweeps at 30 frames a second and a clock of 200 MHz.
const MASTER: f64 = 200e6;
/// From the tick that sees a fold to the set in its register: a quarter of a microsecond.
const TICKS: [u64; 3] = [20, 24, 6];
const FRAMES: usize = 64;

fn scene() -> ComparedScene {
    let mut scene = flat(SIZE);
    scene.sweeps = 525;
    scene.master_hz = MASTER as u64;
    scene.loader = loader(CrossingServer::WiredPointers, 9, TICKS);
    scene
}

/// `R v t_u |sin 2 theta| / d^2`, summed over the sweeps of a frame.
fn expected(scene: &ComparedScene, pose: &Pose) -> f64 {
    let clocks = scene.settings().timebase;
    let active = f64::from(clocks.active_samples) / clocks.sample_rate().hertz();
    let rate = RANGE / active;
    // A fold is seen with the next tick: half of one later, in the mean.
    let urgent = (TICKS.iter().sum::<u64>() as f64 + 0.5) / MASTER;
    let edge = scene.field.tan_half_width;
    let of_sweep = |sweep: u32| {
        let tangent = edge * (2.0 * f64::from(sweep) + 1.0 - 525.0) / 525.0;
        let azimuth = pose.attitude.heading + libm::atan(tangent);
        RANGE * rate * urgent * libm::sin(2.0 * azimuth).abs() / (SIZE * SIZE)
    };
    (0..scene.sweeps).map(of_sweep).sum()
}

/// Neighbouring sweeps meet the same corners, so the sampling error is that of frames: it is taken from their spread.
#[test]
fn late_urgent_sets_are_as_many_as_the_formula_says() {
    let (scene, mut dice) = (scene(), Dice::new(5));
    let control = ControlPlane::new(scene.stage());
    let mut differences = Vec::new();
    let (mut found, mut formula) = (0.0, 0.0);
    for index in 0..FRAMES {
        let pose = thrown(&scene, &mut dice, [index, FRAMES]);
        let late = frame(&control, 0, &pose).sets.late as f64;
        let wanted = expected(&scene, &pose);
        differences.push(late - wanted);
        (found, formula) = (found + late, formula + wanted);
    }
    let mean = differences.iter().sum::<f64>() / FRAMES as f64;
    let variance =
        differences.iter().map(|one| (one - mean) * (one - mean)).sum::<f64>() / (FRAMES - 1) as f64;
    let error = (variance / FRAMES as f64).sqrt();
    let what = format!("{found} late sets, {formula:.0} by formula, error {error:.1} a frame");
    println!("{what}");
    // Two percent of what is expected: a formula without the sine or with another power of d is far outside.
    assert!(error < 0.02 * formula / FRAMES as f64, "{what}");
    assert!(mean.abs() < 4.0 * error, "{what}");
}

/// What each late set is late by.
fn latenesses(frame: &FrameTiming) -> Vec<f64> {
    frame.misses.iter().filter_map(timing::Missed::lateness).collect()
}

#[test]
fn no_set_is_later_than_its_way_takes() {
    let (scene, mut dice) = (scene(), Dice::new(6));
    let pose = thrown(&scene, &mut dice, [9, 64]);
    let found = frame(&ControlPlane::new(scene.stage()), 0, &pose);
    let samples = scene.settings().timebase.ticks_per_sample();
    let longest = (TICKS.iter().sum::<u64>() as f64 + 1.0) / samples;
    let late = latenesses(&found);
    assert_eq!(late.len() as u64, found.sets.late);
    assert!(late.len() > 200 && late.iter().all(|&late| late > 0.0), "{}", late.len());
    let alone = found.misses.iter().filter(|missed| missed.cause == Cause::Access);
    assert!(alone.filter_map(timing::Missed::lateness).all(|late| late < longest));
}

/// Section 7: with a register for the corner beyond both stops nothing is urgent any more.
#[test]
fn a_diagonal_register_ends_it() {
    let (mut scene, mut dice) = (scene(), Dice::new(7));
    let pose = thrown(&scene, &mut dice, [9, 64]);
    let without = frame(&ControlPlane::new(scene.stage()), 0, &pose).sets.late;
    scene.loader.diagonal_register = true;
    let with = frame(&ControlPlane::new(scene.stage()), 0, &pose).sets.late;
    assert!(with < without / 20, "{with} with, {without} without");
}
