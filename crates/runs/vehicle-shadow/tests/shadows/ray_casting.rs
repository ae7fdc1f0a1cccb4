//! The report's chain on flat ground against rays from the ground to the sun.

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use scenario::FieldOfView;
use solids::culture;
use vehicle_shadow::{OutlineRule, Shape, Shot, flat_gates, shadow_outlines};

use crate::scenes::{lies_behind, on_flat_ground, shot, stone, to_sun};

/// What the shadow is to agree to, on the view-plane at distance 1.
const AGREE: f64 = 1e-9;

fn is_dark(shape: &Shape, shot: &Shot, at: DVec2, to_sun: DVec3) -> Option<bool> {
    let place = on_flat_ground(shot, at.x, at.y)?;
    Some(shape.bodies(shot).iter().any(|body| lies_behind(body, place, to_sun)))
}

/// Holds the middle of every visible edge of one convex part against rays from just inside and just outside; tells how
/// many there were.
fn check_edges(shape: &Shape, shot: &Shot, to_sun: DVec3) -> Result<usize, TestCaseError> {
    let (outlines, _) = shadow_outlines(shape.function(), shot, to_sun, OutlineRule::Parts);
    let mut checked = 0;
    for outline in &outlines {
        for (&from, &to) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            let (middle, inwards) = ((from + to) * 0.5, (to - from).perp().normalize());
            let is_visible =
                middle.x.abs() < shot.field.tan_half_width && middle.y.abs() < shot.field.tan_half_height;
            let inside = middle + inwards * AGREE;
            let is_thin = outline
                .iter()
                .zip(outline.iter().cycle().skip(1))
                .any(|(&a, &b)| (b - a).perp_dot(inside - a) < 0.5 * AGREE * (b - a).length());
            if !is_visible || is_thin {
                continue;
            }
            checked += 1;
            prop_assert_eq!(is_dark(shape, shot, inside, to_sun), Some(true), "inside {:?}", middle);
            let outside = is_dark(shape, shot, middle - inwards * AGREE, to_sun);
            prop_assert_ne!(outside, Some(true), "outside {:?}", middle);
        }
    }
    Ok(checked)
}

/// Holds gates against a ray from every third place of a grid; tells how many places were dark.
fn check_gates(shape: &Shape, shot: &Shot, to_sun: DVec3, rule: OutlineRule) -> Result<usize, TestCaseError> {
    let lines = 31;
    let (outlines, _) = shadow_outlines(shape.function(), shot, to_sun, rule);
    let gates = flat_gates(&outlines, shot, lines);
    let mut dark = 0;
    for (line, gate) in gates.lines.iter().enumerate() {
        let y = shot.field.tan_half_height * (2.0 * line as f64 + 1.0 - lines as f64) / lines as f64;
        for column in 0..40 {
            let x = shot.field.tan_half_width * (f64::from(column) / 20.0 - 0.99);
            let is_close = gate.stretches().iter().flatten().any(|end| (end - x).abs() < AGREE);
            let Some(expected) = is_dark(shape, shot, DVec2::new(x, y), to_sun).filter(|_| !is_close) else {
                prop_assert!(is_close || !gate.holds(x), "shadow in the sky at {} {}", x, y);
                continue;
            };
            prop_assert_eq!(gate.holds(x), expected, "{} {}", x, y);
            dark += usize::from(expected);
        }
    }
    Ok(dark)
}

/// A field in which most shadows of a vehicle lie.
const WIDE: FieldOfView = FieldOfView { tan_half_width: 1.5, tan_half_height: 1.2 };

#[derive(Debug, Clone)]
struct Case {
    seed: u64,
    shot: Shot,
    to_sun: DVec3,
}

/// A vehicle that leans, its sun more or less behind it: else its shadow is not in the picture.
fn case() -> impl Strategy<Value = Case> {
    let angles = (-25.0..25.0f64, -35.0..10.0f64, 0.0..360.0f64);
    (any::<u64>(), angles, 0.6..4.0f64, -110.0..110.0f64, 3.0..50.0f64).prop_map(
        |(seed, (roll, pitch, heading), height, aside, elevation)| Case {
            seed,
            shot: Shot { field: WIDE, ..shot([100.0, 200.0, 7.0 + height], height, [roll, pitch, heading]) },
            to_sun: to_sun(heading + 180.0 + aside, elevation),
        },
    )
}

fn stones(seed: u64, count: u64, eye_height: f64) -> Shape {
    let part = |index: u64| {
        let along = |k: u64| 4.0 * quantities::unit_interval(seed, &[index, k]) - 2.0;
        let middle = DVec3::new(along(7), along(8), 1.2 + 0.5 * along(9));
        stone(seed.wrapping_add(index), 5 + index % 9, middle, DVec3::new(0.7, 0.5, 0.9))
    };
    Shape::new((0..count).filter_map(part).collect(), eye_height)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn edges_of_convex_parts_are_where_rays_have_them(case in case()) {
        check_edges(&stones(case.seed, 1, case.shot.height), &case.shot, case.to_sun)?;
    }

    #[test]
    fn gates_are_dark_where_rays_meet_any_part(case in case()) {
        check_gates(&stones(case.seed, 6, case.shot.height), &case.shot, case.to_sun, OutlineRule::Parts)?;
    }
}

/// The properties are about something: such shadows are in the picture.
#[test]
fn a_rover_on_a_slope() {
    let shape = Shape::new(culture::model("rover").unwrap(), 1.6334);
    let shot = shot([100.0, 200.0, 8.6], 1.6334, [8.0, -12.0, 40.0]);
    let mut edges = 0;
    for part in culture::model("rover").unwrap() {
        edges += check_edges(&Shape::new(vec![part], 1.6334), &shot, to_sun(230.0, 25.0)).unwrap();
    }
    assert!(edges > 50, "{edges}");
    let dark = check_gates(&shape, &shot, to_sun(230.0, 25.0), OutlineRule::Parts).unwrap();
    assert!(dark > 20, "{dark}");
}
