//! Light points of a scene: lamps, beacons and stars, as functions of time.

use glam::DVec3;

/// A light point at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightPoint {
    /// Its number among the light points of the mission, the same in every frame.
    pub id: u32,
    /// Where it is and how large or bright.
    pub source: LightSource,
    /// Its colour (linear red, green, blue, 0..=1).
    pub colour: [f64; 3],
    /// Intensity of its face, 1 for the display's white; 0 while a flash is dark.
    pub intensity: f64,
    /// To which side it shines; `None` shines to all sides alike.
    pub lobe: Option<Lobe>,
    /// Priority where two things are equally near: the higher is seen.
    pub priority: i8,
    /// Whether a beam of its own draws it, instead of the raster (EP-0611021, claim 7).
    pub calligraphic: bool,
}

/// Where a light point is, and what its size on the screen follows from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LightSource {
    /// A lamp on or above the ground.
    Lamp {
        /// Place: north, east, up (m).
        at: DVec3,
        /// Diameter of its face (m), above 0.
        diameter: f64,
    },
    /// A star: infinitely far.
    Star {
        /// Unit vector to it: north, east, up.
        direction: DVec3,
        /// Magnitudes by which it is fainter than a star that shows white on the least disc, -100 to 100.
        magnitude: f64,
    },
}

impl LightPoint {
    /// Intensity (at least 0) that an eye at `eye` (north, east, up; m) sees of its face.
    pub fn towards(&self, eye: DVec3) -> f64 {
        match (self.source, &self.lobe) {
            (LightSource::Lamp { at, .. }, Some(lobe)) => self.intensity * lobe.share(eye - at),
            _ => self.intensity,
        }
    }
}

/// A lobe about an axis: the power of the cosine of the angle to it, and nothing beyond the half-angle.
///
/// Chosen: the law of spotlights in graphics libraries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lobe {
    /// Unit vector: north, east, up.
    pub axis: DVec3,
    /// Half-angle (rad), above 0 to pi/2.
    pub half_angle: f64,
    /// Power of the cosine, at least 0; 0 is the same all over.
    pub power: f64,
}

impl Lobe {
    /// Share (0 to 1) of the intensity on its axis that goes along `direction` (any length but 0), away from the lamp.
    pub fn share(&self, direction: DVec3) -> f64 {
        let cosine = self.axis.dot(direction) / direction.length();
        let reaches = cosine >= libm::cos(self.half_angle);
        if reaches { libm::pow(cosine.clamp(0.0, 1.0), self.power) } else { 0.0 }
    }
}

/// A lamp that is lit for a share of every period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flash {
    /// Period (s), above 0.
    pub period: f64,
    /// Share of it that is lit, 0 to 1: its first part.
    pub duty: f64,
    /// Where in the period the start of the mission lies, 0 to below 1.
    pub phase: f64,
}

impl Flash {
    /// Whether the lamp is lit at a time (s), before 0 too.
    pub fn is_lit(&self, time: f64) -> bool {
        let periods = time / self.period + self.phase;
        periods - periods.floor() < self.duty
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_4;

    fn at(degrees: f64) -> DVec3 {
        let angle = degrees.to_radians();
        DVec3::new(3.0 * libm::cos(angle), 0.0, 3.0 * libm::sin(angle))
    }

    #[test]
    fn a_lobe_falls_by_the_power_of_its_cosine_and_ends() {
        let lobe = Lobe { axis: DVec3::X, half_angle: FRAC_PI_4, power: 2.0 };
        assert_eq!(lobe.share(DVec3::X), 1.0);
        assert!((lobe.share(at(30.0)) - 0.75).abs() < 1e-15);
        assert!(lobe.share(at(44.9)) > 0.5 && lobe.share(at(45.1)) == 0.0 && lobe.share(at(180.0)) == 0.0);
        let even = Lobe { power: 0.0, ..lobe };
        assert_eq!((even.share(at(44.9)), even.share(at(45.1))), (1.0, 0.0));
    }

    #[test]
    fn the_first_part_of_each_period_is_lit() {
        let flash = Flash { period: 2.0, duty: 0.25, phase: 0.0 };
        let lit = |flash: &Flash, times: [f64; 5]| times.map(|time| flash.is_lit(time));
        assert_eq!(lit(&flash, [0.0, 0.4, 0.5, 1.9, 2.1]), [true, true, false, false, true]);
        assert_eq!(lit(&flash, [-0.1, -1.4, -1.6, -2.0, -2.1]), [false, false, true, true, false]);
        let late = Flash { phase: 0.5, ..flash };
        assert_eq!(lit(&late, [0.0, 0.9, 1.0, 1.4, 1.5]), [false, false, true, true, false]);
        let [on, off] = [1.0, 0.0].map(|duty| Flash { period: 1.0, duty, phase: 0.0 });
        assert!(on.is_lit(0.99) && !off.is_lit(0.0));
    }

    #[test]
    fn a_lamp_shines_where_its_lobe_points() {
        let lobe = Lobe { axis: DVec3::X, half_angle: FRAC_PI_4, power: 1.0 };
        let source = LightSource::Lamp { at: DVec3::new(10.0, 0.0, 2.0), diameter: 0.3 };
        let light = LightPoint {
            id: 0,
            source,
            colour: [1.0; 3],
            intensity: 0.5,
            lobe: Some(lobe),
            priority: 0,
            calligraphic: false,
        };
        assert_eq!(light.towards(DVec3::new(12.0, 0.0, 2.0)), 0.5);
        assert_eq!(light.towards(DVec3::new(8.0, 0.0, 2.0)), 0.0);
        assert_eq!(LightPoint { lobe: None, ..light }.towards(DVec3::ZERO), 0.5);
    }
}
