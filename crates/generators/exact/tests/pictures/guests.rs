//! Bodies that move, open surfaces, smooth light, suns of groups, priorities.

use std::num::NonZeroU16;
use std::sync::Arc;

use crate::scenes::{landscape, laws, plane, planes, pose, settings, standing_box, sun, value};
use generator::{PlaneKind, Planes};
use glam::DVec3;
use landscape::{Attitude, Sun};
use scenario::{
    Curvature, Frame, Group, GroupSun, Guest, PixelRule, Pose, Projection, Scenery, ShadowFineness, Standing,
};
use solids::Solid;

const PIXELS: [u32; 2] = [41, 31];
const MIDDLE: usize = 15 * 41 + 20;

fn usual() -> hardware_model::Settings {
    let laws = laws(Projection::Exact, Curvature::None, PixelRule::Centre);
    settings(PIXELS[0], PIXELS[1], laws, [1.0, 150.0])
}

/// From 2 m above level ground to the north, at `time`.
fn seen(scenery: Scenery, time: f64) -> Planes {
    let ground = landscape(plane(50.0, [4, 4], 0.0, [0.0; 2]), 0.5);
    planes(&ground, scenery, &usual(), &Pose { time, ..pose([50.0, 100.0, 2.0], 0.0, 0.0) })
}

fn guest(solid: Solid, frames: Vec<Frame>) -> Guest {
    let (from, until, spin) = (0.0, f64::INFINITY, 0.0);
    let solid = Arc::new(solid);
    Guest { from, until, object: 0, solid, scale: 1.0, frames, spin, priority: 0, group: None }
}

fn frame(time: f64, foot: [f64; 3]) -> Frame {
    Frame { time, foot: DVec3::from_array(foot), attitude: Attitude::default() }
}

fn cube(half: f64) -> Solid {
    Solid::boxed(DVec3::splat(-half), DVec3::splat(half), 1.0).unwrap()
}

/// 4 m x 4 m upright across the view, its front to the north.
fn sheet() -> Solid {
    let places = [[0.0, -2.0, -2.0], [0.0, 2.0, -2.0], [0.0, 2.0, 2.0], [0.0, -2.0, 2.0]];
    Solid::open(places.map(DVec3::from_array).to_vec(), vec![(vec![0, 1, 2, 3], 0.5)]).unwrap()
}

#[test]
fn a_box_that_moves_is_where_it_is_at_each_time() {
    let there = [frame(0.0, [70.0, 100.0, 2.0]), frame(10.0, [90.0, 100.0, 2.0])];
    let scenery = || Scenery::still(sun(180.0, 20.0)).with_guests(vec![guest(cube(1.0), there.to_vec())]);
    for (time, range) in [(0.0, 19.0), (2.5, 24.0), (10.0, 39.0), (99.0, 39.0)] {
        let found = seen(scenery(), time);
        assert!((value(&found, PlaneKind::Range, MIDDLE) - range).abs() < 1e-5, "{time}");
        assert_eq!(value(&found, PlaneKind::Label, MIDDLE), 4.0);
    }
}

#[test]
fn a_box_that_spins_turns_its_side() {
    let spin = quantities::radians(15.0);
    let turning = Guest { spin, ..guest(cube(1.0), vec![frame(0.0, [70.0, 100.0, 2.0])]) };
    let found = seen(Scenery::still(sun(180.0, 20.0)).with_guests(vec![turning]), 2.0);
    // 30 degrees from above clockwise: the middle ray meets the side at 1 m over the cosine before the foot.
    assert!((value(&found, PlaneKind::Range, MIDDLE) - (20.0 - 1.0 / libm::cos(2.0 * spin))).abs() < 1e-5);
    assert!((value(&found, PlaneKind::NormalNorth, MIDDLE) + libm::cos(2.0 * spin)).abs() < 1e-6);
}

#[test]
fn a_sheet_is_lit_on_the_side_that_is_seen() {
    let turned = |azimuth| {
        let still = guest(sheet(), vec![frame(0.0, [70.0, 100.0, 2.0])]);
        seen(Scenery::still(sun(azimuth, 30.0)).with_guests(vec![still]), 0.0)
    };
    for (azimuth, light) in [(180.0, 0.5 * libm::cos(quantities::radians(30.0))), (0.0, 0.0)] {
        let found = turned(azimuth);
        assert!((value(&found, PlaneKind::Intensity, MIDDLE) - light).abs() < 1e-7, "{azimuth}");
        assert_eq!(value(&found, PlaneKind::NormalNorth, MIDDLE), -1.0);
        assert!((value(&found, PlaneKind::Range, MIDDLE) - 20.0).abs() < 1e-5);
    }
}

/// A ball of 24 x 48 faces with the normals of a sphere: light is that of the sphere but for the faces' bow.
#[test]
fn smooth_light_is_that_of_a_sphere() {
    let at = |i: usize, j: usize| {
        let (polar, around) = (180.0 * i as f64 / 24.0, 360.0 * (j % 48) as f64 / 48.0);
        let ((s, c), (sin, cos)) = (
            quantities::sin_cos(quantities::radians(polar)),
            quantities::sin_cos(quantities::radians(around)),
        );
        DVec3::new(s * cos, s * sin, c)
    };
    let places: Vec<DVec3> = [DVec3::Z, -DVec3::Z]
        .into_iter()
        .chain((1..24).flat_map(|i| (0..48).map(move |j| (i, j))).map(|(i, j)| at(i, j)))
        .collect();
    let number = |i: usize, j: usize| match i {
        0 => 0,
        24 => 1,
        _ => (2 + (i - 1) * 48 + j % 48) as u32,
    };
    let face = |i: usize, j: usize| {
        let mut corners = vec![number(i, j), number(i, j + 1), number(i + 1, j + 1), number(i + 1, j)];
        corners.dedup();
        (corners, 1.0)
    };
    let faces = (0..24).flat_map(|i| (0..48).map(move |j| (i, j))).map(|(i, j)| face(i, j)).collect();
    let ball = Solid::new(places.clone(), faces).unwrap();
    let ball = ball.with_normals(|_, corner| Some(places[corner as usize]));
    let centre = [60.0, 100.0, 2.0];
    let light = sun(200.0, 35.0);
    let body = guest(ball, vec![frame(0.0, centre)]);
    let found = seen(Scenery::still(light).with_guests(vec![body]), 0.0);
    let mut lit = 0;
    for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
        if value(&found, PlaneKind::Label, index) != 4.0 {
            continue;
        }
        let normal = [PlaneKind::NormalNorth, PlaneKind::NormalEast, PlaneKind::NormalUp]
            .map(|kind| value(&found, kind, index));
        let length: f64 = normal.iter().map(|n| n * n).sum();
        assert!((length - 1.0).abs() < 1e-6);
        // The place that is seen, as a direction from the centre: the sphere's normal.
        let ray = crate::scenes::ray(&usual(), &pose([50.0, 100.0, 2.0], 0.0, 0.0), index);
        let range = value(&found, PlaneKind::Range, index);
        let from = DVec3::new(range * ray.direction[0] - 10.0, range * ray.direction[1], range * ray.rise);
        let expected = from.normalize().dot(DVec3::from_array(light.direction())).max(0.0);
        assert!((value(&found, PlaneKind::Intensity, index) - expected).abs() < 3e-3, "{index}");
        lit += usize::from(expected > 0.1);
    }
    assert!(lit > 20, "{lit}");
}

#[test]
fn a_group_has_its_own_sun_and_no_shadow() {
    let group = NonZeroU16::new(1);
    let own = GroupSun { first: sun(90.0, 0.0), rate: quantities::radians(9.0) };
    let groups = || vec![Group { name: "g".into(), sun: Some(own) }];
    let drawn = |group, time| {
        let mut one = standing_box(0, [70.0, 100.0, 0.0], 1.0, 4.0);
        one.body.group = group;
        let scenery = Scenery::still(sun(0.0, 20.0)).with_bodies(vec![one]).with_groups(groups());
        let settings = hardware_model::Settings { shadows: Some(ShadowFineness::default()), ..usual() };
        let ground = landscape(plane(50.0, [4, 4], 0.0, [0.0; 2]), 0.5);
        planes(&ground, scenery, &settings, &Pose { time, ..pose([50.0, 100.0, 2.0], 0.0, 0.0) })
    };
    // The scene's sun stands behind the box, its own at 180 degrees after 10 s.
    let light = |group, time| value(&drawn(group, time), PlaneKind::Intensity, MIDDLE);
    assert_eq!((light(None, 10.0), light(group, 0.0)), (0.0, light(group, 0.0)));
    assert!(light(group, 0.0).abs() < 1e-7);
    assert!((light(group, 10.0) - 1.0).abs() < 1e-7);
    let dark = |group| {
        let shadow = drawn(group, 10.0);
        (0..(PIXELS[0] * PIXELS[1]) as usize).filter(|&k| value(&shadow, PlaneKind::Shadow, k) == 2.0).count()
    };
    assert!(dark(None) > 5 && dark(group) == 0, "{} {}", dark(None), dark(group));
}

#[test]
fn of_two_things_that_coincide_the_higher_priority_is_seen() {
    let light: Sun = sun(180.0, 30.0);
    let boxed = |priority, albedo: f64| {
        let mut standing: Standing = standing_box(0, [70.0, 100.0, 0.0], 1.0, 4.0);
        standing.body.solid = Arc::new(Solid::clone(&standing.body.solid).painted(|_| albedo).unwrap());
        standing.body.priority = priority;
        standing
    };
    let seen_of = |first, second| {
        let bodies = vec![boxed(first, 1.0), boxed(second, 0.5)];
        value(&seen(Scenery::still(light).with_bodies(bodies), 0.0), PlaneKind::Intensity, MIDDLE)
    };
    let bright = libm::cos(quantities::radians(30.0));
    for (first, second, expected) in
        [(0, 0, bright), (0, 1, 0.5 * bright), (-1, 0, 0.5 * bright), (3, 2, bright)]
    {
        assert!((seen_of(first, second) - expected).abs() < 1e-7, "{first} {second}");
    }
}
