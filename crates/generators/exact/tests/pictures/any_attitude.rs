//! Any attitude from any place: closed forms, and marching along each ray in space.

use std::sync::Arc;

use crate::scenes::{bumps, crater_field, landscape, level, plane};
use exact::{Ceilings, Outlook, Sight, Spot, View};
use glam::DVec3;
use landscape::{Attitude, LUNOID_RADIUS, Landscape};
use proptest::prelude::*;
use quantities::radians;
use scenario::{Curvature, Projection};

/// An eye, how it looks, and the shape of the lunoid.
struct Eye {
    at: [f64; 3],
    attitude: Attitude,
    curvature: Curvature,
}

impl Eye {
    /// Unit vector (north, east, up) through a place of the screen: the camera's rotation, roll included.
    fn direction(&self, [x, y]: [f64; 2]) -> DVec3 {
        let [north, east, down] = (self.attitude.to_terrain() * DVec3::new(1.0, x, y)).to_array();
        DVec3::new(north, east, -down).normalize()
    }

    fn drop(&self, range: f64) -> f64 {
        match self.curvature {
            Curvature::None => 0.0,
            Curvature::Parabolic => range * range / (2.0 * LUNOID_RADIUS),
            Curvature::Exact => range * libm::tan(0.5 * libm::asin(range / LUNOID_RADIUS)),
        }
    }

    /// A place and a height of the map as this eye has them in space, from itself.
    fn in_space(&self, [x, y]: [f64; 2], height: f64) -> DVec3 {
        let [north, east, up] = self.at;
        let over = [x - north, y - east];
        DVec3::new(over[0], over[1], height - self.drop(libm::hypot(over[0], over[1])) - up)
    }

    fn look(&self, ground: &Landscape, ceilings: &Ceilings, [x, y]: [f64; 2]) -> (Sight, Option<DVec3>) {
        let ends = [0.0, f64::INFINITY];
        let outlook = Outlook::new(ground, ceilings, self.at, self.curvature, ends, None);
        let view = View::new(Projection::Exact, &self.attitude).with_yoke(self.attitude.roll);
        let sight = outlook.look(&view.ray(x, y));
        let place = |spot: &Spot| self.in_space(spot.place, outlook.height(spot));
        let Sight::Ground(spot) = &sight else { return (sight, None) };
        (sight, Some(place(spot)))
    }
}

/// Eyes over, beside and far from an area of 800 m x 800 m around (400, 400), all looking at its middle.
fn eyes(curvature: Curvature) -> Vec<Eye> {
    let places = [
        [400.0, 400.0, 30.0],
        [400.0, 400.0, 1e6],
        [-300.0, 170.0, 90.0],
        [5000.0, -9000.0, 7000.0],
        [-7e5, 4e5, 1e6],
        [400.0, 1.2e6, 1e6],
    ];
    let eye = |at: [f64; 3]| {
        let range = libm::hypot(400.0 - at[0], 400.0 - at[1]);
        let mut eye = Eye { at, attitude: Attitude { roll: 2.5, pitch: 0.0, heading: 0.0 }, curvature };
        eye.attitude.heading = libm::atan2(400.0 - at[1], 400.0 - at[0]);
        eye.attitude.pitch = -libm::atan2(at[2] + eye.drop(range), range);
        eye
    };
    places.into_iter().map(eye).collect()
}

/// Holds each ground that an eye sees against the distance (m) along its ray at which it should lie; the largest error (m).
fn worst(ground: &Arc<Landscape>, curvature: Curvature, expected: impl Fn(&Eye, DVec3) -> f64) -> f64 {
    let ceilings = Ceilings::new(ground);
    let mut worst = 0.0_f64;
    for eye in eyes(curvature) {
        let away = libm::hypot(eye.at[2], libm::hypot(eye.at[0] - 400.0, eye.at[1] - 400.0));
        let half = (300.0 / away).min(1.0);
        let mut seen = 0;
        for step in 0..121 {
            let at = [f64::from(step % 11) / 5.0 - 1.0, f64::from(step / 11) / 5.0 - 1.0].map(|at| at * half);
            let direction = eye.direction(at);
            let (sight, found) = eye.look(ground, &ceilings, at);
            let Some(found) = found else { continue };
            let error = (found - direction * expected(&eye, direction)).length();
            assert!(error < 1e-8, "{:?} {at:?}: {error} m, {sight:?}", eye.at);
            worst = worst.max(error);
            seen += 1;
        }
        assert!(seen > 15, "{:?}: {seen} rays meet the ground", eye.at);
    }
    worst
}

#[test]
fn planes_from_anywhere() {
    for [north, east] in [[0.0, 0.0], [0.08, -0.05]] {
        let ground = landscape(plane(40.0, [20, 20], 12.0, [north, east]), 1.0);
        let error = worst(&ground, Curvature::None, |eye, d| {
            let under = 12.0 + north * eye.at[0] + east * eye.at[1] - eye.at[2];
            under / (d.z - north * d.x - east * d.y)
        });
        println!("plane of slopes {north}, {east}: {error:.1e} m");
    }
}

#[test]
fn a_trough_from_anywhere() {
    // h = 2e-4 (x - 400)^2: the words of x^2 are d (hx) = 2 d x and d^2 hxx = 2 d^2.
    let (size, bend) = (40.0, 2e-4);
    let trough = level(size, [20, 20], |m, _| {
        let x = size * m - 400.0;
        [bend * x * x, 0.0, 0.0, 2.0 * bend * x * size, 0.0, 0.0, 2.0 * bend * size * size, 0.0, 0.0]
    });
    let error = worst(&landscape(trough, 1.0), Curvature::None, |eye, d| {
        // bend (x + d t)^2 = z + d_z t: the root where the ray goes from above the trough to under it.
        let x = eye.at[0] - 400.0;
        let (a, b, c) = (bend * d.x * d.x, bend * x * d.x - 0.5 * d.z, bend * x * x - eye.at[2]);
        let root = (b * b - a * c).max(0.0).sqrt();
        let t = if b > 0.0 { -c / (b + root) } else { (root - b) / a };
        // One of Newton's steps: far away the coefficients have lost digits.
        let across = x + d.x * t;
        t - (bend * across * across - eye.at[2] - d.z * t) / (2.0 * bend * across * d.x - d.z)
    });
    println!("trough: {error:.1e} m");
}

#[test]
fn the_sphere_from_anywhere() {
    let ground = landscape(plane(40.0, [20, 20], 12.0, [0.0; 2]), 1.0);
    let error = worst(&ground, Curvature::Exact, |eye, d| {
        // |(0, 0, H) + (0, 0, R) + d t| = R, the nearer root.
        let height = eye.at[2] - 12.0;
        let (b, c) = (d.z * (LUNOID_RADIUS + height), height * (2.0 * LUNOID_RADIUS + height));
        let t = c / (-b + (b * b - c).max(0.0).sqrt());
        // One of Newton's steps with heights of metres: squares of the radius have lost digits.
        let over = libm::hypot(d.x, d.y);
        let range = over * t;
        let fall = range / (LUNOID_RADIUS * LUNOID_RADIUS - range * range).sqrt();
        t - (height + d.z * t + eye.drop(range)) / (d.z + over * fall)
    });
    println!("sphere: {error:.1e} m");
}

/// The first place along a ray, from so far on (m), where the ground lies above it: small steps over the area.
struct March<'a> {
    ground: &'a Landscape,
    eye: &'a Eye,
    direction: DVec3,
}

impl March<'_> {
    /// Ground less ray (m) at a distance along the ray (m); `None` outside the area.
    fn above(&self, distance: f64) -> Option<f64> {
        let [north, east, up] = self.eye.at;
        let at = self.direction * distance;
        let height = self.ground.height(north + at.x, east + at.y)?;
        Some(height - self.eye.drop(libm::hypot(at.x, at.y)) - (up + at.z))
    }

    /// Distances between which the ray is over the area and not far from its ground (m).
    fn ends(&self, heights: [f64; 2]) -> [f64; 2] {
        let [south, west, north, east] = self.ground.level().extent();
        let (mut from, mut to) = (0.0_f64, f64::INFINITY);
        let mut clip = |at: f64, step: f64, [low, high]: [f64; 2]| {
            if step != 0.0 {
                let ends = [(low - at) / step, (high - at) / step];
                from = from.max(ends[0].min(ends[1]));
                to = to.min(ends[0].max(ends[1]));
            } else if !(low..=high).contains(&at) {
                to = -1.0;
            }
        };
        clip(self.eye.at[0], self.direction.x, [south, north]);
        clip(self.eye.at[1], self.direction.y, [west, east]);
        let corners = [[south, west], [south, east], [north, west], [north, east]];
        let ranges = corners.map(|[x, y]| libm::hypot(x - self.eye.at[0], y - self.eye.at[1]));
        let farthest = ranges.into_iter().fold(0.0, f64::max);
        let [low, high] = [farthest, (farthest - 70.0).max(0.0)].map(|range| self.eye.drop(range));
        clip(self.eye.at[2], self.direction.z, [heights[0] - low, heights[1] - high]);
        [from, to]
    }
}

fn curvatures() -> impl Strategy<Value = Curvature> {
    prop_oneof![Just(Curvature::None), Just(Curvature::Parabolic), Just(Curvature::Exact)]
}

/// Where the eye stands: over the area or beside it, near its ground or on high.
fn places() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![
        (2.0..46.0f64, 2.0..46.0f64, 0.05..30.0f64).prop_map(|(x, y, up)| [x, y, up]),
        (-90.0..140.0f64, -90.0..140.0f64, 0.5..60.0f64).prop_map(|(x, y, up)| [x, y, up]),
        (-4e5..4e5f64, -4e5..4e5f64, 0.0..1e6f64).prop_map(|(x, y, up)| [x, y, up]),
        (20.0..30.0f64, 20.0..30.0f64, 1e3..1e6f64).prop_map(|(x, y, up)| [x, y, up]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn every_ray_from_anywhere_meets_the_first_ground(
        (seed, relief, count) in (any::<u64>(), 0.0..1.5f64, 0..60u64),
        place in places(),
        aim in (5.0..43.0f64, 5.0..43.0f64, any::<bool>()),
        (roll, pitch, heading) in (-180.0..180.0f64, -180.0..180.0f64, 0.0..360.0f64),
        curvature in curvatures(),
    ) {
        let ground = landscape(bumps(seed, relief), 1.0);
        let ground = Arc::new(Arc::unwrap_or_clone(ground).with_features(crater_field(seed, count, 6.0)));
        let below = ground.height(place[0], place[1]);
        let at = [place[0], place[1], below.unwrap_or(0.0) + place[2]];
        let mut eye = Eye {
            at,
            attitude: Attitude { roll: radians(roll), pitch: radians(pitch), heading: radians(heading) },
            curvature,
        };
        let to = eye.in_space([aim.0, aim.1], 0.0);
        if aim.2 || below.is_none() {
            eye.attitude.heading = libm::atan2(to.y, to.x);
            eye.attitude.pitch = libm::atan2(to.z, libm::hypot(to.x, to.y));
        }
        let ceilings = Ceilings::new(&ground);
        let half = (20.0 / to.length()).min(1.0);
        for step in 0..9 {
            let screen = [f64::from(step % 3 - 1) * half, f64::from(step / 3 - 1) * half];
            let march = March { ground: &ground, eye: &eye, direction: eye.direction(screen) };
            let (sight, found) = eye.look(&ground, &ceilings, screen);
            let rounding = 1e-11 + 4e-15 * to.length();
            let [mut from, to] = march.ends([-60.0, 60.0]);
            let met = match (sight, found) {
                (Sight::Ground(spot), Some(found)) => {
                    let aside = found.cross(march.direction).length();
                    prop_assert!(aside < rounding, "{spot:?}: {aside} m beside the ray");
                    let over = libm::hypot(found.x, found.y);
                    prop_assert!((spot.range - over).abs() <= 1e-9 * over + rounding, "{spot:?}, not {over}");
                    found.dot(march.direction)
                }
                (Sight::Cut(_), _) => {
                    let inside = march.above(from + 1e-6).or_else(|| march.above(from + 1e-3));
                    prop_assert!(inside.is_none_or(|above| above > -1e-3), "{inside:?} is no cut");
                    continue;
                }
                _ => to,
            };
            while from < met.min(to) - 1e-6 {
                if let Some(above) = march.above(from) {
                    prop_assert!(above < 1e-8, "{sight:?}: {above} m under ground at {from}, before {met}");
                }
                from += 0.01;
            }
        }
    }
}
