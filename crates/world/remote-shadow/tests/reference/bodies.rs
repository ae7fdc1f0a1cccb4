//! Tests of the shadows that bodies cast on the ground.

use crate::common::{cratered, crossing, flat, landscape};
use glam::{DMat3, DVec3};
use landscape::{Landscape, Sun};
use quantities::{radians, sin_cos, unit_interval};
use remote_shadow::{Outlines, Resolution, ShadowBank};
use solids::{Body, Kind, Solid};
use std::sync::Arc;

fn boxed(foot: DVec3, low: f64) -> Body {
    let solid = Solid::boxed(DVec3::new(-1.0, -0.5, low), DVec3::new(1.0, 0.5, 2.0), 0.5).unwrap();
    let (sin, cos) = sin_cos(0.4);
    let turn = DMat3::from_cols(DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z);
    Body::place(0, Kind::Culture, &Arc::new(solid), foot, &turn, 1.0)
}

fn bank(ground: Landscape) -> ShadowBank {
    ShadowBank::new(Arc::new(ground), Resolution { finest: 0.5, angle: 1e-3 })
}

fn area(outline: &Outlines) -> f64 {
    outline.segments().map(|s| 0.5 * (s.from[0] * s.to[1] - s.to[0] * s.from[1])).sum()
}

/// The shadow of a box on a plane is the box swept by `height cot e`: its foot plus its width across the sun times
/// the length.
#[test]
fn a_box_on_flat_ground() {
    let ground = landscape(&flat(400.0), Vec::new());
    let body = boxed(DVec3::new(200.0, 200.0, 0.0), 0.0);
    for (azimuth, elevation) in [(0.0, 30.0), (123.0, 3.0), (287.0, 10.0)] {
        let sun = Sun { azimuth: radians(azimuth), elevation: radians(elevation) };
        let outline = bank(ground.clone()).cast_by_body(&body, &sun);
        let (sin, cos) = sin_cos(sun.azimuth);
        let across = body.vertices().map(|v| v.y * cos - v.x * sin);
        let (least, most) = across.fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p), b.max(p)));
        let length = 2.0 / (libm::tan(sun.elevation));
        let expected = 2.0 + (most - least) * length;
        assert!(
            (area(&outline) - expected).abs() < 1e-6 * expected,
            "{azimuth}: {} {expected}",
            area(&outline)
        );
        // Closed, clockwise, and the shadow of a corner of the lid is on it.
        assert!(
            outline.ends().is_empty() && outline.corners().iter().next() == outline.corners().iter().last()
        );
    }
}

#[test]
fn a_point_of_the_outline_lies_under_the_edge_of_the_body() {
    let ground = cratered(2);
    let foot = [300.0, 310.0];
    let body = boxed(DVec3::new(foot[0], foot[1], ground.height(foot[0], foot[1]).unwrap()), -0.5);
    let sun = Sun { azimuth: radians(60.0), elevation: radians(12.0) };
    let outline = bank(ground.clone()).cast_by_body(&body, &sun);
    let to_sun = DVec3::from(sun.direction());
    let mut inside = 0;
    for n in 0..4000 {
        let place = [0, 1].map(|k| foot[k as usize] - 14.0 + 28.0 * unit_interval(5, &[n, k]));
        let start = DVec3::new(place[0], place[1], ground.height(place[0], place[1]).unwrap());
        // The box from inside: six planes.
        let hit = meets(&body, start, to_sun);
        let dark = outline.segments().map(|segment| crossing(&segment, place)).sum::<i32>() > 0;
        inside += u32::from(dark);
        if hit != dark {
            let beside = (0..32).any(|k| {
                let (sin, cos) = sin_cos(radians(11.25) * f64::from(k));
                let [x, y] = [place[0] + 0.15 * cos, place[1] + 0.15 * sin];
                meets(&body, DVec3::new(x, y, ground.height(x, y).unwrap()), to_sun) != hit
            });
            assert!(beside, "{place:?}: hit = {hit}");
        }
    }
    assert!(inside > 50, "{inside}");
}

fn meets(body: &Body, start: DVec3, direction: DVec3) -> bool {
    let (mut from, mut to) = (0.0f64, f64::MAX);
    for (face, normal) in body.normals().enumerate() {
        let away = normal.dot(body.on_face(face) - start);
        let speed = normal.dot(direction);
        if speed < 0.0 {
            from = from.max(away / speed);
        } else if speed > 0.0 {
            to = to.min(away / speed);
        } else if away < 0.0 {
            return false;
        }
    }
    from < to
}

#[test]
fn what_is_buried_casts_nothing() {
    let ground = landscape(&flat(400.0), Vec::new());
    let sun = Sun { azimuth: radians(60.0), elevation: radians(12.0) };
    let deep = boxed(DVec3::new(200.0, 200.0, -2.5), -0.5);
    assert!(bank(ground.clone()).cast_by_body(&deep, &sun).is_empty());
    // Buried to half its height it casts as a box of half the height.
    let bank = bank(ground);
    let buried = bank.cast_by_body(&boxed(DVec3::new(200.0, 200.0, -1.0), -0.5), &sun);
    let (sin, cos) = sin_cos(sun.azimuth);
    let across = boxed(DVec3::ZERO, 0.0).vertices().map(|v| v.y * cos - v.x * sin).fold(0.0, f64::max);
    let expected = 2.0 + 2.0 * across / libm::tan(sun.elevation);
    assert!((area(&buried) - expected).abs() < 1e-4 * expected, "{} {expected}", area(&buried));
}
