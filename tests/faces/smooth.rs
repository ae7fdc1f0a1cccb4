//! Smooth-shaded faces on their scenarios.

use generator::{Label, PlaneKind, Session};
use lunoid_tests::{Shipped, Shown};
use scenario::Scenario;
use signal::Probe;

fn session(shipped: &Shipped, sets: &[(&str, &str)]) -> Box<dyn Session> {
    let generator =
        registry::configure_with(&smooth_faces::ROW, sets).unwrap_or_else(|problems| panic!("{problems}"));
    generator.prepare(shipped.stage().stage()).unwrap()
}

/// A frame of a scenario under run parameters, after a change of the scenario.
fn drawn(name: &str, frame: u64, sets: &[(&str, &str)], change: impl FnOnce(&mut Scenario)) -> Shown {
    let shipped = Shipped::changed(name, None, change);
    shipped.draw(&*session(&shipped, sets), frame, &mut Probe::off())
}

/// Pixels that show something.
fn pixels(shown: &Shown, label: Label) -> usize {
    let code = f32::from(label.code());
    shown.planes.get(PlaneKind::Label).unwrap().iter().filter(|found| **found == code).count()
}

/// RMSE over displayed grey, 0 to 1.
fn rmse(a: &Shown, b: &Shown) -> f64 {
    compare::compare(&a.picture, &b.picture, None, &[]).unwrap().rmse
}

/// The run parameters of the scenarios at sea, which the table of a scenario gives to the command alone.
const AT_SEA: [(&str, &str); 2] = [("faces.order", "lists"), ("faces.ground", "false")];

fn at_sea(name: &str, frame: u64, change: impl FnOnce(&mut Scenario)) -> Shown {
    drawn(name, frame, &AT_SEA, change)
}

#[test]
fn a_sea_takes_three_words_by_its_sun_and_three_a_normal_by_its_normals() {
    let [order, ground] = AT_SEA;
    let words = |animate| {
        drawn("sea-state", 30, &[order, ground, ("faces.animate", animate)], |_| {}).counts["words"]
    };
    assert_eq!((words("sun"), words("normals")), (3, 121_203));
}

#[test]
fn the_sea_is_seen_through_a_wake_that_is_added() {
    let added = at_sea("sea-wakes", 90, |_| {});
    let replaced = at_sea("sea-wakes", 90, |scenario| {
        scenario.faces.ships[0].stern_wake.as_mut().unwrap().detail = faces::Detail::Replace;
    });
    assert_eq!(format!("{:.3}", rmse(&added, &replaced)), "0.021");
}

#[test]
fn a_ship_moves_and_is_hidden_by_a_sea_that_comes_first() {
    let moving = at_sea("ship-motion", 30, |_| {});
    let still = at_sea("ship-motion", 30, |scenario| scenario.faces.ships[0].motion = Default::default());
    assert_eq!(format!("{:.3}", rmse(&moving, &still)), "0.043");
    let first = at_sea("ship-motion", 30, |scenario| {
        scenario.faces.ships[0].hiding = faces::ship::Hiding::SeaFirst;
    });
    assert_eq!([pixels(&moving, Label::Ship), pixels(&first, Label::Ship)], [41_307, 1735]);
}

#[test]
fn a_ship_grows_on_the_way_to_its_deck() {
    let [far, near] = [0, 540].map(|frame| pixels(&at_sea("ship-landing", frame, |_| {}), Label::Ship));
    assert_eq!([far, near], [2911, 73_947]);
}

#[test]
fn wheels_throw_dust() {
    let tails = |change: fn(&mut Scenario)| pixels(&drawn("rooster-tails", 120, &[], change), Label::Wake);
    assert_eq!([tails(|_| {}), tails(|scenario| scenario.faces.plumes.clear())], [15_693, 0]);
}

#[test]
fn an_engine_blows_dust() {
    let dust = drawn("landing-dust", 120, &[], |_| {});
    let clear = drawn("landing-dust", 120, &[], |scenario| scenario.faces.effects.clear());
    assert_eq!(format!("{:.3}", rmse(&dust, &clear)), "0.159");
}

#[test]
fn smooth_faces_differ_from_flat_ones() {
    let smooth = drawn("smooth-site", 90, &[], |_| {});
    let flat = drawn("smooth-site", 90, &[("faces.shading", "flat")], |_| {});
    assert_eq!(format!("{:.3}", rmse(&smooth, &flat)), "0.093");
}

#[test]
fn four_windows_have_the_words_of_one_four_times() {
    let [order, ground] = AT_SEA;
    let words = |channels| {
        drawn("ship-windows", 300, &[order, ground, ("faces.channels", channels)], |_| {}).counts["words"]
    };
    assert_eq!([words("4"), words("1")], [224, 56]);
}

/// Michelson contrast of 5th and 95th percentile over the pixels of a sea.
fn sea_contrast(shown: &Shown) -> String {
    let [light, labels] =
        [PlaneKind::Intensity, PlaneKind::Label].map(|kind| shown.planes.get(kind).unwrap());
    let sea = f32::from(Label::Sea.code());
    let of_sea = light.iter().zip(labels).filter(|(_, label)| **label == sea);
    let mut light: Vec<f32> = of_sea.map(|(light, _)| *light).collect();
    light.sort_by(f32::total_cmp);
    let [low, high] = [5, 95].map(|percent| light[percent * (light.len() - 1) / 100]);
    format!("{:.2}", (high - low) / (high + low))
}

#[test]
fn a_sea_of_false_normals_has_about_the_contrast_of_waves() {
    let small = |scenario: &mut Scenario| {
        (scenario.raster.columns, scenario.raster.lines) = (Some(120), Some(63));
    };
    let waves = Shipped::changed("sea-waves", None, small).exact(0);
    assert_eq!([sea_contrast(&at_sea("sea-waves", 0, small)), sea_contrast(&waves)], ["0.24", "0.28"]);
}
