//! The figures of the study by number.

use faces::{Pattern, SeaState, TwoSine};
use generator::Label;
use quantities::radians;
use scenario::{FieldWish, Scenario};

use super::exhibits::instead_of_sea;
use super::measured::{apart, contrast, largest_step, mean, told};
use super::{Figure, Measured, Shot, Still};

/// Frames between the two times of figures 8 and 9: a quarter of a turn of the sun.
const LATER: u64 = 37;

/// Frames of figure 13: faces 3, 10, 17 and 24 of 28, two frames each.
const BOW_FRAMES: [u64; 4] = [6, 20, 34, 48];

/// Tangent of half the field of the pictures of a bow.
const HALF_FIELD: f64 = 0.2;

const FLAT: &[(&str, &str)] = &[("faces.shading", "flat")];

fn sea(frame: u64, sets: &'static [(&'static str, &'static str)], change: fn(&mut Scenario)) -> Shot {
    Shot { scenario: "sea-state", frame, sets, change }
}

fn as_it_stands(_: &mut Scenario) {}

fn state(scenario: &mut Scenario, state: SeaState) {
    scenario.faces.sea.as_mut().expect("a sea").state = state;
}

/// A regular pattern of many intensities that stands still: frame 0.
fn regular(scenario: &mut Scenario) {
    let sea = scenario.faces.sea.as_mut().expect("a sea");
    sea.pattern = Pattern::TwoSine(TwoSine { lengths: [60.0, 35.0], turned: radians(60.0) });
}

/// The destroyer comes towards the eye.
pub(super) fn oncoming(scenario: &mut Scenario) {
    let ship = &mut scenario.faces.ships[0];
    (ship.at, ship.heading, ship.speed) = ([960.0, 1048.0], radians(200.0), 0.0);
    ship.stern_wake = None;
    scenario.field = FieldWish::Across(HALF_FIELD);
}

fn one_contrast(stills: &[Still]) -> Vec<Measured> {
    vec![("contrast", told(contrast(&stills[0])))]
}

fn contrast_and_step(stills: &[Still]) -> Vec<Measured> {
    let step = ("largest step of a line, over the mean", told(largest_step(&stills[0])));
    one_contrast(stills).into_iter().chain([step]).collect()
}

fn of_state(stills: &[Still], state: SeaState) -> Vec<Measured> {
    let corners = ("contrast of its corners, cot alpha cot elevation", told(state.contrast()));
    one_contrast(stills).into_iter().chain([corners]).collect()
}

/// All figures, by their numbers.
pub(super) fn all() -> Vec<Figure> {
    let figure = |name, shots, measure| Figure { name, shots, measure };
    let bow = BOW_FRAMES.map(|frame| Shot { scenario: "sea-wakes", frame, sets: &[], change: oncoming });
    let deck = |sets| Shot { scenario: "ship-landing", frame: 330, sets, change: as_it_stands };
    vec![
        figure(
            "figure-01",
            vec![sea(0, &[], |it| instead_of_sea(it, "dropped/smooth-mounds"))],
            one_contrast,
        ),
        figure("figure-02", vec![sea(0, FLAT, regular)], contrast_and_step),
        figure("figure-03", vec![sea(0, &[], regular)], contrast_and_step),
        figure("figure-04", vec![sea(0, &[], |it| state(it, SeaState::Calm))], |stills| {
            of_state(stills, SeaState::Calm)
        }),
        figure("figure-05", vec![sea(0, &[], |it| state(it, SeaState::Moderate))], |stills| {
            of_state(stills, SeaState::Moderate)
        }),
        figure("figure-06", vec![sea(0, &[], |it| state(it, SeaState::High))], |stills| {
            of_state(stills, SeaState::High)
        }),
        figure("figure-08", vec![sea(0, FLAT, as_it_stands)], contrast_and_step),
        figure("figure-09", vec![sea(LATER, FLAT, as_it_stands), sea(0, FLAT, as_it_stands)], |stills| {
            let apart = ("mean distance from figure 8, over the mean", told(apart(&stills[0], &stills[1])));
            contrast_and_step(stills).into_iter().chain([apart]).collect()
        }),
        figure("figure-10", vec![sea(LATER, &[], as_it_stands), sea(LATER, FLAT, as_it_stands)], |stills| {
            let [smooth, flat] = [0, 1].map(|k| mean(&stills[k]));
            let ratio = ("mean light over that of figure 9", told(smooth / flat));
            contrast_and_step(stills).into_iter().chain([ratio]).collect()
        }),
        figure("figure-13", bow.into(), |stills| {
            let names = ["pixels of face 3", "pixels of face 10", "pixels of face 17", "pixels of face 24"];
            let pixels = stills.iter().map(|still| still.pixels(Label::Wake).to_string());
            names.into_iter().zip(pixels).collect()
        }),
        figure("figure-14", vec![deck(FLAT), deck(&[])], |stills| {
            vec![
                ("contrast without smooth shading", told(contrast(&stills[0]))),
                ("contrast with smooth shading", told(contrast(&stills[1]))),
            ]
        }),
    ]
}
