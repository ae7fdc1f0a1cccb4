//! Bodies that move, open surfaces, smooth light, suns of groups, priorities, colours of bodies.

use std::num::NonZeroU16;
use std::sync::Arc;

use crate::scenes::{landscape, laws, place, plane, planes, pose, settings, standing_box, sun, value};
use generator::{Label, PlaneKind, Planes, Shade};
use glam::DVec3;
use hardware_model::Settings;
use landscape::{Attitude, Sun};
use scenario::{
    Curvature, Frame, Group, GroupSun, Guest, Laws, PixelRule, Pose, Projection, Scenery, ShadowFineness,
    ShadowedBodies, Standing,
};
use solids::Solid;

const PIXELS: [u32; 2] = [41, 31];
const MIDDLE: usize = 15 * 41 + 20;

fn usual() -> Settings {
    let laws = laws(Projection::Exact, Curvature::None, PixelRule::Centre);
    settings(PIXELS[0], PIXELS[1], laws, [1.0, 150.0])
}

/// The same with remote shadow.
fn shadowed() -> Settings {
    Settings { shadows: Some(ShadowFineness::default()), ..usual() }
}

/// From 2 m above level ground to the north, at `time`.
fn seen(scenery: Scenery, time: f64) -> Planes {
    seen_from(scenery, Pose { time, ..pose([50.0, 100.0, 2.0], 0.0, 0.0) }, &usual())
}

fn seen_from(scenery: Scenery, pose: Pose, settings: &Settings) -> Planes {
    planes(&landscape(plane(50.0, [4, 4], 0.0, [0.0; 2]), 0.5), scenery, settings, &pose)
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

/// 2 m high and wide: under a sun 30 degrees high in the south its shadow goes 2 / tan 30 to the north of where it is.
#[test]
fn the_shadow_of_a_box_goes_with_it() {
    let block = || Solid::boxed(DVec3::new(-1.0, -1.0, 0.0), DVec3::new(1.0, 1.0, 2.0), 1.0).unwrap();
    let there = || vec![frame(0.0, [60.0, 100.0, 0.0]), frame(8.0, [68.0, 108.0, 0.0])];
    let length = 2.0 * 3.0_f64.sqrt();
    for time in [0.0, 3.0, 8.0] {
        let scenery = Scenery::still(sun(180.0, 30.0)).with_guests(vec![guest(block(), there())]);
        let pose = Pose { time, ..pose([55.0, 85.0, 12.0], -25.0, 60.0) };
        let found = seen_from(scenery, pose, &shadowed());
        let mut counts = [0; 2];
        for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
            if value(&found, PlaneKind::Label, index) != f64::from(Label::Terrain.code()) {
                continue;
            }
            let [x, y] = place(&shadowed(), &pose, index, value(&found, PlaneKind::Range, index));
            let (north, east) = (x - 60.0 - time, y - 100.0 - time);
            let depth = (north - 1.0).min(1.0 + length - north).min(1.0 - east.abs());
            let expected = if depth > 0.0 { Shade::Remote } else { Shade::Lit };
            let shade = value(&found, PlaneKind::Shadow, index);
            assert!(depth.abs() < 1e-5 || shade == f64::from(expected.code()), "{time}: {x} {y}: {shade}");
            counts[usize::from(depth > 0.0)] += 1;
        }
        assert!(counts[0] > 300 && counts[1] > 5, "{counts:?}");
    }
}

#[test]
fn a_sheet_is_seen_from_both_sides_and_lit_on_the_one_to_the_sun() {
    let [from_south, from_north] = [([50.0, 100.0, 2.0], 0.0, -1.0), ([90.0, 100.0, 2.0], 180.0, 1.0)];
    let lit = 0.5 * libm::cos(quantities::radians(30.0));
    for (eye, heading, normal) in [from_south, from_north] {
        for (azimuth, side) in [(180.0, -1.0), (0.0, 1.0)] {
            let still = guest(sheet(), vec![frame(0.0, [70.0, 100.0, 2.0])]);
            let scenery = Scenery::still(sun(azimuth, 30.0)).with_guests(vec![still]);
            let found = seen_from(scenery, pose(eye, 0.0, heading), &usual());
            let light = if side == normal { lit } else { 0.0 };
            assert!(
                (value(&found, PlaneKind::Intensity, MIDDLE) - light).abs() < 1e-7,
                "{heading} {azimuth}"
            );
            assert_eq!(value(&found, PlaneKind::NormalNorth, MIDDLE), normal);
            assert!((value(&found, PlaneKind::Range, MIDDLE) - 20.0).abs() < 1e-5);
        }
    }
}

/// A ball of 24 x 48 faces with the normals of a sphere: the light of the ball is the light of the sphere, but for the bow of the faces.
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

/// The scene's sun stands behind the box; the sun of the group goes from the side of the box to its front in 10 s.
#[test]
fn a_group_has_its_own_sun_and_throws_no_shadow() {
    let group = NonZeroU16::new(1);
    let own = GroupSun { first: sun(90.0, 0.0), rate: quantities::radians(9.0) };
    let drawn = |group, own, time| {
        let mut one = standing_box(0, [70.0, 100.0, 0.0], 1.0, 4.0);
        one.body.group = group;
        let groups = vec![Group { name: "g".into(), sun: own }];
        let scenery = Scenery::still(sun(0.0, 20.0)).with_bodies(vec![one]).with_groups(groups);
        seen_from(scenery, Pose { time, ..pose([50.0, 100.0, 2.0], 0.0, 0.0) }, &shadowed())
    };
    let front = |time: f64| -libm::cos(quantities::radians(90.0 + 9.0 * time));
    for (group, own, time, expected) in [
        (None, Some(own), 10.0, 0.0),
        (group, None, 10.0, 0.0),
        (group, Some(own), 0.0, 0.0),
        (group, Some(own), 5.0, front(5.0)),
        (group, Some(own), 10.0, 1.0),
    ] {
        let light = value(&drawn(group, own, time), PlaneKind::Intensity, MIDDLE);
        assert!((light - expected).abs() < 1e-7, "{group:?} {time}: {light}");
    }
    let dark = |group| {
        let found = drawn(group, Some(own), 10.0);
        (0..(PIXELS[0] * PIXELS[1]) as usize).filter(|&k| value(&found, PlaneKind::Shadow, k) == 2.0).count()
    };
    assert!(dark(None) > 5 && dark(group) == 0, "{} {}", dark(None), dark(group));
}

/// Down a slope of 0.2 from the sun, which stands at a tangent of 0.1: the box stands in the shadow of the ground.
#[test]
fn ground_throws_no_shadow_on_a_group_with_its_own_sun() {
    let slope = landscape(plane(50.0, [4, 4], 0.0, [0.2, 0.0]), 0.5);
    let low = Sun { azimuth: 0.0, elevation: libm::atan(0.1) };
    let settings =
        Settings { laws: Laws { shadowed_bodies: ShadowedBodies::Dark, ..usual().laws }, ..shadowed() };
    let drawn = |own| {
        let mut one = standing_box(0, [70.0, 100.0, 14.0], 1.0, 4.0);
        one.body.group = NonZeroU16::new(1);
        let groups = vec![Group { name: "g".into(), sun: own }];
        let scenery = Scenery::still(low).with_bodies(vec![one]).with_groups(groups);
        // From 2 m above the slope at the middle of the side that looks up it.
        let down = quantities::degrees(libm::atan(4.0 / 19.0));
        planes(&slope, scenery, &settings, &pose([90.0, 100.0, 20.0], -down, 180.0))
    };
    for (own, light, shade) in [
        (None, 0.0, Shade::Remote),
        (Some(GroupSun { first: low, rate: 0.0 }), libm::cos(low.elevation), Shade::Lit),
    ] {
        let found = drawn(own);
        assert!((value(&found, PlaneKind::Intensity, MIDDLE) - light).abs() < 1e-7, "{own:?}");
        assert_eq!(value(&found, PlaneKind::Label, MIDDLE), f64::from(Label::Culture.code()));
        assert_eq!(value(&found, PlaneKind::Shadow, MIDDLE), f64::from(shade.code()), "{own:?}");
    }
}

#[test]
fn a_coloured_box_has_light_in_its_colour() {
    let colour = [0.75, 0.5, 0.125];
    let boxed = guest(cube(1.0).coloured(colour).unwrap(), vec![frame(0.0, [70.0, 100.0, 2.0])]);
    let found = seen(Scenery::still(sun(180.0, 60.0)).with_guests(vec![boxed]), 0.0);
    for (kind, channel) in PlaneKind::COLOUR.into_iter().zip(colour) {
        assert!((value(&found, kind, MIDDLE) - 0.5 * channel).abs() < 1e-7, "{kind:?}");
    }
    let grey = 0.5 * quantities::luminance(colour);
    assert!((value(&found, PlaneKind::Intensity, MIDDLE) - grey).abs() < 1e-7);
}

/// A white sheet that lies on grey ground.
#[test]
fn a_sheet_on_the_ground_is_seen_by_its_priority() {
    let places = [[-9.0, -9.0, 0.0], [9.0, -9.0, 0.0], [9.0, 9.0, 0.0], [-9.0, 9.0, 0.0]];
    let white = Solid::open(places.map(DVec3::from_array).to_vec(), vec![(vec![0, 1, 2, 3], 1.0)]).unwrap();
    for (priority, albedo, label) in [(1, 1.0, Label::Culture), (-1, 0.5, Label::Terrain)] {
        let lying = Guest { priority, ..guest(white.clone(), vec![frame(0.0, [70.0, 100.0, 0.0])]) };
        let scenery = Scenery::still(sun(180.0, 30.0)).with_guests(vec![lying]);
        let found = seen_from(scenery, pose([55.0, 100.0, 15.0], -45.0, 0.0), &shadowed());
        assert_eq!(value(&found, PlaneKind::Label, MIDDLE), f64::from(label.code()));
        assert!((value(&found, PlaneKind::Intensity, MIDDLE) - 0.5 * albedo).abs() < 1e-7, "{priority}");
    }
}

#[test]
fn of_two_boxes_that_coincide_the_higher_priority_is_seen() {
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
