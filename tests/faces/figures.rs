//! Each scenario with its subject, and without it.

use compare::compare;
use lunoid_tests::Shipped;
use lunoid_tests::shipped::Shown;
use scenario::{RollDisplay, Scenario};
use signal::Probe;

/// A frame of a shipped scenario after a change of it, with run parameters (key, value) of the generator.
fn drawn(name: &str, frame: u64, sets: &[(&str, &str)], change: impl FnOnce(&mut Scenario)) -> Shown {
    let shipped = Shipped::changed(name, None, change);
    let generator =
        registry::configure_with(&sampled::ROW, sets).unwrap_or_else(|problems| panic!("{problems}"));
    let session = generator.prepare(shipped.stage().stage()).unwrap();
    shipped.draw(&*session, frame, &mut Probe::off())
}

fn as_it_stands(_: &mut Scenario) {}

fn rmse(a: &Shown, b: &Shown) -> f64 {
    compare(&a.picture, &b.picture, None, &[]).unwrap().rmse
}

/// As printed in the table: half a unit of the last digit.
fn assert_figure(found: f64, table: f64, digit: f64) {
    assert!((found - table).abs() <= 0.5 * digit, "found {found}, the table says {table}");
}

#[test]
fn night_landing_shows_its_beacons() {
    let lit = drawn("night-landing", 70, &[], as_it_stands);
    let dark = drawn("night-landing", 70, &[], |scenario| scenario.effects.lights.clear());
    assert_figure(rmse(&lit, &dark), 0.0078, 1e-4);
}

#[test]
fn stars_are_seen() {
    let with = drawn("stars", 0, &[], as_it_stands);
    let without = drawn("stars", 0, &[], |scenario| scenario.effects.stars = None);
    assert_figure(rmse(&with, &without), 0.0055, 1e-4);
}

#[test]
fn dust_dims_what_stands_behind_it() {
    let dusty = drawn("dust-curtain", 40, &[], as_it_stands);
    let clear = drawn("dust-curtain", 40, &[], |scenario| scenario.effects.sheets.clear());
    assert_figure(rmse(&dusty, &clear), 0.405, 1e-3);
}

#[test]
fn one_light_a_sampling_point_is_too_few_for_a_row_of_lamps() {
    assert_eq!(drawn("lamp-row", 30, &[], as_it_stands).counts["lost_lights"], 86);
    let unlimited = drawn("lamp-row", 30, &[("sampled.lights", "-1")], as_it_stands);
    assert_eq!(unlimited.counts["lost_lights"], 0);
}

#[test]
fn an_overloaded_night_loses_surfaces_and_stars() {
    let counts = drawn("overloaded-night", 0, &[], as_it_stands).counts;
    assert_eq!((counts["lost_surfaces"], counts["beam_dropped"]), (142_727, 512));
    let unlimited = drawn("overloaded-night", 0, &[("sampled.translucent", "-1")], as_it_stands);
    assert_eq!(unlimited.counts["lost_surfaces"], 0);
}

/// Lines by which the horizon is broken where the windows `left` and `right` of `three-windows` meet in frame 0.
fn break_at_seam(left: &str, right: &str, change: impl Fn(&mut Scenario)) -> usize {
    let horizon = |name: &str, column: fn(usize) -> usize| {
        let shown = drawn("three-windows", 0, &[], |scenario| {
            change(scenario);
            *scenario = scenario.clone().through(name).unwrap();
        });
        let (columns, lines) = (shown.picture.columns(), shown.picture.lines());
        let codes = shown.picture.codes();
        (0..lines).find(|line| codes[line * columns + column(columns)] > 0).unwrap()
    };
    horizon(left, |columns| columns - 1).abs_diff(horizon(right, |_| 0))
}

#[test]
fn three_windows_show_one_world() {
    assert!(break_at_seam("left", "ahead", as_it_stands) <= 1);
    assert!(break_at_seam("ahead", "right", as_it_stands) <= 1);
    // Pictures that stay upright do not join.
    let upright = |scenario: &mut Scenario| scenario.roll = RollDisplay::None;
    assert_eq!(break_at_seam("left", "ahead", upright), 30);
}
