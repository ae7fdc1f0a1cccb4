//! Who decides a key: wishes are over the scenario, the scenario is over the model.

use generator::Row;
use scenario::Scenario;

/// What a key of `--set` is of.
#[derive(Debug, Clone, Copy)]
pub enum Decides {
    /// A generator's own: run parameters or gear.
    Generator(&'static Row),
    /// The scenario may wish it, whatever draws; set, the scenario no longer wishes it, and the model has the value.
    View,
    /// A part of the hybrid machine; no scenario wishes it.
    Model,
    /// A key of the scenario itself, over what its file says.
    Scenario,
}

/// What stands before a key of the scenario.
const SCENARIO: &str = "scenario.";

/// The key in the scenario's file that `key` sets, if it sets one.
pub(crate) fn of_scenario(key: &str) -> Option<&str> {
    key.strip_prefix(SCENARIO)
}

/// A key that a scenario may wish, and how it wishes it no longer.
type Wished = (&'static str, fn(&mut Scenario));

/// The keys of a model that a scenario may wish. What ends in `.` is all keys of a table.
const WISHED: [Wished; 13] = [
    ("raster.sweeps", |scenario| scenario.raster.sweeps = None),
    ("raster.samples_per_sweep", |scenario| scenario.raster.samples = None),
    ("raster.update_hz", |scenario| scenario.raster.update = None),
    ("raster.refresh_hz", |scenario| scenario.raster.refresh = None),
    ("dpp.projection", |scenario| scenario.laws.projection = None),
    ("dpp.curvature", |scenario| scenario.laws.curvature = None),
    ("dpp.occlusion", |scenario| scenario.laws.occlusion = None),
    ("sweep_memory.pixel_rule", |scenario| scenario.laws.pixel_rule = None),
    ("feature_generator.light", |scenario| scenario.laws.feature_light = None),
    ("polyhedron_generator.visibility", |scenario| scenario.laws.body_visibility = None),
    ("polyhedron_generator.shadowed_bodies", |scenario| scenario.laws.shadowed_bodies = None),
    ("mixing_unit.texture_in_shadow", |scenario| scenario.laws.texture_in_shadow = None),
    ("range.", |scenario| scenario.range = None),
];

/// Poses go by the yoke, whatever draws; no scenario wishes its keys.
const YOKE: &str = "yoke.";

/// Returns what decides `key`: a generator, the view, the hardware model or the scenario.
pub fn decides(key: &str) -> Decides {
    match registry::owner(key) {
        _ if of_scenario(key).is_some() => Decides::Scenario,
        Some(row) => Decides::Generator(row),
        None if wished(key).is_some() || key.starts_with(YOKE) => Decides::View,
        None => Decides::Model,
    }
}

/// Makes the scenario no longer wish what `key` sets.
pub(crate) fn drop_wish(scenario: &mut Scenario, key: &str) {
    if let Some((_, drop)) = wished(key) {
        drop(scenario);
    }
}

fn wished(key: &str) -> Option<&'static Wished> {
    WISHED.iter().find(|(known, _)| *known == key || (known.ends_with('.') && key.starts_with(known)))
}

#[cfg(test)]
mod tests {
    use scenario::{LawWishes, Scenario};

    use super::{Decides, WISHED, decides, drop_wish};

    const SCENARIO: &str = r#"
format = 1
title = "Ground"
shows = "Nothing but a test."
frames = 4

[landscape]
bank = "gone.bank"

[sun]
azimuth_deg = 100
elevation_deg = 15

[path]
keyframes = [{ t_s = 0, x_m = 100, y_m = 200 }, { t_s = 5, x_m = 108, y_m = 205 }]

[raster]
sweeps = 40
samples_per_sweep = 80
update_hz = 10
refresh_hz = 20

[range]
programme = "geometric"
start_m = 3
end_m = 400

[laws]
feature_light = "combined"
body_visibility = "depth"
shadowed_bodies = "dark"
texture_in_shadow = "off"
projection = "exact"
curvature = "none"
occlusion = "peak-hold"
pixel_rule = "centre"
"#;

    #[test]
    fn a_key_that_is_set_is_no_longer_wished() {
        let mut scenario = Scenario::parse("t.toml", SCENARIO).unwrap();
        for (key, _) in WISHED {
            let before = scenario.clone();
            drop_wish(&mut scenario, key);
            assert_ne!(scenario, before, "{key}");
        }
        assert_eq!((scenario.laws, scenario.range), (LawWishes::default(), None));
        assert_eq!(scenario.raster, scenario::RasterWishes::default());
    }

    #[test]
    fn each_key_has_one_that_decides_it() {
        assert!(matches!(decides("lunsim.grid"), Decides::Generator(row) if row.name == "lunsim"));
        assert!(matches!(decides("recorder.points_s"), Decides::Generator(_)));
        assert!(matches!(decides("range.end_m"), Decides::View));
        assert!(matches!(decides("yoke.damping"), Decides::View));
        assert!(matches!(decides("loader.access_ns"), Decides::Model));
        assert!(matches!(decides("recorders.points_s"), Decides::Model));
        assert!(matches!(decides("computer"), Decides::Model));
        assert!(matches!(decides("scenario.raster.sweeps"), Decides::Scenario));
    }
}
