//! The body: check values of the specification (7.1), and the inverse of every place.

use glam::DVec3;
use photo_camera::{Ellipsoid, Geodetic};

use crate::{Random, ground, place};

fn assert_near(found: DVec3, expected: [f64; 3], within: f64) {
    let miss = (found - DVec3::from(expected)).length();
    assert!(miss < within, "{found} misses {expected:?} by {miss} m");
}

#[test]
fn georectangular_points_are_those_of_the_specification() {
    let first = |height| ground("37:22:47 N", "122:05:03 W", height);
    assert_near(first(0.0), [-2_695_471.040100543, -4_299_587.995183843, 3_850_771.763335468], 1e-8);
    assert_near(first(10.0), [-2_695_475.260890211, -4_299_594.727831428, 3_850_777.834281941], 1e-8);
    let last = ground("37:26:17 N", "122:01:04 W", 0.0);
    assert_near(last, [-2_688_402.099774487, -4_299_373.681753062, 3_855_914.190822236], 1e-8);
    let observer = ground("37:22:30 N", "122:01:59 W", 110.0);
    assert_near(observer, [-2_691_849.605_098_79, -4_302_334.613_283_52, 3_850_422.071_895_488], 1e-8);
    let hadley = Ellipsoid::MOON.point(place("26.13222", "3.63386", -1929.0));
    assert_near(hadley, [1_554_938.632258343, 98_751.038104551, 764_377.965554233], 1e-8);
}

#[test]
fn the_prime_vertical_is_that_of_the_specification() {
    let latitude = place("37:22:47 N", "0", 0.0).latitude;
    assert!((Ellipsoid::CLARKE_1866.prime_vertical(latitude) - 6_386_177.118154326).abs() < 1e-8);
}

#[test]
fn the_perspective_centre_decodes_to_the_place_of_the_specification() {
    let found = Ellipsoid::CLARKE_1866.place(DVec3::new(-2_693_765.9, -4_304_520.4, 3_859_018.3));
    assert!((found.latitude.to_degrees() - 37.420803032314).abs() < 1e-12);
    assert!((found.longitude.to_degrees() + 122.038304152808).abs() < 1e-12);
    assert!((found.height - 7610.467953701).abs() < 2e-8, "{}", found.height);
}

#[test]
fn every_place_comes_back_from_its_point_within_a_few_roundings() {
    let mut random = Random(2);
    for body in [Ellipsoid::CLARKE_1866, Ellipsoid::MOON] {
        for case in 0..3000 {
            let latitude =
                if case % 10 == 0 { 90.0 - random.unit() * 1e-3 } else { random.between(-90.0, 90.0) };
            let longitude = random.between(-180.0, 180.0).to_radians();
            let height = random.between(-20_000.0, 2e6);
            let there = Geodetic { latitude: latitude.to_radians(), longitude, height };
            let point = body.point(there);
            let back = body.point(body.place(point));
            // One unit in the last place of 8e6 m is 9.3e-10 m.
            assert!((back - point).length() < 4e-9, "{there:?}: {}", (back - point).length());
            assert!((body.place(point).height - height).abs() < 5e-9);
        }
    }
}

#[test]
fn poles_are_places() {
    for sign in [-1.0, 1.0] {
        let polar = 6_356_583.8 + 1000.0;
        let found = Ellipsoid::CLARKE_1866.place(DVec3::new(0.0, 0.0, sign * polar));
        assert!((found.latitude - sign * std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        // The rounded e^2 moves the pole by less than 0.01 m.
        assert!((found.height - 1000.0).abs() < 0.01, "{}", found.height);
    }
}

#[test]
fn an_arcsecond_is_as_long_as_the_specification_says() {
    let second = (1.0_f64 / 3600.0).to_radians();
    for (body, latitude, north, east) in [
        (Ellipsoid::CLARKE_1866, 37.4_f64, 30.828509790897, 24.595947522007),
        (Ellipsoid::MOON, 26.13222, 8.423152895597, 7.562138511117),
    ] {
        let at = Geodetic { latitude: latitude.to_radians(), longitude: 0.0, height: 0.0 };
        let frame = body.frame(at);
        let along_north = frame.local(body.point(Geodetic { latitude: at.latitude + second, ..at }));
        let along_east = frame.local(body.point(Geodetic { longitude: second, ..at }));
        assert!((along_north.y - north).abs() < 1e-6, "{along_north}");
        assert!((along_east.x - east).abs() < 1e-6, "{along_east}");
    }
}

#[test]
fn local_frames_are_right_handed_and_undo_themselves() {
    let frame = Ellipsoid::CLARKE_1866.frame(place("37:22:30 N", "122:01:59 W", 110.0));
    assert!((frame.axes.determinant() - 1.0).abs() < 1e-15);
    let local = DVec3::new(120.0, -340.0, 56.0);
    assert!((frame.local(frame.point(local)) - local).length() < 4e-9);
    let up = Ellipsoid::CLARKE_1866.place(frame.point(DVec3::new(0.0, 0.0, 90.0)));
    assert!((up.height - 200.0).abs() < 4e-9);
}

#[test]
fn bodies_that_are_none_are_refused() {
    for (axis, eccentricity) in
        [(0.0, 0.0), (-1.0, 0.0), (f64::NAN, 0.0), (1.0, 0.5), (1.0, -0.1), (1.0, f64::NAN)]
    {
        assert!(Ellipsoid::new(axis, eccentricity).is_err(), "{axis} {eccentricity}");
    }
}
