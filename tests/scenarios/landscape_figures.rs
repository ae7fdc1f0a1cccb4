//! The figures of the full landscape in `scenarios/README.md`, measured again: those with a star, at 250 sweeps.

use compare::compare;
use hardware_model::{FeatureParts, Gate, MixingParts};
use landscape::Photometry;
use lunoid_tests::Shipped;
use lunoid_tests::shipped::Shown;
use scenario::{Curvature, Projection, RollDisplay, Scenario, Sunlight};

fn small(name: &str, change: impl FnOnce(&mut Scenario)) -> Shipped {
    Shipped::changed(name, Some(250), change)
}

fn as_it_stands(_: &mut Scenario) {}

fn rmse(a: &Shown, b: &Shown) -> f64 {
    compare(&a.picture, &b.picture, None, &[]).unwrap().rmse
}

fn black(shown: &Shown) -> f64 {
    let codes = shown.picture.codes();
    codes.iter().filter(|&&code| code == 0).count() as f64 / codes.len() as f64
}

/// As printed in the table: half a unit of the last digit.
fn assert_figure(found: f64, table: f64, digit: f64) {
    assert!((found - table).abs() <= 0.5 * digit, "found {found}, the table says {table}");
}

/// RMSE of a frame of a scenario against the same after a change of it.
fn off_by(name: &str, frame: u64, change: impl FnOnce(&mut Scenario)) -> f64 {
    rmse(&small(name, change).machine(frame), &small(name, as_it_stands).machine(frame))
}

#[test]
fn craters_ask_for_sub_generators() {
    let mut shipped = small("craters", as_it_stands);
    let all = shipped.machine(50);
    assert_eq!(all.counts["dropped_features"], 0);
    let parts = shipped.settings.feature_generator;
    shipped.settings.feature_generator = FeatureParts { sub_generators: Some(2), ..parts };
    let few = shipped.machine(50);
    assert!(few.counts["dropped_features"] > 0, "two of each type are too few");
    assert_eq!(few.counts["features"] + few.counts["dropped_features"], all.counts["features"]);
    assert_figure(rmse(&few, &all), 0.017, 0.001);
    shipped.settings.feature_generator = parts;
    shipped.settings.mixing_unit = MixingParts { gate: Gate::SelfKeyed, threshold: 0.3 };
    assert_figure(rmse(&shipped.machine(50), &all), 0.047, 0.001);
}

#[test]
fn long_shadows_darken_the_plain() {
    let shadowed = small("long-shadows", as_it_stands).machine(53);
    let plain = small("long-shadows", |scenario| scenario.shadows = None).machine(53);
    assert_figure(black(&shadowed), 0.613, 0.001);
    assert_figure(black(&plain), 0.466, 0.001);
    assert_eq!(plain.counts["shadow_toggles"], 0);
}

#[test]
fn the_landing_site_changes_with_its_events() {
    assert_figure(off_by("landing-site", 80, |scenario| scenario.events.clear()), 0.124, 0.001);
}

#[test]
fn regolith_is_grained() {
    assert_figure(off_by("regolith", 30, |scenario| scenario.texture = None), 0.023, 0.001);
}

#[test]
fn far_mountains_sink_behind_the_lunoid() {
    let shipped = small("far-mountains", as_it_stands);
    let mut flat = shipped.clone();
    flat.settings.laws.curvature = Curvature::None;
    assert_figure(rmse(&flat.machine(50), &shipped.machine(50)), 0.075, 0.001);
}

#[test]
fn two_levels_fade_into_one_another() {
    let switched = |scenario: &mut Scenario| scenario.levels.as_mut().expect("two levels").blend = 0.0;
    assert_figure(off_by("two-levels-blended", 0, switched), 0.055, 0.001);
    let shipped = small("two-levels-blended", as_it_stands);
    assert_figure(shipped.machine(0).counts["level_step_mm"] as f64 / 1000.0, 9.1, 0.1);
}

#[test]
fn the_full_drive_is_of_the_reports_measure() {
    let counts = small("full-drive", as_it_stands).machine(0).counts;
    let a_sweep = |count: u64| count as f64 / counts["sweeps"] as f64;
    assert_figure(a_sweep(counts["folds"]), 26.4, 0.1);
    assert_figure(a_sweep(counts["features"]), 34.3, 0.1);
    assert_figure(a_sweep(counts["shadow_toggles"]), 32.5, 0.1);
}

#[test]
fn the_full_drive_asks_too_much_of_the_parts_of_1970() {
    let nominal = |scenario: &mut Scenario| scenario.machine = "pra-nominal".into();
    let counts = Shipped::changed("full-drive", Some(525), nominal).machine(60).counts;
    assert_eq!((counts["late_words"], counts["dropped_segments"], counts["bodies"]), (19_197, 96, 24));
}

#[test]
fn rough_ride_leans_and_bends() {
    let shipped = small("rough-ride", as_it_stands);
    let leaning = shipped.machine(38);
    let mut reported = shipped.clone();
    reported.settings.laws.projection = Projection::AsReported;
    assert_figure(rmse(&reported.machine(38), &leaning), 0.067, 0.001);
    assert_figure(off_by("rough-ride", 38, |scenario| scenario.roll = RollDisplay::None), 0.264, 0.001);
}

#[test]
fn tracks_are_seen_after_the_turn() {
    assert_figure(off_by("tracks", 119, |scenario| scenario.tracks = None), 0.012, 0.001);
}

#[test]
fn the_rover_casts_its_own_shadow() {
    assert_figure(off_by("own-shadow", 33, |scenario| scenario.vehicle_shape = None), 0.138, 0.001);
}

#[test]
fn the_sun_moves() {
    let shipped = small("moving-sun", as_it_stands);
    assert_figure(black(&shipped.machine(0)), 0.424, 0.001);
    assert_figure(black(&shipped.machine(47)), 0.358, 0.001);
    let still = small("moving-sun", |scenario| {
        if let Sunlight::Angles { drift, .. } = &mut scenario.sun {
            *drift = None;
        }
    });
    assert_figure(black(&still.machine(47)), 0.424, 0.001);
}

#[test]
fn lunar_light_is_not_lamberts() {
    let change = |scenario: &mut Scenario| scenario.photometry = Photometry::Lambert;
    assert_figure(off_by("lunar-light", 35, change), 0.205, 0.001);
}

#[test]
fn groups_have_suns_of_their_own() {
    let seen = |change: fn(&mut Scenario)| Shipped::changed("colours", None, change).exact(35);
    let one_sun = seen(|scenario| scenario.groups.iter_mut().for_each(|group| group.sun = None));
    assert_figure(rmse(&one_sun, &seen(as_it_stands)), 0.089, 0.001);
}
