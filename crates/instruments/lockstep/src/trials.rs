//! Random landscapes on both engines.

use std::fmt;
use std::ops::Range;

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scenario::Scalar;

use crate::random::machine;
use crate::report::Report;
use crate::scene::ComparedScene;
use crate::shrink::{Shrunk, shrink};

/// A scene that differs.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// Seed of the scene, for [`random::machine`](crate::random::machine).
    pub seed: u64,
    /// Scalar of the machine.
    pub scalar: Scalar,
    /// The first difference of the whole scene.
    pub difference: String,
    /// The smallest scene that differs.
    pub smallest: Shrunk,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { seed, scalar, difference, smallest } = self;
        write!(
            f,
            "seed {seed}, {scalar:?}: {difference}\n  shrunk: {}\n  to {}",
            smallest.difference,
            smallest.describe()
        )
    }
}

/// What many scenes come to.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trials {
    /// Scenes that ran on both engines.
    pub scenes: u64,
    /// Scenes whose pose the machine refuses.
    pub refused: u64,
    /// Of all scenes together.
    pub report: Report,
    /// Those that differ, by seed.
    pub faults: Vec<Fault>,
}

/// The scene of every seed, all sweeps of one frame.
pub fn trials(seeds: Range<u64>, scalar: Scalar) -> Trials {
    let one = |seed: u64| {
        let scene = ComparedScene { scalar, ..machine(seed) };
        let frame = frame_of(seed);
        let report = scene.lockstep(frame).ok();
        let difference = report.as_ref().and_then(Report::first_difference);
        let fault = difference.and_then(|difference| {
            let differs = |scene: &ComparedScene| scene.lockstep(frame).ok()?.first_difference();
            Some(Fault { seed, scalar, difference, smallest: shrink(scene, differs)? })
        });
        (report, fault)
    };
    let mut sum = Trials::default();
    for (report, fault) in seeds.into_par_iter().map(one).collect::<Vec<_>>() {
        match report {
            Some(report) => {
                sum.scenes += 1;
                sum.report.add(report);
            }
            None => sum.refused += 1,
        }
        sum.faults.extend(fault);
    }
    sum
}

/// Another frame for every scene, so that sweeps begin between ticks.
pub fn frame_of(seed: u64) -> u64 {
    1 + seed % 7
}
