//! Random coefficients, eyes, headings, laws and range programmes, in lockstep.

use hardware_model::LatePolicy;
use lunoid_tests::{Dice, Lockstep, random};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Scalar;

/// Runs every seed; the message of a failure names the seed to run alone.
fn each_seed(seeds: std::ops::Range<u64>, check: impl Fn(u64) + Sync + Send) {
    seeds.into_par_iter().for_each(check);
}

#[test]
fn machine_and_interpreter_agree_in_f64() {
    each_seed(0..160, |seed| crate::agree(&random::scene(seed), &format!("seed {seed}")));
}

#[test]
fn machine_and_interpreter_agree_in_f32_within_its_bound() {
    each_seed(0..160, |seed| {
        let mut scene = random::scene(seed);
        scene.scalar = Scalar::F32;
        crate::agree(&scene, &format!("seed {seed}, f32"));
    });
}

#[test]
fn slow_loaders_agree_under_both_policies() {
    each_seed(1000..1120, |seed| {
        let mut scene = random::scene(seed);
        let mut dice = Dice::new(seed);
        scene.loader.late_policy = dice.choose(&[LatePolicy::StrobeThrough, LatePolicy::Latched]);
        scene.loader.access_ticks = dice.count(1, 40) as u64;
        // About one tick a step, so that words come some steps after their fold.
        scene.master_hz = 30 * u64::from(scene.sweeps) * u64::from(scene.samples) * dice.count(1, 3) as u64;
        let lockstep = Lockstep::run(&scene, seed % 7);
        if let Some(difference) = lockstep.first_difference() {
            panic!("seed {seed}, {:?}: {difference}", scene.loader);
        }
    });
}

#[test]
fn slow_loaders_are_late_somewhere() {
    let mut scene = random::scene(1003);
    scene.loader.access_ticks = 30;
    scene.master_hz = 30 * u64::from(scene.sweeps) * u64::from(scene.samples);
    scene.range.end = 6.0 * scene.level.region_size();
    let late: u64 = Lockstep::run(&scene, 0).records.iter().map(|record| record.late_words).sum();
    assert!(late > 0, "no word was late: the test above tests nothing");
}
