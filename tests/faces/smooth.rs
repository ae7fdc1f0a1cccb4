//! Smooth-shaded faces on their scenarios.

use generator::{Label, PlaneKind, Session};
use lunoid_tests::Shipped;
use scenario::Scenario;
use signal::Probe;

fn session(shipped: &Shipped, sets: &[(&str, &str)]) -> Box<dyn Session> {
    let generator =
        registry::configure_with(&smooth_faces::ROW, sets).unwrap_or_else(|problems| panic!("{problems}"));
    generator.prepare(shipped.stage().stage()).unwrap()
}

/// A frame of a scenario under run parameters, after a change of the scenario.
fn drawn(
    name: &str,
    frame: u64,
    sets: &[(&str, &str)],
    change: impl FnOnce(&mut Scenario),
) -> lunoid_tests::Shown {
    let shipped = Shipped::changed(name, None, change);
    shipped.draw(&*session(&shipped, sets), frame, &mut Probe::off())
}

/// Pixels that show something.
fn pixels(shown: &lunoid_tests::Shown, label: Label) -> usize {
    let code = f32::from(label.code());
    shown.planes.get(PlaneKind::Label).unwrap().iter().filter(|found| **found == code).count()
}

/// RMSE over displayed grey, 0 to 1.
fn rmse(a: &lunoid_tests::Shown, b: &lunoid_tests::Shown) -> f64 {
    compare::compare(&a.picture, &b.picture, None, &[]).unwrap().rmse
}

#[test]
fn figures() {
    let none: &[(&str, &str)] = &[];
    let lists = [("faces.order", "lists"), ("faces.ground", "false")];
    let sun = drawn("sea-state", 30, &lists, |_| {});
    let normals = drawn("sea-state", 30, &[lists[0], lists[1], ("faces.animate", "normals")], |_| {});
    println!("words {} {}", sun.counts["words"], normals.counts["words"]);
    let wakes = drawn("sea-wakes", 90, &lists, |_| {});
    let replaced = drawn("sea-wakes", 90, &lists, |scenario| {
        let wake = scenario.faces.ships[0].stern_wake.as_mut().unwrap();
        wake.detail = faces::Detail::Replace;
    });
    println!("clamped {} {}", wakes.counts["clamped"], replaced.counts["clamped"]);
    let motion = drawn("ship-motion", 30, &lists, |_| {});
    let still =
        drawn("ship-motion", 30, &lists, |scenario| scenario.faces.ships[0].motion = Default::default());
    println!("motion {}", rmse(&motion, &still));
    let first = drawn("ship-motion", 30, &lists, |scenario| {
        scenario.faces.ships[0].hiding = faces::ship::Hiding::SeaFirst;
    });
    println!("ship {} sea first {}", pixels(&motion, Label::Ship), pixels(&first, Label::Ship));
    let [far, near] =
        [0, 540].map(|frame| pixels(&drawn("ship-landing", frame, &lists, |_| {}), Label::Ship));
    println!("landing {far} {near}");
    let tails = drawn("rooster-tails", 120, none, |_| {});
    let bare = drawn("rooster-tails", 120, none, |scenario| scenario.faces.plumes.clear());
    println!("tails {} {}", pixels(&tails, Label::Wake), pixels(&bare, Label::Wake));
    let dust = drawn("landing-dust", 120, none, |_| {});
    let clear = drawn("landing-dust", 120, none, |scenario| scenario.faces.effects.clear());
    println!("dust {}", rmse(&dust, &clear));
    let smooth = drawn("smooth-site", 90, none, |_| {});
    let flat = drawn("smooth-site", 90, &[("faces.shading", "flat")], |_| {});
    println!("site {}", rmse(&smooth, &flat));
}
