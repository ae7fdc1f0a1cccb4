//! Random landscapes on both engines; a scene that differs is shrunk before it is told.

use std::ops::Range;

use lockstep::{Report, Scene, random, shrink};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Scalar;

fn run(seed: u64, scene: &Scene) -> Option<Report> {
    scene.lockstep(1 + seed % 7).ok()
}

/// Runs the scene of every seed; the message of a failure has the seed and the smallest scene that differs alike.
fn each_seed(seeds: Range<u64>, scalar: Scalar) -> Report {
    let one = |seed: u64| {
        let scene = Scene { scalar, ..random::landscape(seed) };
        let differs = |scene: &Scene| run(seed, scene)?.first_difference();
        let shrunk = shrink::shrink(scene.clone(), differs);
        let told = shrunk.map(|shrunk| format!("seed {seed}: {}\n  {}", shrunk.difference, shrunk.describe()));
        (run(seed, &scene), told)
    };
    let found: Vec<_> = seeds.into_par_iter().map(one).collect();
    let differences: Vec<_> = found.iter().filter_map(|(_, told)| told.as_deref()).collect();
    assert!(differences.is_empty(), "{} scenes differ:\n{}", differences.len(), differences.join("\n"));
    let mut sum = Report::default();
    found.into_iter().filter_map(|(report, _)| report).for_each(|report| sum.add(report));
    sum
}

#[test]
fn two_hundred_in_f64() {
    let sum = each_seed(0..200, Scalar::F64);
    
    assert!(sum.sweeps > 1700, "{} sweeps: most scenes could not be drawn", sum.sweeps);
}

#[test]
fn some_in_f32() {
    each_seed(200..260, Scalar::F32);
}
