//! Frames of shipped scenarios, to finished planes.

use control_plane::MachineStage;
use generator::Session;
use hardware_model::Economy;
use scenario::Scalar;
use signal::Probe;

use super::{Work, alone};
use crate::{Choice, TimedScene};

/// Sweeps and samples of a part of a frame: eight groups.
pub(super) const PART: [u32; 2] = [64, 1000];

/// How a machine is elaborated.
type Prepare = fn(MachineStage) -> Box<dyn Session>;

/// Frame 0 of a scenario on its own raster, under its own machine.
pub(super) fn whole(scenario: &str, prepare: Prepare, probe: Probe) -> Work {
    frame(scenario, &Choice::default(), prepare, probe)
}

/// Frame 0 of a scenario on [`PART`].
pub(super) fn part(scenario: &str, model: &'static str, scalar: Scalar, economy: Economy) -> Work {
    let choice = Choice { model: Some(model), scalar: Some(scalar), raster: Some(PART), economy };
    frame(scenario, &choice, machine::Prepare::prepare, Probe::off())
}

fn frame(scenario: &str, choice: &Choice, prepare: Prepare, mut probe: Probe) -> Work {
    let scene = alone(|| TimedScene::shipped(scenario, choice));
    let (mut planes, pose, samples) = (scene.planes(), scene.pose, scene.samples());
    let session = prepare(scene.stage);
    Work::new(samples, move || {
        let counts = alone(|| session.frame(0, &pose, &mut planes, &mut probe));
        assert!(counts.expect("drawn by the tests")["samples"] > 0);
        probe.waveforms.clear();
    })
}
