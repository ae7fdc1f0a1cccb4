//! Discs in the sky: the Earth with its phase, and the sun.

use glam::DVec3;

/// A disc in the sky at one time: opaque, infinitely far, behind everything of the scene and before the stars.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkyDisc {
    /// Unit vector to its middle: north, east, up.
    pub direction: DVec3,
    /// How wide it is seen (rad), above 0.
    pub angular_diameter: f64,
    /// What its face shows.
    pub face: DiscFace,
}

/// What a disc in the sky shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DiscFace {
    /// The sun: the same light all over.
    Sun {
        /// Light of it (linear red, green, blue; at least 0).
        colour: [f64; 3],
    },
    /// A ball that the sun lights: `albedo max(n.s, 0)`.
    Ball {
        /// Share of red, green and blue light that is returned, 0..=1.
        albedo: [f64; 3],
        /// Unit vector to the sun: north, east, up.
        sun: DVec3,
    },
}

impl SkyDisc {
    /// Light (linear red, green, blue) along the unit vector `ray` from the eye; `None` beside the disc.
    pub fn light(&self, ray: DVec3) -> Option<[f64; 3]> {
        // Across the disc in units of its radius; angles this small are their sines.
        let across =
            (ray - self.direction * ray.dot(self.direction)) / libm::sin(self.angular_diameter / 2.0);
        let (squared, before) = (across.length_squared(), ray.dot(self.direction) > 0.0);
        (before && squared <= 1.0).then(|| match self.face {
            DiscFace::Sun { colour } => colour,
            DiscFace::Ball { albedo, sun } => {
                let normal = across - self.direction * (1.0 - squared).sqrt();
                albedo.map(|albedo| albedo * normal.dot(sun).max(0.0))
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_is_lit_on_the_side_of_the_sun() {
        let face = DiscFace::Ball { albedo: [0.3, 0.4, 0.5], sun: DVec3::Y };
        let disc = SkyDisc { direction: DVec3::X, angular_diameter: 0.03, face };
        let ray = |across: f64| DVec3::new(1.0, across, 0.0).normalize();
        let half = disc.light(ray(0.0149)).unwrap();
        assert!((half[0] / 0.3 - 0.993).abs() < 1e-2, "{half:?}");
        assert_eq!(disc.light(ray(-0.0149)), Some([0.0; 3]));
        assert_eq!(disc.light(ray(0.0151)), None);
        assert_eq!(disc.light(-ray(0.0)), None);
        let full = SkyDisc { face: DiscFace::Ball { albedo: [1.0; 3], sun: -DVec3::X }, ..disc };
        assert_eq!(full.light(DVec3::X), Some([1.0; 3]));
    }

    #[test]
    fn the_sun_is_the_same_all_over() {
        let sun = SkyDisc {
            direction: DVec3::Z,
            angular_diameter: 0.0093,
            face: DiscFace::Sun { colour: [1.0; 3] },
        };
        assert_eq!(sun.light(DVec3::new(0.004, 0.0, 1.0).normalize()), Some([1.0; 3]));
    }
}
