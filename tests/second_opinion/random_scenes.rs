//! Random coefficients, eyes, headings, laws and range programmes, in lockstep.

use std::ops::Range;

use hardware_model::{LatePolicy, LoadDelay};
use lunoid_tests::{ComparedScene, Dice, Lockstep, random};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Scalar;
use sweep_program::{Colour, PreloadRegister};

/// Checks the scene of every seed in lockstep; the message of a failure names the seed to run alone.
fn each_seed(seeds: Range<u64>, change: impl Fn(u64, &mut ComparedScene) + Sync) {
    let difference = |seed: u64| {
        let mut scene = random::scene(seed);
        change(seed, &mut scene);
        let difference = Lockstep::run(&scene, 1 + seed % 7).report.first_difference()?;
        Some(format!("seed {seed}, {:?}, loader {:?}: {difference}", scene.scalar, scene.loader))
    };
    let differences: Vec<_> = seeds.into_par_iter().filter_map(difference).collect();
    assert!(differences.is_empty(), "{} scenes differ:\n{}", differences.len(), differences.join("\n"));
}

#[test]
fn machine_and_interpreter_agree_in_f64() {
    each_seed(0..160, |_, _| {});
}

#[test]
fn machine_and_interpreter_agree_in_f32_within_its_bound() {
    each_seed(0..160, |_, scene| scene.scalar = Scalar::F32);
}

#[test]
fn slow_loaders_agree_under_both_policies() {
    each_seed(1000..1120, |seed, scene| {
        let mut dice = Dice::new(seed);
        scene.loader.late_policy = dice.choose(&[LatePolicy::StrobeThrough, LatePolicy::Latched]);
        scene.loader.access = dice.count(1, 40) as u64;
        scene.loader.pointer = dice.count(0, 5) as u64;
        scene.loader.strobe = dice.count(0, 3) as u64;
        scene.loader.words_per_access = dice.count(1, 9) as u32;
        scene.loader.urgent_first = dice.choose(&[true, false]);
        // About one tick a step, so that words come some steps after their fold.
        scene.master_hz = 30 * u64::from(scene.sweeps * scene.samples) * dice.count(1, 3) as u64;
        scene.loader.delays = (0..20).map(|_| held_back(&mut dice, scene.sweeps)).collect();
    });
}

fn held_back(dice: &mut Dice, sweeps: u32) -> LoadDelay {
    LoadDelay {
        frame: dice.choose(&[None, Some(1), Some(4)]),
        sweep: dice.count(0, sweeps as usize - 1) as u32,
        crossing: dice.count(0, 6) as u32,
        colour: dice.choose(&[Colour::Yellow, Colour::Green, Colour::Black, Colour::Red]),
        register: dice.choose(&[PreloadRegister::XFirst, PreloadRegister::YFirst]),
        word: dice.count(0, 8),
        ticks: dice.count(1, 300) as u64,
    }
}

#[test]
fn slow_loaders_are_late_somewhere() {
    let mut scene = random::scene(1003);
    scene.loader.access = 30;
    scene.master_hz = 30 * u64::from(scene.sweeps * scene.samples);
    scene.samples = 300;
    scene.range.end = 6.0 * scene.level.region_size();
    let late = Lockstep::run(&scene, 0).report.events["late"];
    assert!(late > 0, "no word was late: the test above tests nothing");
}
