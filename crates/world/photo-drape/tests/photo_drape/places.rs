//! Which photograph shows a place, and its light there.

use glam::DVec3;
use landscape::{Bank, FileCoordinates, MapFrame};
use photo_camera::Light;
use photo_drape::{Choice, Footprint};
use photograph::{Map, MapUnit, Photograph, Placement};

use crate::{camera, drape, from_above, hill, picture, plane};

/// A footprint so small that light is that of a place.
fn small() -> Footprint {
    Footprint::square(DVec3::Z, 1e-3)
}

#[test]
fn a_ramp_comes_back_at_its_place() {
    let [north, east] = [0.1, -0.05];
    let drape = drape(
        plane([north, east]),
        vec![from_above(500.0, |column, _| column as f64 / 400.0, None)],
        10.0,
        Choice::Best,
    )
    .unwrap();
    for place in [[150.0, 180.0], [201.0, 199.0], [260.0, 143.0]] {
        let up = north * place[0] + east * place[1];
        let shown = drape.at(DVec3::new(place[0], place[1], up), &small()).unwrap();
        // A pixel is a thousandth of a radian, and the middle of the picture is column 200.
        let column = 200.0 + 1000.0 * (place[1] - 200.0) / (500.0 - up);
        let line = 200.0 - 1000.0 * (place[0] - 200.0) / (500.0 - up);
        assert!((shown.pixel[0] - column).abs() < 1e-9 && (shown.pixel[1] - line).abs() < 1e-9);
        assert!((shown.light - (column - 0.5) / 400.0).abs() < 1e-4, "{place:?}: {}", shown.light);
        // On ground that leans, fewer pixels see a square metre: the area of the map's square over that of the ground's.
        let normal = DVec3::new(-north, -east, 1.0).normalize();
        let on_ground = Footprint::square(normal, 1e-3);
        let found = drape.at(DVec3::new(place[0], place[1], up), &on_ground).unwrap().weight;
        let way = DVec3::new(200.0, 200.0, 500.0) - DVec3::new(place[0], place[1], up);
        let depth = way.z;
        let closed = normal.dot(way) / depth * (1e6 / (depth * depth));
        assert!((found / closed - 1.0).abs() < 1e-4, "{found} {closed}");
    }
    assert!(drape.at(DVec3::new(5.0, 5.0, 0.0), &small()).is_none(), "beside the picture");
}

#[test]
fn nothing_is_painted_through_a_hill() {
    let south = camera(DVec3::new(-100.0, 200.0, 300.0), DVec3::new(300.0, 0.0, -300.0), [2000; 2]);
    let north = camera(DVec3::new(500.0, 200.0, 300.0), DVec3::new(-300.0, 0.0, -300.0), [2000; 2]);
    let photo = |placement, light: f64| {
        Photograph::new(picture([2000; 2], |_, _| light), placement, Light::default()).unwrap()
    };
    let one = drape(hill(), vec![photo(south, 0.25)], 4.0, Choice::Best).unwrap();
    let behind = one.ground().post([60, 50]);
    assert_eq!((behind.x, behind.y), (240.0, 200.0));
    assert!(one.at(behind, &small()).is_none(), "behind the hill");
    let before = one.ground().post([40, 50]);
    let light = |shown: photo_drape::Shown| shown.light;
    assert!((one.at(before, &small()).map(light).unwrap() - 0.25).abs() < 1e-4);
    let unseen = one.lights().unwrap();
    assert!(unseen[60 * 101 + 50].is_finite(), "enclosed ground is inferred");

    let both = drape(hill(), vec![photo(south, 0.25), photo(north, 0.75)], 4.0, Choice::Best).unwrap();
    let shown = both.at(behind, &small()).unwrap();
    assert_eq!((shown.photograph, shown.seen_by), (1, 1));
    assert!((shown.light - 0.75).abs() < 1e-4);
    let count = |drape: &photo_drape::Drape| {
        let posts = (0..101).flat_map(|row| (0..101).map(move |column| [row, column]));
        posts.filter(|post| drape.at(drape.ground().post(*post), &small()).is_none()).count()
    };
    let (of_one, of_both) = (count(&one), count(&both));
    assert!(of_both * 5 < of_one && of_one > 200, "{of_one} posts unseen by one, {of_both} by both");
}

#[test]
fn weights_are_pixels_on_a_square_metre() {
    let photos = vec![from_above(500.0, |_, _| 0.2, None), from_above(1000.0, |_, _| 0.6, None)];
    let place = DVec3::new(200.0, 200.0, 0.0);
    let best = drape(plane([0.0; 2]), photos.clone(), 10.0, Choice::Best).unwrap();
    let shown = best.at(place, &small()).unwrap();
    assert_eq!((shown.photograph, shown.seen_by), (0, 2));
    assert!((shown.light - 0.2).abs() < 1e-4 && (shown.weight - 4.0).abs() < 1e-6, "{shown:?}");
    let blend = drape(plane([0.0; 2]), photos, 10.0, Choice::Blend).unwrap();
    // Twice as high, a quarter of the pixels.
    let expected = (4.0 * 0.2 + 0.6) / 5.0;
    assert!((blend.at(place, &small()).unwrap().light - expected).abs() < 1e-4);
}

#[test]
fn a_map_lies_where_the_bank_came_from() {
    let level = plane([0.0; 2]);
    let frame = MapFrame {
        projection: None,
        coordinates: FileCoordinates::Metres,
        origin: [70_000.0, -9000.0],
        first_sample: [0.0; 2],
        spacing: [1.0; 2],
    };
    let bank = Bank::new("map", level.bank().levels().to_vec(), None).unwrap().with_map(Some(frame));
    let landscape = landscape::Landscape::new(bank, 0.5);
    // One pixel a metre, its first line the northern border.
    let map = Map::new([1.0, 0.0, -9000.0], [0.0, -1.0, 70_400.0], MapUnit::Metre).unwrap();
    let ramp = picture([400; 2], |column, _| column as f64 / 400.0);
    let photo = Photograph::new(ramp, Placement::Map(map), Light::default()).unwrap();
    let drape = drape(landscape, vec![photo], 10.0, Choice::Best).unwrap();
    let shown = drape.at(DVec3::new(30.0, 110.5, 0.0), &small()).unwrap();
    assert_eq!(shown.pixel, [110.5, 370.0]);
    assert!((shown.light - 110.0 / 400.0).abs() < 1e-4, "{shown:?}");
}
