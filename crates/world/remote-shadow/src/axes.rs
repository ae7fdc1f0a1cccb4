//! Axes of a sun: p across its azimuth, q away from it.

use landscape::Sun;
use quantities::sin_cos;

/// Ground axes turned so that q runs away from the sun and p to the left of one who looks along q; (p, q) has the
/// handedness of (north, east), so what is clockwise in one is clockwise in the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SunAxes {
    /// Unit vector of q: north, east.
    away: [f64; 2],
    /// Sine and cosine of the elevation.
    pub(crate) sin: f64,
    pub(crate) cos: f64,
}

impl SunAxes {
    pub(crate) fn new(sun: &Sun) -> Self {
        let (sin_a, cos_a) = sin_cos(sun.azimuth);
        let (sin, cos) = sin_cos(sun.elevation);
        Self { away: [-cos_a, -sin_a], sin, cos }
    }

    /// Unit vector of q: north, east.
    pub(crate) fn away(&self) -> [f64; 2] {
        self.away
    }

    /// North and east (m) of (p, q) (m).
    pub(crate) fn to_ground(self, [p, q]: [f64; 2]) -> [f64; 2] {
        let [n, e] = self.away;
        [q * n + p * e, q * e - p * n]
    }

    /// (p, q) (m) of a place north and east (m).
    pub(crate) fn to_sun_axes(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [n, e] = self.away;
        [x * e - y * n, x * n + y * e]
    }
}

#[cfg(test)]
mod tests {
    use super::SunAxes;
    use landscape::Sun;

    #[test]
    fn a_turn_and_back() {
        let axes = SunAxes::new(&Sun { azimuth: 1.1, elevation: 0.1 });
        let [x, y] = axes.to_ground([3.0, -7.0]);
        let [p, q] = axes.to_sun_axes([x, y]);
        assert!((p - 3.0).abs() < 1e-14 && (q + 7.0).abs() < 1e-14);
        let (a, b) = (axes.to_ground([1.0, 0.0]), axes.to_ground([0.0, 1.0]));
        assert!((a[0] * b[1] - a[1] * b[0] - 1.0).abs() < 1e-14, "a rotation, no reflection");
    }

    #[test]
    fn q_runs_away_from_the_sun() {
        let axes = SunAxes::new(&Sun { azimuth: 0.0, elevation: 0.1 });
        assert_eq!(axes.to_ground([0.0, 5.0]), [-5.0, 0.0]);
        assert_eq!(axes.to_ground([5.0, 0.0]), [0.0, 5.0]);
    }
}
