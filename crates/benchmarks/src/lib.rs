//! What a frame costs.
//!
//! `cargo bench -p benchmarks` runs it; `docs/measuring.md` says how to read the figures. The scene is the
//! README's, so that the figures are of a picture that one can look at.

use generator::Stage;
use hardware_model::{HardwareModel, Settings};
use scenario::{Pose, PoseTable, Scalar, Scenario};

/// The README's scene with `scalar` signals, and the pose of its first frame.
///
/// # Panics
/// If the shipped scenario cannot be read: then the tests fail as well.
pub fn first_light(scalar: Scalar) -> (Stage, Pose) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/first-light.toml");
    let read = Scenario::read(path).expect("the shipped scenario is read by the tests");
    let scenario = Scenario { scalar, ..read };
    let settings = stage::settings(&scenario, &HardwareModel::ideal())
        .expect("the shipped settings are resolved by the tests");
    let stage = stage::build(&scenario, settings).expect("the shipped ground is made by the tests");
    let Settings { timebase, yoke, .. } = stage.settings.clone();
    let poses = PoseTable::resolve(&scenario, &stage.landscape, timebase.update, yoke, 0..1);
    let pose = poses.expect("the shipped path is driven by the tests").rows()[0].pose;
    (stage, pose)
}
