//! Footprint and ground sample in closed form; the pixel of a ground point; maps.

use glam::DVec3;
use photo_camera::{Ellipsoid, Light};
use photograph::{Map, MapUnit, Photograph, Placement};
use picture::Depth;

use crate::{from_above, over_the_moon, picture};

fn near(found: DVec3, expected: DVec3, within: f64) {
    assert!((found - expected).length() < within, "{found}, not {expected}");
}

#[test]
fn from_above_a_picture_is_a_scaled_ground() {
    let photo = from_above(picture(40, 30, Depth::Eight, |_, _| 9), Light::default());
    let corners = photo.footprint(0.0).map(|corner| corner.expect("ground"));
    let expected = [[-40.0, 30.0], [40.0, 30.0], [40.0, -30.0], [-40.0, -30.0]];
    for (found, [east, north]) in corners.into_iter().zip(expected) {
        near(found, DVec3::new(east, north, 0.0), 1e-9);
    }
    // At a height of 500 m the ground is half as far away.
    let sample = photo.placement().ground_sample(DVec3::new(3.0, -4.0, 500.0)).expect("in front");
    assert!((sample[0] - 1.0).abs() < 1e-9 && (sample[1] - 1.0).abs() < 1e-9, "{sample:?}");
    let pixel = photo.pixel(DVec3::new(10.0, 20.0, 0.0)).expect("in front");
    assert!((pixel[0] - 25.0).abs() < 1e-9 && (pixel[1] - 5.0).abs() < 1e-9, "{pixel:?}");
    assert_eq!(photo.pixel(DVec3::new(0.0, 0.0, 1001.0)), None);
    assert!(photo.footprint(1001.0).iter().all(Option::is_none));
}

#[test]
fn every_ground_point_of_a_pixel_has_that_pixel() {
    for placement in
        [over_the_moon(), *from_above(picture(4, 3, Depth::Eight, |_, _| 0), Light::default()).placement()]
    {
        for pixel in [[0.5, 0.5], [3.0, 2.5], [1.2, 0.1]] {
            for height in [-80.0, 0.0, 120.0] {
                let point = placement.on_level(pixel, height).expect("ground");
                let back = placement.pixel(point).expect("in front");
                assert!((back[0] - pixel[0]).abs() < 1e-7 && (back[1] - pixel[1]).abs() < 1e-7, "{back:?}");
            }
        }
    }
}

#[test]
fn a_photograph_of_a_body_follows_its_surface() {
    let placement = over_the_moon();
    let middle = placement.on_level([250.0, 250.0], 0.0).expect("the Moon");
    near(middle, DVec3::new(Ellipsoid::MOON.semi_major(), 0.0, 0.0), 1e-6);
    // 20 micrometres at 0.2 m from 10 km: 1 m.
    let sample = placement.ground_sample(middle).expect("the Moon");
    assert!((sample[0] - 1.0).abs() < 1e-6 && (sample[1] - 1.0).abs() < 1e-6, "{sample:?}");
    // 5 km higher the ground is half as far away.
    let high = placement.on_level([250.0, 250.0], 5000.0).expect("the Moon");
    let sample = placement.ground_sample(high).expect("the Moon");
    assert!((sample[0] - 0.5).abs() < 1e-6 && (sample[1] - 0.5).abs() < 1e-6, "{sample:?}");
    let place = Ellipsoid::MOON.place(placement.on_level([400.0, 100.0], 55.0).expect("the Moon"));
    assert!((place.height - 55.0).abs() < 1e-6 && place.latitude > 0.0 && place.longitude > 0.0);
    // 400 000 pixels to the side the ray passes the Moon.
    assert_eq!(placement.on_level([400_000.0, 250.0], 0.0), None);
}

#[test]
fn a_map_has_no_perspective_and_no_height() {
    let map = Map::new([2.0, 0.0, 100.0], [0.0, -3.0, 500.0], MapUnit::Metre).expect("a map");
    let placement = Placement::Map(map);
    for height in [0.0, 4000.0] {
        assert_eq!(placement.pixel(DVec3::new(110.0, 470.0, height)), Some([5.0, 10.0]));
    }
    assert_eq!(placement.on_level([5.0, 10.0], 7.0), Some(DVec3::new(110.0, 470.0, 7.0)));
    assert_eq!(placement.ground_sample(DVec3::new(110.0, 470.0, 0.0)), Some([2.0, 3.0]));
    let picture = picture(20, 20, Depth::Sixteen, |column, _| 1000 * column as u16);
    let photo = Photograph::new(picture, placement, Light::default()).expect("a photograph");
    let found = photo.light_at(DVec3::new(111.0, 470.0, 0.0)).expect("inside");
    assert!((65_535.0 * found - 5000.0).abs() < 1e-2, "{found}");
    assert_eq!(photo.light_at(DVec3::new(99.0, 470.0, 0.0)), None);
}

/// A map that crosses 180 degrees has the pixels of its eastern part.
#[test]
fn longitudes_are_compared_modulo_a_turn() {
    let map = Map::new([0.5, 0.0, 179.0], [0.0, -0.5, 10.0], MapUnit::Degree).expect("a map");
    for longitude in [-178.0, 182.0, 542.0] {
        let pixel = map.pixel(DVec3::new(longitude, 9.0, 0.0));
        assert!((pixel[0] - 6.0).abs() < 1e-9 && (pixel[1] - 2.0).abs() < 1e-9, "{longitude}: {pixel:?}");
    }
}
