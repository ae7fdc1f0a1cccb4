//! Frames of shipped scenarios, to finished planes.

use generator::Generator;
use hardware_model::Economy;
use machine::HybridMachine;
use scenario::Scalar;
use signal::Probe;

use super::{Work, alone};
use crate::{Choice, Scene};

/// Sweeps and samples of a part of a frame: eight groups.
pub(super) const PART: [u32; 2] = [64, 1000];

/// Frame 0 of a scenario on its own raster, under its own machine.
pub(super) fn whole(scenario: &str, generator: &dyn Generator, probe: Probe) -> Work {
    frame(scenario, &Choice::default(), generator, probe)
}

/// Frame 0 of a scenario on [`PART`].
pub(super) fn part(scenario: &str, model: &'static str, scalar: Scalar, economy: Economy) -> Work {
    let choice = Choice { model: Some(model), scalar: Some(scalar), raster: Some(PART), economy };
    frame(scenario, &choice, &HybridMachine, Probe::off())
}

fn frame(scenario: &str, choice: &Choice, generator: &dyn Generator, mut probe: Probe) -> Work {
    let scene = alone(|| Scene::shipped(scenario, choice));
    let (mut planes, pose, samples) = (scene.planes(), scene.pose, scene.samples());
    let session = generator.prepare(scene.stage).expect("the machine draws what is shipped");
    Work::new(samples, move || {
        let counts = alone(|| session.frame(0, &pose, &mut planes, &mut probe));
        assert!(counts.expect("drawn by the tests").samples > 0);
        probe.waveforms.clear();
    })
}
