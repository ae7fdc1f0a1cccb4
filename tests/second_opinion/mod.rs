//! A second opinion on the machine: interpreter, direct evaluation, and words that come too late.

mod direct_sum;
mod interpreter_alone;
mod late_words;
mod named_sweeps;
mod ramp;
mod random_scenes;
mod shipped;
mod wires;

use lunoid_tests::{ComparedScene, Lockstep};

/// Fails with the first difference between machine and interpreter.
fn agree(scene: &ComparedScene, what: &str) {
    if let Some(difference) = Lockstep::run(scene, 0).report.first_difference() {
        panic!("{what}: {difference}");
    }
}
