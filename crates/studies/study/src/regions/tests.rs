use survey::SurveyOptions;

use super::ground::{Relief, Waves};
use super::{HEIGHT_RMS, SLOPE_RMS, ladder, unsmoothed};
use crate::Effort;
use crate::ladder::{Expectation, LadderOutcome};

#[test]
fn slopes_are_those_of_the_heights() {
    let waves = Waves::of_length(80.0);
    for place in [[3.0, 5.0], [41.0, 77.0], [120.0, 9.5]] {
        let step = 1e-4;
        let [_, north, east] = waves.at(place);
        let rise = |axis: usize| {
            let moved = |by: f64| {
                let mut place = place;
                place[axis] += by;
                waves.at(place)[0]
            };
            (moved(step) - moved(-step)) / (2.0 * step)
        };
        assert!((rise(0) - north).abs() < 1e-8 && (rise(1) - east).abs() < 1e-8, "{place:?}");
    }
}

/// A penalty that is too large, a word at the wrong place, or a degree less shows here.
#[test]
fn banks_of_a_smooth_ground_have_the_order_of_their_pieces() {
    let expected = |error, order| Expectation { error, order, why: "theory" };
    let expected = [expected(HEIGHT_RMS, 6.0), expected(SLOPE_RMS, 5.0)];
    let waves = Waves::of_length(160.0);
    let effort = Effort { repetitions: 1 };
    let found = ladder(("r", "r"), &waves, &unsmoothed(10.0), [32, 4], &expected, effort).unwrap();
    assert!(found.orders.iter().all(|order| order.agrees(0.2)), "{:?}", found.orders);
    assert!(found.rungs.iter().all(|rung| rung.time_s.unwrap()[0] > 0.0));
    // As shipped the survey smooths, and holds samples back: small regions gain nothing more.
    let shipped = ladder(("r", "r"), &waves, &SurveyOptions::new(10.0), [16, 4], &[], effort).unwrap();
    let errors = |ladder: &LadderOutcome| {
        ladder.rungs.iter().map(|rung| rung.error(HEIGHT_RMS).unwrap()).collect::<Vec<_>>()
    };
    let (pure, shipped) = (errors(&found), errors(&shipped));
    assert!(shipped.iter().zip(&pure).all(|(shipped, pure)| shipped > pure), "{shipped:?}, {pure:?}");
    assert!(shipped[4] > 1e3 * pure[4], "{shipped:?}, {pure:?}");
}
