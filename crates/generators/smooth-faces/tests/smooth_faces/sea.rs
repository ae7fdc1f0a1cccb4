//! A flat sea that moves: contrast, closed films, drift, no holes.

use faces::{Pattern, SeaState, TwoSine};
use generator::PlaneKind;
use quantities::unit_interval;

use crate::shots::{apart, draw, from_above, light, pose, run, sea, sea_list, session, stage};

const RANDOM: Pattern = Pattern::Random { seed: 1 };

/// Amplitude over mean of the light of a picture.
fn contrast(light: &[f32]) -> f64 {
    let low = light.iter().copied().fold(f32::INFINITY, f32::min);
    let high = light.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    f64::from((high - low) / (high + low))
}

#[test]
fn contrast_grows_with_the_state_and_stays_below_that_of_its_corners() {
    let mut before = -1.0;
    for state in SeaState::ALL {
        let session = session(stage(vec![sea_list(&sea(state, RANDOM))]), run());
        let light = light(&*session, 0, &from_above());
        let found = contrast(&light);
        if state == SeaState::Calm {
            assert!(light.iter().all(|pixel| *pixel == light[0]), "state 0 is uniform");
        }
        assert!(found > before && found <= state.contrast() + 1e-6, "{state:?}: {found}");
        assert!(found >= 0.7 * state.contrast(), "{state:?}: {found}");
        before = found;
    }
}

#[test]
fn a_film_closes_to_the_bit() {
    // State 2 turns once in 5 s: 150 frames.
    let session = session(stage(vec![sea_list(&sea(SeaState::Moderate, RANDOM))]), run());
    let at = |frame| light(&*session, frame, &from_above());
    let first = at(0);
    assert!(apart(&first, &at(75)) > 0.05, "half a turn is another picture");
    assert_eq!(first, at(150));
    assert_eq!(at(37), at(187));
}

#[test]
fn a_travelling_pattern_drifts_and_a_swell_does_not() {
    let drift = |pattern: Pattern, north: f64| {
        let sea = sea(SeaState::Moderate, pattern);
        let session = session(stage(vec![sea_list(&sea)]), run());
        let turn = 150_u64;
        let [first, later] = [(0, 0.0), (turn * 2 / 5, north)]
            .map(|(frame, north)| light(&*session, frame, &pose([150.0 + north, 100.0, 60.0], 0.0, -90.0)));
        apart(&first, &later)
    };
    // Two fifths of a turn: 50 m of a pattern of 125 m, five squares.
    let travelling = Pattern::Travelling { length: 125.0 };
    let [ahead, back] = [50.0, -50.0].map(|north| drift(travelling, north));
    assert!(ahead.min(back) < 0.05 && ahead.max(back) > 0.1, "{ahead} {back}");
    let swell = Pattern::Swell { length: 125.0 };
    let [ahead, back] = [50.0, -50.0].map(|north| drift(swell, north));
    assert!(ahead > 0.1 && back > 0.1, "{ahead} {back}");
    let two = Pattern::TwoSine(TwoSine { lengths: [125.0, 70.0], turned: 0.5 });
    assert!(drift(two, 50.0) > 0.1);
}

#[test]
fn a_sea_has_no_holes() {
    let session = session(stage(vec![sea_list(&sea(SeaState::High, RANDOM))]), run());
    for seed in 0..300 {
        let random = |word: u64| unit_interval(seed, &[word]);
        let eye = [120.0 + 60.0 * random(1), 80.0 + 40.0 * random(2), 5.0 + 40.0 * random(3)];
        let (planes, _) = draw(&*session, 0, &pose(eye, 360.0 * random(4), -90.0 + 20.0 * random(5)));
        let sea = f32::from(generator::Label::Sea.code());
        let labels = planes.get(PlaneKind::Label).unwrap();
        assert!(labels.iter().all(|label| *label == sea), "seed {seed}");
        let distances = planes.get(PlaneKind::Distance).unwrap();
        assert!(distances.iter().all(|distance| *distance >= eye[2] as f32 * 0.999), "seed {seed}");
    }
}
