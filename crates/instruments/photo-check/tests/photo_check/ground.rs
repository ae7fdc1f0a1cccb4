//! Posts in the axes of a photograph; places that do not go with it.

use glam::DVec3;
use photo_camera::voids::Wishes;
use photo_camera::{Ellipsoid, Geodetic};
use photo_check::{Ground, GroundError, fill_voids};
use photograph::MapUnit;
use quantities::radians;
use survey::{Affine, Elevation, Frame, Method, Projection};

use crate::{elevation, from_above, from_the_south, ground, map, over_the_moon, picture};

fn degrees_at(latitude: f64, longitude: f64, height: f64) -> DVec3 {
    let [latitude, longitude] = [latitude, longitude].map(radians);
    Ellipsoid::MOON.point(Geodetic { latitude, longitude, height })
}

/// A grid in degrees of 0.001 around a place, all posts 30 m high.
fn geographic(latitude: f64, longitude: f64) -> Elevation {
    let first = [latitude, longitude].map(radians);
    let affine = Affine { first, step: [radians(-0.001), radians(0.001)] };
    Elevation::new(3, 4, vec![30.0; 12], affine, Frame::Geographic { radius: Ellipsoid::MOON.semi_major() })
}

#[test]
fn posts_of_a_plane_stand_east_north_up() {
    for made in [elevation([4, 3], |n, e| n + 0.1 * e), from_the_south([4, 3], |n, e| n + 0.1 * e)] {
        let ground = ground(&made, &from_above());
        let points: Vec<_> = ground.points().collect();
        assert_eq!(points.len(), 12);
        for point in points {
            assert!((point.z - (point.y + 0.1 * point.x)).abs() < 1e-12, "{point}");
        }
        // Between the posts a plane stays a plane.
        let at = ground.post_at([17.0, 4.0]);
        assert!((ground.height_between(at).expect("inside") - 17.4).abs() < 1e-12);
        assert_eq!(ground.height_between(ground.post_at([30.1, 4.0])), None);
    }
}

#[test]
fn posts_in_degrees_stand_on_the_body() {
    let ground = ground(&geographic(0.05, 0.02), &over_the_moon());
    let found = ground.point([1.0, 2.0], 30.0).expect("a point");
    assert!((found - degrees_at(0.049, 0.022, 30.0)).length() < 1e-6, "{found}");
    let [north, east] = ground.steps(0.0);
    let metre = radians(0.001) * Ellipsoid::MOON.semi_major();
    assert!((north + metre).abs() < 1e-9 && (east - metre * libm::cos(radians(0.05))).abs() < 1e-9);
    assert_eq!(ground.true_north(), 0.0);
    assert!(ground.doubts(over_the_moon().placement()).is_empty());
}

#[test]
fn posts_in_a_projection_stand_on_the_body() {
    let radius = Ellipsoid::MOON.semi_major();
    let projection = Projection {
        method: Method::Orthographic,
        latitude: 0.1,
        longitude: 0.2,
        radius,
        offset: [50.0, -70.0],
    };
    let [north, east] = projection.forward(0.101, 0.2005).expect("shown");
    let affine = Affine { first: [north, east], step: [-5.0, 5.0] };
    let made = Elevation::new(2, 2, vec![12.0; 4], affine, Frame::Plane(Some(projection)));
    let ground = ground(&made, &over_the_moon());
    let expected = Ellipsoid::MOON.point(Geodetic { latitude: 0.101, longitude: 0.2005, height: 12.0 });
    let found = ground.point([0.0, 0.0], 12.0).expect("a point");
    assert!((found - expected).length() < 1e-6, "{found}, not {expected}");
    let back = ground.coordinates_of([0.101, 0.2005]).expect("shown");
    assert!((back[0] - north).abs() < 1e-6 && (back[1] - east).abs() < 1e-6);
    assert!(ground.true_north() != 0.0);
}

/// A grid that crosses 180 degrees has its posts on both sides of it.
#[test]
fn a_grid_across_180_degrees_is_one_grid() {
    let ground = ground(&geographic(0.0, 179.999), &over_the_moon());
    for longitude in [-179.999, 180.001] {
        let at = ground.post_at([0.0, longitude].map(radians));
        assert!((at[1] - 2.0).abs() < 1e-6, "{longitude}: {at:?}");
    }
    let before = ground.post_at([0.0, 179.9985].map(radians));
    assert!((before[1] + 0.5).abs() < 1e-6, "{before:?}");
}

#[test]
fn a_sphere_of_another_size_is_told() {
    let mut made = geographic(0.0, 0.0);
    made.frame = Frame::Geographic { radius: 1_738_000.0 };
    let told = ground(&made, &over_the_moon()).doubts(over_the_moon().placement());
    assert!(told.len() == 1 && told[0].contains("1738000 m") && told[0].contains("1737400 m"), "{told:?}");
}

/// The cameras stand 1000 m above the landscape's zero and 10 km above the Moon.
#[test]
fn a_camera_in_the_ground_is_told() {
    for (height, below) in [(999.0, None), (1001.5, Some("1.5 m under the ground"))] {
        let ground = ground(&elevation([21, 21], |_, _| height), &from_above());
        let told = ground.doubts(from_above().placement());
        assert_eq!(told.len(), usize::from(below.is_some()));
        assert!(told.iter().all(|told| told.contains(below.unwrap_or_default())), "{told:?}");
    }
    let affine = Affine { first: [0.001, -0.001], step: [-0.001, 0.001] };
    let frame = Frame::Geographic { radius: Ellipsoid::MOON.semi_major() };
    let high = ground(&Elevation::new(3, 3, vec![10_002.0; 9], affine, frame), &over_the_moon());
    let told = high.doubts(over_the_moon().placement());
    assert!(told.len() == 1 && told[0].contains("2.0 m under the ground"), "{told:?}");
    assert!(high.doubts(map(picture([3, 3], |_, _| 0), MapUnit::Metre).placement()).is_empty());
}

#[test]
fn places_that_do_not_go_with_the_photograph_are_refused() {
    let (plane, degrees) = (elevation([3, 3], |_, _| 0.0), geographic(0.0, 0.0));
    let metres = map(picture([3, 3], |_, _| 0), MapUnit::Metre);
    let in_degrees = map(picture([3, 3], |_, _| 0), MapUnit::Degree);
    for (made, photo, told) in [
        (&degrees, from_above(), "a camera in the axes of a landscape needs them in metres of a plane"),
        (&plane, over_the_moon(), "in metres of an unknown map"),
        (&degrees, metres, "a map in metres needs them in metres"),
        (&plane, in_degrees, "a map in degrees needs them in degrees"),
    ] {
        let filling = fill_voids(made, Wishes::default()).expect("a grid");
        let error = Ground::new(made, filling, &photo).expect_err(told);
        assert!(matches!(error, GroundError::Axes { .. }) && error.to_string().contains(told), "{error}");
    }
    let small = elevation([1, 5], |_, _| 0.0);
    let error = fill_voids(&small, Wishes::default()).expect_err("small");
    assert_eq!(error, GroundError::Small { lines: 1, columns: 5 });
}
