//! The one query for height, slope and albedo.

use crate::{Bank, Level};

/// The ground at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Height above the lunoid's tangent plane (m).
    pub height: f64,
    /// Slopes `[hx, hy]`: rise to the north and to the east (m/m).
    pub slopes: [f64; 2],
    /// Share of the light that is returned, 0..=1.
    pub albedo: f64,
}

/// Lunoid and terrain: what `exact`, truth, the vehicle and the machine's preparation ask.
#[derive(Debug, Clone, PartialEq)]
pub struct Landscape {
    bank: Bank,
    albedo: f64,
}

impl Landscape {
    /// The landscape of a bank, of one albedo (0..=1).
    pub fn new(bank: Bank, albedo: f64) -> Self {
        Self { bank, albedo }
    }

    /// Terrain coefficients.
    pub fn bank(&self) -> &Bank {
        &self.bank
    }

    /// The level that draws: the finest.
    pub fn level(&self) -> &Level {
        self.bank.finest()
    }

    /// Share of the light that is returned, 0..=1.
    pub fn albedo(&self) -> f64 {
        self.albedo
    }

    /// The ground at (x, y) (m); `None` outside the problem area.
    pub fn at(&self, x: f64, y: f64) -> Option<SurfacePoint> {
        let level = self.level();
        let (region, local) = level.locate(x, y)?;
        let [height, hu, hv] = level.height_and_slopes(region, local);
        let d = level.region_size();
        Some(SurfacePoint { height, slopes: [hu / d, hv / d], albedo: self.albedo })
    }

    /// Whether the ground at (x, y) (m) rests on data; false outside the problem area.
    pub fn has_data(&self, x: f64, y: f64) -> bool {
        self.level().locate(x, y).is_some_and(|(region, _)| !self.bank.is_void(region))
    }

    /// Height at (x, y) (m); `None` outside the problem area.
    pub fn height(&self, x: f64, y: f64) -> Option<f64> {
        self.at(x, y).map(|point| point.height)
    }
}

#[cfg(test)]
mod tests {
    use super::Landscape;
    use crate::{Bank, Level};

    #[test]
    fn a_tilted_plane_is_exact() {
        // h = 5 + 0.1 x - 0.2 y on 250 m regions: words h, d hx, d hy.
        let plane = |m: f64, n: f64| {
            let mut words = [0.0; 9];
            words[0] = 5.0 + 25.0 * m - 50.0 * n;
            words[3] = 25.0;
            words[1] = -50.0;
            words
        };
        let words = (0..9).map(|k| plane(f64::from(k / 3), f64::from(k % 3))).collect();
        let level = Level::new(250.0, [0.0, 0.0], [3, 3], words).unwrap();
        let landscape = Landscape::new(Bank::new("plane", vec![level], None).unwrap(), 1.0);
        let point = landscape.at(123.0, 456.0).unwrap();
        assert!((point.height - (5.0 + 12.3 - 91.2)).abs() < 1e-12);
        assert!((point.slopes[0] - 0.1).abs() < 1e-14);
        assert!((point.slopes[1] + 0.2).abs() < 1e-14);
        assert_eq!(landscape.at(500.1, 0.0), None);
    }
}
