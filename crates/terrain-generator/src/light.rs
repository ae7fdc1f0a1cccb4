//! The sun in the axes of one sweep, and Lambert's law there (section 7).

use landscape::Sun;

/// Components of the sun vector along the sweep, across it (to the right) and up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepLight {
    /// Along.
    pub along: f64,
    /// Across, to the right.
    pub across: f64,
    /// Up.
    pub up: f64,
}

impl SweepLight {
    /// The sun seen from a sweep along `direction` (cosine, sine of azimuth against north), scaled by `albedo`.
    pub fn new(sun: &Sun, albedo: f64, [cos, sin]: [f64; 2]) -> Self {
        let [north, east, up] = sun.direction().map(|component| component * albedo);
        Self { along: north * cos + east * sin, across: east * cos - north * sin, up }
    }
}
