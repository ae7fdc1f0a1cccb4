//! Brightness of a corner, and intensity of a sample.

use glam::DVec3;

/// Brightness (0 to 1) of a corner: the cosine between unit vectors, 0 where the sun is behind.
pub fn brightness(normal: DVec3, sun: DVec3) -> f64 {
    normal.dot(sun).max(0.0)
}

/// Linear red, green, blue of a sample: `colour` under a part `ambient` of light from everywhere, the rest by `brightness` (0 to 1 each).
pub fn lit(colour: [f64; 3], ambient: f64, brightness: f64) -> [f64; 3] {
    colour.map(|channel| channel * (ambient + (1.0 - ambient) * brightness))
}

/// Largest error of interpolation on the screen, as a part of the difference between two corners whose depths have the ratio `ratio`
/// (1 or more).
pub fn screen_error(ratio: f64) -> f64 {
    (ratio.sqrt() - 1.0) / (ratio.sqrt() + 1.0)
}

/// Part of the way in space at part `share` of the way on the screen, between depths `near` and `far` (m, above 0).
pub fn in_space(share: f64, [near, far]: [f64; 2]) -> f64 {
    let (from, to) = ((1.0 - share) / near, share / far);
    to / (from + to)
}
