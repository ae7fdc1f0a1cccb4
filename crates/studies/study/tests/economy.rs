//! Economy of a small scene that has all blocks: the same bits whatever runs, and waste that adds up.

use hardware_model::HardwareModel;
use scenario::Scenario;
use study::Subject;
use study::economy::{EconomyOutcome, Level, Waste, economy};

const FULL: &str = r#"
format = 1
title = "Some of everything"
shows = "Nothing but a test."
machine = "ideal"
frames = 4

[landscape]
albedo = 0.9

[landscape.generated]
seed = 11
extent_m = [1600, 1600]
region_size_m = 40

[landscape.generated.undulation]
rms_height_m = 4
hurst = 0.9
longest_m = 900
shortest_m = 200

[landscape.coarse]
seed = 17
extent_m = [6400, 6400]
region_size_m = 160
undulation = { rms_height_m = 20, hurst = 0.9, longest_m = 3000, shortest_m = 800 }

[levels]
switch_m = 400
blend_m = 100

[[features.population]]
seed = 1
kind = "fresh"
density_per_m2 = 0.002
reference_m = 2
slope = 1.9
smallest_radius_m = 1
largest_radius_m = 20

[rocks]
seed = 5
density_per_m2 = 0.004
slope = 2.0
smallest_m = 0.3
largest_m = 4
radius_m = 80

[texture]
source = "random"
seed = 8
layer = [{ cell_m = 2.2, amplitude = 0.03, range_m = 60 }]

[sun]
azimuth_deg = 243
elevation_deg = 11

[shadows]
finest_m = 1
angle_mrad = 10

[path]
keyframes = [{ t_s = 0, x_m = 800, y_m = 800 }, { t_s = 5, x_m = 808, y_m = 805 }]

[raster]
sweeps = 60
samples_per_sweep = 300
lines = 40
"#;

fn found(text: &str) -> EconomyOutcome {
    let scenario = Scenario::parse("full.toml", text).unwrap_or_else(|list| panic!("{}", list.render(false)));
    let model = HardwareModel::ideal();
    let settings = front_door::settings(&scenario, &model).unwrap();
    let stage = front_door::build(&scenario, settings).unwrap();
    let subject = Subject::new(scenario, model, stage, &[1]).unwrap();
    economy(&subject, 1, &mut |_| {}).unwrap()
}

fn row<'a>(found: &'a EconomyOutcome, what: &str) -> &'a Waste {
    found.waste.iter().find(|row| row.what == what).unwrap_or_else(|| panic!("{what}: {:?}", found.waste))
}

#[test]
fn all_blocks_and_none_of_them_wasted_unseen() {
    let found = found(FULL);
    assert!(found.holds(), "{:?}", found.modes);
    let [bounded, lossless, .., everything, preview] = found.modes.as_slice() else {
        panic!("{:?}", found.modes)
    };
    assert_eq!((lossless.off, everything.off), ([0.0; 2], [0.0; 2]));
    // Small rocks are left out of the first alone.
    assert!(
        !bounded.claims_equal && bounded.blake3 != lossless.blake3 && bounded.off[1] > 0.0,
        "{bounded:?}"
    );
    assert!(!preview.claims_equal && preview.off[0] > bounded.off[0], "{preview:?}");
    assert_eq!(found.modes.len(), 9);
    assert!(found.modes.iter().all(|mode| mode.time_s.iter().all(|time| *time > 0.0)));
    // Eight lanes a group: 60 sweeps leave four idle.
    let lanes = row(&found, "lanes without a sweep");
    assert_eq!((lanes.wasted, lanes.of), (4, 64));
    let samples = [
        "beyond the stored ground",
        "hidden by nearer ground",
        "above or below the picture",
        "covered by bodies",
    ];
    let samples = samples.map(|what| row(&found, &format!("samples {what}")));
    assert!(samples.iter().all(|row| row.of == 60 * 300));
    let wasted: u64 = samples.iter().map(|row| row.wasted).sum();
    assert!(wasted > 0 && wasted < 60 * 300, "{wasted}");
    assert!(samples[1].wasted > 0 && samples[3].wasted > 0, "{samples:?}");
    assert!(found.waste.iter().all(|row| row.wasted <= row.of), "{:?}", found.waste);
    // With and without a crater, each sample once; what craters waste is of those with one.
    let without = row(&found, "samples at which VS1 has no crater to choose");
    let with = row(&found, "samples of craters that are not drawn");
    assert_eq!(without.wasted + with.of, without.of);
    for what in ["crossings of boundaries that unite with others", "samples of texture that are not drawn"] {
        let row = row(&found, what);
        assert!(row.wasted > 0 && row.wasted < row.of, "{row:?}");
    }
    for level in [Level::Mission, Level::Frame, Level::Sweep, Level::Sample] {
        assert!(found.left_out.iter().any(|left| left.level == level), "{level:?}");
    }
    let counts = found.left_out.iter().filter_map(|left| left.count);
    counts.for_each(|[some, all]| assert!(some <= all, "{:?}", found.left_out));
}

#[test]
fn a_bare_scene_has_blocks_that_are_left_out() {
    let bare = ["[[features", "[rocks]", "[texture]", "[shadows]", "[levels]", "[landscape.coarse]"];
    let kept: Vec<&str> =
        FULL.split("\n\n").filter(|part| !bare.iter().any(|name| part.starts_with(name))).collect();
    let found = found(&kept.join("\n\n"));
    assert!(found.holds(), "{:?}", found.modes);
    assert_eq!(found.modes[0].blake3, found.modes[1].blake3, "nothing is bounded");
    let absent =
        |block: &str| found.left_out.iter().any(|left| left.level == Level::Mission && left.block == block);
    let blocks = ["feature-generator", "shadow-controller", "texture-generator", "polyhedron-generator"];
    assert!(blocks.into_iter().all(absent), "{:?}", found.left_out);
    assert!(found.waste.iter().all(|row| !blocks.contains(&row.block)), "{:?}", found.waste);
}
