//! Bow wake of 28 faces (acceptance test 7).

use std::collections::BTreeMap;

use faces::{BOW_FACES, BowWake, Side, blend};
use glam::DVec3;
use quantities::radians;

use crate::near;

fn wake() -> BowWake {
    BowWake { height: 3.0, length: 20.0, lean: 0.0, foam: [1.0; 3], sea: [0.0, 0.1, 0.2] }
}

#[test]
fn every_face_shows_for_its_frames_in_order() {
    for frames in [1, 2, 3] {
        let group = wake().group("bow", Side::Port, 2, frames).expect("a wake");
        assert_eq!(group.mesh.faces().len(), 28);
        let mut counts = BTreeMap::new();
        let mut last = 0;
        for frame in 0..28 * frames {
            let shown = group.shown(frame, |_| 0.0);
            assert_eq!(shown.len(), 1, "one face in the list");
            assert!(shown[0] == last || shown[0] == last + 1, "in order");
            last = shown[0];
            *counts.entry(last).or_insert(0) += 1;
        }
        assert!(counts.len() == 28 && counts.values().all(|&count| count == frames), "{counts:?}");
        assert_eq!(group.shown(28 * frames, |_| 0.0), [0]);
    }
}

#[test]
fn shapes_grow_and_fade() {
    let half = 0.5 / 28.0;
    near(wake().base(0), 20.0 * (0.4 + 0.6 * half));
    near(wake().crest(0), 3.0 * libm::sin(std::f64::consts::PI * half));
    near(wake().crest(27), wake().crest(0));
    let highest = (0..BOW_FACES).max_by(|&a, &b| wake().crest(a).total_cmp(&wake().crest(b)));
    assert!(matches!(highest, Some(13 | 14)));
    assert_eq!(wake().colour(20), [1.0; 3]);
    let faded = (27.5 / 28.0 - 0.75) / 0.25;
    near(wake().colour(27)[1], 1.0 - 0.9 * faded);
    let fast = wake().at_speed(2.0);
    assert_eq!((fast.height, fast.length), (12.0, 40.0));
}

#[test]
fn sides_are_mirrored_and_lean_outwards() {
    let leaning = BowWake { lean: 0.3, ..wake() };
    for face in 0..BOW_FACES {
        let (port, starboard) = (leaning.corners(face, Side::Port), leaning.corners(face, Side::Starboard));
        for (left, right) in port.iter().zip(starboard) {
            assert_eq!(*left, DVec3::new(right.x, -right.y, right.z));
        }
        near(starboard[2].y, 0.3 * leaning.base(face));
        assert_eq!(wake().corners(face, Side::Port)[2].y, 0.0);
        near(starboard[2].x, -0.35 * leaning.base(face));
    }
}

/// Area of a triangle as it is seen along `view`, a unit vector.
fn seen(corners: [DVec3; 3], view: DVec3) -> f64 {
    ((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(view) / 2.0).abs()
}

#[test]
fn an_upright_wake_vanishes_from_above_and_a_leaning_one_does_not() {
    let from = |degrees: f64| {
        let (sin, cos) = libm::sincos(radians(degrees));
        DVec3::new(0.0, cos, sin)
    };
    let leaning = BowWake { lean: 0.3, ..wake() };
    for face in 0..BOW_FACES {
        let area = |wake: BowWake, degrees| seen(wake.corners(face, Side::Starboard), from(degrees));
        assert!(area(wake(), 89.0) < 0.02 * area(wake(), 0.0), "{face}");
        let side = leaning.lean * leaning.base(face) / leaning.crest(face);
        near(area(leaning, 90.0) / area(leaning, 0.0), side);
    }
}

#[test]
fn wakes_that_cannot_be() {
    let refused = |wake: BowWake| wake.group("bow", Side::Port, 2, 2).is_err();
    assert!(refused(BowWake { height: 0.0, ..wake() }) && refused(BowWake { length: -1.0, ..wake() }));
    assert!(refused(BowWake { lean: -0.1, ..wake() }) && refused(BowWake { foam: [1.1; 3], ..wake() }));
    assert!(wake().group("bow", Side::Port, 2, 0).is_err());
}

#[test]
fn a_pattern_takes_over_from_above() {
    let found = [-5.0, 20.0, 30.0, 40.0, 90.0].map(|elevation| blend(radians(elevation)));
    for (found, expected) in found.into_iter().zip([0.0, 0.0, 0.5, 1.0, 1.0]) {
        near(found, expected);
    }
}
