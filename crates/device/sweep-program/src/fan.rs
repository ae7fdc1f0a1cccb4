//! The fan of azimuths over which the sweeps of a frame are spread (section 15.3).

use quantities::sin_cos;
use scenario::{FieldOfView, Projection};

/// Sweeps equally spaced in `tan beta`, beta being the azimuth against the heading; left to right. With level
/// pitch they fall on equally spaced columns; with pitch the fan is wide enough for every corner of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fan {
    /// Tangent of beta at the picture's edge.
    pub edge: f64,
    /// Sweeps in the fan.
    pub sweeps: u32,
}

impl Fan {
    /// The fan that covers `field` at `pitch` (rad). `None` if pitch plus half the vertical field comes within
    /// 10 degrees of the nadir or zenith, where all azimuths meet.
    pub fn covering(projection: Projection, pitch: f64, field: &FieldOfView, sweeps: u32) -> Option<Self> {
        let (sin, cos) = sin_cos(pitch);
        let reach = match projection {
            Projection::Exact => cos - sin.abs() * field.tan_half_height,
            Projection::AsReported | Projection::Corrected => 1.0,
        };
        let half_height = libm::atan(field.tan_half_height);
        (pitch.abs() + half_height < Self::steepest())
            .then_some(Self { edge: field.tan_half_width / reach, sweeps })
    }

    /// Largest pitch plus half the vertical field of view that a fan covers (rad): 80 degrees.
    pub fn steepest() -> f64 {
        quantities::radians(80.0)
    }

    /// `tan beta` of a sweep.
    pub fn tangent(&self, sweep: u32) -> f64 {
        let count = f64::from(self.sweeps);
        self.edge * (2.0 * f64::from(sweep) + 1.0 - count) / count
    }

    /// Where `tan beta` falls between the sweeps: sweep n is at n.
    pub fn position(&self, tangent: f64) -> f64 {
        let count = f64::from(self.sweeps);
        tangent * (0.5 * count / self.edge) + 0.5 * (count - 1.0)
    }

    /// Cosine and sine of the azimuth of a sweep against north, from those of the heading.
    pub fn direction(&self, sweep: u32, [cos, sin]: [f64; 2]) -> [f64; 2] {
        let tangent = self.tangent(sweep);
        let cos_beta = 1.0 / (1.0 + tangent * tangent).sqrt();
        let sin_beta = tangent * cos_beta;
        [cos * cos_beta - sin * sin_beta, sin * cos_beta + cos * sin_beta]
    }
}

#[cfg(test)]
mod tests {
    use super::Fan;
    use quantities::radians;
    use scenario::{FieldOfView, Projection};

    fn field() -> FieldOfView {
        FieldOfView { tan_half_width: libm::tan(radians(25.0)), tan_half_height: libm::tan(radians(15.0)) }
    }

    #[test]
    fn level_sweeps_are_columns() {
        let fan = Fan::covering(Projection::Exact, 0.0, &field(), 525).unwrap();
        assert_eq!(fan.edge, field().tan_half_width);
        assert_eq!(fan.tangent(262), 0.0);
        for sweep in [0, 17, 524] {
            assert!((fan.position(fan.tangent(sweep)) - f64::from(sweep)).abs() < 1e-10);
        }
    }

    #[test]
    fn a_pitched_fan_reaches_every_corner() {
        let field = field();
        for degrees in [-30.0, -12.0, 5.0, 40.0] {
            let pitch = radians(degrees);
            let fan = Fan::covering(Projection::Exact, pitch, &field, 525).unwrap();
            for y in [-field.tan_half_height, field.tan_half_height] {
                let forward = libm::cos(pitch) + y * libm::sin(pitch);
                assert!(field.tan_half_width / forward <= fan.edge * (1.0 + 1e-12));
            }
        }
        assert_eq!(Fan::covering(Projection::Exact, radians(66.0), &field, 525), None);
    }

    #[test]
    fn directions_turn_with_the_heading() {
        let fan = Fan::covering(Projection::Exact, 0.0, &field(), 3).unwrap();
        let [cos, sin] = fan.direction(2, [libm::cos(0.7), libm::sin(0.7)]);
        let azimuth = 0.7 + libm::atan(fan.tangent(2));
        assert!((cos - libm::cos(azimuth)).abs() < 1e-15 && (sin - libm::sin(azimuth)).abs() < 1e-15);
    }
}
