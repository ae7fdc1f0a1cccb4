//! More stars than the beam has time for (acceptance test 13).

use crate::shots::Shot;
use generator::FrameCounts;
use quantities::{Rate, unit_interval};
use scenario::{LightPoint, LightSource};

/// Counters of a frame of 3000 calligraphic stars at an update rate.
fn counts(hertz: u64) -> FrameCounts {
    let mut shot = Shot::new(64, 64, 100.0);
    shot.pose.attitude.pitch = 0.8;
    shot.view.update = Rate::new(hertz, 1).unwrap();
    shot.view.refresh = shot.view.update;
    let star = |id: u32| {
        let part = |k: u64| unit_interval(3, &[u64::from(id), k]);
        let at = [64.0 * part(0), 64.0 * part(1)];
        let source = LightSource::Star {
            direction: shot.eye().direction(at).normalize(),
            magnitude: 2.0 + 4.0 * part(2),
        };
        LightPoint { source, calligraphic: true, ..shot.lamp(id, at, 1.0, 1.0) }
    };
    shot.effects.lights = (0..3000).map(star).collect();
    shot.draw().counts
}

#[test]
fn the_beam_drops_what_it_has_no_time_for() {
    let slow = counts(30);
    assert_eq!((slow["calligraphic"], slow["beam_dropped"]), (3000, 0));
    assert_eq!(counts(60)["beam_dropped"], 1334);
}
