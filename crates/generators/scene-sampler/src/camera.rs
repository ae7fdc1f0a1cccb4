//! From the ground to camera axes and the screen.

use glam::{DMat3, DVec3};
use landscape::Attitude;
use raster::Projection;
use scenario::{Curvature, Pose, View};

/// Room for rounding around what may be on the screen, as a share of its distance (chosen).
const ROUNDING: f64 = 1e-9;

/// An eye and its axes: x right, y down, z ahead. Along y lengths are scaled so that pixels are square.
#[derive(Debug, Clone, Copy)]
pub struct Camera {
    /// Eye: north, east, up (m).
    pub eye: DVec3,
    /// From camera axes to the screen.
    pub projection: Projection,
    /// From north, east, up to right, down, ahead.
    turn: DMat3,
    /// Height of a square pixel over the height of a true pixel.
    squeeze: f64,
    curvature: Curvature,
}

impl Camera {
    /// The camera of a pose in a view. What turns the picture is the yoke.
    pub fn new(pose: &Pose, view: &View) -> Self {
        let attitude = Attitude { roll: pose.yoke, ..pose.attitude };
        let to_ahead = attitude.to_terrain().transpose();
        // North, east, down to ahead, starboard, down; then right, down, ahead.
        let [ahead, right, down] = [0, 1, 2].map(|k| to_ahead.row(k) * DVec3::new(1.0, 1.0, -1.0));
        let focal = |pixels: u32, tangent: f64| f64::from(pixels) / (2.0 * tangent);
        let across = focal(view.columns, view.field.tan_half_width);
        let along = focal(view.lines, view.field.tan_half_height);
        Self {
            eye: DVec3::from_array(pose.eye),
            projection: Projection {
                focal: across,
                centre: [view.columns, view.lines].map(|pixels| f64::from(pixels) / 2.0),
            },
            turn: DMat3::from_cols(right, down, ahead).transpose(),
            squeeze: along / across,
            curvature: view.laws.curvature,
        }
    }

    /// Camera axes (m) of a place on the map (north, east, up; m), lowered by the drop of the lunoid at its range.
    pub fn place(&self, place: DVec3) -> DVec3 {
        let from_eye = place - self.eye;
        let drop = self.curvature.drop(from_eye.truncate().length());
        self.direction(from_eye - DVec3::Z * drop)
    }

    /// Camera axes of a direction (north, east, up).
    pub fn direction(&self, direction: DVec3) -> DVec3 {
        let turned = self.turn * direction;
        DVec3::new(turned.x, turned.y * self.squeeze, turned.z)
    }

    /// Whether no part of a sphere of radius `radius` (m) about a middle, as it lies from the eye (north, east, up; m), can be on the screen.
    pub fn misses(&self, middle: DVec3, radius: f64) -> bool {
        let [across, along] = self.projection.centre.map(|half| half / self.projection.focal);
        let DVec3 { x, y, z } = self.direction(middle);
        // Room for rounding, as a share of the lengths that meet here.
        let reach = radius + ROUNDING * (middle.length() + radius);
        let is_beyond = |off: f64, scale: f64, slope: f64| {
            off.abs() - slope * z > reach * (scale * scale + slope * slope).sqrt()
        };
        z < -reach || is_beyond(x, 1.0, across) || is_beyond(y, self.squeeze, along)
    }

    /// The direction (north, east, up) that a place on the screen (pixels) shows, 1 long along the view axis.
    pub fn ray(&self, place: [f64; 2]) -> DVec3 {
        let ray = self.projection.ray(place);
        self.turn.transpose() * DVec3::new(ray.x, ray.y / self.squeeze, ray.z)
    }

    /// The place on the map (north, east, up; m) that a pixel shows in its middle, at a distance (m) along its ray.
    pub fn shown(&self, pixel: [usize; 2], distance: f64) -> DVec3 {
        let ray = self.ray(pixel.map(|at| at as f64 + 0.5)).normalize();
        let seen = self.eye + ray * distance;
        seen + DVec3::Z * self.drop_at(seen)
    }

    /// Focal length (pixels) with which areas are right: a disc has the area of the ellipse that pixels of other shapes make of it.
    pub fn focal(&self) -> f64 {
        self.projection.focal * self.squeeze.sqrt()
    }

    /// Pixels that a length (m) a metre away has on the screen, at most: anywhere on it, along either axis, however it lies.
    pub fn most_pixels(&self) -> f64 {
        let [across, along] = self.projection.centre.map(|half| half / self.projection.focal);
        let along = along / self.squeeze;
        let corner = across * across + along * along;
        self.projection.focal * self.squeeze.max(1.0) * (1.0 + corner)
    }

    /// Lengths along y in camera axes over those of the scene.
    pub fn squeeze(&self) -> f64 {
        self.squeeze
    }

    /// Drop of the lunoid (m) under a foot point (north, east, up; m).
    pub fn drop_at(&self, foot: DVec3) -> f64 {
        self.curvature.drop((foot - self.eye).truncate().length())
    }
}

#[cfg(test)]
mod tests {
    use quantities::{Rate, radians};
    use scenario::{Display, FieldOfView, Laws};

    use super::*;

    fn camera(heading: f64, pitch: f64, yoke: f64) -> Camera {
        let rate = Rate::new(30, 1).unwrap();
        let view = View {
            columns: 200,
            lines: 100,
            field: FieldOfView { tan_half_width: 0.5, tan_half_height: 0.5 },
            update: rate,
            refresh: rate,
            display: Display { white: 1.0, gamma: 1.0 },
            laws: Laws { curvature: Curvature::None, ..Laws::default() },
            ranges: [1.0, 100.0],
            yoke: None,
            levels: None,
            shadows: None,
        };
        let attitude = Attitude { roll: 9.0, pitch: radians(pitch), heading: radians(heading) };
        Camera::new(&Pose { time: 0.0, eye: [0.0, 0.0, 2.0], attitude, yoke: radians(yoke) }, &view)
    }

    #[test]
    fn the_screen_shows_what_lies_there() {
        let camera = camera(90.0, 0.0, 0.0);
        // East ahead, south to the right.
        let at = |place: [f64; 3]| camera.projection.project(camera.place(DVec3::from_array(place)));
        let close = |found: [f64; 2], expected: [f64; 2]| {
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?} {expected:?}");
        };
        close(at([0.0, 10.0, 2.0]), [100.0, 50.0]);
        close(at([-5.0, 10.0, 2.0]), [200.0, 50.0]);
        close(at([0.0, 10.0, -3.0]), [100.0, 100.0]);
    }

    #[test]
    fn a_pixel_shows_the_place_at_its_distance() {
        let camera = camera(37.0, -8.0, 11.0);
        let place = camera.shown([130, 20], 50.0);
        let seen = camera.projection.project(camera.place(place));
        assert!((seen[0] - 130.5).abs() < 1e-9 && (seen[1] - 20.5).abs() < 1e-9, "{seen:?}");
        assert!(((place - camera.eye).length() - 50.0).abs() < 1e-9, "without curvature nothing drops");
    }

    /// Points of spheres around the screen: none is on it where the sphere is said to miss it, and nearly all that miss are found.
    #[test]
    fn a_sphere_that_misses_the_screen_has_no_point_on_it() {
        let camera = camera(37.0, -8.0, 11.0);
        let mut counts = [0; 2];
        for step in 0..4000 {
            let share = |k: i32, of: f64| of * (f64::from(step * k % 997) / 997.0 - 0.5);
            let (middle, radius) = (DVec3::new(share(1, 40.0), share(31, 40.0), share(173, 20.0)), 1.5);
            let point = |k: i32| {
                let [x, y, z] = [k % 7 - 3, k / 7 % 7 - 3, k / 49 - 3].map(f64::from);
                middle + radius * DVec3::new(x, y, z).normalize_or_zero()
            };
            let is_seen = |k: i32| {
                let place = camera.direction(point(k));
                let [x, y] = camera.projection.project(place);
                place.z > 0.01 && (0.0..=200.0).contains(&x) && (0.0..=100.0).contains(&y)
            };
            let is_missed = camera.misses(middle, radius);
            let is_shown = (0..343).any(is_seen);
            assert!(!(is_missed && is_shown), "{middle}");
            counts[usize::from(is_missed)] += 1;
            counts[0] -= i32::from(!is_missed && is_shown);
        }
        // Beside a corner of the picture a sphere may be said to meet it.
        assert!(counts[1] > 2000 && counts[0] < 200, "{counts:?}");
    }

    #[test]
    fn rays_go_where_places_came_from() {
        let camera = camera(37.0, -8.0, 11.0);
        let place = DVec3::new(40.0, 25.0, -1.0);
        let ray = camera.ray(camera.projection.project(camera.place(place)));
        let along = (place - camera.eye).normalize();
        assert!((ray.normalize() - along).length() < 1e-12, "{ray} {along}");
    }

    #[test]
    fn a_turned_picture_shows_the_right_side_higher() {
        // Starboard down: what lies level to the right is seen above the middle.
        let camera = camera(0.0, 0.0, 10.0);
        let [_, y] = camera.projection.project(camera.place(DVec3::new(10.0, 3.0, 2.0)));
        assert!(y < 50.0, "{y}");
    }
}
