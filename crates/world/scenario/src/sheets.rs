//! Things that let light through: sheets of dust in the scene, and overlays that are fixed to the eye.

use glam::DVec3;

/// A flat convex polygon of the scene at one time, seen from both sides. Its colour is the light that it sends: no sun lights it.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Its number among the sheets of the mission, the same in every frame.
    pub id: u32,
    /// Corners around it, at least 3: north, east, up (m).
    pub corners: Vec<DVec3>,
    /// Its colour (linear red, green, blue, 0..=1).
    pub colour: [f64; 3],
    /// How much light it lets through.
    pub medium: Medium,
    /// Priority where two things are equally near: the higher is seen.
    pub priority: i8,
}

/// How much light a sheet lets through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Medium {
    /// The same share (0 opaque to 1 invisible) in all directions.
    Share(f64),
    /// Dust of a thickness: `exp(-kappa s)`, with the path s inside the sheet.
    Dust {
        /// Extinction (1/m), at least 0.
        kappa: f64,
        /// Thickness (m), above 0.
        thickness: f64,
    },
}

impl Sheet {
    /// Unit normal of the sheet (north, east, up), by the order of its corners (Newell).
    pub fn normal(&self) -> DVec3 {
        let corners = &self.corners;
        let following = corners.iter().skip(1).chain(corners.first());
        let sum: DVec3 =
            corners.iter().zip(following).map(|(a, b)| (*a - corners[0]).cross(*b - corners[0])).sum();
        sum.normalize_or_zero()
    }

    /// Largest distance of two of its corners (m): no path inside it is longer.
    pub fn diameter(&self) -> f64 {
        let from = |a: &DVec3| self.corners.iter().map(|b| a.distance(*b)).fold(0.0, f64::max);
        self.corners.iter().map(from).fold(0.0, f64::max)
    }

    /// Share of light (0 to 1) that it lets through along a ray that crosses it at an angle of this `cosine` to its normal.
    pub fn translucency(&self, cosine: f64) -> f64 {
        match self.medium {
            Medium::Share(share) => share,
            Medium::Dust { kappa, thickness } => {
                libm::exp(-kappa * (thickness / cosine.abs()).min(self.diameter()))
            }
        }
    }
}

/// A flat convex polygon that is fixed to the eye: visor, dirt, reticle. It is before everything else.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// Its number among the overlays of the mission, the same in every frame.
    pub id: u32,
    /// Corners around it, at least 3, on the screen: x right in half widths, y down in half heights, from the middle.
    pub corners: Vec<[f64; 2]>,
    /// Its colour (linear red, green, blue, 0..=1).
    pub colour: [f64; 3],
    /// Share of light that it lets through (0 opaque to 1 invisible).
    pub share: f64,
    /// Which of two overlays is before the other: the higher.
    pub priority: i8,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(medium: Medium) -> Sheet {
        let corners = [[0.0, 0.0, 0.0], [30.0, 0.0, 0.0], [30.0, 0.0, 40.0], [0.0, 0.0, 40.0]];
        let corners = corners.map(DVec3::from_array).to_vec();
        Sheet { id: 0, corners, colour: [0.5; 3], medium, priority: 0 }
    }

    #[test]
    fn a_sheet_knows_its_normal_and_diameter() {
        let sheet = square(Medium::Share(0.5));
        assert_eq!((sheet.normal(), sheet.diameter()), (-DVec3::Y, 50.0));
    }

    /// Check values of the specification: kappa 0.05, 10 m and 40 m.
    #[test]
    fn dust_lets_less_through_on_a_longer_path() {
        let dust = square(Medium::Dust { kappa: 0.05, thickness: 10.0 });
        assert!((dust.translucency(1.0) - 0.606_530_659_712_633).abs() < 1e-15);
        assert!((dust.translucency(-0.25) - 0.135_335_283_236_613).abs() < 1e-15);
        // Along the sheet the path is as long as the sheet.
        assert_eq!(dust.translucency(0.0), libm::exp(-0.05 * 50.0));
        assert_eq!(square(Medium::Share(0.7)).translucency(0.1), 0.7);
    }
}
