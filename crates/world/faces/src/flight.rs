//! Ballistic flight without drag: dust, and its envelope.

use quantities::sin_cos;

use crate::error::{FaceError, within};

/// Gravity of the Moon (m/s2).
pub const MOON: f64 = 1.62;

/// Flight from the ground in an upright plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    speed: f64,
    angle: f64,
    gravity: f64,
}

impl Flight {
    /// A flight of `speed` (m/s) at `angle` above the horizontal (radians) under `gravity` (m/s2).
    ///
    /// # Errors
    /// If speed or gravity are not above 0, or the angle is not above 0 and at most a quarter turn.
    pub fn new(speed: f64, angle: f64, gravity: f64) -> Result<Self, FaceError> {
        within("speed of dust (m/s)", speed, speed > 0.0, "above 0")?;
        within("gravity (m/s2)", gravity, gravity > 0.0, "above 0")?;
        let allowed = angle > 0.0 && angle <= std::f64::consts::FRAC_PI_2;
        within("angle of dust above the horizontal (rad)", angle, allowed, "above 0, pi / 2 at most")?;
        Ok(Self { speed, angle, gravity })
    }

    /// Time from the launch to the landing (s).
    pub fn time(&self) -> f64 {
        2.0 * self.speed * sin_cos(self.angle).0 / self.gravity
    }

    /// Greatest height of the flight (m).
    pub fn apex(&self) -> f64 {
        let up = self.speed * sin_cos(self.angle).0;
        up * up / (2.0 * self.gravity)
    }

    /// Distance of the landing (m).
    pub fn range(&self) -> f64 {
        self.at(self.time())[0]
    }

    /// Distance and height (m) at `time` (s) after the launch.
    pub fn at(&self, time: f64) -> [f64; 2] {
        let (sin, cos) = sin_cos(self.angle);
        [self.speed * time * cos, self.speed * time * sin - self.gravity * time * time / 2.0]
    }

    /// Time (s) at which face `face` of `faces` is drawn: the middle of its part of the flight.
    pub fn time_of(&self, face: usize, faces: usize) -> f64 {
        (face as f64 + 0.5) * self.time() / faces as f64
    }

    /// Height (m) at distance `x` (m) that no flight of the same speed exceeds, whatever its angle; negative beyond its reach.
    pub fn envelope(&self, x: f64) -> f64 {
        let square = self.speed * self.speed;
        square / (2.0 * self.gravity) - self.gravity * x * x / (2.0 * square)
    }

    /// The same flight at another angle (radians), clamped to 0 and a quarter turn.
    fn turned(&self, by: f64) -> Self {
        Self { angle: (self.angle + by).clamp(0.0, std::f64::consts::FRAC_PI_2), ..*self }
    }

    /// Corners (distance, height; m) of a sheet of dust at `time` (s): flights within `spread` (radians) of this one, launched
    /// over the last `part` (0 to 1) of the time. It lies inside the envelope, and reaches below the ground where dust has landed.
    pub(crate) fn sheet(&self, time: f64, spread: f64, part: f64) -> [[f64; 2]; 4] {
        let [low, high] = [self.turned(-spread), self.turned(spread)];
        let young = time * (1.0 - part);
        [low.at(young), low.at(time), high.at(time), high.at(young)]
    }
}
