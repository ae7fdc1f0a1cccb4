//! Shadow on true ground: against the flat law, against marching, and against `exact`.

use std::num::NonZeroU16;
use std::sync::Arc;

use exact::Exact;
use generator::{Generator, Label, PlaneKind, Planes, Shade};
use glam::DVec3;
use landscape::Landscape;
use scenario::{Frame, Group, GroupSun, Guest, Pose, Scenery, Standing};
use signal::Probe;
use solids::{Body, Kind, Solid, culture};
use vehicle_shadow::{Gate, OutlineRule, Shape, Shot, TrueGround, flat_gates, shadow_outlines};

use crate::scenes::{bumps, flat, lies_behind, shot, stage, sun, to_sun};

const SIZE: [usize; 2] = [120, 72];

pub fn middle(half: f64, index: usize, count: usize) -> f64 {
    half * (2.0 * index as f64 + 1.0 - count as f64) / count as f64
}

pub fn gates(
    landscape: &Arc<Landscape>,
    scenery: Scenery,
    shape: &Shape,
    shot: &Shot,
    sun: DVec3,
) -> Vec<Gate> {
    let size = SIZE.map(|count| count as u32);
    TrueGround::new(stage(landscape, scenery, size))
        .unwrap()
        .gates(shape, shot, &[sun], &[], SIZE)
        .suns
        .remove(0)
        .lines
}

/// The eye over the ground in the middle.
fn standing(landscape: &Landscape, angles: [f64; 3]) -> Shot {
    let ground = landscape.height(240.0, 240.0).unwrap();
    shot([240.0, 240.0, ground + 1.6334], 1.6334, angles)
}

#[test]
fn what_moves_is_open_or_has_a_sun_is_refused_by_name() {
    let place = DVec3::new(240.0, 250.0, 0.0);
    let cube = Solid::boxed(-DVec3::ONE, DVec3::ONE, 0.5).unwrap();
    let sheet = Solid::open(cube.vertices()[..3].to_vec(), vec![(vec![0, 1, 2], 0.5)]).unwrap();
    let scenery = || Scenery::still(sun(200.0, 30.0));
    let guest = |solid: &Solid| {
        let (from, until, solid) = (0.0, f64::INFINITY, Arc::new(solid.clone()));
        let frames = vec![Frame { time: 0.0, foot: place, attitude: Default::default() }];
        let guest =
            Guest { from, until, object: 0, solid, scale: 1.0, frames, spin: 0.0, priority: 0, group: None };
        scenery().with_guests(vec![guest])
    };
    let grouped = |sun| {
        let mut body =
            Body::place(0, Kind::Culture, &Arc::new(cube.clone()), place, &glam::DMat3::IDENTITY, 1.0);
        (body.group, body.priority) = (NonZeroU16::new(1), 3);
        let standing = Standing { from: 0.0, until: f64::INFINITY, body };
        scenery().with_bodies(vec![standing]).with_groups(vec![Group { name: "g".into(), sun }])
    };
    let own = GroupSun { first: sun(10.0, 30.0), rate: 0.0 };
    for (scenery, name) in [
        (guest(&cube), "objects that move (`moves`"),
        (guest(&sheet), "open surfaces (`open`"),
        (grouped(Some(own)), "suns of groups (`sun`"),
    ] {
        let refused = TrueGround::new(stage(&flat(), scenery, [4, 3])).unwrap_err().to_string();
        assert!(refused.contains(name) && refused.contains("--ground"), "{refused}");
    }
    assert!(TrueGround::new(stage(&flat(), grouped(None), [4, 3])).is_ok());
}

#[test]
fn on_level_ground_both_laws_are_one() {
    let (ground, to_sun) = (flat(), to_sun(215.0, 18.0));
    let shape = Shape::new(culture::model("rover").unwrap(), 1.6334);
    let shot = standing(&ground, [5.0, -14.0, 30.0]);
    let found = gates(&ground, Scenery::still(sun(215.0, 18.0)), &shape, &shot, to_sun);
    let (outlines, _) = shadow_outlines(shape.function(), &shot, to_sun, OutlineRule::Parts);
    let expected = flat_gates(&outlines, &shot, SIZE[1]);
    let mut stretches = 0;
    for (line, (found, expected)) in found.iter().zip(&expected.lines).enumerate() {
        let width = shot.field.tan_half_width;
        // The flat law has what lies beside the picture as well.
        let seen = |[from, to]: &[f64; 2]| {
            let clipped = [from.max(-width), to.min(width)];
            (clipped[0] < clipped[1] - 1e-12).then_some(clipped)
        };
        let expected: Vec<[f64; 2]> = expected.stretches().iter().filter_map(seen).collect();
        assert_eq!(found.stretches().len(), expected.len(), "line {line}");
        for (found, expected) in found.stretches().iter().zip(&expected) {
            assert!(
                (found[0] - expected[0]).abs() < 1e-9 && (found[1] - expected[1]).abs() < 1e-9,
                "line {line}"
            );
            stretches += 1;
        }
    }
    assert!(stretches > 60, "{stretches}");
}

/// The first place where a ray comes under the ground, by small steps and halving.
fn march(landscape: &Landscape, shot: &Shot, ray: DVec3) -> Option<DVec3> {
    let eye = DVec3::from_array(shot.eye);
    let above = |t: f64| {
        let at = eye + ray * t;
        landscape.height(at.x, at.y).map(|ground| at.z - ground)
    };
    let mut from = 0.0;
    for step in 1..20_000 {
        let to = 0.004 * f64::from(step);
        if above(to)? < 0.0 {
            let mut ends = [from, to];
            for _ in 0..50 {
                let half = 0.5 * (ends[0] + ends[1]);
                ends[usize::from(above(half)? < 0.0)] = half;
            }
            return Some(eye + ray * ends[0]);
        }
        from = to;
    }
    None
}

#[test]
fn rough_ground_against_marching() {
    let shape = Shape::new(culture::model("rover").unwrap(), 1.6334);
    let (mut dark, mut checked) = (0, 0);
    for seed in 1..5 {
        let ground = bumps(seed, 0.35);
        let (azimuth, elevation) = (170.0 + 20.0 * seed as f64, 9.0 + 4.0 * seed as f64);
        let shot = standing(&ground, [3.0 * seed as f64 - 6.0, -10.0, 10.0]);
        let to_sun = to_sun(azimuth, elevation);
        let bodies = shape.bodies(&shot);
        let gates = gates(&ground, Scenery::still(sun(azimuth, elevation)), &shape, &shot, to_sun);
        for line in (0..SIZE[1]).step_by(2) {
            for column in (0..SIZE[0]).step_by(3) {
                let x = middle(shot.field.tan_half_width, column, SIZE[0]);
                let y = middle(shot.field.tan_half_height, line, SIZE[1]);
                // Between places of the grid the ground is a chord: edges may be off by a share of a column.
                let width = 2.0 * shot.field.tan_half_width / SIZE[0] as f64;
                let is_close =
                    gates[line].stretches().iter().flatten().any(|end| (end - x).abs() < 0.1 * width);
                let Some(place) = march(&ground, &shot, shot.ray(x, y)).filter(|_| !is_close) else {
                    continue;
                };
                let expected = bodies.iter().any(|body| lies_behind(body, place, to_sun));
                assert_eq!(gates[line].holds(x), expected, "seed {seed}: {x} {y} at {place}");
                checked += 1;
                dark += usize::from(expected);
            }
        }
    }
    assert!(dark > 150 && checked > 1500, "{dark} of {checked}");
}

/// A thing behind and above the camera, which `exact` can draw as a body that nobody sees.
fn sail() -> Vec<Solid> {
    vec![
        Solid::boxed(DVec3::new(-2.0, -0.9, 1.0), DVec3::new(-1.7, 0.7, 4.5), 1.0).unwrap(),
        Solid::boxed(DVec3::new(-2.4, -2.0, 3.4), DVec3::new(-1.2, 2.2, 3.7), 1.0).unwrap(),
    ]
}

/// What `exact` has at the middles of all pixels.
pub fn drawn(landscape: &Arc<Landscape>, scenery: Scenery, shot: &Shot) -> Planes {
    let mut planes = Planes::new(SIZE[0], SIZE[1], &[PlaneKind::Shadow, PlaneKind::Label]);
    let stage = stage(landscape, scenery, SIZE.map(|count| count as u32));
    let pose = Pose { time: 0.0, eye: shot.eye, attitude: shot.vehicle, yoke: shot.camera.roll };
    Exact.prepare(stage).unwrap().frame(0, &pose, &mut planes, &mut Probe::off()).unwrap();
    planes
}

#[test]
fn exact_casts_the_same_shadow_past_rocks_and_ridges() {
    let ground = bumps(11, 0.4);
    let shape = Shape::new(sail(), 1.6334);
    let shot = standing(&ground, [0.0, -8.0, 0.0]);
    let rock = Arc::new(Solid::boxed(DVec3::new(-0.5, -0.4, -0.3), DVec3::new(0.5, 0.4, 0.8), 1.0).unwrap());
    let foot = DVec3::new(247.0, 241.0, ground.height(247.0, 241.0).unwrap());
    let rock = Body::place(7, Kind::Rock, &rock, foot, &glam::DMat3::IDENTITY, 1.0);
    let stands = |body: Body| Standing { from: 0.0, until: f64::INFINITY, body };
    let scenery = |bodies: Vec<Body>| {
        Scenery::still(sun(187.0, 14.0)).with_bodies(bodies.into_iter().map(stands).collect())
    };
    let without = drawn(&ground, scenery(vec![rock.clone()]), &shot);
    let with = drawn(&ground, scenery([vec![rock.clone()], shape.bodies(&shot)].concat()), &shot);
    let gates = gates(&ground, scenery(vec![rock]), &shape, &shot, to_sun(187.0, 14.0));
    let code = |planes: &Planes, kind, index: usize| planes.get(kind).unwrap()[index];
    let remote = f32::from(Shade::Remote.code());
    let (mut dark, mut differ, mut rocks) = (0, 0, 0);
    for index in 0..SIZE[0] * SIZE[1] {
        let gate = &gates[index / SIZE[0]];
        let x = middle(shot.field.tan_half_width, index % SIZE[0], SIZE[0]);
        let label = code(&with, PlaneKind::Label, index);
        rocks += usize::from(label == f32::from(Label::Rock.code()) && gate.holds(x));
        // A rock that is cast upon stays lit in `exact`, and what is dark anyway does not tell.
        if label != f32::from(Label::Terrain.code()) || code(&without, PlaneKind::Shadow, index) != 0.0 {
            continue;
        }
        let expected = code(&with, PlaneKind::Shadow, index) == remote;
        dark += usize::from(expected);
        differ += usize::from(gate.holds(x) != expected);
    }
    assert!(dark > 400 && rocks > 5, "{dark} dark, {rocks} of the rock");
    // Only where an edge runs through the middle of a pixel.
    assert!(differ <= dark / 200, "{differ} of {dark}");
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let ground = bumps(3, 0.3);
    let shape = Shape::new(culture::model("rover").unwrap(), 1.6334);
    let shot = standing(&ground, [2.0, -10.0, 10.0]);
    let of = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| gates(&ground, Scenery::still(sun(190.0, 20.0)), &shape, &shot, to_sun(190.0, 20.0)))
    };
    assert_eq!(of(1), of(5));
}
