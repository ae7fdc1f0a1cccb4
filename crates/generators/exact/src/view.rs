//! From a place on the view-plane to the ray that a projection law gives it (section 15.3).

use glam::DVec3;
use landscape::Attitude;
use quantities::sin_cos;
use scenario::Projection;

use crate::Ray;

/// The least tangent by which a ray leaves the vertical. One that is nearer to it is taken for one that leaves it by so
/// much: 1000 km below the eye that is 1e-12 m, and every ray has an azimuth.
const UPRIGHT: f64 = 1e-18;

/// Tangent of the steepest elevation of a ray, either way.
pub const STEEPEST: f64 = 1.0 / UPRIGHT;

/// View-plane at distance 1 ahead of an eye, and the screen that the yoke turns against it. Roll is the yoke's: the
/// view-plane itself stays level across.
///
/// With the yoke at an angle the screen's (x, y) shows the view-plane's `(x cos - y sin, x sin + y cos)`: what an
/// ideal camera rolled by that angle has there (`Psi` of section 12). Starboard down, the right of the screen looks
/// lower, and the picture has turned counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    projection: Projection,
    pitch: (f64, f64),
    heading: (f64, f64),
    yoke: (f64, f64),
}

impl View {
    /// The view of a vehicle under a law, the yoke upright.
    pub fn new(projection: Projection, attitude: &Attitude) -> Self {
        let (pitch, heading) = (sin_cos(attitude.pitch), sin_cos(attitude.heading));
        Self { projection, pitch, heading, yoke: (0.0, 1.0) }
    }

    /// The same with the yoke at an angle (rad), positive for starboard down.
    pub fn with_yoke(self, angle: f64) -> Self {
        Self { yoke: sin_cos(angle), ..self }
    }

    /// Place on the view-plane of a place on the screen.
    pub fn unturned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.yoke;
        if self.is_upright() { [x, y] } else { [x * cos - y * sin, x * sin + y * cos] }
    }

    fn is_upright(&self) -> bool {
        self.yoke == (0.0, 1.0)
    }

    /// The ray under the projection law through a place on the screen: `x` (right) and `y` (down), both over the
    /// distance of the view-plane.
    ///
    /// - `Exact`: `(1, x, y)` turned by the pitch.
    /// - `AsReported`: `eta = theta - atan y` at the azimuth of x.
    /// - `Corrected`: `tan eta = -y cos beta`.
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        let [x, y] = self.unturned([x, y]);
        let (sin, cos) = self.pitch;
        match self.projection {
            Projection::Exact => {
                let (direction, length) = self.turn(cos + y * sin, x);
                Ray { direction, rise: (sin - y * cos) / length }
            }
            Projection::AsReported => {
                Ray { direction: self.turn(1.0, x).0, rise: (sin - y * cos) / (cos + y * sin) }
            }
            Projection::Corrected => {
                let (direction, length) = self.turn(1.0, x);
                Ray { direction, rise: -y / length }
            }
        }
    }

    /// Direction of the true perspective, whatever the law: north, east, up; 1 over the ground.
    pub fn perspective(&self, x: f64, y: f64) -> DVec3 {
        let [x, y] = self.unturned([x, y]);
        let (sin, cos) = self.pitch;
        let ([north, east], length) = self.turn(cos + y * sin, x);
        DVec3::new(north, east, (sin - y * cos) / length)
    }

    /// Place on the screen, in true perspective, of what lies `to` (north, east, up; m) from the eye; `None` if it
    /// lies less than `near` (m) ahead.
    pub fn project(&self, to: DVec3, near: f64) -> Option<[f64; 2]> {
        let ((sin_p, cos_p), (sin_h, cos_h), (sin, cos)) = (self.pitch, self.heading, self.yoke);
        let (forward, right) = (to.x * cos_h + to.y * sin_h, to.y * cos_h - to.x * sin_h);
        let ahead = self.ahead(to);
        let [x, y] = [right / ahead, (forward * sin_p - to.z * cos_p) / ahead];
        (ahead >= near).then_some([x * cos + y * sin, y * cos - x * sin])
    }

    /// Axes of the screen (right, down, ahead; m) of what lies `to` (north, east, up; m) from the eye, in true perspective.
    pub fn axes(&self, to: DVec3) -> DVec3 {
        let ((sin_p, cos_p), (sin_h, cos_h), (sin, cos)) = (self.pitch, self.heading, self.yoke);
        let (forward, right) = (to.x * cos_h + to.y * sin_h, to.y * cos_h - to.x * sin_h);
        let down = forward * sin_p - to.z * cos_p;
        DVec3::new(right * cos + down * sin, down * cos - right * sin, self.ahead(to))
    }

    /// How far ahead along the axis of view (m) something is that lies `to` (north, east, up; m) from the eye.
    pub fn ahead(&self, to: DVec3) -> f64 {
        let ((sin_p, cos_p), (sin_h, cos_h)) = (self.pitch, self.heading);
        (to.x * cos_h + to.y * sin_h) * cos_p + to.z * sin_p
    }

    /// The ray of the true perspective that lies 1 ahead along the axis of view: north, east, up.
    pub fn ray_ahead(&self, [x, y]: [f64; 2]) -> DVec3 {
        self.perspective(x, y).normalize() * (1.0 + x * x + y * y).sqrt()
    }

    /// Whether all rays of a column have one azimuth, and rise from its bottom to its top.
    pub fn columns_are_vertical(&self) -> bool {
        self.is_upright() && (self.projection != Projection::Exact || self.pitch == (0.0, 1.0))
    }

    /// Unit vector north and east of the vehicle's (forward, starboard), and their length; straight up or down the
    /// heading and [`UPRIGHT`].
    fn turn(&self, forward: f64, starboard: f64) -> ([f64; 2], f64) {
        let (sin, cos) = self.heading;
        let length = (forward * forward + starboard * starboard).sqrt();
        if length < UPRIGHT {
            return ([cos, sin], UPRIGHT);
        }
        let (forward, starboard) = (forward / length, starboard / length);
        ([forward * cos - starboard * sin, forward * sin + starboard * cos], length)
    }
}

#[cfg(test)]
mod tests {
    use super::View;
    use glam::DVec3;
    use landscape::Attitude;
    use quantities::{degrees, radians};
    use scenario::Projection;

    /// Check table 23.5: pitch, beta, eta (deg), X and Y exact, X and Y as reported.
    const TABLE: [([f64; 3], [f64; 2], [f64; 2]); 4] = [
        (
            [0.0, 25.0, -10.0],
            [0.4663076581549986, 0.1945552970310455],
            [0.4663076581549986, 0.176326980708465],
        ),
        (
            [10.0, 20.0, -15.0],
            [0.3891511366478474, 0.4859032142836099],
            [0.3639702342662024, 0.4663076581549986],
        ),
        (
            [-60.0, 15.0, -50.0],
            [0.1708318126205395, -0.158832528061934],
            [0.2679491924311227, -0.176326980708465],
        ),
        (
            [10.0, -25.0, 5.0],
            [-0.4655764503767126, 0.07845844989550805],
            [-0.4663076581549986, 0.08748866352592401],
        ),
    ];

    fn check(projection: Projection, pitch: f64, at: [f64; 2], beta: f64, eta: f64) {
        for heading in [0.0, 217.0] {
            let attitude = Attitude { roll: 0.3, pitch: radians(pitch), heading: radians(heading) };
            let ray = View::new(projection, &attitude).ray(at[0], at[1]);
            let azimuth = degrees(libm::atan2(ray.direction[1], ray.direction[0]));
            let turned = (azimuth - heading - beta + 540.0).rem_euclid(360.0) - 180.0;
            assert!(turned.abs() < 1e-12, "{projection:?} {at:?}: azimuth off by {turned} deg");
            assert!((degrees(libm::atan(ray.rise)) - eta).abs() < 1e-12, "{projection:?} {at:?}");
        }
    }

    #[test]
    fn check_table_23_5() {
        for ([pitch, beta, eta], exact, as_reported) in TABLE {
            check(Projection::Exact, pitch, exact, beta, eta);
            check(Projection::AsReported, pitch, as_reported, beta, eta);
        }
        check(Projection::Corrected, 12.0, TABLE[0].1, 25.0, -10.0);
    }

    #[test]
    fn the_forward_formulas_lead_back() {
        let (pitch, at) = (radians(-12.0), [0.31, -0.11]);
        let attitude = Attitude { roll: 0.0, pitch, heading: 0.0 };
        let ray = View::new(Projection::Exact, &attitude).ray(at[0], at[1]);
        let [cos_b, sin_b] = ray.direction;
        let (sin, cos) = (libm::sin(pitch), libm::cos(pitch));
        let w = cos * cos_b + sin * ray.rise;
        assert!((sin_b / w - at[0]).abs() < 1e-15);
        assert!(((sin * cos_b - cos * ray.rise) / w - at[1]).abs() < 1e-15);
    }

    /// The picture of a camera that truly rolls is what the yoke makes of the level one's.
    #[test]
    fn the_yoke_is_a_rolled_camera() {
        for (roll, pitch, heading) in [(10.0, 0.0, 0.0), (-25.0, -8.0, 130.0), (40.0, 12.0, 250.0)] {
            let attitude = Attitude { roll: radians(roll), pitch: radians(pitch), heading: radians(heading) };
            let view = View::new(Projection::Exact, &attitude).with_yoke(attitude.roll);
            for at in [[0.0, 0.0], [0.4, 0.1], [-0.3, 0.25], [0.2, -0.2]] {
                let [u, v, w] = (attitude.to_terrain() * DVec3::new(1.0, at[0], at[1])).to_array();
                let (ray, length) = (view.ray(at[0], at[1]), libm::hypot(u, v));
                let expected = [u / length, v / length, -w / length];
                let found = [ray.direction[0], ray.direction[1], ray.rise];
                let drawn = view.perspective(at[0], at[1]).to_array();
                let back = view.project(DVec3::new(u, v, -w) * 7.0, 0.1).unwrap();
                for k in 0..3 {
                    assert!((found[k] - expected[k]).abs() < 1e-14, "{roll}: {found:?}, not {expected:?}");
                    assert!((drawn[k] - expected[k]).abs() < 1e-14, "{roll}: {drawn:?}, not {expected:?}");
                }
                assert!((0..2).all(|axis| (back[axis] - at[axis]).abs() < 1e-14), "{back:?}, not {at:?}");
            }
        }
    }

    #[test]
    fn straight_ahead_along_an_axis_stays_on_it() {
        let attitude = Attitude { roll: 0.0, pitch: 0.2, heading: radians(90.0) };
        assert_eq!(View::new(Projection::Exact, &attitude).ray(0.0, 0.1).direction, [0.0, 1.0]);
    }
}
