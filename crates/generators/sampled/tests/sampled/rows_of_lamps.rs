//! A row of lamps that merge towards the horizon, with few slots for lights (acceptance test 11).

use crate::shots::{Frame, Shot};
use generator::PlaneKind;
use scenario::LightPoint;

const COLUMNS: u32 = 40;
const LINES: u32 = 24;

/// Hundred lamps on posts along a road, with `slots` for lights.
fn road(slots: Option<u32>) -> Shot {
    let mut shot = Shot::new(COLUMNS, LINES, 60.0);
    shot.run.sampling.lights = slots;
    let lamp = |id: u32| {
        let at = glam::DVec3::new(2000.0 + 8.0 + 3.0 * f64::from(id), 2003.0, 3.0);
        LightPoint { intensity: 0.4, colour: [1.0, 0.8, 0.5], ..crate::shots::lamp(id, at, 0.4) }
    };
    shot.effects.lights = (0..100).map(lamp).collect();
    shot
}

/// Mean bound on the green of a pixel's sampling points, as the session explains it.
fn bound(shot: &Shot, pixel: [usize; 2]) -> f64 {
    let facts = shot.session().explain(0, &shot.pose, pixel).unwrap();
    let points = facts.iter().filter(|fact| fact.what == "sampling point");
    let of_point = |text: &str| {
        let lost = text.split("lost to the limits: at most ").nth(1);
        // Four places are printed.
        lost.map_or(0.0, |rest| rest.split(' ').next().unwrap().parse::<f64>().unwrap() + 5e-5)
    };
    points.map(|fact| of_point(&fact.value)).sum::<f64>() / 4.0
}

#[test]
fn lost_lights_are_counted_and_bounded() {
    let unlimited = road(None).draw();
    assert_eq!(unlimited.counts["lost_lights"], 0);
    let mut lost: Vec<(u64, f64)> = Vec::new();
    for slots in [1, 2] {
        let shot = road(Some(slots));
        let frame = shot.draw();
        let far = difference(&frame, &unlimited);
        let mut differing = 0;
        for (index, difference) in far.iter().enumerate().filter(|(_, difference)| **difference > 1e-6) {
            let bound = bound(&shot, [index % COLUMNS as usize, index / COLUMNS as usize]);
            assert!(*difference <= bound, "{slots} slots, pixel {index}: {difference}, bound {bound}");
            differing += 1;
        }
        assert!(differing > 3, "{differing}");
        lost.push((frame.counts["lost_lights"], far.iter().sum()));
    }
    assert!(lost[0].0 >= lost[1].0 && lost[1].0 > 0, "{lost:?}");
    assert!(lost[0].1 > lost[1].1, "{lost:?}");
}

/// How much green the second frame has more, or less, pixel by pixel.
fn difference(one: &Frame, other: &Frame) -> Vec<f64> {
    let pixels = one.plane(PlaneKind::Green).iter().zip(other.plane(PlaneKind::Green));
    pixels.map(|(one, other)| f64::from((one - other).abs())).collect()
}
