//! Area and intensity of a light point by distance or magnitude.

use std::f64::consts::PI;

use glam::DVec3;
use scenario::{LightPoint, LightSource};

use crate::error::{LightError, checked};
use crate::least::LeastDiameter;

/// A light point as the screen shows it with nothing in front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Diameter (pixels), at least the least diameter.
    pub diameter: f64,
    /// Intensity of every point of the disc, at least 0, 1 for the display's white.
    pub intensity: f64,
}

/// Diameter on the screen (pixels) of a lamp of `diameter` (m) at `distance` (m), with the focal length in pixels.
///
/// # Errors If one of them is not finite and above 0.
pub fn projected_diameter(diameter: f64, distance: f64, focal: f64) -> Result<f64, LightError> {
    let above_0 = |what, value| checked(what, value, "a number above 0", |value| value > 0.0);
    let [diameter, distance, focal] = [
        above_0("diameter of a lamp (m)", diameter)?,
        above_0("distance of a lamp (m)", distance)?,
        above_0("focal length (pixels)", focal)?,
    ];
    Ok(diameter * focal / distance)
}

/// Distance (m) beyond which a lamp of `diameter` (m) keeps its least disc and fades, with the focal length in pixels.
pub fn crossover(diameter: f64, focal: f64, least: LeastDiameter) -> f64 {
    diameter * focal / least.pixels()
}

impl Disc {
    /// A lamp of a projected diameter (pixels, above 0) and an intrinsic intensity. Intensity times area is
    /// `intrinsic pi projected^2 / 4`, whichever of the two the least diameter makes it keep. Chosen: the claims ask for functions
    /// of the distance, and this one keeps the lamp's light.
    pub fn of_lamp(projected: f64, intrinsic: f64, least: LeastDiameter) -> Self {
        let share = (projected / least.pixels()).min(1.0);
        Self { diameter: projected.max(least.pixels()), intensity: intrinsic * share * share }
    }

    /// A star that is `fainter` by so many magnitudes (-100 to 100) than one that shows intensity 1 on the least disc. Brighter
    /// ones grow. Chosen: the claims do not speak of stars.
    ///
    /// # Errors If the magnitude is out of range.
    pub fn of_star(fainter: f64, least: LeastDiameter) -> Result<Self, LightError> {
        let holds = |value: f64| value.abs() <= 100.0;
        let flux =
            libm::exp10(-0.4 * checked("magnitude of a star", fainter, "a number from -100 to 100", holds)?);
        Ok(Self { diameter: least.pixels() * flux.max(1.0).sqrt(), intensity: flux.min(1.0) })
    }

    /// A light point of a scene as an eye (north, east, up; m) sees it, with the focal length in pixels. `None` where it sends the
    /// eye nothing, or has a figure that no light point has.
    pub fn of_light(light: &LightPoint, eye: DVec3, focal: f64, least: LeastDiameter) -> Option<Self> {
        let intensity = light.towards(eye);
        let disc = match light.source {
            LightSource::Lamp { at, diameter } => {
                let projected = projected_diameter(diameter, (at - eye).length(), focal).ok()?;
                Self::of_lamp(projected, intensity, least)
            }
            LightSource::Star { magnitude, .. } => Self::of_star(magnitude, least).ok()?.dimmed(intensity),
        };
        (intensity > 0.0).then_some(disc)
    }

    /// Area of the disc (pixels squared).
    pub fn area(&self) -> f64 {
        PI * self.diameter * self.diameter / 4.0
    }

    /// Intensity times area: the light that the screen shows of it with nothing in front.
    pub fn light(&self) -> f64 {
        self.intensity * self.area()
    }

    /// The same disc with its intensity times a factor of at least 0: of a lobe, a flash or a medium.
    pub fn dimmed(self, factor: f64) -> Self {
        Self { intensity: self.intensity * factor, ..self }
    }
}
