//! The figures of `scenarios/README.md`, measured again.

use compare::compare;
use hardware_model::LatePolicy;
use landscape::Sun;
use lunoid_tests::Shipped;
use lunoid_tests::shipped::Shown;
use quantities::radians;
use scenario::{Curvature, RangeLaw, Sunlight};

fn rmse(a: &Shown, b: &Shown) -> f64 {
    compare(&a.picture, &b.picture, None, &[]).unwrap().rmse
}

fn share(values: &[f64], counts: impl Fn(&f64) -> bool) -> f64 {
    values.iter().filter(|value| counts(value)).count() as f64 / values.len() as f64
}

/// As printed in the table: half a unit of the last digit.
fn assert_figure(found: f64, table: f64, digit: f64) {
    assert!((found - table).abs() <= 0.5 * digit, "found {found}, the table says {table}");
}

#[test]
fn first_light_late_words_tear_the_massif() {
    let mut shipped = Shipped::read("first-light", None);
    let clean = shipped.machine(60);
    assert_eq!(clean.counts["late_words"], 0);
    // 90 ns at 1000 MHz.
    shipped.settings.loader.access = 90;
    shipped.settings.loader.late_policy = LatePolicy::StrobeThrough;
    let late = shipped.machine(60);
    assert_eq!(late.counts["late_words"], 2_506_113);
    assert_figure(rmse(&late, &clean), 0.118, 0.001);
}

#[test]
fn the_nominal_drive_is_late_noisy_and_short_of_rocks() {
    let shipped = Shipped::read("nominal-drive", None);
    let ideal = Shipped::changed("nominal-drive", Some(525), |scenario| scenario.machine = "ideal".into());
    let (nominal, ideal) = (shipped.machine(45), ideal.machine(45));
    assert_eq!((nominal.counts["late_words"], nominal.counts["bodies"]), (17_595, 24));
    assert_eq!((ideal.counts["late_words"], ideal.counts["bodies"]), (0, 48));
    assert_figure(rmse(&nominal, &ideal), 0.057, 0.001);
}

#[test]
fn ridge_crossing_opens_from_the_crest() {
    let shipped = Shipped::read("ridge-crossing", None);
    let blanked = |frame| share(&shipped.waveform(frame, 300, "dpp.blank"), |&gate| gate == 1.0);
    assert_figure(blanked(0), 0.595, 0.001);
    assert_figure(blanked(99), 0.352, 0.001);
}

#[test]
fn lunar_horizon_hides_the_feet_of_mountains() {
    let mut shipped = Shipped::read("lunar-horizon", None);
    let curved = shipped.machine(0);
    shipped.settings.laws.curvature = Curvature::None;
    assert_figure(rmse(&shipped.machine(0), &curved), 0.098, 0.001);
}

#[test]
fn low_sun_leaves_faces_in_local_shadow() {
    let mut shipped = Shipped::read("low-sun", None);
    let shadow = |shipped: &Shipped| share(&shipped.waveform(0, 300, "tg.reflectivity"), |&r| r == 0.0);
    assert_figure(shadow(&shipped), 0.261, 0.001);
    let first = Sun { azimuth: radians(255.0), elevation: radians(60.0) };
    shipped.scenario.sun = Sunlight::Angles { first, drift: None };
    assert_eq!(shadow(&shipped), 0.0);
}

#[test]
fn descent_follows_its_file() {
    let shipped = Shipped::read("descent", Some(8));
    let heights = [0, shipped.frames() - 1].map(|frame| shipped.pose(frame).pose.eye[2]);
    assert_figure(heights[0], 324.0, 0.1);
    assert_figure(heights[1], 14.5, 0.1);
}

#[test]
fn range_programmes_decide_the_foreground() {
    let mut shipped = Shipped::read("range-programmes", None);
    let exact = shipped.exact(0);
    let off = |shown: &Shown| compare(&shown.picture, &exact.picture, None, &[2]).unwrap().beyond[0].share;
    assert_figure(off(&shipped.machine(0)), 0.007, 0.001);
    shipped.settings.range.law = RangeLaw::ConstantRate;
    assert_figure(off(&shipped.machine(0)), 0.341, 0.001);
}
