//! What the study dropped, beside what replaced it.

use quantities::{radians, sin_cos};
use scenario::{EffectFileWish, FacePlace, Scenario};

use super::figures::oncoming;
use super::measured::{contrast, told};
use super::{Figure, Measured, Shot, Still};
use crate::shipped::folder;

/// Half of the length of a destroyer (m).
const HALF_LENGTH: f64 = 171.6 / 2.0;

const BY_DEPTH: &[(&str, &str)] = &[("faces.order", "depth")];

/// An effect of the library at a place with a heading.
fn effect(scenario: &mut Scenario, name: &str, at: [f64; 2], heading: f64) {
    let file = folder().join("effects").join(format!("{name}.toml"));
    let place = FacePlace::Ground([at[0], at[1], 0.0], heading);
    scenario.faces.effects.push(EffectFileWish { file, place });
}

/// An effect before the eye in place of the sea, under a sun at 30 degrees as in the test of mounds.
pub(super) fn instead_of_sea(scenario: &mut Scenario, name: &str) {
    scenario.faces.sea = None;
    let sun = landscape::Sun { azimuth: radians(90.0), elevation: radians(30.0) };
    scenario.sun = scenario::Sunlight::Angles { first: sun, drift: None };
    effect(scenario, name, [260.0, 1000.0], 0.0);
}

/// Removes the wakes of the ship and puts an effect so far ahead of its middle (m).
fn instead_of_wakes(scenario: &mut Scenario, name: &str, ahead: f64) {
    let ship = &mut scenario.faces.ships[0];
    (ship.bow_wake, ship.stern_wake) = (None, None);
    let ([north, east], heading) = (ship.at, ship.heading);
    let (sin, cos) = sin_cos(heading);
    effect(scenario, name, [north + ahead * cos, east + ahead * sin], heading);
}

fn oncoming_with(scenario: &mut Scenario, name: &str) {
    oncoming(scenario);
    instead_of_wakes(scenario, name, HALF_LENGTH);
}

fn before_the_eye(change: fn(&mut Scenario)) -> Shot {
    Shot { scenario: "sea-state", frame: 0, sets: &[], change }
}

fn at_sea(frame: u64, change: fn(&mut Scenario)) -> Shot {
    Shot { scenario: "sea-wakes", frame, sets: BY_DEPTH, change }
}

/// Contrasts of the left and the right picture.
fn two_contrasts(stills: &[Still]) -> Vec<Measured> {
    let [dropped, instead] = [0, 1].map(|k| told(contrast(&stills[k])));
    vec![("contrast of what was dropped", dropped), ("contrast of what replaced it", instead)]
}

/// Pieces that cross the scan lines of the left and of the right picture.
fn crossings(stills: &[Still]) -> Vec<Measured> {
    let [dropped, instead] = [0, 1].map(|k: usize| stills[k].counts["crossings"].to_string());
    vec![("crossings with what was dropped", dropped), ("crossings with what replaced it", instead)]
}

/// All of them: the dropped means on the left, what replaced it on the right.
pub(super) fn all() -> Vec<Figure> {
    let figure = |name, shots, measure| Figure { name, shots, measure };
    let confused = || before_the_eye(|it| instead_of_sea(it, "confused-sea"));
    let mounds = |it: &mut Scenario| instead_of_sea(it, "dropped/mounds");
    let smooth = |it: &mut Scenario| instead_of_sea(it, "dropped/smooth-mounds");
    vec![
        figure(
            "dropped-mounds",
            vec![before_the_eye(mounds), before_the_eye(smooth), confused()],
            |stills| {
                let [faceted, smooth, instead] = [0, 1, 2].map(|k| told(contrast(&stills[k])));
                vec![
                    ("contrast of faceted mounds", faceted),
                    ("contrast of smooth mounds", smooth),
                    ("contrast of what replaced them", instead),
                ]
            },
        ),
        figure(
            "dropped-outlined-mounds",
            vec![before_the_eye(|it| instead_of_sea(it, "dropped/outlined-mounds")), confused()],
            two_contrasts,
        ),
        figure(
            "dropped-overdrawn-mounds",
            vec![before_the_eye(|it| instead_of_sea(it, "dropped/overdrawn-mounds")), confused()],
            two_contrasts,
        ),
        figure(
            "dropped-white-v",
            vec![
                at_sea(0, |it| instead_of_wakes(it, "dropped/white-v", HALF_LENGTH)),
                at_sea(0, |it| instead_of_wakes(it, "churned-water", -HALF_LENGTH)),
            ],
            crossings,
        ),
        figure(
            "dropped-turning-cam",
            vec![
                at_sea(24, |it| oncoming_with(it, "dropped/turning-cam")),
                at_sea(24, |it| oncoming_with(it, "bow-wake")),
            ],
            crossings,
        ),
    ]
}
