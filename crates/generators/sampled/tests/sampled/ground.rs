//! Level ground against closed forms.

use crate::shots::{HOME, Shot, is_same, level_ground};
use generator::{Label, PlaneKind};
use glam::DVec3;
use landscape::LUNOID_RADIUS;
use quantities::{radians, sin_cos};
use raster::Pattern;
use scenario::Curvature;

const COLUMNS: u32 = 40;
const LINES: u32 = 30;

/// Level ground seen askew, with the pattern that has its point in the middle of each pixel.
fn askew(pattern: Pattern) -> Shot {
    let mut shot = Shot::new(COLUMNS, LINES, 50.0);
    shot.ground = level_ground(HOME, 0.7);
    shot.run.sampling.pattern = pattern;
    shot.run.ground_half_side = 64.0;
    shot.pose.eye[2] = 3.0;
    (shot.pose.attitude.pitch, shot.pose.attitude.heading) = (radians(-12.0), radians(35.0));
    shot.pose.yoke = radians(9.0);
    shot
}

/// Distance along the ray of a pixel's place to the ground (m), as long as it is well within the bank.
fn distance(direction: DVec3, height: f64) -> Option<f64> {
    let distance = -height * direction.length() / direction.z;
    (direction.z < 0.0 && distance < 1000.0).then_some(distance)
}

#[test]
fn planes_are_those_of_the_ray() {
    let shot = askew(Pattern::One);
    let frame = shot.draw();
    let eye = shot.eye();
    let lambert = 0.7 * sin_cos(shot.sun.elevation).0;
    let mut seen = 0;
    for index in 0..(COLUMNS * LINES) as usize {
        let at = [index % COLUMNS as usize, index / COLUMNS as usize].map(|pixel| pixel as f64 + 0.5);
        let direction = eye.direction(at);
        let Some(distance) = distance(direction, 3.0) else { continue };
        let range = distance * direction.truncate().length() / direction.length();
        let value = |kind| f64::from(frame.plane(kind)[index]);
        assert!((value(PlaneKind::Distance) / distance - 1.0).abs() < 1e-5, "{index}");
        assert!((value(PlaneKind::Range) / range - 1.0).abs() < 1e-5, "{index}");
        assert!(frame.colour(index).iter().all(|channel| is_same(*channel, lambert)), "{index}");
        assert!(is_same(value(PlaneKind::Intensity), lambert), "{index}");
        seen += 1;
    }
    assert!(seen > 700, "{seen}");
}

/// With more points a pixel has the distance of its nearest one, which lies within half a pixel of its middle.
#[test]
fn distance_is_that_of_the_nearest_point_of_the_pixel() {
    let shot = askew(Pattern::Four);
    let (frame, eye) = (shot.draw(), shot.eye());
    for index in 0..(COLUMNS * LINES) as usize {
        let corner = [index % COLUMNS as usize, index / COLUMNS as usize].map(|pixel| pixel as f64);
        let middle = eye.direction(corner.map(|at| at + 0.5));
        // Depths of the sampling points, as 1 over the length along the view axis.
        let nearest = [[12.0, 4.0], [28.0, 12.0], [4.0, 20.0], [20.0, 28.0]]
            .map(|offset: [f64; 2]| [0, 1].map(|axis| corner[axis] + offset[axis] / 32.0))
            .map(|at| -eye.direction(at).z / 3.0)
            .into_iter()
            .fold(0.0, f64::max);
        if nearest < 1e-2 {
            continue;
        }
        let found = f64::from(frame.plane(PlaneKind::Distance)[index]);
        assert!((found * nearest / middle.length() - 1.0).abs() < 1e-6, "{index}: {found}");
    }
}

/// The horizon of a sphere dips by `acos(R / (R + h))`; here about 10.7 pixels.
#[test]
fn the_horizon_of_a_curved_lunoid_dips() {
    let (focal, height) = (1000.0, 100.0);
    for curvature in [Curvature::Parabolic, Curvature::Exact] {
        let mut shot = Shot::new(8, 64, focal);
        shot.ground = level_ground(30_000.0, 1.0);
        shot.run.ground_half_side = 1000.0;
        shot.run.ground_cells = 32;
        shot.view.laws.curvature = curvature;
        shot.pose.eye = [30_000.0, 30_000.0, height];
        let frame = shot.draw();
        let ground = frame.labelled(Label::Terrain);
        let dip = libm::acos(LUNOID_RADIUS / (LUNOID_RADIUS + height));
        let horizon = 32.0 + focal * libm::tan(dip);
        for column in 0..8 {
            let first = ground.iter().find(|index| *index % 8 == column).unwrap() / 8;
            assert!((first as f64 - horizon).abs() < 1.0, "{curvature:?}: {first}, not {horizon}");
        }
    }
}
