//! What a frame costs.
//!
//! `cargo bench -p benchmarks` runs it; `docs/measuring.md` says how to read the figures. The scene is the
//! README's, so that the figures are of a picture that one can look at.

use std::sync::Arc;

use generator::Stage;
use hardware_model::{HardwareModel, Settings};
use landscape::{Bank, Landscape};
use scenario::{Ground, Pose, PoseTable, Scalar, Scenario, Scenery};

/// The README's scene with `scalar` signals, and the pose of its first frame.
///
/// # Panics
/// If the shipped scenario cannot be read: then the tests fail as well.
pub fn first_light(scalar: Scalar) -> (Stage, Pose) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/first-light.toml");
    let scenario = Scenario::read(path).expect("the shipped scenario is read by the tests");
    let Ground::Generated(relief) = &scenario.ground else { panic!("first light generates its ground") };
    let level = relief.build().expect("the shipped relief is built by the tests");
    let bank = Bank::new(&*scenario.title, vec![level], None).expect("one level");
    let landscape = Arc::new(Landscape::new(bank, scenario.albedo));
    let settings = Settings::resolve(
        &HardwareModel::ideal(),
        scenario.field,
        scenario.raster,
        scenario.range,
        scenario.laws,
        scalar,
        scenario.display,
    )
    .expect("the shipped settings are resolved by the tests");
    let poses = PoseTable::resolve(&scenario, &landscape, settings.timebase.update, 0..1);
    let pose = poses.expect("the shipped path is driven by the tests").rows()[0].pose;
    (Stage { landscape, scenery: Arc::new(Scenery::still(scenario.sun)), settings }, pose)
}
