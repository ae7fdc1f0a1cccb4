//! How the ground falls away under a line: not at all, by a parabola, or by the sphere (section 15.4).

use landscape::{LUNOID_RADIUS, parabolic_drop, spherical_drop};
use scenario::Curvature;

/// The shape of the lunoid along a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bend {
    /// A drop of so much times the square of ground range (1/m, at least 0).
    Parabola(f64),
    /// A drop of `R - sqrt(R^2 - s^2)`: no polynomial, so root finding bounds it by tangents.
    Sphere,
}

impl Bend {
    /// The bend of a flat Moon: none.
    pub const FLAT: Self = Self::Parabola(0.0);

    /// The bend of a law.
    pub fn of(curvature: Curvature) -> Self {
        match curvature {
            Curvature::None => Self::FLAT,
            Curvature::Parabolic => Self::Parabola(parabolic_drop(1.0)),
            Curvature::Exact => Self::Sphere,
        }
    }

    /// How far the ground has dropped at a range (m): grows with it.
    pub fn drop(self, range: f64) -> f64 {
        match self {
            Self::Parabola(bend) => bend * range * range,
            Self::Sphere => spherical_drop(range),
        }
    }

    /// The drop at a range (m), and by how much it grows for each metre; the growth never falls.
    pub fn drop_and_slope(self, range: f64) -> [f64; 2] {
        match self {
            Self::Parabola(bend) => [bend * range * range, 2.0 * bend * range],
            Self::Sphere => below_plane(range).map(|part| -part),
        }
    }

    /// Its share that is a polynomial: a multiple of the square of range (1/m).
    pub fn square(self) -> f64 {
        match self {
            Self::Parabola(bend) => bend,
            Self::Sphere => 0.0,
        }
    }

    /// Range at which the lunoid ends (m).
    pub fn end(self) -> f64 {
        match self {
            Self::Parabola(_) => f64::INFINITY,
            Self::Sphere => LUNOID_RADIUS,
        }
    }

    /// Tangent of the elevation under which an eye `height` (m) above the lunoid sees its horizon, at most 0.
    pub fn horizon(self, height: f64) -> f64 {
        let height = height.max(0.0);
        match self {
            Self::Parabola(bend) => -2.0 * (bend * height).sqrt(),
            Self::Sphere => -(height * (2.0 * LUNOID_RADIUS + height)).sqrt() / LUNOID_RADIUS,
        }
    }
}

/// Minus the drop of the sphere at a range within it (m), and its derivative: both fall with range.
pub fn below_plane(range: f64) -> [f64; 2] {
    let root = (LUNOID_RADIUS * LUNOID_RADIUS - range * range).max(0.0).sqrt();
    [-spherical_drop(range), -range / root]
}

#[cfg(test)]
mod tests {
    use super::{Bend, below_plane};
    use landscape::LUNOID_RADIUS;
    use scenario::Curvature;

    /// The line from an eye that touches the lunoid at a range has the slope of the ground there.
    #[test]
    fn the_horizon_touches_the_ground() {
        for height in [1.63, 4e4, 1e6] {
            let parabola = (2.0 * LUNOID_RADIUS * height).sqrt();
            let far = LUNOID_RADIUS + height;
            let sphere = LUNOID_RADIUS * (1.0 - (LUNOID_RADIUS / far) * (LUNOID_RADIUS / far)).sqrt();
            for (curvature, range) in [(Curvature::Parabolic, parabola), (Curvature::Exact, sphere)] {
                let bend = Bend::of(curvature);
                let seen = -(height + bend.drop(range)) / range;
                assert!((bend.horizon(height) / seen - 1.0).abs() < 1e-9, "{curvature:?} {height}");
            }
        }
        assert_eq!(Bend::FLAT.horizon(7.0), 0.0);
        assert_eq!(Bend::Sphere.horizon(-7.0), 0.0);
    }

    #[test]
    fn the_derivative_is_the_difference() {
        for range in [1.0, 3e4, 1.2e6] {
            let by_difference = (below_plane(range + 0.1)[0] - below_plane(range - 0.1)[0]) / 0.2;
            assert!((below_plane(range)[1] - by_difference).abs() < 1e-8, "{range}");
            for bend in [Bend::Sphere, Bend::of(Curvature::Parabolic), Bend::FLAT] {
                let [drop, slope] = bend.drop_and_slope(range);
                let by_difference = (bend.drop(range + 0.1) - bend.drop(range - 0.1)) / 0.2;
                assert!(drop == bend.drop(range) && (slope - by_difference).abs() < 1e-8, "{bend:?} {range}");
            }
        }
    }
}
