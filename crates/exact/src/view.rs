//! From a place on the view-plane to the ray that a projection law gives it (section 15.3).

use landscape::Attitude;
use quantities::sin_cos;
use scenario::Projection;

use crate::Ray;

/// View-plane at distance 1 ahead of an eye; the yoke is upright, roll is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    projection: Projection,
    pitch: (f64, f64),
    heading: (f64, f64),
}

impl View {
    /// The view of a vehicle under a law.
    pub fn new(projection: Projection, attitude: &Attitude) -> Self {
        Self { projection, pitch: sin_cos(attitude.pitch), heading: sin_cos(attitude.heading) }
    }

    /// The ray through `x` (right) and `y` (down), both over the distance of the view-plane.
    ///
    /// - `Exact`: `(1, x, y)` turned by the pitch.
    /// - `AsReported`: `eta = theta - atan y` at the azimuth of x.
    /// - `Corrected`: `tan eta = -y cos beta`.
    pub fn ray(&self, x: f64, y: f64) -> Ray {
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

    /// Whether all rays of a column have one azimuth.
    pub fn columns_are_vertical(&self) -> bool {
        self.projection != Projection::Exact || self.pitch.0 == 0.0
    }

    /// Unit vector north and east of the vehicle's (forward, starboard), and their length.
    fn turn(&self, forward: f64, starboard: f64) -> ([f64; 2], f64) {
        let (sin, cos) = self.heading;
        let length = (forward * forward + starboard * starboard).sqrt();
        let (forward, starboard) = (forward / length, starboard / length);
        ([forward * cos - starboard * sin, forward * sin + starboard * cos], length)
    }
}

#[cfg(test)]
mod tests {
    use super::View;
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

    #[test]
    fn straight_ahead_along_an_axis_stays_on_it() {
        let attitude = Attitude { roll: 0.0, pitch: 0.2, heading: radians(90.0) };
        assert_eq!(View::new(Projection::Exact, &attitude).ray(0.0, 0.1).direction, [0.0, 1.0]);
    }
}
