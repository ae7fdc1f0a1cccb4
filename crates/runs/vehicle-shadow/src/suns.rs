//! The sun as a point, or as a disc that makes a penumbra (19.1: 0.5 degrees, neglected; it could be smeared).

use std::f64::consts::PI;

use glam::DVec3;
use landscape::Sun;
use quantities::{degrees, radians, sin_cos};

/// Half of the angle that the sun's disc fills at the mean distance (deg).
pub const SUN_HALF_ANGLE_DEG: f64 = 0.2666;

/// Points of the disc (our choice): a penumbra has as many steps.
pub const SUN_POINTS: usize = 64;

/// A sun that does not stand wholly above the horizontal: it has no shadow on flat ground.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the sun at an elevation of {elevation_deg} deg: expected more than {least_deg} and at most 90 deg, or the shadow \
     has no end"
)]
pub struct LowSun {
    /// Elevation that was found (deg).
    pub elevation_deg: f64,
    /// Elevation that it must be over (deg).
    pub least_deg: f64,
}

/// Unit vectors (north, east, up) to points of the sun, each of the same weight: one, or with a penumbra
/// [`SUN_POINTS`] that cover its disc evenly (a spiral of equal areas).
///
/// # Errors
/// If not all of the sun is above the horizontal.
pub fn suns(sun: &Sun, penumbra: bool) -> Result<Vec<DVec3>, LowSun> {
    let (elevation_deg, least_deg) =
        (degrees(sun.elevation), if penumbra { SUN_HALF_ANGLE_DEG } else { 0.0 });
    // Also refuses what is no number.
    if !(elevation_deg > least_deg && elevation_deg <= 90.0) {
        return Err(LowSun { elevation_deg, least_deg });
    }
    let centre = DVec3::from_array(sun.direction());
    if !penumbra {
        return Ok(vec![centre]);
    }
    let (first, second) = centre.any_orthonormal_pair();
    let radius = libm::tan(radians(SUN_HALF_ANGLE_DEG));
    let golden = PI * (3.0 - 5f64.sqrt());
    let point = |index: usize| {
        let out = radius * ((index as f64 + 0.5) / SUN_POINTS as f64).sqrt();
        let (sin, cos) = sin_cos(golden * index as f64);
        (centre + (first * cos + second * sin) * out).normalize()
    };
    Ok((0..SUN_POINTS).map(point).collect())
}

#[cfg(test)]
mod tests {
    use landscape::Sun;
    use quantities::{degrees, radians};

    use super::{SUN_HALF_ANGLE_DEG, SUN_POINTS, suns};

    fn sun(elevation_deg: f64) -> Sun {
        Sun { azimuth: radians(200.0), elevation: radians(elevation_deg) }
    }

    #[test]
    fn the_disc_is_covered_evenly() {
        let found = suns(&sun(20.0), true).unwrap();
        let centre = suns(&sun(20.0), false).unwrap()[0];
        assert_eq!(found.len(), SUN_POINTS);
        let away: Vec<f64> = found.iter().map(|to| degrees(libm::acos(to.dot(centre).min(1.0)))).collect();
        assert!(away.iter().all(|&angle| angle < SUN_HALF_ANGLE_DEG));
        // Half of the disc's area lies within 0.707 of its radius.
        let inner = away.iter().filter(|&&angle| angle < SUN_HALF_ANGLE_DEG * 0.5f64.sqrt()).count();
        assert_eq!(inner, SUN_POINTS / 2);
        let mean = found.iter().sum::<glam::DVec3>() / SUN_POINTS as f64;
        assert!(degrees(mean.normalize().distance(centre)) < 0.02 * SUN_HALF_ANGLE_DEG);
    }

    #[test]
    fn a_sun_on_the_horizon_is_refused() {
        for (elevation, penumbra, fine) in [
            (0.0, false, false),
            (-3.0, false, false),
            (0.2, false, true),
            (0.2, true, false),
            (0.3, true, true),
            (90.0, true, true),
            (91.0, false, false),
            (f64::NAN, false, false),
        ] {
            assert_eq!(suns(&sun(elevation), penumbra).is_ok(), fine, "{elevation} {penumbra}");
        }
    }
}
