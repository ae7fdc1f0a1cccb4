//! Scenarios damaged at random, from their text to a picture: refused, or drawn without a value that is no number.

use machine::Prepare;
use std::panic::{AssertUnwindSafe, catch_unwind};

use exact::Exact;
use generator::{Generator, PlaneKind, Planes};
use hardware_model::{HardwareModel, ModelSource};
use landscape::relief::Relief;
use lunoid_tests::Dice;
use scenario::{GroundSource, PoseTable, Scenario};
use signal::Probe;

use crate::mutation::{damaged, renumbered};

/// Terrain, craters, rocks, a thing, shadows, texture, tracks, a vehicle that casts: everything on a small piece of ground.
const SCENE: &str = r#"format = 1
title = "Hostile"
shows = "Everything, small."
frames = 3
[landscape]
albedo = 0.8
[landscape.generated]
seed = 3
extent_m = [400, 400]
region_size_m = 50
[landscape.generated.undulation]
rms_height_m = 2
hurst = 0.9
longest_m = 300
shortest_m = 160
waves = 20
[[features.population]]
seed = 1
kind = "fresh"
density_per_m2 = 0.001
reference_m = 2
slope = 2
smallest_radius_m = 2
largest_radius_m = 20
[rocks]
seed = 9
density_per_m2 = 0.001
slope = 2
smallest_m = 0.3
largest_m = 2.5
radius_m = 40
[[object]]
id = "lm"
model = "marker"
x_m = 130
y_m = 210
heading_deg = 30
[texture]
source = "random"
seed = 4
layer = [{ cell_m = 2.2, amplitude = 0.03, range_m = 100 }]
[sun]
azimuth_deg = 200
elevation_deg = 15
[shadows]
finest_m = 0.5
angle_mrad = 4
[vehicle]
model = "marker"
[tracks]
[path]
keyframes = [{ t_s = 0, x_m = 100, y_m = 200 }, { t_s = 5, x_m = 108, y_m = 205 }]
[raster]
sweeps = 12
samples_per_sweep = 60
update_hz = 10
refresh_hz = 30
field_of_view_deg = [50, 30]
[range]
programme = "geometric"
start_m = 2
end_m = 300
[display]
white = 1.2
gamma = 2.2
"#;

/// More than this takes long and tests nothing else.
fn is_small(scenario: &Scenario) -> bool {
    let GroundSource::Generated(Relief { extent, region_size, .. }) = &scenario.ground else { return false };
    let corners = (extent[0] / region_size) * (extent[1] / region_size);
    let crowd = |sizes: &features::population::SizeLaw| sizes.all() * extent[0] * extent[1];
    let few = scenario.features.populations.iter().all(|wish| crowd(&wish.sizes) < 1e4);
    corners < 2e4 && few
}

/// How far a scenario came.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    Refused,
    TooLarge,
    Drawn,
}

fn draw(text: &str) -> Way {
    let Ok(mut scenario) = Scenario::parse("hostile.toml", text) else { return Way::Refused };
    if !is_small(&scenario) {
        return Way::TooLarge;
    }
    scenario.raster.sweeps = Some(12);
    (scenario.raster.columns, scenario.raster.lines) = (Some(12), Some(8));
    scenario.raster.samples = scenario.raster.samples.map(|samples| samples.min(200));
    let model =
        HardwareModel::load(&ModelSource::BuiltIn("ideal".into()), &[], &[]).expect("a shipped model");
    let Ok(settings) = front_door::settings(&scenario, &model.model) else { return Way::Refused };
    let Ok(stage) = front_door::build(&scenario, settings) else { return Way::Refused };
    let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
    let Ok(poses) = PoseTable::resolve(&scenario, &stage.landscape, update, yoke, 0..1) else {
        return Way::Refused;
    };
    let row = poses.rows()[0];
    let Ok(exact) = Exact.prepare(stage.stage()) else { return Way::Refused };
    for (name, session) in [("hybrid", stage.clone().prepare()), ("exact", exact)] {
        let mut planes = Planes::new(12, 8, &[PlaneKind::Intensity, PlaneKind::Range]);
        if session.frame(row.frame, &row.pose, &mut planes, &mut Probe::off()).is_err() {
            return Way::Refused;
        }
        let intensity = planes.get(PlaneKind::Intensity).expect("a plane that was asked for");
        assert!(intensity.iter().all(|value| (0.0..=1.0).contains(value)), "{}: {intensity:?}", name);
        assert!(!planes.get(PlaneKind::Range).expect("the other").iter().any(|range| range.is_nan()));
    }
    Way::Drawn
}

/// Draws the damaged scenes of `numbers`; none may end in a panic.
pub fn search(numbers: std::ops::Range<u64>) {
    assert_eq!(draw(SCENE), Way::Drawn);
    let mut ways = [0; 3];
    for number in numbers {
        let mut dice = Dice::new(number);
        let text = match dice.count(0, 3) {
            0 => {
                let bytes = damaged(&mut dice, SCENE.as_bytes(), SCENE.as_bytes());
                String::from_utf8_lossy(&bytes).into_owned()
            }
            _ => renumbered(&mut dice, SCENE),
        };
        match catch_unwind(AssertUnwindSafe(|| draw(&text))) {
            Ok(way) => ways[way as usize] += 1,
            Err(_) => panic!("scene number {number}:\n{text}"),
        }
    }
    let [refused, too_large, drawn] = ways;
    println!("{refused} refused, {too_large} too large to be drawn here, {drawn} drawn");
    assert!(drawn > 20 && refused > 20, "{ways:?}");
}

#[test]
fn a_damaged_scenario_is_refused_or_drawn() {
    search(0..150);
}
