//! Where a pixel lies among the sweeps (section 15.3, inverted), as numbers that a page can carry.

use serde::{Deserialize, Serialize};

/// The sweeps of a run on its screen.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sight {
    /// Whether a scan converter reads between the sweeps; otherwise column n of the raster is sweep n.
    pub tube: bool,
    /// Sweeps of a frame.
    pub sweeps: u32,
    /// Tangents of half the field of view of the screen: width, height.
    pub field: [f64; 2],
    /// Tangent of half the width of the raster that is written.
    pub raster: f64,
    /// First frame of `frames`, counted at the update rate.
    pub first: u64,
    /// Fan and yoke of each frame, ascending.
    pub frames: Vec<SightLine>,
}

/// The fan and the yoke of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(from = "[f64; 4]", into = "[f64; 4]")]
pub struct SightLine {
    /// Tangent of the azimuth at the edge of the fan.
    pub edge: f64,
    /// Sine and cosine of the pitch by which sweeps cross the lines; 0 and 1 where the law of projection has none.
    pub pitch: [f64; 2],
    /// Angle by which the yoke turns the picture (rad).
    pub yoke: f64,
}

impl From<[f64; 4]> for SightLine {
    fn from([edge, sin, cos, yoke]: [f64; 4]) -> Self {
        Self { edge, pitch: [sin, cos], yoke }
    }
}

impl From<SightLine> for [f64; 4] {
    fn from(SightLine { edge, pitch: [sin, cos], yoke }: SightLine) -> Self {
        [edge, sin, cos, yoke]
    }
}

impl Sight {
    /// Sweep at a place of the screen, -1 to 1 to the right and down; whole numbers at the middle of sweeps. The script
    /// of the page has the same formula. None for a frame that is not there.
    pub fn sweep_at(&self, frame: u64, [across, down]: [f64; 2]) -> Option<f64> {
        let index = usize::try_from(frame.checked_sub(self.first)?).ok()?;
        let SightLine { edge, pitch: [sin_pitch, cos_pitch], yoke } = *self.frames.get(index)?;
        let (sin, cos) = (libm::sin(yoke), libm::cos(yoke));
        let (x, y) = (across * self.field[0], down * self.field[1]);
        let (x, y) = (cos * x - sin * y, sin * x + cos * y);
        let share = match self.tube {
            true => x / (cos_pitch + sin_pitch * y) / edge,
            false => x / self.raster,
        };
        let count = f64::from(self.sweeps);
        Some(0.5 * ((share + 1.0) * count - 1.0))
    }
}
