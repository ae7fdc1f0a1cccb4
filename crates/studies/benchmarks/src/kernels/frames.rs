//! Frames of shipped scenarios, to finished planes.

use std::path::Path;

use control_plane::MachineStage;
use generator::Session;
use hardware_model::{Economy, ShadowCache};
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
    frame(scenario, &Choice::default(), None, prepare, probe)
}

/// The same, probing nothing, with shadow boundaries kept in `shadows`.
pub(super) fn shadowed_whole(scenario: &str, prepare: Prepare, shadows: Option<&Path>) -> Work {
    frame(scenario, &Choice::default(), shadows, prepare, Probe::off())
}

/// Frame 0 of a scenario on [`PART`].
pub(super) fn part(scenario: &str, model: &'static str, scalar: Scalar, economy: Economy) -> Work {
    let choice = Choice { model: Some(model), scalar: Some(scalar), raster: Some(PART), economy };
    frame(scenario, &choice, None, machine::Prepare::prepare, Probe::off())
}

/// The same by ideal parts in f32, with shadow boundaries kept in `shadows`.
pub(super) fn shadowed_part(scenario: &str, economy: Economy, shadows: Option<&Path>) -> Work {
    let choice = Choice { model: Some("ideal"), scalar: Some(Scalar::F32), raster: Some(PART), economy };
    frame(scenario, &choice, shadows, machine::Prepare::prepare, Probe::off())
}

fn frame(
    scenario: &str,
    choice: &Choice,
    shadows: Option<&Path>,
    prepare: Prepare,
    mut probe: Probe,
) -> Work {
    let mut scene = alone(|| TimedScene::shipped(scenario, choice));
    scene.stage.settings.shadow_cache = shadows.map(ShadowCache::shared);
    let (mut planes, pose, samples) = (scene.planes(), scene.pose, scene.samples());
    let session = prepare(scene.stage);
    Work::new(samples, move || {
        let counts = alone(|| session.frame(0, &pose, &mut planes, &mut probe));
        assert!(counts.expect("drawn by the tests")["samples"] > 0);
        probe.waveforms.clear();
    })
}
