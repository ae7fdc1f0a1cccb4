//! A flag held out by a rod, rippled as it was folded.

use super::{Parts, boxed, plate, strut};

/// Ripples of the cloth, and bands across them.
const RIPPLES: usize = 6;
const BANDS: usize = 7;

pub(super) fn parts() -> Parts {
    let mut parts = vec![
        boxed([-0.0125, -0.0125, -0.25], [0.0125, 0.0125, 2.4], 0.9)?,
        strut([0.0, 0.0, 2.375], [0.0, 1.5, 2.375], 0.018, 0.9)?,
    ];
    let (left, width, low, high) = (0.02, 1.48, 1.46, 2.37);
    let edge = |ripple: usize| {
        let ahead = [0.0, 0.05, -0.035, 0.045, -0.05, 0.04, 0.0][ripple];
        [ahead, left + width * ripple as f64 / RIPPLES as f64]
    };
    let height = |band: usize| low + (high - low) * band as f64 / BANDS as f64;
    for ripple in 0..RIPPLES {
        let ([x0, y0], [x1, y1]) = (edge(ripple), edge(ripple + 1));
        for band in 0..BANDS {
            let (z0, z1) = (height(band), height(band + 1));
            let albedo = match (ripple < 2 && band >= BANDS - 4, band % 2) {
                (true, _) => 0.25,
                (false, 0) => 0.5,
                _ => 0.95,
            };
            parts.push(plate(&[[x0, y0, z0], [x1, y1, z0], [x1, y1, z1], [x0, y0, z1]], 0.006, albedo)?);
        }
    }
    Ok(parts)
}
