//! A spherical datum: closed forms, and dense sampling of rough ground.

use sight::{Curvature, Point, Posts, Sight};

use crate::{Random, posts};

const MOON: f64 = 1_737_400.0;

/// `R - sqrt(R^2 - s^2)`.
fn drop(radius: f64, distance: f64) -> f64 {
    radius - (radius * radius - distance * distance).sqrt()
}

/// Right triangles of whole numbers: 3, 4, 5 and 7, 24, 25.
#[test]
fn the_drop_is_that_of_the_sphere() {
    let body = Curvature::spherical(25.0, 0.0).unwrap();
    for (distance, expected) in [(0.0, 0.0), (7.0, 1.0), (15.0, 5.0), (24.0, 18.0), (25.0, 25.0)] {
        assert!((body.drop(distance) - expected).abs() < 1e-13, "{distance}");
    }
    let refracted = Curvature::spherical(20.0, 0.2).unwrap();
    assert!((refracted.drop(7.0) - 1.0).abs() < 1e-13);
    assert_eq!((body.reach(), Curvature::FLAT.reach()), (25.0, f64::INFINITY));
    let parabola = Curvature::parabolic(MOON, 0.0).unwrap();
    let sphere = Curvature::spherical(MOON, 0.0).unwrap();
    let more = sphere.drop(1e5) - parabola.drop(1e5);
    assert!((more - 1e20 / (8.0 * MOON * MOON * MOON)).abs() < 0.01, "{more}");
}

/// Seen from a height h the horizon lies at `R sqrt(1 - (R / (R + h))^2)`. The line that touches the sphere there falls by
/// `sqrt(h (2 R + h)) / R`.
#[test]
fn the_horizon_of_a_smooth_sphere() {
    let body = Curvature::spherical(MOON, 0.0).unwrap();
    for (height, spacing) in [(0.001, 0.5), (2.0, 20.0), (5e3, 1e3), (1e6, 8e3)] {
        let smooth = posts([2, 201], spacing, |_, _| 0.0);
        let eye = Point::above_ground([0.0, 0.0], height);
        let seen = smooth.viewshed(&eye, 0.0, body).unwrap();
        let least = smooth.least_heights(&eye, body).unwrap();
        let share = MOON / (MOON + height);
        let horizon = MOON * (1.0 - share * share).sqrt();
        let slope = (height * (2.0 * MOON + height)).sqrt() / MOON;
        assert!(horizon < 200.0 * spacing, "{height}: {horizon}");
        for column in 1..201 {
            let distance = column as f64 * spacing;
            let beyond = distance > horizon;
            assert!(
                (distance - horizon).abs() < 1e-6 || (seen[column] == Sight::Hidden) == beyond,
                "{column}"
            );
            let line = height - slope * distance + body.drop(distance);
            let expected = if beyond { line } else { 0.0 };
            assert!(
                (least[column] - expected).abs() < 1e-8 + 1e-9 * expected,
                "{height} {column}: {}",
                least[column]
            );
        }
    }
}

/// Least clearance (m) and least rise (m) of the target, from many places of the line.
fn sampled(ground: &Posts, from: [f64; 3], to: [f64; 3], radius: f64) -> [f64; 2] {
    let length = libm::hypot(to[0] - from[0], to[1] - from[1]);
    let end = to[2] - drop(radius, length);
    let mut found = [f64::INFINITY, 0.0_f64];
    for step in 1..20_000 {
        let t = f64::from(step) / 20_000.0;
        let place = [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])];
        let line = from[2] + t * (end - from[2]) + drop(radius, t * length);
        let clearance = line - ground.height(place).unwrap();
        found = [found[0].min(clearance), found[1].max(-clearance / t)];
    }
    found
}

#[test]
fn rough_ground_on_a_small_sphere_agrees_with_dense_sampling() {
    let mut random = Random(7);
    let heights = random.rough([33, 33], 12.0);
    let ground = Posts::new([33, 33], [0.0, 0.0], 10.0, heights).unwrap();
    let radius = 900.0;
    let body = Curvature::spherical(radius, 0.0).unwrap();
    let (mut visible, mut hidden) = (0, 0);
    for _ in 0..60 {
        let [eye, target] = [0, 1].map(|_| [-random.between(1.0, 319.0), random.between(1.0, 319.0)]);
        let heights = [random.between(0.1, 30.0), random.between(0.0, 20.0)];
        let [from, to] = [(eye, heights[0]), (target, heights[1])]
            .map(|(place, height)| Point::above_ground(place, height));
        let line = ground.line_of_sight(&from, &to, body).unwrap();
        let above = |place, height| ground.height(place).unwrap() + height;
        let at = |place: [f64; 2], height| [place[0], place[1], above(place, height)];
        let [clearance, _] = sampled(&ground, at(eye, heights[0]), at(target, heights[1]), radius);
        let clearance = clearance.min(heights[0]).min(heights[1]);
        assert!(
            line.clearance <= clearance + 1e-9 && line.clearance > clearance - 0.02,
            "{} {clearance}",
            line.clearance
        );
        if line.clearance.abs() > 0.02 {
            assert_eq!(line.sight == Sight::Hidden, clearance < 0.0);
        }
        let [_, rise] = sampled(&ground, at(eye, heights[0]), at(target, 0.0), radius);
        let least = line.least_height.unwrap();
        assert!(least >= rise - 1e-9 && least < rise + 0.05, "{least} {rise}");
        visible += usize::from(line.sight == Sight::Visible);
        hidden += usize::from(line.sight == Sight::Hidden);
    }
    assert!(visible > 5 && hidden > 5, "{visible} {hidden}");
}

#[test]
fn what_lies_beyond_the_end_of_the_sphere_is_refused() {
    let ground = posts([2, 12], 10.0, |_, _| 0.0);
    let eye = Point::above_ground([0.0, 0.0], 5.0);
    let body = Curvature::spherical(100.0, 0.0).unwrap();
    let far = ground.line_of_sight(&eye, &Point::above_ground([0.0, 100.0], 0.0), body).unwrap_err();
    assert!(far.to_string().contains("distance to the target (m) is 100"), "{far}");
    assert!(ground.line_of_sight(&eye, &Point::above_ground([0.0, 90.0], 0.0), body).is_ok());
    assert!(ground.viewshed(&eye, 0.0, body).is_err() && ground.least_heights(&eye, body).is_err());
    for (radius, refraction) in [(0.0, 0.0), (f64::NAN, 0.0), (1e6, 1.0), (1e6, -0.1)] {
        assert!(Curvature::spherical(radius, refraction).is_err());
    }
}
