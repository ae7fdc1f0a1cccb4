//! Flat ground, a control plane over it, and poses.

use std::sync::Arc;

use control_plane::{ControlPlane, MachineStage};
use hardware_model::{CrossingServer, HardwareModel, Loader};
use landscape::Attitude;
use lunoid_tests::{ComparedScene, Dice, level_of, plane};
use scenario::{Pose, RangeLaw, RangeProgramme, Scenery};
use timing::FrameTiming;

/// Ground range of a sweep and side of a region (m): hardware section 7, pra-nominal.
pub const RANGE: f64 = 5000.0;
pub const SIZE: f64 = 300.0;

/// A flat scene, seen from above its middle at constant rate, out to [`RANGE`].
pub fn flat(size: f64) -> ComparedScene {
    let corners = 2 * (RANGE / size).ceil() as usize + 6;
    let mut scene =
        ComparedScene::over(level_of(size, [0.0, 0.0], [corners; 2], plane(size, 0.0, [0.0, 0.0])));
    scene.samples = 1000;
    scene.range = RangeProgramme { law: RangeLaw::ConstantRate, start: RANGE / 1000.0, end: RANGE };
    scene
}

/// Four banks as wide as a set, or one line; times in master ticks.
pub fn loader(
    served_by: CrossingServer,
    words_per_access: u32,
    [pointer, access, strobe]: [u64; 3],
) -> Loader {
    Loader { served_by, words_per_access, pointer, access, strobe, ..HardwareModel::ideal().loader }
}

/// The pose of `scene` with its heading (rad), `moved` regions to the north and east.
pub fn pose(scene: &ComparedScene, heading: f64, [north, east]: [f64; 2]) -> Pose {
    let size = scene.level.region_size();
    let [x, y, h] = scene.eye;
    let attitude = Attitude { roll: 0.0, pitch: 0.0, heading };
    Pose { time: 0.0, eye: [x + size * north, y + size * east, h], attitude, yoke: 0.0 }
}

/// A pose anywhere in a region, the heading in sector `index` of `sectors` of the circle.
pub fn thrown(scene: &ComparedScene, dice: &mut Dice, [index, sectors]: [usize; 2]) -> Pose {
    let heading = (index as f64 + dice.between(0.0, 1.0)) / sectors as f64 * 2.0 * std::f64::consts::PI;
    let moved = [dice.between(-0.5, 0.5), dice.between(-0.5, 0.5)];
    pose(scene, heading, moved)
}

/// The stage of `scene` with a course, which data banks follow.
pub fn on_course(scene: &ComparedScene, course: Vec<Pose>) -> MachineStage {
    let stage = scene.stage();
    MachineStage { scenery: Arc::new(Scenery::still(scene.sun).with_course(course)), ..stage }
}

/// One frame of a control plane.
pub fn frame(control: &ControlPlane, number: u64, pose: &Pose) -> FrameTiming {
    control.frame(number, pose).expect("a pose over flat ground")
}

/// Busy ticks of a unit.
pub fn busy(frame: &FrameTiming, unit: &str) -> u64 {
    frame.units.iter().find(|found| found.unit == unit).unwrap_or_else(|| panic!("no unit {unit}")).busy
}
