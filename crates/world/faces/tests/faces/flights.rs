//! Dust in ballistic flight, plumes and rooster tails (check values 8.5, acceptance test 12).

use faces::{Flight, Half, MOON, Plume};
use glam::DVec3;
use proptest::prelude::*;
use quantities::radians;

use crate::near;

fn flight(speed: f64, degrees: f64) -> Flight {
    Flight::new(speed, radians(degrees), MOON).expect("a flight")
}

#[test]
fn apex_range_and_time() {
    let first = flight(3.0, 60.0);
    near(first.apex(), 2.0833333333333335);
    near(first.range(), 4.811252243247);
    near(first.time(), 3.207501495498);
    near(flight(2.0, 45.0).apex(), 0.617283950617);
    near(flight(2.0, 45.0).range(), 2.469135802469);
    for (face, time, [x, z]) in [
        (0, 0.057276812420, [0.085915218629, 0.146152210884]),
        (14, 1.661027560169, [2.491541340253, 2.080676020408]),
    ] {
        near(first.time_of(face, 28), time);
        let found = first.at(first.time_of(face, 28));
        near(found[0], x);
        near(found[1], z);
    }
    near(first.envelope(1.5), 2.575277777777778);
}

#[test]
fn no_flight_leaves_the_envelope_and_some_touch_it() {
    let mut nearest = f64::INFINITY;
    for degrees in 1..=90 {
        let flight = flight(3.0, f64::from(degrees));
        for part in 0..=100 {
            let [x, z] = flight.at(flight.time() * f64::from(part) / 100.0);
            let room = flight.envelope(x) - z;
            assert!(room > -1e-12, "{degrees} deg: {room}");
            nearest = nearest.min(room);
        }
    }
    assert!(nearest < 1e-3, "{nearest}");
}

fn plume() -> Plume {
    Plume {
        flight: flight(3.0, 60.0),
        spread: radians(8.0),
        azimuth: radians(180.0),
        faces: 28,
        colour: [0.5; 3],
    }
}

#[test]
fn a_rooster_tail_stays_inside_its_envelope_for_a_drive_of_30_s() {
    let tails: Vec<_> = (0..4).map(|copy| plume().group("tail", 4, 2, (copy, 4)).expect("a tail")).collect();
    let (mut highest, mut shown) = (0.0_f64, 0);
    for frame in 0..900 {
        for tail in &tails {
            let faces = tail.shown(frame, |_| 0.0);
            assert_eq!(faces.len(), 1, "one face of each copy, frame {frame}");
            for place in tail.mesh.places(&tail.mesh.faces()[faces[0]]) {
                assert!(place.z >= 0.0 && place.x <= 1e-12, "{place}");
                let room = plume().flight.envelope(place.x) - place.z;
                assert!(room > -1e-9, "frame {frame}: {room}");
                highest = highest.max(place.z);
                shown += 1;
            }
        }
    }
    assert!(highest > 2.0 && shown >= 4 * 900 * 3, "{highest} {shown}");
}

#[test]
fn staggered_tails_never_start_together() {
    let tails: Vec<_> = (0..4).map(|copy| plume().group("tail", 4, 2, (copy, 4)).expect("a tail")).collect();
    let jumps = |tail: &faces::Group, frame| tail.shown(frame, |_| 0.0) == [0] && frame % 2 == 0;
    for frame in 0..112 {
        assert!(tails.iter().filter(|tail| jumps(tail, frame)).count() <= 1, "frame {frame}");
    }
}

#[test]
fn figures_of_flights_and_plumes_out_of_range() {
    for (speed, angle, gravity) in
        [(0.0, 1.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.6, 1.0), (1.0, 1.0, 0.0), (f64::NAN, 1.0, 1.0)]
    {
        assert!(Flight::new(speed, angle, gravity).is_err(), "{speed} {angle} {gravity}");
    }
    let refused = |plume: Plume| plume.group("tail", 4, 2, (0, 4)).is_err();
    assert!(refused(Plume { spread: 0.0, ..plume() }) && refused(Plume { azimuth: f64::NAN, ..plume() }));
    assert!(refused(Plume { faces: 0, ..plume() }) && refused(Plume { colour: [2.0; 3], ..plume() }));
    assert!(plume().group("tail", 4, 0, (0, 4)).is_err());
}

#[test]
fn outlines_are_cut_at_a_plane() {
    let square = [[0.0, -1.0], [1.0, -1.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, z]| DVec3::new(x, 0.0, z));
    let cut = Half::above(0.0).clip(&square);
    let expected = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]].map(|[x, z]| DVec3::new(x, 0.0, z));
    let mut found = cut.clone();
    found.rotate_left(1);
    assert!(cut == expected || found == expected, "{cut:?}");
    assert_eq!(Half::above(2.0).clip(&square), []);
    assert_eq!(Half::above(-1.0).clip(&square), square);
    assert_eq!(Half::above(0.0).clip(&[]), []);
}

proptest! {
    /// Both halves of a cut square make the square.
    #[test]
    fn areas_of_both_sides_make_the_whole(angle in 0.0..6.2_f64, offset in -0.6..0.6_f64) {
        let (sin, cos) = libm::sincos(angle);
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let area = |outline: &[DVec3]| -> f64 {
            let next = outline.iter().cycle().skip(1);
            outline.iter().zip(next).map(|(a, b)| a.cross(*b).z / 2.0).sum()
        };
        let half = Half { normal: DVec3::new(cos, sin, 0.0), offset };
        let other = Half { normal: -half.normal, offset: -offset };
        let whole = area(&half.clip(&square)) + area(&other.clip(&square));
        prop_assert!((whole - 4.0).abs() < 1e-12, "{}", whole);
    }
}
