//! Photographs that cannot be laid over ground.

use glam::DVec3;
use photo_camera::{Axes, Ellipsoid, Light};
use photo_drape::{Choice, DrapeError, Ground};
use photograph::{Map, MapUnit, Photograph, Placement};

use crate::{camera, drape, from_above, picture, plane};

fn refused(photographs: Vec<Photograph>) -> DrapeError {
    drape(plane([0.0; 2]), photographs, 20.0, Choice::Best).unwrap_err()
}

fn photo(placement: Placement) -> Photograph {
    Photograph::new(picture([40; 2], |_, _| 0.5), placement, Light::default()).unwrap()
}

#[test]
fn no_photograph_is_refused() {
    let error = refused(Vec::new());
    assert!(matches!(error, DrapeError::None) && error.to_string().contains("[[photograph]]"));
}

#[test]
fn a_photograph_of_other_ground_is_named() {
    let far = photo(camera(DVec3::new(9000.0, 0.0, 500.0), -DVec3::Z, [40; 2]));
    let error = refused(vec![from_above(500.0, |_, _| 0.5, None), far]).to_string();
    assert!(error.starts_with("photograph 2: ") && error.contains("no pixel in common"), "{error}");
}

#[test]
fn a_camera_in_the_ground_is_named() {
    let ahead = DVec3::new(1.0, 0.0, 0.4);
    let buried = camera(DVec3::new(100.0, 200.0, -50.0), ahead, [2000; 2]);
    let buried = Photograph::new(picture([2000; 2], |_, _| 0.5), buried, Light::default()).unwrap();
    let error = refused(vec![buried]);
    assert!(matches!(error, DrapeError::Camera { number: 1, .. }), "{error}");
}

#[test]
fn axes_that_the_ground_does_not_have_are_refused() {
    let map = Map::new([1e-5, 0.0, 3.0], [0.0, -1e-5, 26.0], MapUnit::Degree).unwrap();
    let error = refused(vec![photo(Placement::Map(map))]).to_string();
    assert!(error.contains("a map in degrees") && error.contains("photograph 1"), "{error}");
    let Placement::Camera { camera, .. } = camera(DVec3::Z * 1e6, -DVec3::Z, [40; 2]) else { panic!() };
    let body = Placement::Camera { camera, axes: Axes::Body(Ellipsoid::CLARKE_1866) };
    assert!(refused(vec![photo(body)]).to_string().contains("axes of a body"));
}

#[test]
fn posts_and_suns_that_are_missing_are_refused() {
    let landscape = plane([0.0; 2]);
    for (spacing, area) in [(500.0, [0.0, 0.0, 400.0, 400.0]), (1e-3, [0.0, 0.0, 400.0, 400.0])] {
        let error = Ground::new(&landscape, area, spacing).unwrap_err();
        assert!(matches!(error, DrapeError::Posts { .. }), "{error}");
    }
    let hole = Ground::new(&landscape, [0.0, 0.0, 500.0, 400.0], 10.0).unwrap_err();
    assert!(matches!(hole, DrapeError::Hole { .. }), "{hole}");
    let sunless = drape(landscape, vec![from_above(500.0, |_, _| 0.5, None)], 20.0, Choice::Best).unwrap();
    assert!(matches!(sunless.albedo(), Err(DrapeError::NoSun { number: 1 })));
}
