//! How much of a crater samples of the ground can show.

/// Outer radius over spacing up to which a crater is left out. Chosen: Nyquist's limit, two samples over its diameter.
const GONE: f64 = 1.0;

/// Outer radius over spacing from which on a crater is whole. Chosen: one octave above the limit.
const WHOLE: f64 = 2.0;

/// Share of a crater (0 to 1) that stays where the ground is sampled at a spacing, by its outer radius over this spacing:
/// 0 up to 1, 1 from 2 on, and `3 t^2 - 2 t^3` with `t = radius / spacing - 1` in between.
///
/// A crater that is smaller than the spacing would be seen by one sample or none (aliasing). The share and its derivative are
/// continuous.
pub fn kept_share(radii_a_spacing: f64) -> f64 {
    let t = ((radii_a_spacing - GONE) / (WHOLE - GONE)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Largest outer radius (m) of which nothing stays at a spacing (m).
pub(crate) fn gone_to(spacing: f64) -> f64 {
    GONE * spacing
}

#[cfg(test)]
mod tests {
    use super::kept_share;

    #[test]
    fn the_share_rises_smoothly_from_nothing_to_all() {
        assert_eq!(
            [0.0, 0.5, 1.0, 1.5, 2.0, 1e9, f64::INFINITY].map(kept_share),
            [0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0]
        );
        let shares: Vec<f64> = (0..=3000).map(|k| kept_share(1e-3 * f64::from(k))).collect();
        assert!(shares.windows(2).all(|pair| pair[0] <= pair[1] && pair[1] - pair[0] < 1.6e-3));
        // Nor does its slope jump.
        let bends = shares.windows(3).map(|three| (three[0] - 2.0 * three[1] + three[2]).abs());
        assert!(bends.fold(0.0, f64::max) < 7e-6);
    }
}
