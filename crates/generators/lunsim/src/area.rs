//! The viewed area (block 5): what part of the map the picture can show.

use landscape::{LUNOID_RADIUS, Landscape, Level};
use scenario::Curvature;

use crate::observer::Observer;

/// A rectangle of the map in the observer's axes (m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ViewedArea {
    /// Nearest and farthest row; the nearest may lie behind the observer's foot point.
    pub along: [f64; 2],
    /// Left and right column.
    pub across: [f64; 2],
}

/// Least and greatest height of the ground (m): stored corners, widened by the deepest crater and the highest rim.
pub(crate) fn heights(landscape: &Landscape) -> [f64; 2] {
    let corners = landscape.level().words().iter().map(|words| words[0]);
    let [low, high] = corners
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| [low.min(height), high.max(height)]);
    let craters = landscape.features().craters();
    let deepest = craters.iter().map(|crater| crater.depth()).fold(0.0, f64::max);
    let highest = craters.iter().map(|crater| crater.highest()).fold(0.0, f64::max);
    [low - deepest, high + highest]
}

/// The area that the field of view covers on ground of heights `low` to `high` (m) on a lunoid of this shape, as far
/// as `end` (m) and the map reach; `None` if that is nothing.
pub(crate) fn viewed(
    observer: &Observer,
    level: &Level,
    [low, high]: [f64; 2],
    curvature: Curvature,
    end: f64,
) -> Option<ViewedArea> {
    let [half_width, half_height] = observer.half_field;
    let drop_to = |height: f64| (observer.eye[2] - height).max(0.0);
    let upper = observer.ray(-half_height);
    let lower = observer.ray(half_height);
    // A corner of the picture looks less steeply than the middle of its edge, and so sees farther ground.
    let reach = |x: f64| {
        let slant = (upper[0] * upper[0] + x * x).sqrt();
        let range = meeting(upper[1] / slant, drop_to(low), high - low, curvature).min(end);
        [range * upper[0] / slant, range * x / slant]
    };
    let (middle, corner) = (reach(0.0), reach(half_width));
    let far = middle[0].max(corner[0]);
    // Below a lower edge that looks ahead high ground is nearest, below one that looks back low ground.
    let nearest = if lower[0] > 0.0 { drop_to(high) } else { drop_to(low) };
    let steps = |drop: f64| if lower[1] > 0.0 { drop / lower[1] } else { 0.0 };
    let near = steps(nearest) * lower[0];
    let side = corner[1].max(steps(drop_to(low)) * half_width);
    let [along, across] = on_map(observer, level);
    let area = ViewedArea {
        along: [near.max(along[0]), far.min(along[1])],
        across: [across[0].max(-side), across[1].min(side)],
    };
    (area.along[0] < area.along[1] && area.across[0] < area.across[1]).then_some(area)
}

/// Ground range at which a ray of `slope` downwards meets ground `drop` (m) below the eye: on the lunoid the place
/// where it goes through the curved ground or, if it passes above, the range at which what stands `relief` (m) above
/// that ground has sunk below the horizon.
fn meeting(slope: f64, drop: f64, relief: f64, curvature: Curvature) -> f64 {
    match curvature {
        Curvature::None => {
            if slope > 0.0 {
                drop / slope
            } else {
                f64::INFINITY
            }
        }
        Curvature::Parabolic => on_parabola(slope, drop, relief),
        Curvature::Exact => on_sphere(slope, drop, relief),
    }
}

/// `t s = drop + s^2 / 2R`.
fn on_parabola(slope: f64, drop: f64, relief: f64) -> f64 {
    let root = slope * slope - 2.0 * drop / LUNOID_RADIUS;
    match slope > 0.0 && root >= 0.0 {
        true => 2.0 * drop / (slope + root.sqrt()),
        false => (2.0 * LUNOID_RADIUS * drop).sqrt() + (2.0 * LUNOID_RADIUS * relief).sqrt(),
    }
}

/// `t s = drop + R - sqrt(R^2 - s^2)`, squared: `(1 + t^2) s^2 - 2 t (R + drop) s + drop (2R + drop) = 0`.
fn on_sphere(slope: f64, drop: f64, relief: f64) -> f64 {
    let square = 1.0 + slope * slope;
    let (half, constant) = (slope * (LUNOID_RADIUS + drop), drop * (2.0 * LUNOID_RADIUS + drop));
    let root = half * half - square * constant;
    match slope > 0.0 && root >= 0.0 {
        true => constant / (half + root.sqrt()),
        false => horizon(drop) + horizon(relief),
    }
}

/// Range of the sphere's horizon (m) for an eye `height` (m) above it.
fn horizon(height: f64) -> f64 {
    LUNOID_RADIUS * (height * (2.0 * LUNOID_RADIUS + height)).sqrt() / (LUNOID_RADIUS + height)
}

/// The box around the map in the observer's axes: along, across. Looking along a cardinal direction it is the map.
fn on_map(observer: &Observer, level: &Level) -> [[f64; 2]; 2] {
    let [south, west, north, east] = level.extent();
    let corners = [[south, west], [south, east], [north, west], [north, east]];
    let places = corners.map(|[x, y]| observer.in_axes([x - observer.eye[0], y - observer.eye[1]]));
    std::array::from_fn(|axis| {
        let values = places.map(|place| place[axis]);
        [
            values.into_iter().fold(f64::INFINITY, f64::min),
            values.into_iter().fold(f64::NEG_INFINITY, f64::max),
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::{horizon, meeting};
    use landscape::LUNOID_RADIUS;
    use scenario::Curvature;

    /// A ray meets the ground where ground and ray have dropped by the same.
    #[test]
    fn a_ray_meets_the_ground_of_every_law() {
        for drop in [1.6, 4e3, 1e6] {
            for slope in [0.8, 2.0, 100.0, 1e4] {
                for law in [Curvature::None, Curvature::Parabolic, Curvature::Exact] {
                    let range = meeting(slope, drop, 0.0, law);
                    let is_past = range > LUNOID_RADIUS || slope * slope < 2.5 * drop / LUNOID_RADIUS;
                    let left = slope * range - drop - law.drop(range);
                    assert!(is_past || left.abs() < 1e-9 * (1.0 + drop), "{law:?} {drop} {slope}: {left}");
                }
            }
        }
    }

    /// A level ray passes above the sphere: ground is in view up to the horizon, and relief up to its own beyond.
    #[test]
    fn the_horizon_of_the_sphere() {
        let touch = |height: f64| {
            let far = LUNOID_RADIUS + height;
            LUNOID_RADIUS * libm::sin(libm::acos(LUNOID_RADIUS / far))
        };
        for height in [10.0, 1e4, 1e6] {
            assert!((horizon(height) / touch(height) - 1.0).abs() < 1e-6, "{height}");
            let seen = meeting(0.0, height, 900.0, Curvature::Exact);
            assert!((seen - touch(height) - touch(900.0)).abs() < 1.0, "{height}: {seen}");
        }
    }
}
