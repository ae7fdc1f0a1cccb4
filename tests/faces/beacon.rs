//! Lights of one scenario on the hybrid machine and on the sampled generator (acceptance test 14 of the sampled generator).

use generator::Session;
use lunoid_tests::Shipped;
use machine::Prepare;
use scenario::Scenario;

/// Frames of `night-landing`: the beacon is behind the ridge in the first and clear of it in the last.
const FRAMES: [u64; 2] = [0, 99];

/// `night-landing` with its beacon behind the ridge alone, on a small raster, by the parts of a model.
fn beacon(model: &str) -> Shipped {
    Shipped::changed("night-landing", None, |scenario: &mut Scenario| {
        scenario.machine = model.into();
        scenario.effects.lights.retain(|light| light.id == "ridge-beacon");
        scenario.effects.stars = None;
        scenario.raster.sweeps = Some(400);
        (scenario.raster.columns, scenario.raster.lines) = (Some(400), Some(230));
    })
}

/// Share of the beacon's light that reaches the eye in a frame.
fn fading(shipped: &Shipped, session: &dyn Session, frame: u64) -> f64 {
    let list = session.beam_list(frame, &shipped.pose(frame).pose).unwrap().expect("it has a beam");
    list.first().map_or(0.0, |entry| entry.display_intensity / entry.intensity)
}

/// First frame that shows the beacon.
fn first_shown(shipped: &Shipped, session: &dyn Session) -> u64 {
    let [mut hidden, mut shown] = FRAMES;
    assert_eq!(fading(shipped, session, hidden), 0.0);
    assert!(fading(shipped, session, shown) > 0.99);
    while hidden + 1 < shown {
        let middle = u64::midpoint(hidden, shown);
        *(if fading(shipped, session, middle) > 0.0 { &mut shown } else { &mut hidden }) = middle;
    }
    shown
}

#[test]
fn a_beacon_appears_over_its_ridge_in_the_same_frame_on_every_machine() {
    // Noise of the nominal processor moves the elevation that it holds.
    let machines = [("ideal", 1), ("pra-parts", 1), ("pra-nominal", 2)];
    let ideal = beacon("ideal");
    let sampled = registry::configure_with(&sampled::ROW, &[]).unwrap_or_else(|error| panic!("{error}"));
    let expected = first_shown(&ideal, &*sampled.prepare(ideal.stage().stage()).unwrap());
    for (model, frames) in machines {
        let shipped = beacon(model);
        let found = first_shown(&shipped, &*shipped.stage().prepare());
        assert!(found.abs_diff(expected) <= frames, "{model}: frame {found}, sampled {expected}");
    }
}
